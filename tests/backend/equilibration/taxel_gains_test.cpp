// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/equilibration/taxel_gains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

using namespace teleta;
using namespace teleta::equilibration;

namespace {

constexpr core::ArrayLayout kLayout{.rows = 6, .columns = 14, .pitchX_m = 0.0034};

/// An array whose responses are known, and presses on it.
struct Bench {
    core::ArrayLayout layout = kLayout;
    std::vector<double> response = std::vector<double>(kLayout.taxels(), 1.0);
    std::mt19937_64 random{7};

    explicit Bench(double spread = 0.0) {
        std::normal_distribution<double> normal;
        for (double& value : response)
            value = std::exp(spread * normal(random));
    }

    using Load = std::function<double(std::size_t frame)>;
    using Unevenness = std::function<double(std::size_t taxel)>;

    /// Frames under load(frame) * unevenness(taxel), with noise, and steps of the readings when step > 0.
    [[nodiscard]] std::vector<float> press(std::size_t frames, const Load& load, double noise = 0.0,
                                           double step = 0.0, const Unevenness& unevenness = {}) {
        std::normal_distribution<double> normal;
        std::vector<float> raw;
        for (std::size_t frame = 0; frame < frames; ++frame) {
            for (std::size_t taxel = 0; taxel < response.size(); ++taxel) {
                double value = load(frame) * response[taxel] * (unevenness ? unevenness(taxel) : 1.0) +
                               noise * normal(random);
                if (step > 0.0)
                    value = std::round(value / step) * step;
                raw.push_back(static_cast<float>(value));
            }
        }
        return raw;
    }

    /// What the gains should be: those that keep the mean response of the good taxels.
    [[nodiscard]] std::vector<double> expected(const TaxelGains& gains) const {
        double mean = 0.0;
        for (std::size_t i = 0; i < response.size(); ++i)
            mean += gains.taxels[i].isGood() ? response[i] / static_cast<double>(gains.good()) : 0.0;
        std::vector<double> all;
        for (std::size_t i = 0; i < response.size(); ++i)
            all.push_back(gains.taxels[i].isGood() ? mean / response[i] : 0.0);
        return all;
    }

    /// Largest relative error of a good taxel's gain.
    [[nodiscard]] double error(const TaxelGains& gains) const {
        const std::vector<double> truth = expected(gains);
        double largest = 0.0;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            if (gains.taxels[i].isGood())
                largest = std::max(largest, std::abs(gains.taxels[i].gain / truth[i] - 1.0));
        }
        return largest;
    }
};

Bench::Load steady(double load) {
    return [load](std::size_t) { return load; };
}

/// Up, held, and down again.
double ramp(std::size_t frame) {
    return 1.0 + 0.5 * std::sin(0.02 * static_cast<double>(frame));
}

core::Expected<TaxelGains> gainsOf(const std::vector<float>& press,
                                   const contact::ConditioningSettings& settings = {}) {
    return findTaxelGains(kLayout, std::array{GainPress{press, settings}});
}

core::Expected<TaxelGains> gainsOf(const std::vector<std::vector<float>>& presses) {
    std::vector<GainPress> all;
    for (const std::vector<float>& press : presses)
        all.push_back({press, {}});
    return findTaxelGains(kLayout, all);
}

} // namespace

TEST(TaxelGains, ofExactFramesAreExact) {
    Bench bench(0.3);
    const auto gains = gainsOf(bench.press(50, ramp));
    ASSERT_TRUE(gains) << describe(gains.error());
    EXPECT_EQ(gains->good(), kLayout.taxels());
    EXPECT_LT(bench.error(*gains), 1e-6) << "readings are single precision";
    EXPECT_FALSE(gains->isTilted);
    EXPECT_EQ(gains->presses, 1U);
    const std::vector<double> truth = bench.expected(*gains);
    ASSERT_TRUE(gains->range());
    EXPECT_NEAR(gains->range()->least, *std::ranges::min_element(truth), 1e-6);
    EXPECT_NEAR(gains->range()->greatest, *std::ranges::max_element(truth), 1e-5);
    EXPECT_FALSE(TaxelGains().range());
}

