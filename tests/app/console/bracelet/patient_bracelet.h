// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_service.h"

#include <memory>

namespace teleta::test {

/// A station that plays on where a busy machine pauses: the board's usual time-out of 0.1 s, its silence of a
/// second and reports half a second old would end the playing there, as they should outside of tests.
inline std::unique_ptr<console::BraceletService> patientBracelet(core::StopSwitch& stop) {
    constexpr std::int64_t kPatience_ns = 10'000'000'000;
    return std::make_unique<console::BraceletService>(
        stop, nullptr, playback::PlayerConfig{.boardTimeout_ms = 5000, .longestSilence_ns = kPatience_ns},
        kPatience_ns);
}

} // namespace teleta::test
