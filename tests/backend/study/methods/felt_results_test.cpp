// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/felt/equal_strength.h"
#include "backend/study/methods/felt/felt_results.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace teleta::study {

namespace {

/// Of a comparison by gauss: the JND is this share of the spread.
constexpr double kJndOfSpread = 0.6744897501960817;

/// Starts at 0.2, speed proportional to the drive above it: 50 to 250 Hz.
pattern::MotorProfiles measuredMotors() {
    pattern::MotorProfiles motors = pattern::assumedMotors();
    for (pattern::MotorProfile& motor : motors) {
        motor.assumed = motor.rangeAssumed = false;
        motor.startDrive = 0.2;
        motor.fullDrive = 1.0;
        motor.curve = {{0.2, 50.0}, {1.0, 250.0}};
    }
    return motors;
}

FeltTask feltOf(Design design, Vary vary) {
    FeltTask felt;
    felt.task = "task";
    felt.design = design;
    felt.vary = vary;
    felt.tracks["all"] = {{0, 1, 2, 3, 4, 5}, {0, 1, 2, 3, 4, 5}};
    for (std::size_t tactor = 1; tactor < core::kTactors; ++tactor)
        felt.tracks["t" + std::to_string(tactor + 1)] = {{tactor}, {0}};
    for (const std::size_t tactor : {0U, 2U, 3U, 4U, 5U})
        felt.tracks["u" + std::to_string(tactor + 1)] = {{tactor}, {1}};
    return felt;
}

ThresholdLine lineOf(const std::string& participant, const std::string& condition, const std::string& track,
                     double threshold, double reference, double difference) {
    ThresholdLine line;
    line.participant = participant;
    line.task = "task";
    line.condition = condition;
    line.track = track;
    line.facts.design = Design::compare;
    line.facts.unit = unitOf(Vary::intensity);
    line.reference = reference;
    line.model.shape = RiseShape::gauss;
    line.fit.note = FitNote::none;
    line.fit.threshold = threshold;
    line.fit.thresholdInterval = {threshold - 0.02, threshold + 0.02};
    line.fit.spread = difference / kJndOfSpread;
    line.fit.guess = line.fit.lapse = 0.0;
    return line;
}

std::vector<LevelCount> onsetCounts(const std::vector<int>& yes) {
    const double onsets_s[] = {.020, .050, .080, .110, .140, .200};
    std::vector<LevelCount> counts;
    for (std::size_t i = 0; i < yes.size(); ++i)
        counts.push_back({onsets_s[i], yes[i], 24});
    return counts;
}

} // namespace

TEST(MotorStrength, isSpeedAndItsSquareByTheMeasuredCurve) {
    const pattern::MotorProfiles motors = measuredMotors();
    const std::vector<std::size_t> one{2};
    // Half of the way from 0.2 to 1 is a drive of 0.6: 150 Hz, (150/250)^2 of the force.
    const auto half = motorStrength(motors, one, 0.5);
    ASSERT_TRUE(half);
    EXPECT_NEAR(half->speed_Hz, 150.0, 1e-9);
    EXPECT_NEAR(half->force, 0.36, 1e-12);
    EXPECT_DOUBLE_EQ(motorStrength(motors, one, 1.0)->force, 1.0);
    EXPECT_DOUBLE_EQ(motorStrength(motors, one, 0.0)->speed_Hz, 0.0);
}

TEST(MotorStrength, isTheMeanOfSeveralTactors) {
    pattern::MotorProfiles motors = measuredMotors();
    motors[1].curve = {{0.2, 100.0}, {1.0, 200.0}};
    const auto both = motorStrength(motors, std::vector<std::size_t>{0, 1}, 0.5);
    ASSERT_TRUE(both);
    EXPECT_NEAR(both->speed_Hz, 150.0, 1e-9);
    EXPECT_NEAR(both->force, (0.36 + 0.5625) / 2.0, 1e-12);
}

