// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/playback/measurement_end.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

namespace teleta::playback {

namespace {

struct RunText {
    Q_DECLARE_TR_FUNCTIONS(RunText)
};

} // namespace

core::Unexpected measurementEnd(const PlayerStatus& status) {
    switch (status.ending) {
    case PlayerEnding::stopSwitch:
        return core::refused(RunText::tr("STOP ended the measurement."),
                             RunText::tr("release STOP and measure again"));
    case PlayerEnding::deviceLost:
        return core::refused(RunText::tr("The bracelet was lost during the measurement."),
                             RunText::tr("connect it and measure again"));
    case PlayerEnding::stalled:
        return core::refused(
            RunText::tr("The computer was too slow for the measurement: the bracelet paused in between."),
            RunText::tr("measure again with fewer programs running"));
    case PlayerEnding::tooHot:
        return core::refused(RunText::tr("The bracelet is too hot to be measured."),
                             RunText::tr("let it cool down and measure again"));
    default:
        return core::refused(RunText::tr("Something else was played meanwhile."),
                             RunText::tr("measure again"));
    }
}

} // namespace teleta::playback
