// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/feature_batch.h"
#include "tests/backend/contact/allocation_count.h"
#include "tests/backend/contact/contact_frames.h"
#include "tests/support/floating_point_traps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace teleta::contact;
using namespace teleta::contact::test;
using teleta::core::ArrayLayout;
using teleta::test::FloatingPointTraps;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Memory for the features of many frames.
struct Table {
    std::vector<ContactType> type;
    std::array<std::vector<double>, 11> number;
    std::vector<std::int64_t> active;

    explicit Table(std::size_t frames)
        : type(frames)
        , active(frames) {
        for (auto& each : number)
            each.resize(frames);
    }
    [[nodiscard]] FeatureArrays arrays() {
        return {type,      number[0], number[1], number[2], number[3],  number[4], number[5],
                number[6], number[7], number[8], number[9], number[10], active};
    }
};

enum Number { kForce, kCopX, kCopY, kCocX, kCocY, kDzmpX, kDzmpY, kAlpha, kLambda1, kLambda2, kThreshold };

bool sameBits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Frames of random contacts; with broken, some have values that no load has.
std::vector<float> randomFrames(std::mt19937& random, const ArrayLayout& layout, int frames, bool broken) {
    std::vector<float> all;
    std::uniform_int_distribution<std::size_t> taxel(0, layout.taxels() - 1);
    for (int i = 0; i < frames; ++i) {
        Frame frame = randomFrame(random, layout, 0.1 * (i % 11));
        if (broken && i % 5 == 2)
            for (const float value : {kNan, -0.5F, kInfinity, -0.0F, -kInfinity})
                frame.load_N[taxel(random)] = value;
        all.insert(all.end(), frame.load_N.begin(), frame.load_N.end());
    }
    return all;
}

Table batchOf(const ArrayLayout& layout, const ConditioningSettings& conditioning,
              const FeatureSettings& settings, const std::vector<float>& raw) {
    Table table(raw.size() / layout.taxels());
    FeatureBatch(layout, conditioning, settings).compute(raw, table.arrays());
    return table;
}

Table oneByOne(const ArrayLayout& layout, const ConditioningSettings& conditioning,
               const FeatureSettings& settings, const std::vector<float>& raw) {
    const std::size_t taxels = layout.taxels();
    Table table(raw.size() / taxels);
    const FrameConditioner conditioner(taxels, conditioning);
    FeatureExtractor extractor(layout, settings);
    std::vector<float> load_N(taxels);
    std::vector<std::uint8_t> dead(taxels);
    for (std::size_t i = 0; i < table.type.size(); ++i) {
        conditioner.apply(std::span(raw).subspan(i * taxels, taxels), load_N, dead);
        table.arrays().set(i, extractor.compute(load_N, dead));
    }
    return table;
}

/// What comes from counts is the same; what comes from sums of loads may be rounded differently.
void expectSame(const Table& batch, const Table& one, const ArrayLayout& layout) {
    const double side_m = std::max(layout.rows, layout.columns) * layout.pitchX_m;
    for (std::size_t i = 0; i < one.type.size(); ++i) {
        SCOPED_TRACE(i);
        ASSERT_EQ(batch.type[i], one.type[i]);
        ASSERT_EQ(batch.active[i], one.active[i]);
        ASSERT_NEAR(batch.number[kForce][i], one.number[kForce][i], 1e-14 * one.number[kForce][i]);
        for (const Number number : {kCopX, kCopY, kDzmpX, kDzmpY}) {
            ASSERT_EQ(std::isnan(batch.number[number][i]), std::isnan(one.number[number][i])) << number;
            if (!std::isnan(one.number[number][i])) {
                ASSERT_NEAR(batch.number[number][i], one.number[number][i], 1e-14 * side_m) << number;
            }
        }
        for (const Number number : {kCocX, kCocY, kAlpha, kLambda1, kLambda2, kThreshold}) {
            ASSERT_EQ(std::isnan(batch.number[number][i]), std::isnan(one.number[number][i])) << number;
            if (!std::isnan(one.number[number][i])) {
                ASSERT_EQ(batch.number[number][i], one.number[number][i]) << number;
            }
        }
    }
}

} // namespace

