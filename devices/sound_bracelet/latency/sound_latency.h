// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_device.h"
#include "backend/core/error.h"
#include "backend/playback/player.h"
#include "devices/sound_bracelet/sound_bracelet_file.h"

#include <functional>
#include <string>
#include <vector>

namespace teleta::sound {

/// Clicks that are heard, so that the median of their latencies is known.
inline constexpr int kClicks = 10;

/// From a frame that drives a tactor to the click that is heard.
struct SoundLatency {
    std::vector<double> clicks_s; ///< kClicks, in the order in which they were played
    [[nodiscard]] double median_s() const;
    /// Between the shortest and the longest.
    [[nodiscard]] double spread_s() const;
};

/// Who watches a measurement; both are called on its thread.
struct LatencyWatch {
    std::function<bool()> goesOn;                  ///< false ends it within some ms
    std::function<void(double latency_s)> heard{}; ///< of each click that counts; may be empty
};

/// Plays clicks on tactor 1, one after the other, and listens to an input of the sound server. A click that
/// is not heard, or whose period was missed, is played again, of at most 2 kClicks; fewer when none is heard
/// at all. bracelet: opened by the file and started; player: that drives it. Error: as
/// ClickListener::open; unavailable, too few were heard, with the level of the input; refused, STOP, heat or
/// something else that is played; cancelled. Blocks for some seconds.
[[nodiscard]] core::Expected<SoundLatency>
measureSoundLatency(const SoundBraceletFile& file, const core::BraceletSource& bracelet,
                    playback::Player& player, const std::string& input, const LatencyWatch& watch);

} // namespace teleta::sound
