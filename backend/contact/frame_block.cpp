// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/frame_block.h"

#include <bit>
#include <cstring>

namespace teleta::contact {

namespace {

// Vector extension of GCC and Clang, available on every target. A vector of doubles has half as many lanes,
// so that all vectors are as wide as the processor's.
template <std::size_t lanes>
struct Wide {
    using Floats [[gnu::vector_size(4 * lanes)]] = float;
    using HalfFloats [[gnu::vector_size(2 * lanes)]] = float;
    using Words [[gnu::vector_size(4 * lanes)]] = std::int32_t;
    using Doubles [[gnu::vector_size(4 * lanes)]] = double;
};

/// Writes four taxels of four frames side by side.
[[gnu::always_inline]] inline void transposeSquare(const float* const* frames, std::size_t taxel,
                                                   Wide<4>::Floats (&out)[4]) {
    using Floats = Wide<4>::Floats;
    Floats a, b, c, d;
    std::memcpy(&a, frames[0] + taxel, sizeof(a));
    std::memcpy(&b, frames[1] + taxel, sizeof(b));
    std::memcpy(&c, frames[2] + taxel, sizeof(c));
    std::memcpy(&d, frames[3] + taxel, sizeof(d));
    const Floats lowAB = __builtin_shufflevector(a, b, 0, 4, 1, 5);
    const Floats highAB = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    const Floats lowCD = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    const Floats highCD = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    out[0] = __builtin_shufflevector(lowAB, lowCD, 0, 1, 4, 5);
    out[1] = __builtin_shufflevector(lowAB, lowCD, 2, 3, 6, 7);
    out[2] = __builtin_shufflevector(highAB, highCD, 0, 1, 4, 5);
    out[3] = __builtin_shufflevector(highAB, highCD, 2, 3, 6, 7);
}

/// Eight taxels of four frames: a square of 4 x 4 in each half of the vectors.
[[gnu::always_inline]] inline void transposeSquares(const float* const* frames, std::size_t taxel,
                                                    Wide<8>::Floats (&out)[4]) {
    using Floats = Wide<8>::Floats;
    Floats a, b, c, d;
    std::memcpy(&a, frames[0] + taxel, sizeof(a));
    std::memcpy(&b, frames[1] + taxel, sizeof(b));
    std::memcpy(&c, frames[2] + taxel, sizeof(c));
    std::memcpy(&d, frames[3] + taxel, sizeof(d));
    const Floats lowAB = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
    const Floats highAB = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
    const Floats lowCD = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
    const Floats highCD = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
    out[0] = __builtin_shufflevector(lowAB, lowCD, 0, 1, 8, 9, 4, 5, 12, 13);
    out[1] = __builtin_shufflevector(lowAB, lowCD, 2, 3, 10, 11, 6, 7, 14, 15);
    out[2] = __builtin_shufflevector(highAB, highCD, 0, 1, 8, 9, 4, 5, 12, 13);
    out[3] = __builtin_shufflevector(highAB, highCD, 2, 3, 10, 11, 6, 7, 14, 15);
}

/// Eight taxels of eight frames.
[[gnu::always_inline]] inline void transposeSquare(const float* const* frames, std::size_t taxel,
                                                   Wide<8>::Floats (&out)[8]) {
    Wide<8>::Floats front[4];
    Wide<8>::Floats back[4];
    transposeSquares(frames, taxel, front);
    transposeSquares(frames + 4, taxel, back);
    for (std::size_t i = 0; i < 4; ++i) {
        out[i] = __builtin_shufflevector(front[i], back[i], 0, 1, 2, 3, 8, 9, 10, 11);
        out[i + 4] = __builtin_shufflevector(front[i], back[i], 4, 5, 6, 7, 12, 13, 14, 15);
    }
}

/// Writes the taxels of `lanes` frames side by side.
template <std::size_t lanes>
[[gnu::always_inline]] inline void interleave(const float* const* frames, std::size_t taxels, float* out) {
    if (taxels < lanes) {
        for (std::size_t taxel = 0; taxel < taxels; ++taxel)
            for (std::size_t lane = 0; lane < lanes; ++lane)
                out[taxel * lanes + lane] = frames[lane][taxel];
        return;
    }
    for (std::size_t next = 0; next < taxels; next += lanes) {
        // The last square ends with the frame and repeats taxels of the one before it.
        const std::size_t taxel = next + lanes <= taxels ? next : taxels - lanes;
        typename Wide<lanes>::Floats square[lanes];
        transposeSquare(frames, taxel, square);
        for (std::size_t i = 0; i < lanes; ++i)
            std::memcpy(out + (taxel + i) * lanes, &square[i], sizeof(square[i]));
    }
}

// Sums weighted with column or row come from sums of running sums: w counts from the last column or row,
// which has 1. ww sums w (w + 1) / 2.
template <std::size_t lanes, bool activeOnly>
[[gnu::always_inline]] inline void addLanes(const float* values, const core::ArrayLayout& layout,
                                            float threshold, std::size_t first, BlockMoments& moments) {
    using Floats = typename Wide<lanes>::Floats;
    using HalfFloats = typename Wide<lanes>::HalfFloats;
    using Words = typename Wide<lanes>::Words;
    using Doubles = typename Wide<lanes>::Doubles;
    Doubles low{}, high{}, lowX{}, highX{}, lowY{}, highY{};
    Words n{}, nX{}, nXX{}, nY{}, nYY{}, nXY{};
    for (int row = 0; row < layout.rows; ++row) {
        Doubles rowLow{}, rowHigh{};
        Words rowN{}, rowX{};
        for (int column = 0; column < layout.columns; ++column, values += lanes) {
            Words bits;
            std::memcpy(&bits, values, sizeof(bits));
            const Words active = reinterpret_cast<Floats>(bits) >= threshold;
            if constexpr (activeOnly)
                bits &= active;
            std::array<HalfFloats, 2> halves;
            std::memcpy(halves.data(), &bits, sizeof(bits));
            rowLow += __builtin_convertvector(halves[0], Doubles);
            rowHigh += __builtin_convertvector(halves[1], Doubles);
            lowX += rowLow;
            highX += rowHigh;
            rowN -= active;
            rowX += rowN;
            nXX += rowX;
        }
        low += rowLow;
        high += rowHigh;
        lowY += low;
        highY += high;
        n += rowN;
        nY += n;
        nYY += nY;
        nX += rowX;
        nXY += nX;
    }

    const double toX = 0.5 * (layout.columns + 1);
    const double toY = 0.5 * (layout.rows + 1);
    const auto keep = [first](auto& each, const auto& vector, std::size_t offset = 0) {
        std::memcpy(each.data() + first + offset, &vector, sizeof(vector));
    };
    keep(moments.sum, low);
    keep(moments.sum, high, lanes / 2);
    keep(moments.sumX, Doubles(toX * low - lowX));
    keep(moments.sumX, Doubles(toX * high - highX), lanes / 2);
    keep(moments.sumY, Doubles(toY * low - lowY));
    keep(moments.sumY, Doubles(toY * high - highY), lanes / 2);

    const int columns = layout.columns;
    const int rows = layout.rows;
    const Words x = columns * n - nX;
    const Words y = rows * n - nY;
    keep(moments.active, n);
    keep(moments.x, x);
    keep(moments.y, y);
    keep(moments.xx, Words(columns * (x - nX) + 2 * nXX - nX));
    keep(moments.yy, Words(rows * (y - nY) + 2 * nYY - nY));
    keep(moments.xy, Words(nXY - columns * rows * n + columns * y + rows * x));
}

template <std::size_t lanes>
[[gnu::always_inline]] inline void addBlock(const std::array<const float*, kBlockFrames>& frames,
                                            const core::ArrayLayout& layout, float threshold, bool activeOnly,
                                            float* buffer, BlockMoments& moments) {
    for (std::size_t first = 0; first < kBlockFrames; first += lanes) {
        interleave<lanes>(frames.data() + first, layout.taxels(), buffer);
        if (activeOnly)
            addLanes<lanes, true>(buffer, layout, threshold, first, moments);
        else
            addLanes<lanes, false>(buffer, layout, threshold, first, moments);
    }
}

#ifdef __x86_64__
// AVX2 without fused multiplication, so that the sums are those of every other processor.
[[gnu::target("avx2")]] void addBlockAvx2(const std::array<const float*, kBlockFrames>& frames,
                                          const core::ArrayLayout& layout, float threshold, bool activeOnly,
                                          float* buffer, BlockMoments& moments) {
    addBlock<8>(frames, layout, threshold, activeOnly, buffer, moments);
}
#endif

} // namespace

bool isUsable(const float* values, std::size_t count) {
    // Sets the sign bit for every value that is negative, infinite or NaN.
    std::uint32_t any = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto bits = std::bit_cast<std::uint32_t>(values[i]);
        any |= bits | (bits + 0x00800000U);
    }
    return any >> 31 == 0;
}

void momentsOfBlockAnywhere(const std::array<const float*, kBlockFrames>& frames,
                            const core::ArrayLayout& layout, float threshold, bool activeOnly, float* lanes,
                            BlockMoments& moments) {
    addBlock<4>(frames, layout, threshold, activeOnly, lanes, moments);
}

void momentsOfBlock(const std::array<const float*, kBlockFrames>& frames, const core::ArrayLayout& layout,
                    float threshold, bool activeOnly, float* lanes, BlockMoments& moments) {
#ifdef __x86_64__
    static const bool hasAvx2 = __builtin_cpu_supports("avx2") != 0;
    if (hasAvx2) {
        addBlockAvx2(frames, layout, threshold, activeOnly, lanes, moments);
        return;
    }
#endif
    momentsOfBlockAnywhere(frames, layout, threshold, activeOnly, lanes, moments);
}

} // namespace teleta::contact