TEST(TaxelGains, keepTheForceOfAnEvenLoad) {
    Bench bench(0.3);
    const std::vector<float> press = bench.press(50, steady(2.0));
    const auto gains = gainsOf(press);
    ASSERT_TRUE(gains);
    double before = 0.0;
    double after = 0.0;
    for (std::size_t i = 0; i < kLayout.taxels(); ++i) {
        before += static_cast<double>(press[i]);
        after += static_cast<double>(press[i]) * gains->taxels[i].gain;
    }
    EXPECT_NEAR(after / before, 1.0, 1e-6);
    EXPECT_NEAR(gains->level, before / static_cast<double>(kLayout.taxels()), 1e-5);
}

TEST(TaxelGains, errorsAreAsLargeAsTheySay) {
    // Standardised errors of many taxels: 68 % within one standard error, 95 % within two.
    int within1 = 0;
    int within2 = 0;
    int all = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        Bench bench(0.2);
        bench.random.seed(seed);
        const auto gains = gainsOf(bench.press(200, ramp, 0.05));
        ASSERT_TRUE(gains);
        const std::vector<double> truth = bench.expected(*gains);
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const double error = std::abs(gains->taxels[i].gain - truth[i]);
            within1 += error <= gains->taxels[i].error ? 1 : 0;
            within2 += error <= 2.0 * gains->taxels[i].error ? 1 : 0;
            ++all;
        }
    }
    EXPECT_NEAR(static_cast<double>(within1) / all, 0.683, 0.04);
    EXPECT_NEAR(static_cast<double>(within2) / all, 0.954, 0.02);
}

TEST(TaxelGains, tareDirectionAndDeadTaxelsAreTaken) {
    Bench bench(0.2);
    std::vector<float> press = bench.press(40, ramp);
    contact::ConditioningSettings settings;
    settings.inverted = true;
    settings.tare.assign(kLayout.taxels(), 482.0F);
    settings.dead.assign(kLayout.taxels(), 0);
    settings.dead[5] = 1;
    settings.tare[6] = std::numeric_limits<float>::quiet_NaN();
    for (float& value : press)
        value = 482.0F - 100.0F * value;
    const auto gains = gainsOf(press, settings);
    ASSERT_TRUE(gains) << describe(gains.error());
    EXPECT_EQ(gains->taxels[5].state, TaxelState::dead);
    EXPECT_EQ(gains->taxels[6].state, TaxelState::dead);
    EXPECT_TRUE(std::isnan(gains->taxels[5].gain));
    EXPECT_TRUE(std::isnan(gains->values()[5]));
    EXPECT_EQ(gains->good(), kLayout.taxels() - 2);
    EXPECT_LT(bench.error(*gains), 1e-5);
}

TEST(TaxelGains, framesWithoutTheLoadAreNotUsed) {
    Bench bench(0.2);
    const auto load = [](std::size_t frame) { return frame < 60 ? 0.02 : 1.0; };
    const auto gains = gainsOf(bench.press(100, load));
    ASSERT_TRUE(gains);
    EXPECT_EQ(gains->frames, 40U);
}

TEST(TaxelGains, aTaxelWithoutReadingsInSomeFramesIsComparedInTheOthers) {
    Bench bench(0.2);
    std::vector<float> press = bench.press(200, ramp);
    // It reads mostly while the load is low: the ratio of the means would be wrong by a quarter.
    for (std::size_t frame = 0; frame < 200; ++frame) {
        if (ramp(frame) > 1.3 && frame % 10 != 0)
            press[frame * kLayout.taxels() + 20] = std::numeric_limits<float>::quiet_NaN();
    }
    const auto gains = gainsOf(press);
    ASSERT_TRUE(gains);
    EXPECT_EQ(gains->good(), kLayout.taxels());
    EXPECT_LT(bench.error(*gains), 1e-6);
}

