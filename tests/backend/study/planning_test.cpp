// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/csv_reader.h"
#include "backend/study/planning/identification_plan.h"
#include "backend/study/planning/plan_file.h"
#include "backend/study/planning/power.h"
#include "backend/study/planning/study_truth.h"
#include "backend/study/planning/threshold_plan.h"
#include "tests/backend/study/levels/level_protocol.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>

namespace teleta::study {

namespace {

/// Significant with a share that grows with the number of participants.
class Steps : public PossibleStudy {
public:
    std::vector<double> participant(core::RandomStream& random) const override { return {random.uniform()}; }
    std::optional<double> p(std::span<const std::vector<double>> participants) const override {
        // The first participant decides: as likely as participants / 10.
        const double share = 0.1 * static_cast<double>(participants.size());
        return participants.front().front() < share ? 0.01 : 0.5;
    }
};

/// No analysis for fewer than three.
class Refusing : public PossibleStudy {
public:
    std::vector<double> participant(core::RandomStream& random) const override { return {random.uniform()}; }
    std::optional<double> p(std::span<const std::vector<double>> participants) const override {
        return participants.size() < 3 ? std::nullopt : std::optional(0.001);
    }
};

constexpr const char* kTruth = R"(
[[task]]
id = "shape"
participant_sd = 0.4
participant_condition_sd = 0.2
condition = [
    { id = "static", correct = 0.6 },
    { id = "dynamic", correct = 0.85, pattern = [{ letter = "A", correct = 1.0 }] },
]
)";

constexpr const char* kThresholdTruth = R"(
[[task]]
id = "detect"
threshold = { t = 0.1, slope = 3.5 }
)";

const std::string kDetection =
    "design = \"interval\"\n" + kStimulus + kLogLevels +
    "procedure = { kind = \"staircase\", first = 0.8, down = 2, step_up = 0.0911, step_down = 0.05, "
    "fast_reversals = 2, fast_factor = 4.0, reversals = 400, skip_reversals = 4, most_trials = 80 }\n";

Protocol paper() {
    return paperProtocol().value();
}

StudyTruth truth() {
    return parseTruth(kTruth, "truth.toml").value();
}

} // namespace

TEST(Power, doesNotDependOnTheThreads) {
    const auto plan = IdentificationPlan::make(paper(), truth(), "shape:condition");
    ASSERT_TRUE(plan);
    PlanSettings settings{{4, 6}, 300, 7};
    settings.target = 0.01; // far from the power, so that no more studies are drawn
    settings.threads = 1;
    const PowerPlan one = planPower(*plan, settings);
    settings.threads = 5;
    const PowerPlan five = planPower(*plan, settings);
    ASSERT_EQ(one.points.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(one.points[i].significant, five.points[i].significant);
        EXPECT_EQ(one.points[i].studies, five.points[i].studies);
    }
    settings.seed = 8;
    EXPECT_NE(planPower(*plan, settings).points[0].significant, one.points[0].significant);
}

// The first participants are the same at every number: a study that is significant with 3 is so with 4.
TEST(Power, largerStudiesHaveTheParticipantsOfSmallerOnes) {
    PlanSettings settings{{3, 4}, 2000};
    settings.target = 0.9;
    const PowerPlan plan = planPower(Steps(), settings);
    EXPECT_LT(plan.points[0].significant, plan.points[1].significant);
    EXPECT_NEAR(plan.points[0].power(), 0.3, 4 * 0.0103);
    EXPECT_NEAR(plan.points[1].power(), 0.4, 4 * 0.0110);
    EXPECT_FALSE(plan.participants);
}

TEST(Power, theSmallestNumberThatReachesTheTargetIsTheAnswer) {
    PlanSettings settings{{2, 4, 6, 8}, 2000};
    settings.target = 0.5;
    const PowerPlan plan = planPower(Steps(), settings);
    EXPECT_EQ(plan.participants, 6U);
    EXPECT_FALSE(plan.orParticipants);
    EXPECT_EQ(plan.points[2].studies, 2000U);
}

