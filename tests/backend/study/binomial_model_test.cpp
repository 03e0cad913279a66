// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/model/accuracy_model.h"
#include "backend/study/model/binomial_model.h"
#include "backend/study/model/gauss_hermite.h"
#include "backend/study/model/group_threshold.h"
#include "backend/study/model/marginal_likelihood.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>
#include <string>

namespace teleta::study {

namespace {

constexpr std::int64_t kOf = 30;

/// Two conditions of 30 trials each.
TaskResults twoConditions(const std::vector<std::int64_t>& first, const std::vector<std::int64_t>& second) {
    TaskResults task;
    task.patterns = {"A", "B"};
    for (const auto& [condition, counts] : {std::pair("a", first), std::pair("b", second)}) {
        GroupSummary group{condition, ConfusionMatrix(2)};
        for (std::size_t i = 0; i < counts.size(); ++i) {
            ConfusionMatrix matrix(2);
            matrix.add(0, 0, counts[i]);
            matrix.add(0, 1, kOf - counts[i]);
            task.participants.push_back({"P" + std::to_string(i), condition, matrix, {}, {}});
            group.matrix.add(matrix);
        }
        task.groups.push_back(group);
        task.conditions.emplace_back(condition);
    }
    return task;
}

constexpr std::array kLevels{.2, .5, .8, 1.2, 1.6};

/// Right answers of 20 at the levels by six participants, two intervals.
std::vector<PersonLevel> sixCurves() {
    std::vector<PersonLevel> trials;
    const std::array<std::array<int, 5>, 6> counts{{{11, 13, 16, 19, 20},
                                                    {10, 11, 13, 16, 19},
                                                    {12, 16, 18, 20, 20},
                                                    {9, 12, 14, 18, 19},
                                                    {11, 12, 17, 19, 20},
                                                    {10, 14, 15, 17, 20}}};
    for (std::size_t i = 0; i < counts.size(); ++i) {
        for (std::size_t j = 0; j < kLevels.size(); ++j)
            trials.push_back({i, kLevels[j], counts[i][j], 20});
    }
    return trials;
}

} // namespace

// The integrals of x^2k exp(-x^2) are Gamma(k + 1/2).
TEST(GaussHermite, integratesPolynomialsExactly) {
    const auto nodes = gaussHermite(25);
    for (int k = 0; k <= 12; ++k) {
        double sum = 0.0;
        for (const QuadratureNode& node : nodes)
            sum += node.weight * std::pow(node.at, 2 * k);
        EXPECT_NEAR(sum / std::tgamma(k + 0.5), 1.0, 1e-12) << k;
    }
}

// Expected values: lme4 1.1-31 with 25 nodes and R 4.2.2; those of the threshold with 80 nodes.
TEST(AccuracyModel, agreesWithLme4) {
    const auto model =
        accuracyModel(twoConditions({21, 17, 25, 12, 19, 23, 15, 27}, {24, 19, 28, 13, 25, 24, 21, 26}));
    ASSERT_TRUE(model);
    EXPECT_EQ(model->reference, "a");
    ASSERT_EQ(model->terms, std::vector<std::string>{"b"});
    EXPECT_EQ(model->trials, 480);
    EXPECT_EQ(model->fit.participants, 8U);
    EXPECT_NEAR(model->fit.b[0], .7496009, 1e-4 * .7496009);
    EXPECT_NEAR(model->fit.standardError(0), .2908, 1e-4);
    EXPECT_NEAR(model->fit.b[1], .4674937, 1e-4 * .4674937);
    EXPECT_NEAR(model->fit.standardError(1), .2125652, 1e-4 * .2125652);
    EXPECT_NEAR(model->fit.s, .7108485, 1e-4 * .7108485);
    EXPECT_NEAR(model->fit.logLikelihood, -273.558366, 1e-6);
    ASSERT_TRUE(model->condition);
    EXPECT_NEAR(model->condition->chi2, 4.890648, 2e-6);
    EXPECT_EQ(model->condition->df, 1.0);
    EXPECT_NEAR(model->condition->p, .0270026, 1e-6);
    const Interval wald = model->fit.interval(1);
    EXPECT_NEAR(wald.high - wald.low, 2 * 1.959963985 * model->fit.standardError(1), 1e-8);
}

TEST(AccuracyModel, noSpreadBetweenPeopleIsAnAnswer) {
    const auto model = accuracyModel(twoConditions({20, 20, 20, 20, 20, 20}, {24, 24, 24, 24, 24, 24}));
    ASSERT_TRUE(model);
    EXPECT_EQ(model->fit.s, 0.0);
    EXPECT_NEAR(model->fit.b[0], std::numbers::ln2, 1e-8);
    EXPECT_NEAR(model->fit.b[1], std::numbers::ln2, 1e-8);
    EXPECT_NEAR(model->fit.standardError(1), .2443813, 1e-6 * .2443813);
    EXPECT_NEAR(model->condition.value().chi2, 8.248950, 1e-6 * 8.248950);
}

TEST(AccuracyModel, refusesSeparableDataAndFewPeople) {
    EXPECT_EQ(accuracyModel(twoConditions({30, 30, 30, 30, 30}, {24, 21, 28, 13, 25})).error(),
              ModelRefusal::separable);
    EXPECT_EQ(accuracyModel(twoConditions({0, 0, 0, 0, 0}, {24, 21, 28, 13, 25})).error(),
              ModelRefusal::separable);
    EXPECT_EQ(accuracyModel(twoConditions({20, 21, 22, 23}, {24, 21, 28, 13})).error(),
              ModelRefusal::tooFewParticipants);
    EXPECT_EQ(accuracyModel({}).error(), ModelRefusal::noData);
}

// With one condition the estimate is that of R's glm where everybody has the same share: log(2).
TEST(AccuracyModel, oneConditionHasNoTest) {
    TaskResults task = twoConditions({20, 20, 20, 20, 20}, {24, 24, 24, 24, 24});
    task.groups.pop_back();
    std::erase_if(task.participants, [](const ParticipantSummary& one) { return one.condition == "b"; });
    const auto model = accuracyModel(task);
    ASSERT_TRUE(model);
    EXPECT_NEAR(model->fit.b[0], std::numbers::ln2, 1e-8);
    EXPECT_FALSE(model->condition);
}

TEST(GroupThreshold, agreesWithLme4) {
    const auto group = groupThreshold(sixCurves(), 0.5, 0.0);
    ASSERT_TRUE(group);
    EXPECT_NEAR(group->fit.b[0], -1.839639, 1e-4 * 1.839639);
    EXPECT_NEAR(group->fit.b[1], 2.388485, 1e-4 * 2.388485);
    EXPECT_NEAR(group->fit.s, .4047371, 1e-4 * .4047371);
    EXPECT_NEAR(group->threshold, .7702117, 1e-4 * .7702117);
    EXPECT_NEAR(group->participantSd, .1694535, 1e-4 * .1694535);
    ASSERT_TRUE(group->low && group->high);
    EXPECT_LT(*group->low, group->threshold);
    EXPECT_GT(*group->high, group->threshold);
}

// A threshold in another unit is the same threshold.
TEST(GroupThreshold, doesNotDependOnTheUnit) {
    const auto group = groupThreshold(sixCurves(), 0.5, 0.0);
    std::vector<PersonLevel> trials = sixCurves();
    for (PersonLevel& one : trials)
        one.level = 1000.0 * one.level - 7.0;
    const auto moved = groupThreshold(trials, 0.5, 0.0);
    ASSERT_TRUE(group && moved);
    EXPECT_NEAR(moved->threshold, 1000.0 * group->threshold - 7.0, 1e-4);
    EXPECT_NEAR(*moved->low, 1000.0 * *group->low - 7.0, 1e-2);
    EXPECT_NEAR(moved->fit.b[0] + moved->fit.b[1] * moved->threshold, 0.0, 1e-9);
    EXPECT_NEAR(moved->fit.standardError(1), group->fit.standardError(1) / 1000.0, 1e-8);
}

TEST(GroupThreshold, refusesWhatDoesNotRise) {
    std::vector<PersonLevel> trials = sixCurves();
    for (PersonLevel& one : trials)
        one.level = -one.level;
    EXPECT_EQ(groupThreshold(trials, 0.5, 0.0).error(), ModelRefusal::falls);
    for (PersonLevel& one : trials)
        one.level = 1.0;
    EXPECT_EQ(groupThreshold(trials, 0.5).error(), ModelRefusal::noData);
    EXPECT_EQ(groupThreshold({}, 0.5).error(), ModelRefusal::noData);
    std::vector<PersonLevel> few = sixCurves();
    std::erase_if(few, [](const PersonLevel& one) { return one.participant > 3; });
    EXPECT_EQ(groupThreshold(few, 0.5).error(), ModelRefusal::tooFewParticipants);
}

// A step between two levels that is the same for everybody has no finite slope.
TEST(GroupThreshold, aStepIsSeparable) {
    std::vector<PersonLevel> trials;
    for (std::size_t i = 0; i < 6; ++i) {
        for (const double level : {1.0, 2.0, 3.0, 4.0})
            trials.push_back({i, level, level > 2.5 ? 20 : 0, 20});
    }
    EXPECT_EQ(groupThreshold(trials, 0.0, 0.0).error(), ModelRefusal::separable);
}

// With guesses and lapses, participants whom no function fits (falling answers, no mistake, a step) make
// integrands far from a normal curve: against Boost's quadrature of many short parts.
TEST(MarginalLikelihood, isTheIntegralAlsoForPeopleWhomNoFunctionFits) {
    constexpr double kGuess = 0.5;
    constexpr double kLapse = 0.02;
    constexpr int kTrials = 40;
    constexpr std::array<double, 6> kLevels{0.02, 0.04, 0.06, 0.08, 0.12, 0.16};
    constexpr std::array<std::array<int, 6>, 5> kPeople{{{22, 25, 29, 33, 38, 39},
                                                         {22, 25, 36, 28, 38, 32},
                                                         {40, 40, 40, 40, 40, 40},
                                                         {39, 38, 33, 29, 25, 22},
                                                         {20, 20, 20, 40, 40, 40}}};
    BinomialModel model;
    model.link = Link::probit;
    model.guess = kGuess;
    model.lapse = kLapse;
    for (std::size_t person = 0; person < kPeople.size(); ++person) {
        for (std::size_t i = 0; i < kLevels.size(); ++i)
            model.rows.push_back({person, {1.0, std::log10(kLevels[i])}, kPeople[person][i], kTrials});
    }
    const MarginalLikelihood likelihood(model);
    const auto integral = [&](const Eigen::Vector3d& at) {
        double sum = 0.0;
        for (const auto& person : kPeople) {
            const auto height = [&](double z) {
                double value = -0.5 * z * z;
                for (std::size_t i = 0; i < kLevels.size(); ++i) {
                    const double eta = at(0) + at(1) * std::log10(kLevels[i]) + at(2) * z;
                    const double right =
                        kGuess + (1.0 - kGuess - kLapse) * 0.5 * std::erfc(-eta / std::numbers::sqrt2);
                    value += person[i] * std::log(right) + (kTrials - person[i]) * std::log1p(-right);
                }
                return value;
            };
            double top = height(0.0);
            for (int k = -1000; k <= 1000; ++k)
                top = std::max(top, height(0.01 * k));
            double area = 0.0;
            for (int k = -100; k < 100; ++k)
                area += boost::math::quadrature::gauss_kronrod<double, 15>::integrate(
                    [&](double z) { return std::exp(height(z) - top); }, 0.1 * k, 0.1 * (k + 1), 0);
            sum += top + std::log(area / std::sqrt(2.0 * std::numbers::pi));
        }
        return sum;
    };
    for (const Eigen::Vector3d& at : {Eigen::Vector3d(6.5, 5.0, 2.6), Eigen::Vector3d(2.6, 2.0, 0.4),
                                      Eigen::Vector3d(13.0, 10.0, 8.0), Eigen::Vector3d(6.5, 5.0, 0.0)}) {
        const MarginalLikelihood::Value value = likelihood.at(at);
        EXPECT_NEAR(value.logLikelihood, integral(at), 1e-6) << at.transpose();
        for (Eigen::Index i = 0; i < 3; ++i) {
            const Eigen::Vector3d move = 1e-4 * Eigen::Vector3d::Unit(i);
            EXPECT_NEAR(value.gradient(i), (integral(at + move) - integral(at - move)) / 2e-4, 1e-2)
                << at.transpose();
        }
    }
}

} // namespace teleta::study