TEST(TaxelGains, sparksMoveNothing) {
    Bench bench(0.2);
    std::vector<float> press = bench.press(200, ramp, 0.01);
    const auto calm = gainsOf(press);
    std::mt19937_64 random(3);
    for (std::size_t spark = 0; spark < press.size() / 50; ++spark)
        press[random() % press.size()] = spark % 2 == 0 ? 1e4F : -1e4F;
    const auto gains = gainsOf(press);
    ASSERT_TRUE(calm && gains);
    EXPECT_EQ(gains->good(), kLayout.taxels());
    EXPECT_LT(bench.error(*calm), 0.004);
    EXPECT_LT(bench.error(*gains), 0.006);
}

TEST(TaxelGains, aTaxelThatIsClippedAtHighLoadsIsJudgedByTheLowerOnes) {
    Bench bench(0.1);
    bench.response[30] = 1.5;
    std::vector<float> press = bench.press(400, ramp, 0.005);
    for (std::size_t frame = 0; frame < 400; ++frame) {
        float& value = press[frame * kLayout.taxels() + 30];
        value = std::min(value, 1.5F); // from the load 1 on
    }
    const auto gains = gainsOf(press);
    ASSERT_TRUE(gains);
    EXPECT_EQ(gains->taxels[30].state, TaxelState::good);
    EXPECT_NEAR(gains->taxels[30].gain / bench.expected(*gains)[30], 1.0, 0.005);
}

TEST(TaxelGains, aPressThatClipsMostTaxelsIsJudgedByItsLowerLoads) {
    Bench bench(0.2);
    // Most taxels are at the within the range of the taxels in more than half of the frames.
    std::vector<float> press = bench.press(
        400, [](std::size_t frame) { return 0.005 * static_cast<double>(frame); }, 0.005);
    for (float& value : press)
        value = std::min(value, 1.0F);
    const auto gains = gainsOf(press);
    ASSERT_TRUE(gains) << describe(gains.error());
    EXPECT_GE(gains->good(), kLayout.taxels() - 2);
    EXPECT_LT(bench.error(*gains), 0.015);
}

TEST(TaxelGains, aPressWithHardlyAnyFrameBelowTheEndOfTheRangeIsRefused) {
    Bench bench(0.2);
    const auto load = [](std::size_t frame) {
        const auto x = static_cast<double>(frame);
        return frame < 15 ? 0.5 + 0.4 * x / 15.0 : 1.0 + (x - 15.0) / 85.0;
    };
    std::vector<float> press = bench.press(100, load, 0.001);
    for (float& value : press)
        value = std::min(value, 1.0F);
    const auto gains = gainsOf(press);
    ASSERT_FALSE(gains);
    EXPECT_EQ(gains.error().kind, core::ErrorKind::refused);
    EXPECT_NE(gains.error().message.find("within the range of the taxels"), std::string::npos)
        << gains.error().message;
}

TEST(TaxelGains, anArrayThatIsSaturatedThroughoutIsRefused) {
    contact::ConditioningSettings settings;
    for (std::size_t taxel = 0; taxel < kLayout.taxels(); ++taxel)
        settings.tare.push_back(90.0F + static_cast<float>(taxel % 21));
    const auto gains = gainsOf(std::vector<float>(kLayout.taxels() * 50, 4095.0F), settings);
    ASSERT_FALSE(gains);
    EXPECT_EQ(gains.error().kind, core::ErrorKind::refused);
    EXPECT_NE(gains.error().message.find("4095"), std::string::npos) << gains.error().message;
}

