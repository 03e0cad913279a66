// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/frame_conditioner.h"
#include "tests/backend/contact/allocation_count.h"
#include "tests/support/floating_point_traps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace teleta::contact;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Conditioned {
    std::vector<float> load_N;
    std::vector<std::uint8_t> dead;
    std::size_t count = 0;
};

Conditioned condition(const ConditioningSettings& settings, const std::vector<float>& raw) {
    // Old contents must be overwritten.
    Conditioned result{std::vector<float>(raw.size(), 7.0F), std::vector<std::uint8_t>(raw.size(), 9), 0};
    result.count = FrameConditioner(raw.size(), settings).apply(raw, result.load_N, result.dead);
    return result;
}

} // namespace

TEST(FrameConditioner, withoutSettingsLoadsAreTheRawValues) {
    const Conditioned frame = condition({}, {0.0F, 1.5F, 2.0F});
    EXPECT_EQ(frame.load_N, (std::vector<float>{0.0F, 1.5F, 2.0F}));
    EXPECT_EQ(frame.dead, (std::vector<std::uint8_t>{0, 0, 0}));
    EXPECT_EQ(frame.count, 0U);
}

TEST(FrameConditioner, tareIsSubtractedBeforeTheGain) {
    const Conditioned frame = condition({.tare = {10.0F, 20.0F}, .gain = 0.5, .dead = {}}, {14.0F, 21.0F});
    EXPECT_EQ(frame.load_N, (std::vector<float>{2.0F, 0.5F}));
}

TEST(FrameConditioner, anInvertedValueThatFallsIsALoad) {
    const Conditioned frame =
        condition({.tare = {482.0F, 482.0F}, .gain = 0.25, .inverted = true, .dead = {}}, {470.0F, 490.0F});
    EXPECT_EQ(frame.load_N, (std::vector<float>{3.0F, 0.0F}));
    EXPECT_EQ(frame.count, 0U) << "drift below the tare is no defect";
}

TEST(FrameConditioner, aNegativeGainInvertsAsWell) {
    EXPECT_EQ(condition({.tare = {}, .gain = -2.0, .dead = {}}, {-3.0F, 3.0F}).load_N,
              (std::vector<float>{6.0F, 0.0F}));
}

TEST(FrameConditioner, aLoadBelowZeroIsZero) {
    const Conditioned frame = condition({.tare = {5.0F}, .dead = {}}, {4.0F});
    EXPECT_EQ(frame.load_N[0], 0.0F);
    EXPECT_FALSE(std::signbit(frame.load_N[0]));
}

TEST(FrameConditioner, eachTaxelHasItsOwnGain) {
    const Conditioned result = condition({.tare = {1.0F, 1.0F, 1.0F, 1.0F},
                                          .gain = 2.0,
                                          .taxelGain = {1.0F, 0.5F, std::nanf(""), 3.0F},
                                          .dead = {}},
                                         {2.0F, 5.0F, 2.0F, 0.0F});
    EXPECT_EQ(result.load_N, (std::vector<float>{2.0F, 4.0F, 0.0F, 0.0F}));
    EXPECT_EQ(result.dead, (std::vector<std::uint8_t>{0, 0, 1, 0}));
    EXPECT_EQ(result.count, 1U);
    // Settings of another size count as empty.
    EXPECT_EQ(condition({.tare = {}, .taxelGain = {9.0F}, .dead = {}}, {1.0F, 2.0F}).load_N,
              (std::vector<float>{1.0F, 2.0F}));
}

TEST(FrameConditioner, framesOfAnyLengthFollowTheDefinition) {
    // Several taxels are computed at once, and without a tare and gains in another way.
    const std::vector<float> values{1.5F, kNan,  -2.0F,      0.0F, kInfinity, 3e38F,
                                    2.0F, -0.0F, -kInfinity, 7.0F, 1e-42F};
    for (std::size_t taxels = 1; taxels <= 70; ++taxels) {
        std::vector<float> raw(taxels);
        ConditioningSettings plain;
        plain.dead.resize(taxels);
        for (std::size_t i = 0; i < taxels; ++i) {
            raw[i] = values[(3 * i + taxels) % values.size()];
            plain.dead[i] = i % 13 == 5 ? 1 : 0;
        }
        ConditioningSettings doubled = plain;
        doubled.gain = 2.0;
        for (const ConditioningSettings& settings : {plain, doubled}) {
            const Conditioned frame = [&] {
                const teleta::test::FloatingPointTraps traps;
                return condition(settings, raw);
            }();
            std::size_t count = 0;
            for (std::size_t i = 0; i < taxels; ++i) {
                const auto load = static_cast<float>(settings.gain * static_cast<double>(raw[i]));
                const bool isDead = settings.dead[i] != 0 || !std::isfinite(load);
                ASSERT_EQ(frame.dead[i], isDead ? 1 : 0) << taxels << " taxels, " << i;
                ASSERT_EQ(frame.load_N[i], isDead || std::signbit(load) ? 0.0F : load) << taxels << ", " << i;
                ASSERT_FALSE(std::signbit(frame.load_N[i])) << taxels << ", " << i;
                count += isDead ? 1U : 0U;
            }
            EXPECT_EQ(frame.count, count);
        }
    }
}