TEST(FeatureBatch, equalsOneFrameAfterTheOther) {
    std::mt19937 random(41);
    for (const ArrayLayout& layout :
         {kPaperArray, ArrayLayout{1, 1, 0.01}, ArrayLayout{1, 24, 0.004}, ArrayLayout{24, 1, 0.004},
          ArrayLayout{2, 3, 0.01}, ArrayLayout{16, 16, 0.0034}, ArrayLayout{12, 27, 0.0034},
          ArrayLayout{128, 1, 0.0034}, ArrayLayout{64, 27, 0.0034}})
        for (const MomentRange range : {MomentRange::image, MomentRange::active})
            for (const int frames : {1, 7, 8, 83}) {
                SCOPED_TRACE(testing::Message() << layout.rows << " x " << layout.columns << ", " << frames);
                const FeatureSettings settings{.range = range, .edgeRatio = 1.6, .pointRatio = 1.2};
                const std::vector<float> raw = randomFrames(random, layout, frames, true);
                expectSame(batchOf(layout, {}, settings, raw), oneByOne(layout, {}, settings, raw), layout);
            }
}

TEST(FeatureBatch, conditionsTheFrames) {
    std::mt19937 random(42);
    const std::vector<float> raw = randomFrames(random, kPaperArray, 50, true);
    std::uniform_real_distribution<float> part(0.0F, 1.0F);
    ConditioningSettings tared;
    tared.gain = 1.5;
    for (std::size_t i = 0; i < kPaperArray.taxels(); ++i) {
        tared.tare.push_back(part(random));
        tared.taxelGain.push_back(0.5F + part(random));
    }
    ConditioningSettings dead;
    dead.dead.assign(kPaperArray.taxels(), 0);
    dead.dead[17] = 1;
    ConditioningSettings inverted;
    inverted.tare.assign(kPaperArray.taxels(), 2.0F);
    inverted.gain = 0.7;
    inverted.inverted = true;
    for (const ConditioningSettings& conditioning : {tared, dead, inverted})
        expectSame(batchOf(kPaperArray, conditioning, {}, raw), oneByOne(kPaperArray, conditioning, {}, raw),
                   kPaperArray);
}

TEST(FeatureBatch, followsEverySetting) {
    std::mt19937 random(43);
    const std::vector<float> raw = randomFrames(random, kPaperArray, 60, true);
    for (const FeatureSettings& settings :
         {FeatureSettings{.threshold_N = 1.0}, FeatureSettings{.threshold_N = 0.0},
          FeatureSettings{.automaticThreshold = true},
          FeatureSettings{.orientation = OrientationMode::weighted}})
        expectSame(batchOf(kPaperArray, {}, settings, raw), oneByOne(kPaperArray, {}, settings, raw),
                   kPaperArray);
}

// The tactile servoing paper's features of one bar, by hand: eight taxels in columns 4 and 5 of rows 1 to 4,
// the right ones twice as heavy.
TEST(FeatureBatch, describesABarAsComputedByHand) {
    Frame frame = block(kPaperArray, 1, 4, 4, 4, 1.0F);
    for (int row = 1; row <= 4; ++row)
        frame.at(row, 5) = 2.0F;
    const Table table = batchOf(kPaperArray, {}, {}, frame.load_N);
    const double pitch_m = kPaperArray.pitchX_m;
    EXPECT_EQ(table.type[0], ContactType::edge);
    EXPECT_EQ(table.active[0], 8);
    EXPECT_EQ(table.number[kForce][0], 12.0);
    EXPECT_NEAR(table.number[kCopX][0], (14.0 / 3.0 - 6.5) * pitch_m, 1e-17);
    EXPECT_EQ(table.number[kCopY][0], 0.0);
    EXPECT_EQ(table.number[kCocX][0], -2.0 * pitch_m);
    EXPECT_NEAR(table.number[kDzmpY][0], pitch_m / 6.0, 1e-17);
    // Variances of four rows and of two columns, 8/7 of 5/4 and of 1/4.
    EXPECT_NEAR(table.number[kLambda1][0], 10.0 / 7.0 * pitch_m * pitch_m, 1e-19);
    EXPECT_NEAR(table.number[kLambda2][0], 2.0 / 7.0 * pitch_m * pitch_m, 1e-19);
    EXPECT_NEAR(table.number[kAlpha][0], std::numbers::pi / 2.0, 1e-15);
}