TEST(TaxelGains, aTaxelThatIsClippedInAllButAFewFramesIsStuck) {
    Bench bench(0.05);
    bench.response[30] = 1.0;
    std::vector<float> press = bench.press(
        40, [](std::size_t frame) { return 0.5 + static_cast<double>(frame) / 40.0; }, 0.002);
    for (std::size_t frame = 0; frame < 40; ++frame) {
        float& value = press[frame * kLayout.taxels() + 30];
        value = std::min(value, 0.85F); // in 26 of the 30 frames under load
    }
    const auto gains = gainsOf(press);
    ASSERT_TRUE(gains) << describe(gains.error());
    EXPECT_EQ(gains->taxels[30].state, TaxelState::stuck);
    EXPECT_EQ(gains->good(), kLayout.taxels() - 1);
    EXPECT_LT(bench.error(*gains), 0.004);
}

TEST(TaxelGains, aShortPressInALongRecordingIsFound) {
    for (const double noise : {0.0, 0.01}) {
        Bench bench(0.2);
        const auto load = [](std::size_t frame) { return frame >= 700 && frame < 760 ? 1.0 : 0.0; };
        const auto gains = gainsOf(bench.press(2000, load, noise));
        ASSERT_TRUE(gains) << describe(gains.error());
        EXPECT_EQ(gains->frames, 60U);
        EXPECT_LT(bench.error(*gains), 0.01);
        const double sum = std::accumulate(bench.response.begin(), bench.response.end(), 0.0);
        EXPECT_NEAR(gains->level, sum / static_cast<double>(kLayout.taxels()), 0.002);
    }
}

TEST(TaxelGains, eachPressHasTheTareOfItsTime) {
    Bench bench(0.2);
    const auto moved = [&](float by) {
        std::vector<float> press = bench.press(50, ramp);
        for (float& value : press)
            value += by;
        return press;
    };
    const std::vector<float> first = moved(100.0F);
    const std::vector<float> second = moved(100.5F); // the array has drifted, and was tared again
    contact::ConditioningSettings before;
    contact::ConditioningSettings after;
    before.tare.assign(kLayout.taxels(), 100.0F);
    after.tare.assign(kLayout.taxels(), 100.5F);
    const auto gains =
        findTaxelGains(kLayout, std::array{GainPress{first, before}, GainPress{second, after}});
    ASSERT_TRUE(gains);
    EXPECT_LT(bench.error(*gains), 1e-4);
    EXPECT_LT(gains->repeatability, 1e-4);
}

TEST(TaxelGains, aTaxelThatIsAlwaysClippedIsStuck) {
    Bench bench(0.1);
    std::vector<float> press = bench.press(200, ramp, 0.005);
    for (std::size_t frame = 0; frame < 200; ++frame)
        press[frame * kLayout.taxels() + 30] = 0.4F;
    const auto gains = gainsOf(press);
    ASSERT_TRUE(gains);
    EXPECT_EQ(gains->taxels[30].state, TaxelState::stuck);
    EXPECT_EQ(gains->good(), kLayout.taxels() - 1);
    EXPECT_LT(bench.error(*gains), 0.003);
}

TEST(TaxelGains, coarseReadingsUnderASteadyLoadAreNotStuck) {
    Bench bench(0.1);
    // Most taxels read one count all the time.
    const auto gains = gainsOf(bench.press(100, steady(40.0), 0.1, 1.0));
    ASSERT_TRUE(gains) << describe(gains.error());
    EXPECT_EQ(gains->good(), kLayout.taxels());
    EXPECT_LT(bench.error(*gains), 0.5 / 28.0 + 0.005) << "half a count of the weakest taxel";
}

TEST(TaxelGains, taxelsThatFeelTooLittleOrTooMuchAreNotUsed) {
    Bench bench(0.1);
    bench.response[1] = 0.05;
    bench.response[2] = 0.0;
    bench.response[3] = 20.0;
    bench.response[4] = -1.0;
    const auto gains = gainsOf(bench.press(200, ramp, 0.002));
    ASSERT_TRUE(gains);
    EXPECT_EQ(gains->taxels[1].state, TaxelState::weak);
    EXPECT_EQ(gains->taxels[2].state, TaxelState::weak);
    EXPECT_EQ(gains->taxels[3].state, TaxelState::strong);
    EXPECT_EQ(gains->taxels[4].state, TaxelState::weak);
    EXPECT_EQ(gains->good(), kLayout.taxels() - 4);
    EXPECT_LT(bench.error(*gains), 0.002);
}

