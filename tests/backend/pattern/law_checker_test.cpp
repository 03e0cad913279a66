// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/laws/law_checker.h"
#include "backend/pattern/model/built_in_patterns.h"

#include <gtest/gtest.h>

#include <numbers>
#include <variant>

using namespace teleta::pattern;

namespace {

Pattern withObjects(std::vector<ObjectForm> forms, double duration_s) {
    Pattern pattern;
    pattern.duration_s = duration_s;
    for (ObjectForm& form : forms)
        pattern.objects.push_back({"", std::move(form), {}});
    return pattern;
}

std::vector<Finding> check(const Pattern& pattern) {
    return checkLaws(pattern, assumedMotors());
}

/// The only finding; after its fix none is left.
Finding onlyFixable(const Pattern& pattern) {
    const std::vector<Finding> findings = check(pattern);
    EXPECT_EQ(findings.size(), 1U);
    if (findings.empty())
        return {};
    const std::optional<Pattern> better = fixed(pattern, findings[0]);
    EXPECT_TRUE(better);
    if (better) {
        for (const Finding& left : check(*better))
            ADD_FAILURE() << "left: " << describe(left);
    }
    EXPECT_NE(describe(findings[0]), "");
    EXPECT_NE(describeFix(findings[0]), "");
    return findings[0];
}

} // namespace

TEST(LawChecker, findsNothingInTheStimuliOfThePaper) {
    for (const Pattern& pattern : builtInPatterns()) {
        for (const Finding& finding : check(pattern))
            ADD_FAILURE() << pattern.id << ": " << describe(finding);
    }
}

TEST(LawChecker, ringsOfThreeFourAndFiveTurnsInTwoSecondsAreLawful) {
    for (const int turns : {1, 3, 4, 5})
        EXPECT_TRUE(check(withObjects({Ring{0.0, 2.0, turns, 0, true, std::nullopt, 1.0}}, 2.0)).empty());
}

TEST(LawChecker, advisesFewerTurnsToARingThatIsTooFast) {
    const Finding finding = onlyFixable(withObjects({Ring{0.0, 2.0, 6, 0, true, std::nullopt, 1.0}}, 2.0));
    EXPECT_EQ(finding.law, Law::ringTooFast);
    EXPECT_NEAR(finding.value, 2.0 / 6.0, 1e-12);
    EXPECT_EQ(finding.limit, 0.4);
    EXPECT_EQ(finding.suggestion, 5.0);
    const Pattern tooShort = withObjects({Ring{0.0, 0.3, 2, 0, true, std::nullopt, 1.0}}, 2.0);
    const Finding longer = onlyFixable(tooShort);
    EXPECT_EQ(longer.suggestion, 0.4) << "no number of turns would do";
    const Ring ring = std::get<Ring>(fixed(tooShort, longer)->objects[0].form);
    EXPECT_EQ(ring.turns, 1);
    EXPECT_EQ(ring.duration_s, 0.4);
}

TEST(LawChecker, findsBurstsThatAreShorterThanTheRiseOfTheMotor) {
    const double rise_s = MotorProfile::assumedCoinMotor().riseTime_s;
    const Finding sweep = onlyFixable(withObjects({Sweep{0.0, 0.02, std::nullopt, {0, 1}, 1.0}}, 1.0));
    EXPECT_EQ(sweep.law, Law::burstTooShort);
    EXPECT_EQ(sweep.value, 0.02);
    EXPECT_EQ(sweep.limit, rise_s);
    EXPECT_EQ(onlyFixable(withObjects({PulseTrain{0.0, 1.0, 0.2, 0.01, {3}, 1.0}}, 1.0)).law,
              Law::burstTooShort);
    Pattern track;
    track.duration_s = 1.0;
    track.tracks[4] = {{0.0, 1.0}, {0.3, 1.0}, {0.3, 0.0}, {0.5, 0.0}, {0.5, 1.0}, {0.52, 1.0}};
    const auto findings = check(track);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_FALSE(findings[0].object);
    EXPECT_EQ(findings[0].tactors, std::vector{4});
    EXPECT_NEAR(findings[0].span.begin_s, 0.5, 1e-12);
    EXPECT_NEAR(findings[0].value, 0.02, 1e-12);
    const Finding lengthened = onlyFixable(track);
    const Track longer = fixed(track, lengthened)->tracks[4];
    EXPECT_DOUBLE_EQ(longer.back().time_s, 0.5 + rise_s);
    EXPECT_EQ((Track(longer.begin(), longer.begin() + 5)),
              (Track(track.tracks[4].begin(), track.tracks[4].begin() + 5)))
        << "what lies before it stays";
    // The next burst begins when the longer one ends, and a burst at the end extends the pattern.
    track.tracks[4] = {{0.9, 1.0}, {0.92, 1.0}, {0.92, 0.0}, {0.93, 0.0}, {0.93, 0.5}, {1.0, 0.5}};
    const auto merged = fixed(track, check(track).at(0));
    ASSERT_TRUE(merged);
    EXPECT_TRUE(check(*merged).empty());
    EXPECT_EQ(merged->duration_s, 1.0);
    track.tracks[4] = {{0.98, 1.0}, {1.0, 1.0}};
    EXPECT_DOUBLE_EQ(fixed(track, check(track).at(0))->duration_s, 0.98 + rise_s);
}

