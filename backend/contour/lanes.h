// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
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
