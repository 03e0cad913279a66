// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace teleta::core {

/// Some consecutive frames of one stream as they left the device: raw values, not tared, not scaled.
///   values: frames() x channels, row-major. Of a tactile source as core::TaxelLayout says.
/// time_ns: steady clock at the read of each frame, one entry a frame, never decreasing.
/// sourceTime_s: the stream's own time (recording or simulated time), one entry a frame.
/// firstFrame: number of the first frame in the stream since it was opened; a gap between blocks is a loss.
/// discontinuity: the stream jumped before this block (seek, loop, reconnect); trackers start over.
struct SampleBlock {
    std::uint64_t firstFrame = 0;
    std::size_t channels = 0;
    std::vector<std::int64_t> time_ns;
    std::vector<double> sourceTime_s;
    std::vector<float> values;
    bool discontinuity = false;

    [[nodiscard]] std::size_t frames() const { return time_ns.size(); }
    [[nodiscard]] std::span<const float> frame(std::size_t index) const {
        return std::span<const float>(values).subspan(index * channels, channels);
    }
};

} // namespace teleta::core
