// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace teleta::contour {

/// Several numbers that are computed at once. Passed by reference, so that no call depends on the processor.
inline constexpr std::size_t kLanes = 4;
using Lanes [[gnu::vector_size(8 * kLanes)]] = double;

[[gnu::always_inline]] inline void load(Lanes& lanes, const double* from) {
    std::memcpy(&lanes, from, sizeof(lanes));
}

/// The numbers less an origin.
[[gnu::always_inline]] inline void load(Lanes& lanes, const double* from, double origin) {
    load(lanes, from);
    lanes -= origin;
}

[[gnu::always_inline]] inline void store(double* to, const Lanes& lanes) {
    std::memcpy(to, &lanes, sizeof(lanes));
}

[[gnu::always_inline]] inline double sumOf(const Lanes& lanes) {
    return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

/// Replaces numbers by their square roots.
[[gnu::always_inline]] inline void takeRoots(Lanes& lanes) {
    lanes = Lanes{__builtin_sqrt(lanes[0]), __builtin_sqrt(lanes[1]), __builtin_sqrt(lanes[2]),
                  __builtin_sqrt(lanes[3])};
}

/// Replaces numbers, at most 700, by their exponentials, off by 4e-16 of them at most; below -700 as at -700.
/// 2^k by the exponent's bits times the Taylor series of what is left, at most ln 2 / 2.
[[gnu::always_inline]] inline void takeExponentials(Lanes& numbers) {
    constexpr double kPerLn2 = 1.4426950408889634;
    constexpr double kLn2High = 0x1.62e42feep-1; // exact when multiplied by a power's number
    constexpr double kLn2Low = 0x1.a39ef35793c76p-33;
    constexpr double kRound = 0x1.8p52; // adding it leaves the nearest whole number in the lowest bits
    using Bits [[gnu::vector_size(8 * kLanes)]] = std::int64_t;
    const Lanes x = numbers < -700.0 ? -700.0 - Lanes{} : numbers;
    const Lanes rounded = x * kPerLn2 + kRound;
    const Lanes power = rounded - kRound;
    const Lanes rest = (x - power * kLn2High) - power * kLn2Low;
    constexpr double kFactors[] = {1.0 / 6227020800.0, 1.0 / 479001600.0, 1.0 / 39916800.0, 1.0 / 3628800.0,
                                   1.0 / 362880.0,     1.0 / 40320.0,     1.0 / 5040.0,     1.0 / 720.0,
                                   1.0 / 120.0,        1.0 / 24.0,        1.0 / 6.0,        0.5};
    Lanes series = kFactors[0] - Lanes{};
    for (std::size_t k = 1; k < 12; ++k)
        series = series * rest + kFactors[k];
    series = series * rest * rest + rest + 1.0;
    Bits bits, shift;
    std::memcpy(&bits, &series, sizeof(bits));
    std::memcpy(&shift, &rounded, sizeof(shift));
    bits += shift << 52;
    std::memcpy(&numbers, &bits, sizeof(bits));
}

#ifdef __x86_64__
/// The processor must have AVX2.
template <typename Work>
[[gnu::target("avx2")]] void doWithAvx2(const Work& work) {
    work();
}
#endif

/// Does the work with the widest instructions that the processor has. Work: its operator() is always_inline
/// and calls nothing that is not. Results are the same bits on every x86-64 processor: it uses AVX2
/// without fused multiplication (FMA). Other processors may round differently.
template <typename Work>
void doInLanes(const Work& work) {
#ifdef __x86_64__
    static const bool hasAvx2 = __builtin_cpu_supports("avx2") != 0;
    if (hasAvx2)
        return doWithAvx2(work);
#endif
    work();
}

} // namespace teleta::contour