// At 5 of 10 the power is the target, whatever the number of studies: chance cannot decide, and mostly does
// not.
TEST(Power, whatChanceCannotDecideIsSaid) {
    std::size_t undecided = 0;
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        PlanSettings settings{{4, 5, 6}, 500, seed};
        settings.target = 0.5;
        const PowerPlan plan = planPower(Steps(), settings);
        ASSERT_TRUE(plan.participants);
        EXPECT_TRUE(*plan.participants == 5U || *plan.participants == 6U);
        if (!plan.orParticipants)
            continue;
        ++undecided;
        EXPECT_EQ(plan.points[1].studies, kMostStudies) << "more were drawn first";
        EXPECT_EQ(*plan.participants, 5U);
        EXPECT_EQ(*plan.orParticipants, 6U);
    }
    EXPECT_GT(undecided, 0U);
}

TEST(Power, refusedAnalysesAreCountedApart) {
    const PowerPlan plan = planPower(Refusing(), {{2, 3}, 200});
    EXPECT_EQ(plan.points[0].refused, 200U);
    EXPECT_EQ(plan.points[0].significant, 0U);
    EXPECT_EQ(plan.points[1].refused, 0U);
    EXPECT_EQ(plan.points[1].power(), 1.0);
    EXPECT_EQ(plan.points[1].standardError(), 0.0);
    EXPECT_EQ(plan.participants, 3U);
}

TEST(Power, canBeCancelled) {
    int asked = 0;
    PlanSettings settings{{500}, kMostStudies};
    settings.threads = 2;
    const PowerPlan plan = planPower(Steps(), settings, [&](double done) {
        EXPECT_GE(done, 0.0);
        EXPECT_LE(done, 1.0);
        return ++asked < 2;
    });
    EXPECT_TRUE(plan.cancelled);
    EXPECT_LT(plan.points[0].studies, kMostStudies);
}

TEST(IdentificationPlan, drawsSharesAsAssumed) {
    const auto plan = IdentificationPlan::make(paper(), truth(), "shape:condition");
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->trials(), 60U);
    core::RandomStream random(1);
    double fixed = 0.0;
    for (int i = 0; i < 4000; ++i) {
        const std::vector<double> cells = plan->participant(random);
        ASSERT_EQ(cells.size(), 12U);
        EXPECT_EQ(cells[6], 1.0) << "dynamic A is always right";
        fixed += std::accumulate(cells.begin(), cells.begin() + 6, 0.0) / 6.0;
    }
    // The mean of logistic(logit(.6) + N(0, .4^2 + .2^2)) is 0.5956006 (R, integrate).
    EXPECT_NEAR(fixed / 4000.0, 0.5956006, 4 * 0.0023);
}

TEST(IdentificationPlan, theTestsOfATaskAreTheLinesOfItsAnalysis) {
    for (const char* test :
         {"shape:condition", "shape:pattern", "shape:condition:pattern", "shape:condition@A"}) {
        const auto plan = IdentificationPlan::make(paper(), truth(), test);
        ASSERT_TRUE(plan) << test;
        EXPECT_EQ(plan->test().name(), test);
        core::RandomStream random(2);
        std::vector<std::vector<double>> people;
        for (int i = 0; i < 8; ++i)
            people.push_back(plan->participant(random));
        const auto p = plan->p(people);
        ASSERT_TRUE(p) << test;
        EXPECT_GE(*p, 0.0);
        EXPECT_LE(*p, 1.0);
        EXPECT_FALSE(plan->p(std::span(people).first(1))) << "one participant has no ANOVA";
    }
    for (const char* test : {"", "shape", "shape:", "form:condition", "shape:luck", "shape:condition@Z",
                             "shape:pattern@A", "stiffness:condition"}) {
        const auto plan = IdentificationPlan::make(paper(), truth(), test);
        ASSERT_FALSE(plan) << test;
        EXPECT_EQ(plan.error().kind, core::ErrorKind::badInput);
        EXPECT_FALSE(plan.error().expected.empty());
    }
}

