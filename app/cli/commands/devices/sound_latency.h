// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/threads/stop_switch.h"
#include "devices/sound_bracelet/sound_bracelet_file.h"

#include <string>
#include <vector>

namespace teleta::core {
class BraceletSource;
}

namespace teleta::cli {

/// Clicks that are heard, so that the median of their latencies is known.
inline constexpr int kClicks = 10;

/// From a frame that drives a tactor to the click that is heard.
struct SoundLatency {
    std::vector<double> clicks_s; ///< kClicks, in the order in which they were played
    [[nodiscard]] double median_s() const;
    /// Between the shortest and the longest.
    [[nodiscard]] double spread_s() const;
};

/// Plays clicks on tactor 1, one after the other, and listens to an input of the sound server. A click that
/// is not heard, or whose period was missed, is played again, of at most 2 kClicks; fewer when none is heard
/// at all. bracelet: opened by the file and started. Error: as sound::ClickListener::open; unavailable, too
/// few were heard, with the level of the input; cancelled. Blocks for some seconds.
[[nodiscard]] core::Expected<SoundLatency> measureSoundLatency(const sound::SoundBraceletFile& file,
                                                               core::BraceletSource& bracelet,
                                                               const core::StopSwitch& stop,
                                                               const std::string& port);

} // namespace teleta::cli
