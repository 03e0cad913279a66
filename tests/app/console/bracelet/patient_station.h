// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_station.h"

#include <memory>

namespace teleta::test {

/// A station that plays on where a busy machine pauses: the board's usual time-out of 0.1 s, and its silence
/// of a second, would end the playing there, as they should outside of tests.
inline std::unique_ptr<console::BraceletStation> patientStation(core::StopSwitch& stop) {
    return std::make_unique<console::BraceletStation>(
        stop, nullptr,

        playback::PlayerConfig{.boardTimeout_ms = 5000, .longestSilence_ns = 10'000'000'000});
}

} // namespace teleta::test
