// SPDX-License-Identifier: GPL-3.0-or-later
// Power by simulation against exact power: closed forms, computed with R 4.2.2 (power.t.test(strict = TRUE),
// pbinom, noncentral pf).
#include "backend/study/analysis/proportion.h"
#include "backend/study/analysis/repeated_anova.h"
#include "backend/study/planning/power.h"
#include "backend/study/planning/threshold_plan.h"
#include "tests/backend/study/levels/level_protocol.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace teleta::study {

namespace {

constexpr std::size_t kStudies = 10'000;

/// Within four standard errors of the exact power.
void expectPower(const PossibleStudy& study, std::size_t participants, double exact) {
    PlanSettings settings{{participants}, kStudies, 11};
    // A target that no interval holds, so that no more studies are drawn.
    settings.target = 0.999;
    const PowerPlan plan = planPower(study, settings);
    ASSERT_EQ(plan.points.size(), 1U);
    EXPECT_EQ(plan.points[0].studies, kStudies);
    EXPECT_EQ(plan.points[0].refused, 0U);
    const double error = std::sqrt(exact * (1.0 - exact) / static_cast<double>(kStudies));
    EXPECT_NEAR(plan.points[0].power(), exact, 4.0 * error);
}

/// Normal differences with this mean and standard deviation 1, paired t test.
class PairedDifferences : public PossibleStudy {
public:
    explicit PairedDifferences(double dz)
        : m_dz(dz) {}
    std::vector<double> participant(core::RandomStream& random) const override {
        const double base = random.normal();
        return {base + m_dz + random.normal(), base};
    }
    std::optional<double> p(std::span<const std::vector<double>> participants) const override {
        // F of two levels is t squared.
        const auto table = oneWayAnova({participants.begin(), participants.end()});
        return table && table->effect ? std::optional(table->effect->p) : std::nullopt;
    }

private:
    double m_dz;
};

/// One person, 30 trials of six patterns, right with this share, against guessing.
class OnePerson : public PossibleStudy {
public:
    std::vector<double> participant(core::RandomStream& random) const override {
        double right = 0.0;
        for (int trial = 0; trial < 30; ++trial)
            right += random.uniform() < 0.4 ? 1.0 : 0.0;
        return {right};
    }
    std::optional<double> p(std::span<const std::vector<double>> participants) const override {
        return chanceProbability(static_cast<std::int64_t>(participants.front().front()), 30, 1.0 / 6.0);
    }
};

/// Five levels with these means, independent errors; the uncorrected F, which is exact for them.
class FiveLevels : public PossibleStudy {
public:
    std::vector<double> participant(core::RandomStream& random) const override {
        std::vector<double> cells;
        const double person = 0.1 * random.normal();
        for (const double mean : {.70, .75, .80, .80, .85})
            cells.push_back(mean + person + 0.12 * random.normal());
        return cells;
    }
    std::optional<double> p(std::span<const std::vector<double>> participants) const override {
        const auto table = oneWayAnova({participants.begin(), participants.end()});
        return table && table->effect ? std::optional(table->effect->p) : std::nullopt;
    }
};

/// Better or worse with probability .8 or .2; exact two-sided sign test.
class Signs : public PossibleStudy {
public:
    std::vector<double> participant(core::RandomStream& random) const override {
        return {random.uniform() < 0.8 ? 1.0 : 0.0};
    }
    std::optional<double> p(std::span<const std::vector<double>> participants) const override {
        double better = 0.0;
        for (const std::vector<double>& one : participants)
            better += one.front();
        const auto n = static_cast<std::int64_t>(participants.size());
        const auto most = std::max(static_cast<std::int64_t>(better), n - static_cast<std::int64_t>(better));
        const std::optional<double> tail = chanceProbability(most, n, 0.5);
        return tail ? std::optional(std::min(1.0, 2.0 * *tail)) : std::nullopt;
    }
};

/// Normal thresholds with this standard deviation; the t interval of their mean is as narrow as wished.
class NormalThresholds : public PossibleStudy {
public:
    std::vector<double> participant(core::RandomStream& random) const override {
        return {0.15 * random.normal()};
    }
    std::optional<double> p(std::span<const std::vector<double>> participants) const override {
        std::vector<double> values;
        for (const std::vector<double>& one : participants)
            values.push_back(one.front());
        return narrowEnough(values, 0.1);
    }
};

} // namespace

// P(chi2(11) <= 11 n w^2 / (t^2 s^2)) with n = 12, w = 0.1, s = 0.15 (R: pchisq, qt).
TEST(PowerAccuracy, widthOfTheIntervalOfAMean) {
    expectPower(NormalThresholds(), 12, .644595002);
}

// Many trials at each level: the thresholds are known so well that only the people differ.
TEST(PowerAccuracy, widthOfTheIntervalOfAThreshold) {
    const Protocol protocol = levelProtocol(
        "design = \"interval\"\n" + kStimulus +
        "level = { scale = \"log10\", lowest = 0.01, highest = 1.0, reference = 0.0, "
        "values = [0.02, 0.04, 0.06, 0.08, 0.12, 0.2, 0.4] }\nprocedure = { kind = \"constant\" }\n");
    StudyTruth truth;
    truth.tasks.push_back({"detect", 0.0, 0.0, {}, ThresholdTruth{0.08, 3.5, 0.02, 0.02, 0.15}});
    const auto plan = ThresholdPlan::make(protocol, truth, "detect:threshold", {0.1, 1000});
    ASSERT_TRUE(plan) << core::describe(plan.error());
    PlanSettings settings{{12}, 300, 11};
    settings.target = 0.999;
    const PowerPlan found = planPower(*plan, settings);
    // The errors of the fits, about 0.01 beside 0.15, change the power by less than a standard error.
    EXPECT_NEAR(found.points[0].power(), .644595002, 4.0 * std::sqrt(.6446 * .3554 / 300.0));
    EXPECT_EQ(found.points[0].refused, 0U);
}

TEST(PowerAccuracy, pairedTTest) {
    expectPower(PairedDifferences(0.8), 12, .7136601);
}

// The exact power passes .9 between 18 (.8919738) and 19 (.9092070).
TEST(PowerAccuracy, theSmallestNumberOfThePairedTTestIs19) {
    PlanSettings settings{{15, 16, 17, 18, 19, 20, 21}, kStudies, 11};
    const PowerPlan plan = planPower(PairedDifferences(0.8), settings);
    EXPECT_EQ(plan.participants, 19U);
    EXPECT_FALSE(plan.orParticipants);
}

TEST(PowerAccuracy, onePersonAboveChance) {
    expectPower(OnePerson(), 1, .8237135);
}

TEST(PowerAccuracy, repeatedMeasuresAnova) {
    expectPower(FiveLevels(), 12, .7026949);
}

TEST(PowerAccuracy, signTest) {
    expectPower(Signs(), 15, .6481631);
}

} // namespace teleta::study