TEST(TaxelGains, aTiltedPlateIsNoticedAndCancelsWhenItIsTurned) {
    Bench bench(0.1);
    const auto tilted = [](double sign) {
        return [sign](std::size_t taxel) {
            const double x = static_cast<double>(taxel % 14) / 13.0 - 0.5;
            return std::exp(0.3 * sign * x);
        };
    };
    const std::vector<float> one = bench.press(100, ramp, 0.01, 0.0, tilted(1.0));
    const auto gains = gainsOf(one);
    ASSERT_TRUE(gains);
    EXPECT_TRUE(gains->isTilted);
    // The taxels' own spread along x belongs to what is found.
    EXPECT_NEAR(gains->tilt_x, 2.0 * std::tanh(0.15), 4.0 * 0.1 * std::sqrt(12.0 / 84.0));

    const std::vector<std::vector<float>> both{one, bench.press(100, ramp, 0.01, 0.0, tilted(-1.0))};
    const auto turned = gainsOf(both);
    ASSERT_TRUE(turned);
    EXPECT_FALSE(turned->isTilted);
    EXPECT_EQ(turned->presses, 2U);
    EXPECT_LT(bench.error(*turned), 0.01);
    // Each press is off by exp(+-0.3 x): the rms of 0.3 x over 14 columns.
    double squares = 0.0;
    for (int column = 0; column < 14; ++column)
        squares += std::pow(0.3 * (column / 13.0 - 0.5), 2) / 14.0;
    EXPECT_NEAR(turned->repeatability, std::sqrt(squares), 0.005);
    // What differs between presses is an error of their mean.
    EXPECT_GT(turned->taxels[40].error, 0.05);
}

TEST(TaxelGains, anEvenArrayIsNotCalledTilted) {
    int called = 0;
    for (unsigned seed = 0; seed < 100; ++seed) {
        Bench bench;
        bench.random.seed(seed);
        std::normal_distribution<double> normal;
        for (double& value : bench.response)
            value = std::exp(0.2 * normal(bench.random));
        const auto gains = gainsOf(bench.press(30, ramp, 0.01));
        ASSERT_TRUE(gains);
        called += gains->isTilted ? 1 : 0;
    }
    EXPECT_LE(called, 1) << "two axes, once in 1300 each";
}

TEST(TaxelGains, aTaxelThatIsGoodInOnePressOnlyIsKnownFromThatOne) {
    Bench bench(0.2);
    std::vector<std::vector<float>> presses{bench.press(50, ramp), bench.press(50, ramp)};
    for (std::size_t frame = 0; frame < 50; ++frame)
        presses[0][frame * kLayout.taxels() + 7] = std::numeric_limits<float>::quiet_NaN();
    const auto gains = gainsOf(presses);
    ASSERT_TRUE(gains);
    EXPECT_EQ(gains->good(), kLayout.taxels());
    EXPECT_LT(bench.error(*gains), 1e-5);
}

TEST(TaxelGains, refuseWhatTellsNothing) {
    Bench bench(0.1);
    EXPECT_EQ(findTaxelGains(kLayout, {}).error().kind, core::ErrorKind::refused);
    EXPECT_EQ(gainsOf(std::vector<float>(85)).error().kind, core::ErrorKind::badInput);
    EXPECT_EQ(gainsOf(std::vector<float>()).error().kind, core::ErrorKind::refused);
    EXPECT_EQ(gainsOf(bench.press(19, steady(1.0))).error().kind, core::ErrorKind::refused);
    EXPECT_EQ(gainsOf(std::vector<float>(84 * 50, 0.0F)).error().kind, core::ErrorKind::refused);
    EXPECT_EQ(gainsOf(std::vector<float>(84 * 50, std::numeric_limits<float>::quiet_NaN())).error().kind,
              core::ErrorKind::refused);
    // A ball on a few taxels.
    const auto ball = [](std::size_t taxel) { return taxel % 14 < 3 ? 1.0 : 0.0; };
    const auto few = gainsOf(bench.press(100, ramp, 0.001, 0.0, ball));
    ASSERT_FALSE(few);
    EXPECT_EQ(few.error().kind, core::ErrorKind::refused);
    // Nothing but noise.
    EXPECT_EQ(gainsOf(bench.press(400, steady(0.0), 0.01)).error().kind, core::ErrorKind::refused);
}