TEST(MotorStrength, isUnknownWithoutAMeasuredCurveOrOutsideOfIntensities) {
    pattern::MotorProfiles motors = measuredMotors();
    EXPECT_FALSE(motorStrength(motors, std::vector<std::size_t>{}, 0.5));
    EXPECT_FALSE(motorStrength(motors, std::vector<std::size_t>{0}, 1.01));
    EXPECT_FALSE(motorStrength(motors, std::vector<std::size_t>{0}, std::nan("")));
    motors[0].assumed = true;
    EXPECT_FALSE(motorStrength(motors, std::vector<std::size_t>{0, 1}, 0.5));
    EXPECT_TRUE(motorStrength(motors, std::vector<std::size_t>{1}, 0.5));
}

TEST(FeltTask, knowsTactorsStrengthAndBurstOfItsStimulus) {
    pattern::Pattern stimulus;
    stimulus.duration_s = 1.0;
    stimulus.objects.push_back({"motion", pattern::Sweep{0.0, 0.1, 0.08, {1, 3}, 0.5}, {}});
    StudyTask task;
    task.id = "task";
    task.design = Design::yesNo;
    task.levels.vary = Vary::onset;
    task.levels.tracks = {{"all"}, {"t6", {5}}, {"t2", {1}, {0}}};
    const FeltTask felt = feltTask(task, stimulus);
    EXPECT_EQ(felt.tracks.at("all").tactors, (std::vector<std::size_t>{1, 3}));
    EXPECT_EQ(felt.tracks.at("t6").reference, (std::vector<std::size_t>{5}));
    EXPECT_EQ(felt.tracks.at("t2").reference, (std::vector<std::size_t>{0}));
    EXPECT_DOUBLE_EQ(felt.strongest, 0.5);
    EXPECT_EQ(felt.burst_s, 0.1);
}

TEST(MotorStrengths, haveTheWeberFractionOfSpeedAndForce) {
    ThresholdResults results;
    results.lines.push_back(lineOf("P01", "medium", "all", 0.5, 0.5, 0.1));
    results.lines.push_back(lineOf("P02", "strong", "all", 0.95, 0.95, 0.1));
    const auto lines = feltStrengths(results, feltOf(Design::compare, Vary::intensity), measuredMotors());
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_NEAR(lines[0].strength.speed_Hz, 150.0, 1e-9);
    // From 150 to 170 Hz.
    EXPECT_NEAR(lines[0].weberSpeed.value(), 20.0 / 150.0, 1e-9);
    EXPECT_NEAR(lines[0].weberForce.value(), 170.0 * 170.0 / (150.0 * 150.0) - 1.0, 1e-9);
    EXPECT_FALSE(lines[1].weberSpeed) << "reference + JND is stronger than the motors can be";
    EXPECT_TRUE(feltStrengths(results, feltOf(Design::yesNo, Vary::onset), measuredMotors()).empty());
    EXPECT_TRUE(
        feltStrengths(results, feltOf(Design::compare, Vary::intensity), pattern::assumedMotors()).empty());
}

TEST(BestOnsets, areThoseOfRForEachParticipantAndTheirMean) {
    ThresholdResults results;
    for (const char* participant : {"P01", "P02", "P03"}) {
        ThresholdLine line = lineOf(participant, "rest", "all", 0.1, 0.0, 0.1);
        line.facts.design = Design::yesNo;
        line.facts.unit = unitOf(Vary::onset);
        line.facts.procedure = "constant";
        // The third says yes more and more.
        line.counts = onsetCounts(participant[2] == '3' ? std::vector{1, 3, 6, 10, 13, 20}
                                                        : std::vector{3, 9, 17, 20, 15, 6});
        results.lines.push_back(line);
    }
    FeltTask felt = feltOf(Design::yesNo, Vary::onset);
    felt.burst_s = 0.1;
    const auto lines = feltOnsets(results, felt);
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_NEAR(lines[0].best.onset_s, 0.1160469, 1e-6);
    EXPECT_NEAR(lines[0].best.se_s, 0.004939937, 1e-7);
    EXPECT_NEAR(lines[0].law_s.value(), 0.32 * 0.1 + 0.0473, 1e-12);
    EXPECT_EQ(lines[2].best.doubt, OnsetDoubt::outside);
    EXPECT_TRUE(lines[3].participant.empty());
    EXPECT_EQ(lines[3].participants, 2U);
    EXPECT_NEAR(lines[3].best.onset_s, 0.1160469, 1e-6);

    results.lines[0].facts.procedure = "bayes";
    EXPECT_EQ(feltOnsets(results, felt).size(), 3U) << "an adaptive procedure looks for an edge";
    EXPECT_TRUE(feltOnsets(results, feltOf(Design::compare, Vary::intensity)).empty());
}

