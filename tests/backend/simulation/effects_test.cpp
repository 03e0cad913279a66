// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"
#include "backend/simulation/base/timed_effects.h"
#include "backend/simulation/effects/gain_spread.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>
#include <vector>

using namespace teleta;
using namespace teleta::simulation;
using core::ArrayLayout;
using core::RandomStream;

namespace {

const ArrayLayout kLayout{6, 14, 0.0034};

/// The effect as a scene with such an array gets it.
template <typename Spec>
std::unique_ptr<TaxelEffect> made(const Spec& spec, const ArrayLayout& layout = kLayout,
                                  double step_s = 0.005, std::uint64_t seed = 1, double fullScale_N = 2.89) {
    scene::Scene scene;
    scene.array().sensor = {.layout = layout, .fullScale_N = fullScale_N};
    return std::make_unique<TaxelEffect>(makeEffect(Listed<Spec>{spec, scene, seed, step_s}));
}

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

} // namespace

TEST(Noise, addsIndependentValuesOfTheStatedDeviation) {
    const auto noise = made(scene::NoiseSpec{.sd_N = 0.05});
    constexpr int kFrames = 2000;
    const double count = kFrames * 84.0;
    double mean = 0.0, square = 0.0, inTime = 0.0, inSpace = 0.0;
    std::vector<double> last(84, 0.0);
    for (int frame = 0; frame < kFrames; ++frame) {
        std::vector<double> load_N(84, 2.0);
        noise->apply(load_N);
        for (std::size_t i = 0; i < load_N.size(); ++i) {
            load_N[i] = (load_N[i] - 2.0) / 0.05;
            mean += load_N[i] / count;
            square += load_N[i] * load_N[i] / count;
            inTime += load_N[i] * last[i] / count;
            if (i > 0)
                inSpace += load_N[i] * load_N[i - 1] / count;
        }
        last = load_N;
    }
    const double standardError = 1.0 / std::sqrt(count);
    EXPECT_NEAR(mean, 0.0, 5.0 * standardError);
    EXPECT_NEAR(square, 1.0, 5.0 * std::sqrt(2.0) * standardError);
    EXPECT_NEAR(inTime, 0.0, 5.0 * standardError);
    EXPECT_NEAR(inSpace, 0.0, 5.0 * standardError);
}

TEST(Quantization, roundsToTheNearestStep) {
    const auto quantization = made(scene::QuantizationSpec{.step_N = 0.25});
    std::vector<double> load_N{0.0, 0.12, 0.13, 0.25, 1.1, -0.13, 1e6 + 0.2};
    quantization->apply(load_N);
    EXPECT_EQ(load_N, (std::vector<double>{0.0, 0.0, 0.25, 0.25, 1.0, -0.25, 1e6 + 0.25}));
}

TEST(Saturation, limitsReadingsToTheScale) {
    const auto saturation = made(scene::SaturationSpec{}, kLayout, 0.005, 1, 2.89);
    std::vector<double> load_N{-0.1, 0.0, 1.0, 2.89, 2.9, 1e9};
    saturation->apply(load_N);
    EXPECT_EQ(load_N, (std::vector<double>{0.0, 0.0, 1.0, 2.89, 2.89, 2.89}));
}

TEST(DeadTaxels, readTheirValueWhateverTheirLoad) {
    const auto named = made(scene::DeadTaxelsSpec{
        .taxels = {{.row = 0, .column = 0}, {.row = 5, .column = 13}}, .count = 0, .reading_N = 0.7});
    std::vector<double> load_N(84, 2.0);
    named->apply(load_N);
    EXPECT_EQ(load_N[0], 0.7);
    EXPECT_EQ(load_N[83], 0.7);
    EXPECT_EQ(std::count(load_N.begin(), load_N.end(), 2.0), 82);

    const auto nan = made(
        scene::DeadTaxelsSpec{.taxels = {{.row = 1, .column = 2}}, .count = 0, .reading_N = std::nan("")});
    nan->apply(load_N);
    EXPECT_TRUE(std::isnan(load_N[16]));
}

