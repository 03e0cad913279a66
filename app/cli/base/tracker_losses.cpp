// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/tracker_losses.h"

#include "app/cli/base/command_io.h"
#include "backend/vision/contacts/camera_tracker.h"

#include <QCoreApplication>

namespace teleta::cli {

namespace {

struct TrackText {
    Q_DECLARE_TR_FUNCTIONS(TrackCommand)
};

} // namespace

void warnOfUnusableFrames(const vision::CameraTracker& tracker) {
    if (tracker.unusableFrames() > 0)
        warn(TrackText::tr("%1 of %2 frames could not be used. The last reason: %3")
                 .arg(tracker.unusableFrames())
                 .arg(tracker.frames())
                 .arg(QString::fromStdString(tracker.whyUnusable())));
}

} // namespace teleta::cli
