// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace teleta::contact {

/// Frames that are computed side by side.
constexpr std::size_t kBlockFrames = 8;

/// The moments of FrameMoments for each frame of a block.
struct BlockMoments {
    template <typename T>
    using Each = std::array<T, kBlockFrames>;

    alignas(32) Each<double> sum, sumX, sumY;
    alignas(32) Each<std::int32_t> active, x, y, xx, xy, yy;
};

/// Whether the frames of an array are so small that momentsOfBlock() counts without overflow and that the
/// products of their second moments, n^2 side^2 / 4, are exact in double.
[[nodiscard]] inline bool fitsBlock(const core::ArrayLayout& layout) {
    constexpr std::size_t kLargest = 1 << 14;
    return layout.taxels() * static_cast<std::size_t>(layout.columns) <= kLargest &&
           layout.taxels() * static_cast<std::size_t>(layout.rows) <= kLargest;
}

/// Whether all values are finite and none has a minus sign.
[[nodiscard]] bool isUsable(const float* values, std::size_t count);

/// Moments of eight small frames in one pass, a frame in each lane of the processor's vectors. The counts are
/// exact. The load sums add the same terms as momentsOf() in another order: they differ by rounding, at most
/// taxels x 1.1e-16 of the force, times the array's sides. layout: fitsBlock(). frames: row-major, each
/// isUsable(). threshold, activeOnly: as momentsOf(). lanes: working memory, kBlockFrames x taxels. Thread:
/// any (pure); allocates nothing.
void momentsOfBlock(const std::array<const float*, kBlockFrames>& frames, const core::ArrayLayout& layout,
                    float threshold, bool activeOnly, float* lanes, BlockMoments& moments);

/// The same, bit for bit, with the instructions that every processor has.
void momentsOfBlockAnywhere(const std::array<const float*, kBlockFrames>& frames,
                            const core::ArrayLayout& layout, float threshold, bool activeOnly, float* lanes,
                            BlockMoments& moments);

} // namespace teleta::contact