TEST(DeadTaxels, areSoManyAndOthersWithAnotherSeed) {
    std::set<std::vector<double>> patterns;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const auto drawn =
            made(scene::DeadTaxelsSpec{.taxels = {}, .count = 5, .reading_N = 0.0}, kLayout, 0.005, seed);
        std::vector<double> load_N(84, 1.0);
        drawn->apply(load_N);
        EXPECT_EQ(sum(load_N), 79.0);
        std::vector<double> again(84, 1.0);
        drawn->apply(again);
        EXPECT_EQ(again, load_N) << "the same taxels stay dead";
        patterns.insert(load_N);
    }
    EXPECT_GE(patterns.size(), 49U);
    const auto all = made(scene::DeadTaxelsSpec{.taxels = {}, .count = 84, .reading_N = 0.0});
    std::vector<double> load_N(84, 1.0);
    all->apply(load_N);
    EXPECT_EQ(sum(load_N), 0.0);
}

TEST(Crosstalk, handsTheStatedShareToTheFourNeighbours) {
    const auto crosstalk = made(scene::CrosstalkSpec{.share = 0.2});
    std::vector<double> load_N(84, 0.0);
    load_N[2 * 14 + 5] = 4.0;
    crosstalk->apply(load_N);
    EXPECT_DOUBLE_EQ(load_N[2 * 14 + 5], 3.2);
    for (const int neighbour : {2 * 14 + 4, 2 * 14 + 6, 1 * 14 + 5, 3 * 14 + 5})
        EXPECT_DOUBLE_EQ(load_N[static_cast<std::size_t>(neighbour)], 0.2);
    EXPECT_DOUBLE_EQ(sum(load_N), 4.0);
}

TEST(Crosstalk, keepsAtTheBorderWhatHasNoNeighbour) {
    const auto crosstalk = made(scene::CrosstalkSpec{.share = 0.2});
    std::vector<double> load_N(84, 0.0);
    load_N[13] = 4.0; // the corner of the first row: nothing may reach the start of the second row
    crosstalk->apply(load_N);
    EXPECT_DOUBLE_EQ(load_N[13], 3.6);
    EXPECT_DOUBLE_EQ(load_N[12], 0.2);
    EXPECT_DOUBLE_EQ(load_N[27], 0.2);
    EXPECT_EQ(load_N[14], 0.0);
}

TEST(Crosstalk, conservesTheTotalAndLeavesAnEvenLoadAlone) {
    RandomStream random(1, "load");
    for (const double share : {0.0, 0.3, 1.0}) {
        const auto crosstalk = made(scene::CrosstalkSpec{.share = share});
        std::vector<double> even(84, 1.5);
        crosstalk->apply(even);
        EXPECT_EQ(even, std::vector<double>(84, 1.5));
        std::vector<double> load_N(84);
        for (double& load : load_N)
            load = random.uniform();
        const double before_N = sum(load_N);
        crosstalk->apply(load_N);
        EXPECT_NEAR(sum(load_N), before_N, 1e-12);
        for (const double load : load_N)
            EXPECT_GE(load, 0.0);
    }
    const auto single = made(scene::CrosstalkSpec{.share = 1.0}, ArrayLayout{1, 1, 0.01});
    std::vector<double> one{3.0};
    single->apply(one);
    EXPECT_EQ(one[0], 3.0);
}

// A load that rises to X and falls to 0: y = x; then y = X while x > X/(1+h); then y = (1+h) x.
TEST(Hysteresis, followsItsTwoBranchesAndEnclosesTheStatedArea) {
    constexpr double kShare = 0.25;
    constexpr double kPeak_N = 2.0;
    constexpr int kSteps = 10'000;
    const auto hysteresis = made(scene::HysteresisSpec{.share = kShare}, ArrayLayout{1, 1, 0.01});
    double area_N2 = 0.0;
    const auto reading_N = [&](double load_N) {
        std::vector<double> value{load_N};
        hysteresis->apply(value);
        return value[0];
    };
    for (int i = 0; i <= kSteps; ++i) {
        const double load_N = kPeak_N * i / kSteps;
        const double y_N = reading_N(load_N);
        ASSERT_DOUBLE_EQ(y_N, load_N);
        area_N2 -= y_N * kPeak_N / kSteps;
    }
    for (int i = kSteps; i >= 0; --i) {
        const double load_N = kPeak_N * i / kSteps;
        const double y_N = reading_N(load_N);
        ASSERT_NEAR(y_N, std::min(kPeak_N, (1.0 + kShare) * load_N), 1e-12);
        area_N2 += y_N * kPeak_N / kSteps;
    }
    EXPECT_NEAR(area_N2, kPeak_N * kPeak_N * kShare / (2.0 * (1.0 + kShare)), 1e-3);
    EXPECT_EQ(reading_N(0.0), 0.0);
}