TEST(StudyTruth, mistakesHaveTheirPlace) {
    const std::string text = kTruth;
    const auto wrong = parseTruth(
        text + "[[task]]\nid = \"x\"\ncondition = [{ id = \"a\", correct = 1.5 }]\n", "truth.toml");
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().where.line, 12);
    EXPECT_FALSE(parseTruth("", "truth.toml"));
    EXPECT_EQ(readTruth("/no/such/truth.toml").error().kind, core::ErrorKind::notFound);
}

TEST(StudyTruth, aPilotGivesSharesAndSpreads) {
    TaskResults task;
    task.task = "shape";
    task.patterns = {"A", "B"};
    const std::vector<std::int64_t> rights[2] = {{21, 17, 25, 12, 19, 23, 15, 27},
                                                 {24, 19, 28, 13, 25, 24, 21, 26}};
    for (const int c : {0, 1}) {
        GroupSummary group{c == 0 ? "a" : "b", ConfusionMatrix(2)};
        for (std::size_t i = 0; i < 8; ++i) {
            ConfusionMatrix matrix(2);
            matrix.add(0, 0, rights[c][i]);
            matrix.add(0, 1, 30 - rights[c][i]);
            task.participants.push_back({"P" + std::to_string(i), group.condition, matrix, {}, {}});
            group.matrix.add(matrix);
        }
        task.groups.push_back(group);
    }
    const auto found = truthOf({task}, "pilot");
    ASSERT_TRUE(found);
    const TaskTruth* own = found->find("shape");
    ASSERT_NE(own, nullptr);
    // lme4: s = .7108485.
    EXPECT_NEAR(own->participantSd, .7108485, 1e-4);
    EXPECT_GE(own->participantConditionSd, 0.0);
    ASSERT_EQ(own->conditions.size(), 2U);
    EXPECT_DOUBLE_EQ(own->conditions[0].correctOf("A"), 159.5 / 241.0);
    task.participants.erase(task.participants.begin() + 3, task.participants.end());
    EXPECT_EQ(truthOf({task}, "pilot").error().kind, core::ErrorKind::refused);
}

TEST(StudyTruth, anEmptyPilotIsToldAsSuch) {
    const auto none = truthOf({}, "pilot");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().kind, core::ErrorKind::refused);
    EXPECT_NE(none.error().message.find("no test trials"), std::string::npos) << none.error().message;
    EXPECT_EQ(none.error().where.file, "pilot");
}

TEST(StudyTruth, aTaskNeedsSharesOrAThreshold) {
    const auto nothing = parseTruth("[[task]]\nid = \"detect\"\n", "truth.toml");
    ASSERT_FALSE(nothing);
    EXPECT_NE(core::describe(nothing.error()).find("detect"), std::string::npos);
    const auto found = parseTruth(kThresholdTruth, "truth.toml");
    ASSERT_TRUE(found) << core::describe(found.error());
    ASSERT_TRUE(found->find("detect")->threshold);
    EXPECT_EQ(found->find("detect")->threshold->threshold, 0.1);
    EXPECT_EQ(found->find("detect")->threshold->lapse, 0.02);
    EXPECT_FALSE(
        parseTruth("[[task]]\nid = \"detect\"\nthreshold = { t = 0.1, slope = 0.0 }\n", "truth.toml"));
}

