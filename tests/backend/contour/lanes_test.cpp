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

TEST(Lanes, exponentialsAndRootsAreThoseOfTheLibrary) {
    for (double x = -700.0; x < 700.0; x += 0.37) {
        Lanes numbers{x, -1e-9 * x, 0.01 * x, -5000.0};
        Lanes roots{std::abs(x), 0.0, 2.0, 1e-300};
        takeExponentials(numbers);
        takeRoots(roots);
        const double expected[] = {std::exp(x), std::exp(-1e-9 * x), std::exp(0.01 * x), std::exp(-700.0)};
        for (std::size_t lane = 0; lane < kLanes; ++lane)
            ASSERT_NEAR(numbers[lane] / expected[lane], 1.0, 5e-16) << x << ' ' << lane;
        ASSERT_EQ(roots[0], std::sqrt(std::abs(x)));
        ASSERT_EQ(roots[1], 0.0);
        ASSERT_EQ(roots[2], std::sqrt(2.0));
        ASSERT_EQ(roots[3], 1e-150);
    }
}

} // namespace teleta::contour