TEST(Hysteresis, doesNotDependOnSpeedAndStaysWithinItsBranches) {
    RandomStream random(1, "load");
    const auto slow = made(scene::HysteresisSpec{.share = 0.3}, ArrayLayout{1, 1, 0.01});
    const auto fast = made(scene::HysteresisSpec{.share = 0.3}, ArrayLayout{1, 1, 0.01});
    double from_N = 0.0;
    for (int i = 0; i < 200; ++i) {
        const double to_N = random.uniform();
        std::vector<double> value{to_N};
        fast->apply(value);
        std::vector<double> inSteps;
        for (int k = 1; k <= 10; ++k) {
            inSteps.assign(1, from_N + (to_N - from_N) * k / 10.0);
            slow->apply(inSteps);
        }
        EXPECT_NEAR(value[0], inSteps[0], 1e-12);
        EXPECT_GE(value[0], to_N);
        EXPECT_LE(value[0], 1.3 * to_N + 1e-12);
        from_N = to_N;
    }
}

TEST(Drift, hasTheStatedVarianceAtEveryTime) {
    constexpr double kStep_s = 0.005;
    constexpr double kTime_s = 2.0;
    const ArrayLayout large{100, 100, 0.01};
    const auto drift = made(scene::DriftSpec{.sd_N = 0.1, .timeConstant_s = kTime_s}, large, kStep_s);
    std::vector<double> first;
    for (int frame = 1; frame <= 1600; ++frame) {
        std::vector<double> load_N(large.taxels(), 0.0);
        drift->apply(load_N);
        if (frame != 40 && frame != 400 && frame != 1600)
            continue;
        double mean = 0.0, square = 0.0;
        for (const double value : load_N) {
            mean += value / 1e4;
            square += value * value / 1e4;
        }
        const double expected = 0.01 * (1.0 - std::exp(-2.0 * frame * kStep_s / kTime_s));
        EXPECT_NEAR(square / expected, 1.0, 5.0 * std::sqrt(2.0 / 1e4)) << frame;
        EXPECT_NEAR(mean, 0.0, 5.0 * std::sqrt(expected / 1e4)) << frame;
    }
}

TEST(Drift, doesNotDependOnTheFrameRate) {
    // Values a second apart are correlated by exp(-1 s / tau) at any rate.
    const ArrayLayout large{100, 100, 0.01};
    for (const int rate_Hz : {1, 20}) {
        const auto drift = made(scene::DriftSpec{.sd_N = 1.0, .timeConstant_s = 2.0}, large, 1.0 / rate_Hz);
        std::vector<double> early(large.taxels()), late;
        for (int frame = 0; frame < 30 * rate_Hz; ++frame) {
            early.assign(large.taxels(), 0.0);
            drift->apply(early);
        }
        for (int frame = 0; frame < rate_Hz; ++frame) {
            late.assign(large.taxels(), 0.0);
            drift->apply(late);
        }
        const double product = std::inner_product(early.begin(), early.end(), late.begin(), 0.0) / 1e4;
        EXPECT_NEAR(product, std::exp(-0.5), 5.0 * std::sqrt(2.0 / 1e4));
    }
}

TEST(Drift, staysFiniteForAnEndlessTimeConstant) {
    const auto drift =
        made(scene::DriftSpec{.sd_N = 1.0, .timeConstant_s = 1e12}, ArrayLayout{1, 1, 0.01}, 1e-3);
    std::vector<double> load_N{0.0};
    drift->apply(load_N);
    // sd sqrt(2 dt/tau), not 0 by cancellation
    EXPECT_GT(std::abs(load_N[0]), 1e-9);
    EXPECT_LT(std::abs(load_N[0]), 1e-6);
}