// Around the arm at a steady pace: a point between two motors, so that each is on for two steps of 60
// degrees.
TEST(LawChecker, findsStrokesThatPassMotorsFasterThanTheyRise) {
    const double rise_s = MotorProfile::assumedCoinMotor().riseTime_s;
    const auto around = [](double length_s) {
        Stroke stroke;
        const double turn_rad = 2.0 * std::numbers::pi;
        stroke.points = {{0.0, 0.0, 0.5}, {length_s, turn_rad, 0.5}};
        return withObjects({stroke}, 3.0);
    };
    EXPECT_TRUE(check(around(2.0)).empty());
    const Finding finding = onlyFixable(around(0.06));
    EXPECT_EQ(finding.law, Law::burstTooShort);
    EXPECT_EQ(finding.object, 0U);
    EXPECT_EQ(finding.limit, rise_s);
    EXPECT_GE(finding.tactors.size(), 5U);
    EXPECT_LT(finding.value, 0.06 / 2.0);
    // A tap is one motor for as long as it lasts.
    Stroke tap;
    tap.points = {{0.0, 0.0, 0.0}, {0.02, 0.0, 0.0}};
    const Finding tapped = onlyFixable(withObjects({tap}, 1.0));
    EXPECT_NEAR(tapped.value, 0.02, 1e-4);
    EXPECT_EQ(tapped.tactors, std::vector{0});
    tap.points[1].time_s = 1.1 * rise_s;
    EXPECT_TRUE(check(withObjects({tap}, 1.0)).empty());
    tap.points[1].time_s = 0.0;
    EXPECT_TRUE(check(withObjects({tap}, 1.0)).empty()) << "plays nothing";
}

TEST(LawChecker, findsOnsetsOffTheLawOfApparentMotion) {
    const Finding finding = onlyFixable(withObjects({Sweep{0.0, 0.1, 0.2, {0, 1, 2}, 1.0}}, 1.0));
    EXPECT_EQ(finding.law, Law::onsetOffLaw);
    EXPECT_DOUBLE_EQ(finding.limit, 0.0793);
    EXPECT_TRUE(check(withObjects({Sweep{0.0, 0.1, 0.08, {0, 1, 2}, 1.0}}, 1.0)).empty());
    EXPECT_TRUE(check(withObjects({Sweep{0.0, 0.1, 0.2, {0}, 1.0}}, 1.0)).empty());
}

TEST(LawChecker, findsTwoPhantomsOnOneMotor) {
    const Finding finding = onlyFixable(
        withObjects({Phantom{0.0, 1.0, 0, 1, 0.5, 0.5, 1.0}, Phantom{0.4, 1.0, 1, 2, 0.3, 0.3, 1.0}}, 3.0));
    EXPECT_EQ(finding.law, Law::sharedPhantoms);
    EXPECT_EQ(finding.object, 1U);
    EXPECT_EQ(finding.tactors, std::vector{1});
    EXPECT_DOUBLE_EQ(finding.span.begin_s, 0.4);
    EXPECT_DOUBLE_EQ(finding.span.end_s, 1.0);
    EXPECT_EQ(finding.suggestion, 1.0);
    EXPECT_TRUE(
        check(withObjects({Phantom{0.0, 1.0, 0, 1, 0.9, 0.9, 1.0}, Phantom{0.4, 1.0, 2, 3, 0.1, 0.1, 0.7}},
                          3.0))
            .empty());
}

TEST(LawChecker, findsMotorsThatBeat) {
    // 0.90 and 0.93 of the scale are 2/3 x 0.03 x 250 Hz = 5 Hz apart.
    Pattern pattern;
    pattern.duration_s = 1.0;
    pattern.tracks[1] = {{0.0, 0.90}, {1.0, 0.90}};
    pattern.tracks[4] = {{0.0, 0.93}, {1.0, 0.93}};
    const auto findings = check(pattern);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0].law, Law::beating);
    EXPECT_EQ(findings[0].tactors, (std::vector{1, 4}));
    EXPECT_NEAR(findings[0].value, 5.0, 1e-9);
    // 10 Hz below 0.93: 0.93 - 10 / (2/3 x 250) = 0.87 of the scale.
    EXPECT_EQ(onlyFixable(pattern).weaker, 1);
    const Pattern apart = *fixed(pattern, findings[0]);
    EXPECT_NEAR(apart.tracks[1][0].intensity, 0.87, 1e-6);
    EXPECT_NEAR(apart.tracks[1][1].intensity, 0.87, 1e-6);
    EXPECT_EQ(apart.tracks[4], pattern.tracks[4]);
    Pattern byObject = pattern;
    byObject.tracks[1].clear();
    byObject.objects.push_back({"", Ramp{0.0, 1.0, {1}, 0.9, 0.9, Easing::linear}, {}});
    ASSERT_EQ(check(byObject).size(), 1U);
    EXPECT_FALSE(fixed(byObject, check(byObject)[0])) << "the ramp drives it, not its track";
    pattern.duration_s = 0.15; // less than a period of 0.2 s
    pattern.tracks[1].back().time_s = pattern.tracks[4].back().time_s = 0.15;
    EXPECT_TRUE(check(pattern).empty());
}

TEST(LawChecker, findsWhatTheEndOfThePatternCutsOff) {
    const Finding finding = onlyFixable(withObjects({Ramp{1.0, 2.0, {0}, 0.0, 1.0, Easing::linear}}, 2.0));
    EXPECT_EQ(finding.law, Law::cutOff);
    EXPECT_EQ(finding.suggestion, 3.0);
    Pattern track;
    track.duration_s = 1.0;
    track.tracks[0] = {{0.0, 1.0}, {1.5, 1.0}};
    EXPECT_EQ(onlyFixable(track).law, Law::cutOff);
}

TEST(LawChecker, hasAnAnswerForPatternsWithoutTime) {
    EXPECT_TRUE(check(Pattern{}).empty());
    Pattern many = withObjects({}, 1.0);
    for (int k = 0; k < 3000; ++k)
        many.objects.push_back({"", Sweep{0.0, 0.01, std::nullopt, {0}, 1.0}, {}});
    EXPECT_EQ(check(many).size(), kMostFindings);
}
