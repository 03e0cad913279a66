// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/lanes.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace teleta::contour {

#ifdef __x86_64__
TEST(Lanes, areTheSameBitsWithAvx2AsWithout) {
    if (!__builtin_cpu_supports("avx2"))
        GTEST_SKIP() << "this processor has no AVX2";
    // Sums of products, which fused multiplication would round once less, of numbers of all sizes.
    constexpr std::size_t kCount = 4096;
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
    std::uniform_int_distribution<int> exponent(-40, 40);
    std::vector<double> numbers(2 * kCount);
    for (double& number : numbers)
        number = std::ldexp(mantissa(random), exponent(random));
    const double* const x = numbers.data();
    const double* const y = x + kCount;
    const auto resultsOf = [&](const auto& doIt) {
        std::vector<double> results(3 * kCount + 1);
        double* const out = results.data();
        doIt([&]() __attribute__((always_inline)) {
            Lanes sums{};
            for (std::size_t i = 0; i < kCount; i += kLanes) {
                Lanes a, b;
                load(a, x + i);
                load(b, y + i);
                const Lanes square = a * a + b * b;
                const Lanes side = 0.3 * a - b * 0.7;
                store(out + i, square);
                store(out + kCount + i, side);
                store(out + 2 * kCount + i, (side < a ? side : a * b) / (1.0 + square));
                sums += a * b;
            }
            out[3 * kCount] = sumOf(sums) * x[0] + y[0];
        });
        return results;
    };
    const std::vector<double> plain = resultsOf([](const auto& work) { work(); });
    const std::vector<double> wide = resultsOf([](const auto& work) { doWithAvx2(work); });
    std::size_t others = 0;
    for (std::size_t i = 0; i < plain.size(); ++i)
        others += std::bit_cast<std::uint64_t>(plain[i]) == std::bit_cast<std::uint64_t>(wide[i]) ? 0 : 1;
    EXPECT_EQ(others, 0U);
    EXPECT_NE(plain[0], 0.0);
}
#endif

} // namespace teleta::contour
