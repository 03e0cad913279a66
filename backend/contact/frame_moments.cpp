// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/frame_moments.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace teleta::contact {

namespace {

// Vector extension of GCC and Clang, available on every target.
using Floats [[gnu::vector_size(4 * kMomentLanes)]] = float;
using Words [[gnu::vector_size(4 * kMomentLanes)]] = std::int32_t;
using UnsignedWords [[gnu::vector_size(4 * kMomentLanes)]] = std::uint32_t;
using Doubles [[gnu::vector_size(8 * kMomentLanes)]] = double;
using HalfDoubles [[gnu::vector_size(4 * kMomentLanes)]] = double;

// A strip is so small that its counts, multiplied by column and column squared, are exact in float: 128 * 129
// / 2 * (0 + 1 + .. + 31) < 2^24.
constexpr int kStripRows = 128;
constexpr int kStripColumns = 32;

// Lanes read from [kMomentLanes - n] on drop the first n columns and keep the others.
constexpr auto kKeep = [] {
    std::array<std::int32_t, 2 * kMomentLanes> keep{};
    for (std::size_t i = kMomentLanes; i < keep.size(); ++i)
        keep[i] = -1;
    return keep;
}();

template <typename Vector>
[[gnu::always_inline]] inline auto laneSum(const Vector& lanes) {
    auto sum = lanes[0];
    for (std::size_t i = 1; i < sizeof(lanes) / sizeof(lanes[0]); ++i)
        sum += lanes[i];
    return sum;
}

struct Strip {
    int row = 0;
    int rows = 0;
    int column = 0;
    int columns = 0;
};

// Sums weighted with the row come from sums of running sums, with w = rows of the strip - row in the strip:
// c0 = sum 1, c1 = sum w, c2 = sum w (w + 1) / 2; likewise load and weighted load.
template <bool activeOnly>
[[gnu::always_inline]] inline void addStrip(FrameMoments& moments, const float* values,
                                            const FrameShape& shape, const Strip& strip, float threshold) {
    HalfDoubles load{}, loadX{}, loadY{};
    Words count{}, countY{}, countYY{}, unusable{};
    Floats countX{}, countXX{}, countXY{}, peak{};

    const double centre = 0.5 * (shape.columns - 1) - strip.column;
    Floats x{0, 1, 2, 3};
    HalfDoubles xLow{0, 1}, xHigh{2, 3};
    xLow -= centre;
    xHigh -= centre;
    for (int column = 0; column < strip.columns; column += kMomentLanes) {
        // The last group ends with the strip and skips the columns that the group before it has counted.
        const int counted = std::max(0, column + kMomentLanes - strip.columns);
        Words keep;
        std::memcpy(&keep, kKeep.data() + kMomentLanes - counted, sizeof(keep));
        x -= static_cast<float>(counted);
        xLow -= static_cast<double>(counted);
        xHigh -= static_cast<double>(counted);

        HalfDoubles low{}, high{}, lowY{}, highY{};
        Words c0{}, c1{}, c2{};
        const float* row =
            values + static_cast<std::ptrdiff_t>(strip.row) * shape.stride + strip.column + column - counted;
        for (int r = 0; r < strip.rows; ++r, row += shape.stride) {
            Words bits;
            std::memcpy(&bits, row, sizeof(bits));
            bits &= keep;
            // Sets the sign bit of every value that is negative, infinite or NaN.
            unusable |= bits | reinterpret_cast<Words>(reinterpret_cast<UnsignedWords>(bits) + 0x00800000U);
            const auto value = reinterpret_cast<Floats>(bits);
            const Words active = value >= threshold;
            peak = value > peak ? value : peak;
            const auto counts = activeOnly ? reinterpret_cast<Floats>(bits & active) : value;
            const Doubles wide = __builtin_convertvector(counts, Doubles);
            std::array<HalfDoubles, 2> halves;
            std::memcpy(halves.data(), &wide, sizeof(wide));
            low += halves[0];
            high += halves[1];
            lowY += low;
            highY += high;
            c0 -= active;
            c1 += c0;
            c2 += c1;
        }
        load += low + high;
        loadX += low * xLow + high * xHigh;
        loadY += lowY + highY;
        const Floats countsX = __builtin_convertvector(c0, Floats) * x;
        count += c0;
        countX += countsX;
        countXX += countsX * x;
        countXY += __builtin_convertvector(c1, Floats) * x;
        countY += c1;
        countYY += c2;
        x += static_cast<float>(kMomentLanes);
        xLow += static_cast<double>(kMomentLanes);
        xHigh += static_cast<double>(kMomentLanes);
    }

    const double stripLoad = laneSum(load);
    const int end = strip.row + strip.rows;
    moments.sum += stripLoad;
    moments.sumX += laneSum(loadX);
    moments.sumY += (end - 0.5 * (shape.rows - 1)) * stripLoad - laneSum(loadY);

    const std::int64_t n = laneSum(count);
    const auto stripX = static_cast<std::int64_t>(laneSum(countX));
    const auto stripXX = static_cast<std::int64_t>(laneSum(countXX));
    const auto stripXW = static_cast<std::int64_t>(laneSum(countXY));
    const std::int64_t stripW = laneSum(countY);
    const std::int64_t stripWW = 2 * static_cast<std::int64_t>(laneSum(countYY)) - stripW;
    const std::int64_t left = strip.column;
    moments.active += n;
    moments.x += stripX + left * n;
    moments.xx += stripXX + left * (2 * stripX + left * n);
    moments.y += end * n - stripW;
    moments.yy += end * (end * n - 2 * stripW) + stripWW;
    moments.xy += end * (stripX + left * n) - stripXW - left * stripW;

    for (int i = 0; i < kMomentLanes; ++i) {
        moments.peak = std::max(moments.peak, peak[i]);
        moments.unusable = moments.unusable || unusable[i] < 0;
    }
}

template <bool activeOnly>
FrameMoments addStrips(const float* values, const FrameShape& shape, float threshold) {
    FrameMoments moments;
    Strip strip;
    for (strip.row = 0; strip.row < shape.rows; strip.row += kStripRows) {
        strip.rows = std::min(kStripRows, shape.rows - strip.row);
        for (strip.column = 0; strip.column < shape.stride; strip.column += kStripColumns) {
            strip.columns = std::min(kStripColumns, shape.stride - strip.column);
            addStrip<activeOnly>(moments, values, shape, strip, threshold);
        }
    }
    return moments;
}

} // namespace

FrameMoments momentsOf(const float* values, const FrameShape& shape, float threshold, bool activeOnly) {
    return activeOnly ? addStrips<true>(values, shape, threshold)
                      : addStrips<false>(values, shape, threshold);
}

} // namespace teleta::contact