TEST(FrameConditioner, valuesThatAreNotFiniteAreDeadAndCounted) {
    const Conditioned frame = condition({}, {kNan, kInfinity, -kInfinity, 1.0F});
    EXPECT_EQ(frame.dead, (std::vector<std::uint8_t>{1, 1, 1, 0}));
    EXPECT_EQ(frame.load_N, (std::vector<float>{0.0F, 0.0F, 0.0F, 1.0F}));
    EXPECT_EQ(frame.count, 3U);
}

TEST(FrameConditioner, aTareThatIsNotFiniteMarksADeadTaxel) {
    const Conditioned frame = condition({.tare = {kNan, 0.0F, kInfinity}, .dead = {}}, {1.0F, 2.0F, 3.0F});
    EXPECT_EQ(frame.dead, (std::vector<std::uint8_t>{1, 0, 1}));
    EXPECT_EQ(frame.load_N, (std::vector<float>{0.0F, 2.0F, 0.0F}));
    EXPECT_EQ(frame.count, 2U);
}

TEST(FrameConditioner, aMarkedTaxelIsDeadWhateverItReads) {
    const Conditioned frame = condition({.tare = {}, .dead = {0, 1, 0}}, {1.0F, 2.0F, kNan});
    EXPECT_EQ(frame.dead, (std::vector<std::uint8_t>{0, 1, 1}));
    EXPECT_EQ(frame.load_N, (std::vector<float>{1.0F, 0.0F, 0.0F}));
    EXPECT_EQ(frame.count, 2U);
}

TEST(FrameConditioner, aLoadThatOverflowsIsDead) {
    const Conditioned frame = condition({.tare = {}, .gain = 1e30, .dead = {}}, {1e30F, 1e-29F});
    EXPECT_EQ(frame.dead, (std::vector<std::uint8_t>{1, 0}));
    EXPECT_EQ(frame.load_N[0], 0.0F);
    EXPECT_FLOAT_EQ(frame.load_N[1], 10.0F);
}

TEST(FrameConditioner, largeRawValuesLoseNoDigitsToTheTare) {
    // 2^24 - 1 and 2^24 - 2: their difference is exact.
    EXPECT_EQ(condition({.tare = {16777214.0F}, .gain = 1e-3, .dead = {}}, {16777215.0F}).load_N[0], 1e-3F);
}

TEST(FrameConditioner, settingsOfAnotherSizeCountAsNone) {
    const Conditioned frame = condition({.tare = {1.0F}, .dead = {1, 1, 1}}, {4.0F, 5.0F});
    EXPECT_EQ(frame.load_N, (std::vector<float>{4.0F, 5.0F}));
    EXPECT_EQ(frame.count, 0U);
}

TEST(FrameConditioner, aDeadTaxelComesBackWhenItReadsAgain) {
    const FrameConditioner conditioner(1, {});
    std::vector<float> load_N(1);
    std::vector<std::uint8_t> dead(1);
    EXPECT_EQ(conditioner.apply(std::vector<float>{kNan}, load_N, dead), 1U);
    EXPECT_EQ(conditioner.apply(std::vector<float>{2.0F}, load_N, dead), 0U);
    EXPECT_EQ(load_N[0], 2.0F);
    EXPECT_EQ(dead[0], 0);
}

TEST(FrameConditioner, valuesThatAreNotFiniteRaiseNoFloatingPointException) {
    const FrameConditioner conditioner(1, {});
    std::vector<float> load_N(1);
    std::vector<std::uint8_t> dead(1);
    const std::vector<float> raw{kNan};
    const teleta::test::FloatingPointTraps traps;
    EXPECT_EQ(conditioner.apply(raw, load_N, dead), 1U);
}

TEST(FrameConditioner, anEmptyArrayHasNothingToDo) {
    EXPECT_EQ(condition({}, {}).count, 0U);
}

TEST(FrameConditioner, applyAllocatesNothing) {
    const FrameConditioner conditioner(84, {.tare = std::vector<float>(84, 1.0F), .dead = {}});
    const std::vector<float> raw(84, 3.0F);
    std::vector<float> load_N(84);
    std::vector<std::uint8_t> dead(84);
    const std::size_t before = test::allocationCount();
    const std::size_t count = conditioner.apply(raw, load_N, dead);
    EXPECT_EQ(test::allocationCount(), before);
    EXPECT_EQ(count, 0U);
    EXPECT_EQ(load_N, std::vector<float>(84, 2.0F));
}
