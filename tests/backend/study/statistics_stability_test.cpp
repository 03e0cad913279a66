// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/study/analysis/information_transfer.h"
#include "backend/study/analysis/proportion.h"
#include "backend/study/analysis/repeated_anova.h"
#include "backend/study/analysis/study_transfer.h"
#include "backend/study/analysis/transfer_interval.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace teleta::study {

namespace {

/// Small whole numbers, so that offsets and factors of powers of two are exact.
ParticipantCells wholeNumbers(std::size_t participants, std::size_t cells, std::uint64_t seed) {
    core::RandomStream random(seed);
    ParticipantCells data(participants, std::vector<double>(cells));
    for (auto& row : data) {
        for (double& value : row)
            value = static_cast<double>(random.below(6));
    }
    return data;
}

ParticipantCells transformed(ParticipantCells data, double factor, double offset) {
    for (auto& row : data) {
        for (double& value : row)
            value = value * factor + offset;
    }
    return data;
}

} // namespace

TEST(StatisticsStability, anovaDoesNotChangeWithTheUnit) {
    const ParticipantCells data = wholeNumbers(8, 12, 1);
    const auto plain = twoWayAnova(data, 2, 6);
    ASSERT_TRUE(plain && plain->second);
    for (const double factor : {1e-12, 1e-6, 0.2, 100.0, 1e6, 1e12, -1.0}) {
        const auto scaled = twoWayAnova(transformed(data, factor, 0.0), 2, 6);
        ASSERT_TRUE(scaled && scaled->second) << factor;
        EXPECT_NEAR(scaled->second->f, plain->second->f, 1e-11 * plain->second->f) << factor;
        EXPECT_NEAR(scaled->second->epsilonGg, plain->second->epsilonGg, 1e-11) << factor;
        EXPECT_NEAR(scaled->second->sumOfSquares, plain->second->sumOfSquares * factor * factor,
                    1e-11 * plain->second->sumOfSquares * factor * factor)
            << factor;
    }
}

// The data stay exact up to 2^50; only the mean that is taken off is rounded, with an error that grows with
// the offset.
TEST(StatisticsStability, anovaLosesNoMoreThanAnOffsetTakes) {
    const ParticipantCells data = wholeNumbers(8, 12, 2);
    const auto plain = twoWayAnova(data, 2, 6);
    ASSERT_TRUE(plain && plain->interaction);
    for (int power = 0; power <= 40; power += 4) {
        const double offset = std::ldexp(1.0, power);
        const auto shifted = twoWayAnova(transformed(data, 1.0, offset), 2, 6);
        ASSERT_TRUE(shifted && shifted->interaction) << power;
        EXPECT_NEAR(shifted->interaction->f / plain->interaction->f, 1.0, 1e-13 + 1e-14 * offset) << power;
        EXPECT_NEAR(shifted->second->p, plain->second->p, 1e-13 + 1e-14 * offset) << power;
    }
}

TEST(StatisticsStability, anovaDoesNotDependOnTheOrderOfParticipantsAndPatterns) {
    const ParticipantCells data = wholeNumbers(7, 12, 3);
    const auto plain = twoWayAnova(data, 2, 6);
    ASSERT_TRUE(plain && plain->second && plain->interaction);
    ParticipantCells turned(data.rbegin(), data.rend());
    for (auto& row : turned) {
        std::rotate(row.begin(), row.begin() + 2, row.begin() + 6);
        std::rotate(row.begin() + 6, row.begin() + 8, row.end());
    }
    const auto other = twoWayAnova(turned, 2, 6);
    ASSERT_TRUE(other && other->second && other->interaction);
    EXPECT_NEAR(other->second->f, plain->second->f, 1e-12 * plain->second->f);
    EXPECT_NEAR(other->interaction->epsilonGg, plain->interaction->epsilonGg, 1e-12);
}