TEST(StepCounts, countFromStartToFullAndNeedEveryReference) {
    ThresholdResults results;
    for (const double reference : {0.3, 0.5, 0.7}) {
        results.lines.push_back(
            lineOf("P01", "r" + std::to_string(reference), "all", reference, reference, 0.1));
        results.lines.push_back(
            lineOf("P02", "r" + std::to_string(reference), "all", reference, reference, 0.1));
    }
    results.lines.back().fit.spread.reset();
    const auto lines = feltSteps(results, feltOf(Design::compare, Vary::intensity));
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0].steps, 10U); // 0, 0.1 .. 1
    EXPECT_EQ(lines[1].references, 2U);
    EXPECT_EQ(lines[1].wanted, 3U);
    EXPECT_FALSE(lines[1].steps);
}

class EqualStrengths : public testing::Test {
protected:
    EqualStrengths() {
        for (std::size_t tactor = 1; tactor < core::kTactors; ++tactor)
            m_results.lines.push_back(
                lineOf("P01", "rest", "t" + std::to_string(tactor + 1), tactor == 1 ? 0.8 : 0.6, 0.6, 0.1));
    }
    ThresholdResults m_results;
    FeltTask m_felt = feltOf(Design::compare, Vary::intensity);
};

TEST_F(EqualStrengths, becomeFullDrivesOfWhichNoneExceedsOne) {
    const auto all = equalStrengths(m_results, m_felt, "P01");
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].reference, 0U);
    EXPECT_EQ(all[0].levels[0], 0.6);
    const auto balanced = balancedMotors(all[0], m_felt.strongest, measuredMotors());
    ASSERT_TRUE(balanced);
    // Drives 0.2 + 0.8 x: tactor 2 needs 0.84 for what the others do with 0.68.
    EXPECT_NEAR((*balanced)[1].fullDrive, 1.0, 1e-12);
    EXPECT_NEAR((*balanced)[0].fullDrive, 0.68 / 0.84, 1e-12);
    EXPECT_TRUE(equalStrengths(m_results, m_felt, "P02").empty());
}

TEST_F(EqualStrengths, areNoBalanceWhereATactorIsMissing) {
    m_results.lines[3].fit.threshold.reset();
    const auto all = equalStrengths(m_results, m_felt, "P01");
    ASSERT_EQ(all.size(), 1U);
    const auto balanced = balancedMotors(all[0], m_felt.strongest, measuredMotors());
    ASSERT_FALSE(balanced);
    EXPECT_EQ(balanced.error().kind, core::ErrorKind::refused);
    EXPECT_NE(balanced.error().message.find('5'), std::string::npos);
}

TEST_F(EqualStrengths, contradictEachOtherOnlyOutsideOfBothIntervals) {
    // Against tactor 2 at 0.8, which is as strong as the others at 0.6.
    for (const std::size_t tactor : {0U, 2U, 3U, 4U, 5U})
        m_results.lines.push_back(lineOf("P01", "again", "u" + std::to_string(tactor + 1),
                                         tactor == 4   ? 0.75
                                         : tactor == 5 ? 0.63
                                                       : 0.6,
                                         0.8, 0.1));
    const auto all = equalStrengths(m_results, m_felt, "P01");
    ASSERT_EQ(all.size(), 2U);
    // Tactor 6 differs by 0.03, which intervals of +-0.02 on both sides allow; tactor 5 by 0.15.
    EXPECT_EQ(disagreements(all[0], all[1], m_felt.strongest, measuredMotors()),
              (std::vector<std::size_t>{4}));
    EXPECT_TRUE(disagreements(all[0], all[0], m_felt.strongest, measuredMotors()).empty());
}

} // namespace teleta::study