TEST(TaxelGains, ofASingleTaxelAndASingleRowAreDefined) {
    const std::vector<float> one(50, 3.0F);
    const auto single = findTaxelGains({.rows = 1, .columns = 1}, std::array{GainPress{one, {}}});
    ASSERT_TRUE(single) << describe(single.error());
    EXPECT_DOUBLE_EQ(single->taxels.front().gain, 1.0);
    std::vector<float> row;
    for (int frame = 0; frame < 30; ++frame)
        row.insert(row.end(), {1.0F, 2.0F, 3.0F, 2.0F, 1.0F, 2.0F});
    const auto line = findTaxelGains({.rows = 1, .columns = 6}, std::array{GainPress{row, {}}});
    ASSERT_TRUE(line) << describe(line.error());
    EXPECT_NEAR(line->taxels[0].gain, 11.0 / 6.0, 1e-12);
    EXPECT_NEAR(line->taxels[2].gain, 11.0 / 18.0, 1e-12);
    EXPECT_EQ(line->tilt_y, 0.0);
}

TEST(TaxelGains, beatTheRatioOfTheMeansWhereReadingsAreMissingOrSpark) {
    // The usual way: each taxel's mean over the press against the mean of all.
    const auto ratioOfMeans = [](const std::vector<float>& press) {
        std::vector<double> mean(kLayout.taxels(), 0.0);
        std::vector<double> count(kLayout.taxels(), 0.0);
        for (std::size_t i = 0; i < press.size(); ++i) {
            if (std::isfinite(press[i])) {
                mean[i % kLayout.taxels()] += static_cast<double>(press[i]);
                count[i % kLayout.taxels()] += 1.0;
            }
        }
        double all = 0.0;
        for (std::size_t i = 0; i < mean.size(); ++i)
            all += (mean[i] /= count[i]) / static_cast<double>(mean.size());
        std::vector<double> gains;
        for (const double one : mean)
            gains.push_back(all / one);
        return gains;
    };
    const auto rms = [](const std::vector<double>& truth, const std::function<double(std::size_t)>& gain) {
        double squares = 0.0;
        for (std::size_t i = 0; i < truth.size(); ++i)
            squares += std::pow(gain(i) / truth[i] - 1.0, 2) / static_cast<double>(truth.size());
        return std::sqrt(squares);
    };
    Bench bench(0.2);
    const std::vector<float> clean = bench.press(400, ramp, 0.02);
    std::vector<float> rough = clean;
    std::mt19937_64 random(5);
    for (float& value : rough) {
        const auto chance = random() % 1000;
        if (chance < 5)
            value = 30.0F;
        else if (chance < 100 && value > 1.0F)
            value = std::numeric_limits<float>::quiet_NaN();
    }
    struct Case {
        const std::vector<float>* press;
        double better;
    };
    for (const auto& [press, better] : {Case{&clean, 0.9}, Case{&rough, 10.0}}) {
        const auto gains = gainsOf(*press);
        ASSERT_TRUE(gains);
        const std::vector<double> truth = bench.expected(*gains);
        const double ours = rms(truth, [&](std::size_t i) { return gains->taxels[i].gain; });
        const std::vector<double> means = ratioOfMeans(*press);
        const double theirs = rms(truth, [&](std::size_t i) { return means[i]; });
        RecordProperty("ours", std::to_string(ours));
        RecordProperty("ratio_of_means", std::to_string(theirs));
        EXPECT_GT(theirs, better * ours) << ours << " against " << theirs;
    }
}
