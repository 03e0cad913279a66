// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/tracker_rows.h"

#include "backend/vision/contacts/contact_rows.h"

#include <QCoreApplication>

namespace teleta::cli {

namespace {

struct TrackText {
    Q_DECLARE_TR_FUNCTIONS(TrackCommand)
};

} // namespace

void writeContacts(RowOutput& rows, long long frame, double time_s, const vision::CameraTracker& tracker,
                   std::span<const vision::FollowedContact> contacts) {
    const int bumped = tracker.bump() ? tracker.bump()->contact : 0;
    for (const vision::FollowedContact& followed : contacts)
        if (followed.seen || followed.event == vision::ContactEvent::ends)
            vision::writeContact(rows, frame, time_s, followed, bumped);
}

void warnOfUnusableFrames(const vision::CameraTracker& tracker) {
    if (tracker.unusableFrames() > 0)
        warn(TrackText::tr("%1 of %2 frames could not be used. The last reason: %3")
                 .arg(tracker.unusableFrames())
                 .arg(tracker.frames())
                 .arg(QString::fromStdString(tracker.whyUnusable())));
}

} // namespace teleta::cli