TEST(Latency, aRampReadsWhatItWasSoManyFramesAgo) {
    // 37 ms are 7.4 frames of 5 ms: 7 of them.
    TimedEffects<TaxelEffect> latency({*made(scene::LatencySpec{.delay_s = 0.037})});
    for (int run = 0; run < 2; ++run) {
        for (int frame = 0; frame < 30; ++frame) {
            std::vector<double> load_N(84);
            for (std::size_t i = 0; i < load_N.size(); ++i)
                load_N[i] = frame + 0.01 * static_cast<double>(i);
            latency.apply([&](TaxelEffect& effect) { effect.apply(load_N); });
            for (std::size_t i = 0; i < load_N.size(); ++i)
                ASSERT_EQ(load_N[i], frame < 7 ? 0.0 : frame - 7 + 0.01 * static_cast<double>(i));
        }
        latency.restart();
    }
}

TEST(Latency, oneShorterThanHalfAFrameIsNone) {
    const auto latency = made(scene::LatencySpec{.delay_s = 0.002});
    std::vector<double> load_N(84, 1.5);
    latency->apply(load_N);
    EXPECT_EQ(load_N, std::vector<double>(84, 1.5));
}

TEST(GainSpread, multipliesEachTaxelWithItsOwnFactor) {
    const scene::GainSpreadSpec spec{.sd = 0.2};
    const std::vector<double> factors = gainFactors(spec, 5000, RandomStream(1, "gain_spread"));
    double mean = 0.0;
    double squares = 0.0;
    for (const double factor : factors) {
        mean += std::log(factor) / 5000.0;
        squares += std::log(factor) * std::log(factor) / 5000.0;
    }
    EXPECT_NEAR(mean, 0.0, 4.0 * 0.2 / std::sqrt(5000.0));
    EXPECT_NEAR(std::sqrt(squares), 0.2, 4.0 * 0.2 / std::sqrt(10000.0));

    const auto spread = made(spec, ArrayLayout{1, 3, 0.01});
    const std::vector<double> three = gainFactors(spec, 3, RandomStream(1, "gain_spread"));
    std::vector<double> load_N{1.0, 2.0, 0.0};
    spread->apply(load_N);
    spread->apply(load_N);
    EXPECT_EQ(load_N, (std::vector<double>{three[0] * three[0], 2.0 * three[1] * three[1], 0.0}));
}

TEST(NonlinearResponse, isExactAtBothEndsAndWrongByTheBowHalfWay) {
    for (const double bow : {-0.25, -0.1, 0.0, 0.1, 0.25}) {
        const auto response = made(scene::NonlinearResponseSpec{.bow = bow}, kLayout, 0.005, 1, 2.0);
        std::vector<double> load_N{0.0, 0.5, 1.0, 1.5, 2.0, -1.0, 3.0};
        response->apply(load_N);
        EXPECT_EQ(load_N[0], 0.0);
        EXPECT_NEAR(load_N[1], 0.5 + 0.75 * bow * 2.0, 1e-15);
        EXPECT_NEAR(load_N[2], 1.0 + bow * 2.0, 1e-15);
        EXPECT_NEAR(load_N[3], 1.5 + 0.75 * bow * 2.0, 1e-15);
        EXPECT_EQ(load_N[4], 2.0);
        EXPECT_NEAR(load_N[5], -1.0 - 4.0 * bow, 1e-15);
        EXPECT_NEAR(load_N[6], 2.0 + (1.0 - 4.0 * bow), 1e-15);
    }
}

TEST(NonlinearResponse, risesWithTheLoadEverywhere) {
    for (const double bow : {-0.25, 0.25}) {
        const auto response = made(scene::NonlinearResponseSpec{.bow = bow}, kLayout, 0.005, 1, 2.89);
        std::vector<double> load_N(600);
        for (std::size_t i = 0; i < load_N.size(); ++i)
            load_N[i] = -1.0 + 0.01 * static_cast<double>(i);
        response->apply(load_N);
        for (std::size_t i = 1; i < load_N.size(); ++i)
            EXPECT_GE(load_N[i], load_N[i - 1]) << i;
    }
}