// One participant's effect differs by d from the others': F is finite, grows as 1/d^2, and stays within what
// rounding leaves of d until the refusal.
TEST(StatisticsStability, anovaApproachesNoErrorVarianceSmoothly) {
    constexpr double kParticipants = 5.0;
    for (int decade = 0; decade <= 12; ++decade) {
        const double d = std::pow(10.0, -decade);
        ParticipantCells data(5, std::vector<double>{0.0, 1.0});
        data[0][1] += d;
        const auto table = oneWayAnova(data);
        ASSERT_TRUE(table && table->effect) << decade;
        const double actual = data[0][1] - 1.0;
        const double mean = 1.0 + actual / kParticipants;
        const double squares = actual * actual * (1.0 - 1.0 / kParticipants);
        const double expected = kParticipants * mean * mean / (squares / (kParticipants - 1.0));
        EXPECT_NEAR(table->effect->f / expected, 1.0, 1e-13 + 1e-14 / d) << decade;
        EXPECT_GE(table->effect->p, 0.0);
    }
    ParticipantCells same(5, std::vector<double>{0.1, 0.7});
    EXPECT_EQ(oneWayAnova(same)->effect.error(), Refusal::noErrorVariance);
}

TEST(StatisticsStability, anovaSeesNoVarianceInWhatRoundingLeft) {
    ParticipantCells data;
    for (int i = 1; i <= 6; ++i) {
        const double third = 1.0 / (3.0 * i) * i;
        data.push_back({third, 1.0 / 3.0, third, 1.0 - 2.0 / 3.0});
    }
    const auto table = twoWayAnova(data, 2, 2);
    ASSERT_TRUE(table);
    EXPECT_EQ(table->first.error(), Refusal::noVariance);
    EXPECT_EQ(table->interaction.error(), Refusal::noVariance);
}

TEST(StatisticsStability, intervalsContainTheShareAndMirrorForAllSizes) {
    for (std::int64_t n = 1; n <= 1'000'000'000'000; n *= 10) {
        for (const std::int64_t x : {std::int64_t{0}, n / 3, n / 2, n - 1, n}) {
            const double share = static_cast<double>(x) / static_cast<double>(n);
            for (const auto& interval : {wilsonInterval(x, n), clopperPearsonInterval(x, n)}) {
                ASSERT_TRUE(interval) << x << "/" << n;
                EXPECT_LE(0.0, interval->low);
                EXPECT_LE(interval->low, share) << x << "/" << n;
                EXPECT_GE(interval->high, share) << x << "/" << n;
                EXPECT_LE(interval->high, 1.0);
            }
            const auto mirrored = wilsonInterval(n - x, n);
            EXPECT_NEAR(mirrored->low, 1.0 - wilsonInterval(x, n)->high, 1e-15);
            const auto mirroredExact = clopperPearsonInterval(n - x, n);
            EXPECT_NEAR(mirroredExact->low, 1.0 - clopperPearsonInterval(x, n)->high, 1e-12);
        }
    }
}

TEST(StatisticsStability, groupMeanScalesOverTwentyFourDecades) {
    const std::array values = {1.0, 2.0, 4.0, 8.0};
    const auto plain = groupMean(values);
    ASSERT_TRUE(plain);
    for (const double factor : {1e-300, 1e-12, 1e12, 1e300}) {
        std::array<double, 4> scaled{};
        std::transform(values.begin(), values.end(), scaled.begin(), [&](double v) { return v * factor; });
        const auto group = groupMean(scaled);
        ASSERT_TRUE(group && group->interval);
        EXPECT_NEAR(group->mean / factor, plain->mean, 1e-14);
        EXPECT_NEAR(group->interval->high / factor, plain->interval->high, 1e-13);
    }
}

TEST(StatisticsStability, informationTransferDependsOnSharesOnly) {
    ConfusionMatrix small(3);
    small.add(0, 0, 4);
    small.add(0, 1, 1);
    small.add(1, 1, 5);
    small.add(2, std::nullopt, 2);
    small.add(2, 2, 3);
    const double plain_bit = informationTransfer(small)->measured_bit;
    for (std::int64_t factor = 1; factor <= 1'000'000'000'000; factor *= 10) {
        ConfusionMatrix large(3);
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j)
                large.add(i, j, small.count(i, j) * factor);
            large.add(i, std::nullopt, small.count(i, small.noneColumn()) * factor);
        }
        EXPECT_NEAR(informationTransfer(large)->measured_bit, plain_bit, 1e-14);
    }
}