TEST(StudyTruth, aPilotWithLevelsGivesThresholdAndSpread) {
    ThresholdResults pilot;
    ThresholdGroup& group = pilot.groups.emplace_back();
    group.task = "detect";
    group.scale = LevelScale::log10;
    group.threshold = 0.1;
    group.standardDeviation = 0.3;
    for (const double slope : {2.0, 3.0, 9.0}) {
        ThresholdLine& line = pilot.lines.emplace_back();
        line.task = "detect";
        line.fit.spread = slope;
    }
    auto found = truthOf({}, pilot, "pilot");
    ASSERT_TRUE(found) << core::describe(found.error());
    EXPECT_NEAR(found->find("detect")->threshold->threshold, 0.1, 1e-12);
    EXPECT_EQ(found->find("detect")->threshold->slope, 3.0);
    EXPECT_EQ(found->find("detect")->threshold->sd, 0.3);
    group.hierarchical = HierarchicalThreshold{};
    group.hierarchical->participantSd = 0.2;
    EXPECT_EQ(truthOf({}, pilot, "pilot")->find("detect")->threshold->sd, 0.2);
    group.threshold.reset();
    EXPECT_EQ(truthOf({}, pilot, "pilot").error().kind, core::ErrorKind::refused);
}

TEST(ThresholdPlan, needsATaskWithLevelsAndItsTruth) {
    const StudyTruth assumed = parseTruth(kThresholdTruth, "truth.toml").value();
    const Protocol protocol = levelProtocol(kDetection);
    EXPECT_TRUE(ThresholdPlan::make(protocol, assumed, "detect:threshold", {}));
    for (const char* test : {"detection:threshold", ":threshold"})
        EXPECT_EQ(ThresholdPlan::make(protocol, assumed, test, {}).error().kind, core::ErrorKind::badInput);
    EXPECT_EQ(ThresholdPlan::make(paper(), assumed, "shape:threshold", {}).error().kind,
              core::ErrorKind::badInput);
    EXPECT_EQ(ThresholdPlan::make(protocol, truth(), "detect:threshold", {}).error().kind,
              core::ErrorKind::badInput);
    EXPECT_TRUE(ThresholdPlan::isTest("detect:threshold"));
    EXPECT_FALSE(ThresholdPlan::isTest("shape:condition"));
}

// Everybody has the same threshold, so that only the errors of the estimates are left: fewer with more
// trials.
TEST(ThresholdPlan, moreTrialsMakeTheEstimateMorePrecise) {
    const StudyTruth assumed = parseTruth(kThresholdTruth, "truth.toml").value();
    const auto spreadOf = [&](std::size_t trials) {
        const auto plan =
            ThresholdPlan::make(levelProtocol(kDetection), assumed, "detect:threshold", {0.1, trials});
        EXPECT_TRUE(plan);
        std::vector<double> places;
        for (std::uint64_t person = 0; person < 60; ++person) {
            core::RandomStream random(person);
            if (const double place = plan->participant(random).at(0); !std::isnan(place))
                places.push_back(place);
        }
        EXPECT_GE(places.size(), 40U);
        const GroupMean mean = groupMean(places).value();
        EXPECT_NEAR(mean.mean, -1.0, 0.1);
        return mean.standardDeviation.value();
    };
    EXPECT_LT(spreadOf(400), 0.6 * spreadOf(40));
}

TEST(ThresholdPlan, isRefusedWithFewerThanTwoThresholds) {
    const double none = std::nan("");
    EXPECT_FALSE(narrowEnough(std::vector{none, none, 0.1}, 1.0));
    EXPECT_EQ(narrowEnough(std::vector{none, 0.1, 0.1}, 1.0), 0.0);
    EXPECT_EQ(narrowEnough(std::vector{0.0, 1.0}, 1.0), 1.0) << "12.7 times 0.5";
}

TEST(PlanFile, hasARowPerNumber) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath(QStringLiteral("plan.csv")).toStdString();
    const PlanSettings settings{{2, 3}, 200, 5};
    ASSERT_TRUE(writePlan(planPower(Refusing(), settings), settings, "shape:condition", path));
    auto csv = core::CsvReader::open(path);
    ASSERT_TRUE(csv);
    EXPECT_EQ(csv->header().size(), 11U);
    std::vector<std::string_view> fields;
    ASSERT_TRUE(csv->nextText(fields).value());
    EXPECT_EQ(fields[0], "shape:condition");
    EXPECT_EQ(fields[1], "2");
    EXPECT_EQ(fields[4], "200");
}

} // namespace teleta::study