TEST(FeatureBatch, aFrameDoesNotDependOnThoseBesideIt) {
    std::mt19937 random(44);
    const std::vector<float> raw = randomFrames(random, kPaperArray, 40, true);
    Table whole = batchOf(kPaperArray, {}, {}, raw);
    Table parts(40);
    FeatureBatch batch(kPaperArray, {});
    std::size_t done = 0;
    for (const std::size_t frames : {1UL, 3UL, 8UL, 11UL, 0UL, 17UL}) {
        batch.compute(std::span(raw).subspan(done * 84, frames * 84), parts.arrays().from(done));
        done += frames;
    }
    ASSERT_EQ(done, 40U);
    EXPECT_EQ(parts.type, whole.type);
    EXPECT_EQ(parts.active, whole.active);
    for (std::size_t number = 0; number < whole.number.size(); ++number)
        EXPECT_TRUE(std::ranges::equal(parts.number[number], whole.number[number], sameBits)) << number;
}

TEST(FeatureBatch, emptyAndBrokenFramesRaiseNoFloatingPointException) {
    std::vector<float> raw(9 * 84, 0.0F);
    raw[84] = 1.0F; // one taxel
    raw[3 * 84 + 5] = kNan;
    raw[4 * 84 + 5] = -kInfinity;
    raw[4 * 84 + 6] = kInfinity;
    raw[5 * 84 + 7] = std::numeric_limits<float>::denorm_min();
    raw[6 * 84 + 8] = std::numeric_limits<float>::max();
    Table table(9);
    FeatureBatch batch(kPaperArray, {});
    {
        const FloatingPointTraps traps;
        batch.compute(raw, table.arrays());
    }
    EXPECT_EQ(table.type, (std::vector{ContactType::none, ContactType::point, ContactType::none,
                                       ContactType::none, ContactType::none, ContactType::none,
                                       ContactType::point, ContactType::none, ContactType::none}));
    for (const Number number : {kCopX, kCocY, kDzmpX, kAlpha, kLambda1})
        EXPECT_TRUE(std::isnan(table.number[number][0])) << number;
    EXPECT_TRUE(std::isnan(table.number[kLambda1][1]));
    EXPECT_EQ(table.number[kCocX][1], -6.5 * kPaperArray.pitchX_m);
}

TEST(FeatureBatch, computeAllocatesNothing) {
    std::mt19937 random(45);
    const std::vector<float> raw = randomFrames(random, kPaperArray, 20, true);
    Table table(20);
    FeatureBatch batch(kPaperArray, {});
    const FeatureArrays arrays = table.arrays();
    const std::size_t before = allocationCount();
    batch.compute(raw, arrays);
    EXPECT_EQ(allocationCount(), before);
}

TEST(FrameBlock, everyProcessorGivesTheSameMoments) {
    std::mt19937 random(46);
    for (const ArrayLayout& layout : {kPaperArray, ArrayLayout{1, 3, 0.01}, ArrayLayout{24, 24, 0.01}})
        for (const bool activeOnly : {false, true}) {
            const std::vector<float> raw = randomFrames(random, layout, kBlockFrames, false);
            std::array<const float*, kBlockFrames> frames{};
            for (std::size_t i = 0; i < kBlockFrames; ++i)
                frames[i] = raw.data() + i * layout.taxels();
            std::vector<float> lanes(raw.size());
            BlockMoments here, anywhere;
            momentsOfBlock(frames, layout, 0.2F, activeOnly, lanes.data(), here);
            momentsOfBlockAnywhere(frames, layout, 0.2F, activeOnly, lanes.data(), anywhere);
            EXPECT_EQ(here.sum, anywhere.sum);
            EXPECT_EQ(here.sumX, anywhere.sumX);
            EXPECT_EQ(here.sumY, anywhere.sumY);
            EXPECT_EQ(here.active, anywhere.active);
            EXPECT_EQ(here.x, anywhere.x);
            EXPECT_EQ(here.y, anywhere.y);
            EXPECT_EQ(here.xx, anywhere.xx);
            EXPECT_EQ(here.xy, anywhere.xy);
            EXPECT_EQ(here.yy, anywhere.yy);
        }
}