// A binary channel near independence: T = 1 - H((1+d)/2), which is d^2 / (2 ln 2) for small d.
TEST(StatisticsStability, informationTransferApproachesZeroWithoutGoingBelow) {
    constexpr std::int64_t kHalf = 1'000'000'000'000;
    for (std::int64_t excess = kHalf; excess >= 1; excess /= 10) {
        ConfusionMatrix matrix(2);
        for (std::size_t i = 0; i < 2; ++i) {
            matrix.add(i, i, kHalf + excess);
            matrix.add(i, 1 - i, kHalf - excess);
        }
        const double d = static_cast<double>(excess) / static_cast<double>(kHalf);
        const double entropyLoss = 0.5 * ((1 + d) * std::log1p(d) + (d < 1 ? (1 - d) * std::log1p(-d) : 0.0));
        const double measured_bit = informationTransfer(matrix)->measured_bit;
        EXPECT_GE(measured_bit, 0.0);
        EXPECT_NEAR(measured_bit, entropyLoss / std::log(2.0), 1e-14) << d;
    }
}

namespace {

ConfusionMatrix times(std::int64_t factor, const std::array<std::array<std::int64_t, 4>, 3>& counts) {
    ConfusionMatrix matrix(3);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            matrix.add(i, j < 3 ? std::optional(j) : std::nullopt, factor * counts[i][j]);
    return matrix;
}

constexpr std::array<std::array<std::int64_t, 4>, 3> kCounts{{{4, 1, 0, 0}, {0, 5, 0, 0}, {0, 0, 3, 2}}};

} // namespace

TEST(StatisticsStability, theJackknifeIsItsDefinitionForFewTrials) {
    const ConfusionMatrix matrix = times(1, kCounts);
    const double n = 15.0;
    double mean_bit = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            if (kCounts[i][j] > 0) {
                auto others = kCounts;
                --others[i][j];
                mean_bit += static_cast<double>(kCounts[i][j]) / n *
                            informationTransfer(times(1, others))->measured_bit;
            }
    EXPECT_NEAR(*jackknifeTransfer(matrix),
                n * informationTransfer(matrix)->measured_bit - (n - 1.0) * mean_bit, 1e-13);
}

// The bias goes with 1/n, so towards many trials nothing but rounding is left; the interval goes with its
// root.
TEST(StatisticsStability, intervalsOfTheTransferShrinkOverTwelveDecadesOfTrials) {
    const auto plain = asymptoticTransfer(times(1, kCounts), TransferBias::none);
    ASSERT_TRUE(plain);
    for (std::int64_t factor = 1; factor <= 1'000'000'000'000; factor *= 10) {
        const ConfusionMatrix matrix = times(factor, kCounts);
        const auto transfer = informationTransfer(matrix);
        const double bias_bit = transferBias(matrix, TransferBias::miller);
        EXPECT_LE(std::abs(*jackknifeTransfer(matrix) - transfer->measured_bit), 2.0 * bias_bit + 1e-13)
            << factor;
        EXPECT_LE(std::abs(transfer->bias_bit), 4.0 * bias_bit + 1e-13) << factor;
        const auto interval = asymptoticTransfer(matrix, TransferBias::none);
        ASSERT_TRUE(interval);
        const double root = std::sqrt(static_cast<double>(factor));
        EXPECT_NEAR((interval->high - transfer->measured_bit) * root,
                    plain->high - informationTransfer(times(1, kCounts))->measured_bit, 1e-13 * root + 1e-12);
    }
}

// The people keep their shares, so their differences, which make the interval, stay as they are.
TEST(StatisticsStability, theIntervalOfAStudyKeepsItsWidthOverTwelveDecadesOfTrials) {
    const auto study = [](std::int64_t factor) {
        return std::array{times(factor, kCounts), times(factor, {{{3, 2, 0, 0}, {1, 4, 0, 0}, {0, 1, 4, 0}}}),
                          times(factor, {{{5, 0, 0, 0}, {2, 3, 0, 0}, {0, 0, 4, 1}}}),
                          times(factor, {{{4, 0, 1, 0}, {0, 4, 1, 0}, {1, 0, 4, 0}}}),
                          times(factor, {{{4, 1, 0, 0}, {0, 5, 0, 0}, {0, 1, 2, 2}}})};
    };
    const auto plain = studyTransfer(study(1));
    ASSERT_TRUE(plain && plain->interval);
    for (std::int64_t factor = 1; factor <= 1'000'000'000'000; factor *= 10) {
        const auto many = studyTransfer(study(factor));
        ASSERT_TRUE(many && many->interval) << factor;
        EXPECT_NEAR(many->measured_bit, plain->measured_bit, 1e-13);
        EXPECT_NEAR(many->interval->low, plain->interval->low, 1e-11) << factor;
        EXPECT_NEAR(many->interval->high, plain->interval->high, 1e-11) << factor;
    }
    auto turned = study(1);
    std::reverse(turned.begin(), turned.end());
    EXPECT_NEAR(studyTransfer(turned)->interval->low, plain->interval->low, 1e-12);
}

// Bounds of every kind stay numbers, and within what is possible.
TEST(StatisticsStability, boundsOfTheTransferStayWithinZeroAndTheEntropyOverTwelveDecades) {
    for (std::int64_t factor = 1; factor <= 1'000'000'000'000; factor *= 10)
        for (const auto& counts : {std::array<std::array<std::int64_t, 4>, 3>{{{7, 0}, {0, 7}, {0, 0, 7}}},
                                   {{{7, 0}, {7, 0}, {7, 0}}},
                                   {{{2, 2, 2}, {2, 2, 2}, {2, 2, 2}}},
                                   {{{1, 0, 0}, {0, 0, 0}, {0, 0, 0}}},
                                   kCounts})
            for (const std::size_t people : {1U, 2U, 3U, 4U, 9U}) {
                const std::vector<ConfusionMatrix> same(people, times(factor, counts));
                const auto transfer = studyTransfer(same);
                ASSERT_TRUE(transfer);
                EXPECT_EQ(transfer->interval.has_value(), transfer->doubt == TransferDoubt::none);
                EXPECT_EQ(transfer->atLeast_bit.has_value(), transfer->doubt == TransferDoubt::fewDifferent);
                EXPECT_EQ(transfer->interval || transfer->atLeast_bit || transfer->atMost_bit, true);
                for (const double bound :
                     {transfer->atLeast_bit.value_or(0.0), transfer->atMost_bit.value_or(0.0)}) {
                    EXPECT_GE(bound, 0.0);
                    EXPECT_LE(bound, std::log2(3.0) + 1e-14);
                }
            }
}

TEST(StatisticsStability, answersThatAllTellAsMuchHaveAnIntervalWithoutWidth) {
    for (std::int64_t factor = 1; factor <= 1'000'000'000'000; factor *= 1000) {
        const auto interval = asymptoticTransfer(times(factor, {{{7, 0, 0, 0}, {0, 7, 0, 0}, {0, 0, 7, 0}}}),
                                                 TransferBias::none);
        ASSERT_TRUE(interval);
        EXPECT_NEAR(interval->low, std::log2(3.0), 1e-14);
        EXPECT_NEAR(interval->high, std::log2(3.0), 1e-14);
    }
}

TEST(StatisticsStability, theOrderOfPatternsDoesNotMatterToTheTransfer) {
    const ConfusionMatrix plain = times(1, kCounts);
    const ConfusionMatrix other = times(1, {{{3, 0, 0, 2}, {0, 4, 1, 0}, {0, 0, 5, 0}}});
    EXPECT_NEAR(*jackknifeTransfer(other), *jackknifeTransfer(plain), 1e-14);
    EXPECT_NEAR(asymptoticTransfer(other, TransferBias::miller)->high,
                asymptoticTransfer(plain, TransferBias::miller)->high, 1e-14);
}

TEST(StatisticsStability, chanceProbabilityStaysAProbabilityForManyTrials) {
    for (std::int64_t n = 1; n <= 1'000'000'000; n *= 10) {
        double last = 1.0;
        for (const std::int64_t x : {std::int64_t{0}, n / 6, n / 5, n / 2, n}) {
            const auto p = chanceProbability(x, n, 1.0 / 6.0);
            ASSERT_TRUE(p);
            EXPECT_GE(*p, 0.0);
            EXPECT_LE(*p, last + 1e-15);
            last = *p;
        }
    }
}

} // namespace teleta::study
