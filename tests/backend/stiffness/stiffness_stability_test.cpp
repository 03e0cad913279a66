// SPDX-License-Identifier: GPL-3.0-or-later
// Hard inputs of the stiffness estimators. Every call runs with floating-point exceptions trapped.
#include "backend/stiffness/contact_detector.h"
#include "backend/stiffness/stiffness_estimator.h"
#include "tests/backend/stiffness/simulated_touch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

using namespace teleta::stiffness;
using teleta::stiffness::test::SimulatedTouch;

namespace {

constexpr Method kMethods[] = {Method::twoPoint, Method::regression};
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

TouchSettings at(double contactDistance_m, Method method) {
    TouchSettings settings;
    settings.contactDistance_m = contactDistance_m;
    settings.contactDistanceSe_m = 0.0;
    settings.method = method;
    return settings;
}

tl::expected<TouchStiffness, Refusal> estimate(const std::vector<JointSample>& log,
                                               const TouchSettings& settings) {
    return estimateStiffness(log, settings);
}

/// What holds for every answer.
void expectSane(const TouchStiffness& touch) {
    for (const Stiffness* stiffness : {&touch.total, &touch.object}) {
        for (const auto& number :
             {stiffness->value_NPerM, stiffness->lower95_NPerM, stiffness->upper95_NPerM}) {
            if (number) {
                EXPECT_TRUE(std::isfinite(*number));
                EXPECT_GT(*number, 0.0);
            }
        }
        if (stiffness->se_NPerM) {
            EXPECT_TRUE(std::isfinite(*stiffness->se_NPerM));
            EXPECT_GE(*stiffness->se_NPerM, 0.0);
        }
        if (stiffness->onlyBound()) {
            EXPECT_TRUE(stiffness->lower95_NPerM);
            EXPECT_FALSE(stiffness->upper95_NPerM);
        }
        if (stiffness->value_NPerM && stiffness->lower95_NPerM) {
            EXPECT_LE(*stiffness->lower95_NPerM, *stiffness->value_NPerM);
            EXPECT_GE(stiffness->upper95_NPerM.value(), *stiffness->value_NPerM);
        }
    }
    EXPECT_TRUE(std::isfinite(touch.deltaTheta_rad));
    EXPECT_TRUE(std::isfinite(touch.deltaTorque_Nm));
}

std::vector<JointSample> cleanTouch(double objectCompliance_mPerN) {
    SimulatedTouch world;
    world.objectCompliance_mPerN = objectCompliance_mPerN;
    world.torqueNoise_Nm = 0.0;
    return world.record(1);
}

} // namespace

TEST(StiffnessStability, cleanTouchesLoseNoMoreThanTheConditionNumberTowardsRigid) {
    for (const Method method : kMethods) {
        for (int decade = 0; decade <= 12; ++decade) {
            const double truth_NPerM = 100.0 * std::pow(10.0, decade);
            const auto touch = estimate(cleanTouch(1.0 / truth_NPerM), at(0.17, method));
            ASSERT_TRUE(touch);
            expectSane(*touch);
            // A thousandth of the link's compliance is the resolution: 3.4686e6 N/m.
            EXPECT_EQ(touch->object.onlyBound(), decade >= 5) << truth_NPerM;
            if (touch->object.value_NPerM) {
                const double condition = 1.0 + truth_NPerM / kPaperLinkStiffness_NPerM;
                // The angle of a sample is kept to 1e-16 of 2.5 mrad, and 0.3 mrad of it are the touch.
                const double rounding = 200.0 * kEpsilon;
                EXPECT_NEAR(*touch->object.value_NPerM / truth_NPerM, 1.0, rounding * condition);
            } else {
                EXPECT_LE(*touch->object.lower95_NPerM, 1000.0 * kPaperLinkStiffness_NPerM * (1.0 + 1e-9));
                EXPECT_GE(*touch->object.lower95_NPerM, kPaperLinkStiffness_NPerM);
                EXPECT_EQ(touch->material, Material::metal);
            }
        }
    }
}

TEST(StiffnessStability, noisyTouchesWidenTheirIntervalTowardsRigidAndEndInABound) {
    for (const Method method : kMethods) {
        double lastWidth = 0.0;
        bool bounded = false;
        for (int step = 0; step <= 48; ++step) {
            SimulatedTouch world;
            world.objectCompliance_mPerN = std::pow(10.0, -2.0 - 0.25 * step);
            world.freeMotion_s = 1.0;
            const auto touch = estimate(world.record(11), at(0.17, method));
            ASSERT_TRUE(touch);
            expectSane(*touch);
            if (touch->object.value_NPerM && method == Method::regression) {
                EXPECT_FALSE(bounded) << "once bounded, always bounded";
                const double width = (*touch->object.upper95_NPerM - *touch->object.lower95_NPerM) /
                                     *touch->object.value_NPerM;
                EXPECT_GT(width, lastWidth);
                lastWidth = width;
            } else {
                bounded = touch->object.onlyBound();
            }
        }
        EXPECT_TRUE(bounded);
    }
}

TEST(StiffnessStability, angleNoiseAloneAcrossZeroComplianceNeverGivesANegativeOrInfiniteNumber) {
    // A link so stiff that nothing turns: the slope is noise and has either sign.
    for (const Method method : kMethods) {
        int bounds = 0;
        for (unsigned seed = 0; seed < 200; ++seed) {
            std::mt19937_64 random(seed);
            std::normal_distribution<double> normal;
            std::vector<JointSample> log;
            for (int i = 0; i <= 120; ++i)
                log.push_back({0.001 * i, 1e-5 * normal(random), 0.0005 * i});
            TouchSettings settings = at(0.17, method);
            settings.linkStiffness_NPerM = 1e12;
            const auto touch = estimate(log, settings);
            if (!touch) {
                EXPECT_EQ(touch.error(), Refusal::angleOpposesTorque);
                continue;
            }
            expectSane(*touch);
            bounds += touch->object.onlyBound() ? 1 : 0;
        }
        EXPECT_GE(bounds, 180) << "2.5 % may be refused and fewer taken for soft";
    }
}

TEST(StiffnessStability, resultsScaleWithForceLengthAngleAndTime) {
    SimulatedTouch world;
    world.objectCompliance_mPerN = 1.0 / 1325.9;
    const auto log = world.record(3);
    for (const Method method : kMethods) {
        const auto reference = estimate(log, at(0.17, method));
        ASSERT_TRUE(reference);
        for (const double scale : {1e-12, 1e-6, 1e-3, 1e3, 1e6, 1e12}) {
            for (int kind = 0; kind < 4; ++kind) {
                SCOPED_TRACE(testing::Message() << "scale " << scale << ", kind " << kind);
                TouchSettings settings = at(0.17, method);
                auto scaled = log;
                double factor = 1.0;
                if (kind == 0) { // torque
                    for (JointSample& sample : scaled)
                        sample.torque_Nm *= scale;
                    settings.window = {0.02 * scale, 0.05 * scale};
                    factor = scale;
                } else if (kind == 1) { // angle
                    for (JointSample& sample : scaled)
                        sample.angle_rad *= scale;
                    factor = 1.0 / scale;
                } else if (kind == 2) { // length
                    settings.contactDistance_m *= scale;
                    factor = 1.0 / scale / scale;
                } else { // time
                    for (JointSample& sample : scaled)
                        sample.time_s *= scale;
                }
                settings.linkStiffness_NPerM *= factor;
                const auto touch = estimate(scaled, settings);
                ASSERT_TRUE(touch);
                expectSane(*touch);
                ASSERT_TRUE(touch->object.value_NPerM);
                const double tolerance = 1e-9 * factor;
                EXPECT_EQ(touch->samples, reference->samples);
                EXPECT_NEAR(*touch->object.value_NPerM, *reference->object.value_NPerM * factor,
                            tolerance * *reference->object.value_NPerM);
                EXPECT_NEAR(*touch->object.lower95_NPerM, *reference->object.lower95_NPerM * factor,
                            tolerance * *reference->object.lower95_NPerM);
                EXPECT_NEAR(*touch->object.upper95_NPerM, *reference->object.upper95_NPerM * factor,
                            tolerance * *reference->object.upper95_NPerM);
            }
        }
    }
}

TEST(StiffnessStability, anglesFarFromZeroAndLateTimesKeepTheAnswer) {
    const auto log = cleanTouch(1.0 / 1325.9);
    auto shifted = log;
    for (JointSample& sample : shifted) {
        sample.angle_rad += 1000.0;
        sample.time_s += 1e9;
    }
    for (const Method method : kMethods) {
        const auto reference = estimate(log, at(0.17, method));
        const auto touch = estimate(shifted, at(0.17, method));
        ASSERT_TRUE(reference && touch);
        // 1000 rad are kept to 1.1e-13 rad, of 1 mrad.
        EXPECT_NEAR(*touch->object.value_NPerM, *reference->object.value_NPerM, 1e-9 * 1325.9);
    }
}

TEST(StiffnessStability, permutedAndRepeatedRowsGiveTheSameBits) {
    SimulatedTouch world;
    world.objectCompliance_mPerN = 1.0 / 7223.9;
    world.angleNoise_rad = 1e-6;
    const auto log = world.record(5);
    std::mt19937_64 random(17);
    for (const Method method : kMethods) {
        const auto reference = estimate(log, at(0.17, method));
        ASSERT_TRUE(reference);
        auto other = log;
        for (int round = 0; round < 20; ++round) {
            other.push_back(log[random() % log.size()]);
            std::shuffle(other.begin(), other.end(), random);
            const auto touch = estimate(other, at(0.17, method));
            ASSERT_TRUE(touch);
            EXPECT_EQ(touch->samples, reference->samples);
            EXPECT_EQ(touch->totalCompliance.value_mPerN, reference->totalCompliance.value_mPerN);
            EXPECT_EQ(touch->totalCompliance.se_mPerN, reference->totalCompliance.se_mPerN);
            EXPECT_EQ(touch->object.lower95_NPerM, reference->object.lower95_NPerM);
            EXPECT_EQ(touch->object.upper95_NPerM, reference->object.upper95_NPerM);
        }
    }
}

TEST(StiffnessStability, everyNonFiniteNumberIsRefused) {
    const auto log = cleanTouch(1.0 / 282.0);
    const double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                          -std::numeric_limits<double>::infinity()};
    for (const Method method : kMethods) {
        for (const double value : bad) {
            for (double JointSample::*field :
                 {&JointSample::time_s, &JointSample::angle_rad, &JointSample::torque_Nm}) {
                auto spoiled = log;
                spoiled[spoiled.size() / 2].*field = value;
                EXPECT_EQ(estimate(spoiled, at(0.17, method)).error(), Refusal::notFinite);
            }
            for (double TouchSettings::*field :
                 {&TouchSettings::contactDistance_m, &TouchSettings::linkStiffness_NPerM,
                  &TouchSettings::linkStiffnessSe_NPerM}) {
                TouchSettings settings = at(0.17, method);
                settings.*field = value;
                EXPECT_EQ(estimate(log, settings).error(), Refusal::notFinite);
            }
            for (std::optional<double> TouchSettings::*field :
                 {&TouchSettings::contactDistanceSe_m, &TouchSettings::torqueReference_Nm}) {
                TouchSettings settings = at(0.17, method);
                settings.*field = value;
                EXPECT_EQ(estimate(log, settings).error(), Refusal::notFinite);
            }
            TouchSettings settings = at(0.17, method);
            settings.window.high_Nm = value;
            EXPECT_EQ(estimate(log, settings).error(), Refusal::notFinite);
            settings = at(0.17, method);
            settings.torqueNoise_Nm = value;
            EXPECT_EQ(estimate(log, settings).error(), Refusal::notFinite);
        }
    }
}

TEST(StiffnessStability, numbersThatCannotBeReckonedWithAreRefused) {
    const auto log = cleanTouch(1.0 / 282.0);
    for (const Method method : kMethods) {
        EXPECT_EQ(estimate(log, at(1e-200, method)).error(), Refusal::outOfRange);
        EXPECT_EQ(estimate(log, at(1e200, method)).error(), Refusal::outOfRange);
        TouchSettings settings = at(0.17, method);
        settings.linkStiffness_NPerM = std::numeric_limits<double>::denorm_min();
        EXPECT_EQ(estimate(log, settings).error(), Refusal::outOfRange);
        auto huge = log;
        huge.back().torque_Nm = std::numeric_limits<double>::max();
        EXPECT_EQ(estimate(huge, at(0.17, method)).error(), Refusal::outOfRange);
    }
}

TEST(StiffnessStability, emptyOneTwoAndThreeSamplesHaveDefinedAnswers) {
    const std::vector<JointSample> two{{0.0, 0.0, 0.02}, {1.0, 0.002, 0.05}};
    const std::vector<JointSample> three{{0.0, 0.0, 0.02}, {0.5, 0.001, 0.0351}, {1.0, 0.002, 0.05}};
    for (const Method method : kMethods)
        EXPECT_EQ(estimate({}, at(0.17, method)).error(), Refusal::noSamples);
    EXPECT_EQ(estimate({{0.0, 0.0, 0.03}}, at(0.17, Method::twoPoint)).error(), Refusal::windowNotReached);
    EXPECT_EQ(estimate({{0.0, 0.0, 0.03}}, at(0.17, Method::regression)).error(), Refusal::tooFewSamples);
    EXPECT_EQ(estimate(two, at(0.17, Method::regression)).error(), Refusal::tooFewSamples);
    EXPECT_EQ(estimate(three, at(0.17, Method::regression)).error(), Refusal::tooFewSamples);

    const auto answer = estimate(two, at(0.17, Method::twoPoint));
    ASSERT_TRUE(answer);
    expectSane(*answer);
    EXPECT_NEAR(answer->total.value_NPerM.value(), 0.03 / (0.17 * 0.17 * 0.002), 1e-9);
    EXPECT_FALSE(answer->total.se_NPerM);
    const auto roughly = estimate(three, at(0.17, Method::twoPoint));
    ASSERT_TRUE(roughly);
    expectSane(*roughly);
    EXPECT_TRUE(roughly->total.lower95_NPerM) << "three samples tell a noise, however roughly";
}

TEST(StiffnessStability, aRegressionNeedsTwentySamplesInTheWindow) {
    const auto rampOf = [](int samples) {
        std::vector<JointSample> log;
        for (int i = 0; i < samples; ++i) {
            const double share = samples > 1 ? static_cast<double>(i) / (samples - 1) : 0.0;
            log.push_back({0.001 * i, 0.002 * share, 0.02 + 0.03 * share});
        }
        return log;
    };
    EXPECT_EQ(estimate(rampOf(19), at(0.17, Method::regression)).error(), Refusal::tooFewSamples);
    const auto touch = estimate(rampOf(20), at(0.17, Method::regression));
    ASSERT_TRUE(touch);
    expectSane(*touch);
    EXPECT_EQ(touch->samples, 20U);
    EXPECT_EQ(touch->effectiveSamples, 20.0);
}

TEST(StiffnessStability, oneSampleManyTimesIsOneSample) {
    const std::vector<JointSample> log(1000, JointSample{0.0, 0.0, 0.03});
    EXPECT_EQ(estimate(log, at(0.17, Method::regression)).error(), Refusal::tooFewSamples);
    EXPECT_EQ(estimate(log, at(0.17, Method::twoPoint)).error(), Refusal::windowNotReached);
}

TEST(StiffnessStability, equalTimesStillGiveTheStiffness) {
    auto log = cleanTouch(1.0 / 282.0);
    for (JointSample& sample : log)
        sample.time_s = 4.0;
    for (const Method method : kMethods) {
        const auto touch = estimate(log, at(0.17, method));
        ASSERT_TRUE(touch && touch->object.value_NPerM);
        EXPECT_NEAR(*touch->object.value_NPerM, 282.0, 1e-6);
    }
}

TEST(StiffnessStability, anAngleThatDoesNotTurnIsABound) {
    for (const Method method : kMethods) {
        for (const double angle_rad : {0.0, 1.0, -1e6}) {
            auto log = cleanTouch(1.0 / 282.0);
            for (JointSample& sample : log)
                sample.angle_rad = angle_rad;
            const auto touch = estimate(log, at(0.17, method));
            ASSERT_TRUE(touch);
            expectSane(*touch);
            EXPECT_NEAR(touch->object.lower95_NPerM.value(), kPaperLinkStiffness_NPerM, 1e-9);
            EXPECT_EQ(touch->material, Material::metal);
        }
    }
}

TEST(StiffnessStability, aLinkSofterThanTheTotalByAnyFactorIsABoundThatFallsBackToTheLink) {
    const auto log = cleanTouch(1.0 / 1325.9);
    for (const Method method : kMethods) {
        double last_NPerM = std::numeric_limits<double>::max();
        for (int decade = 0; decade <= 12; ++decade) {
            TouchSettings settings = at(0.17, method);
            settings.linkStiffness_NPerM = 900.0 * std::pow(10.0, -decade); // k_i is 959.2
            const auto touch = estimate(log, settings);
            ASSERT_TRUE(touch);
            expectSane(*touch);
            EXPECT_TRUE(touch->stifferThanLink);
            EXPECT_TRUE(touch->object.onlyBound());
            EXPECT_GE(*touch->object.lower95_NPerM, settings.linkStiffness_NPerM * (1.0 - 1e-9));
            EXPECT_LT(*touch->object.lower95_NPerM, last_NPerM);
            last_NPerM = *touch->object.lower95_NPerM;
        }
    }
}

TEST(StiffnessStability, noiseAsLargeAsTheWindowIsAnswered) {
    for (const Method method : kMethods) {
        for (const double noise_Nm : {0.005, 0.015, 0.05, 0.5}) {
            for (unsigned seed = 0; seed < 50; ++seed) {
                SimulatedTouch world;
                world.objectCompliance_mPerN = 1.0 / 1325.9;
                world.torqueNoise_Nm = noise_Nm;
                world.freeMotion_s = 0.0;
                const auto touch = estimate(world.record(seed), at(0.17, method));
                if (touch)
                    expectSane(*touch);
                else
                    EXPECT_TRUE(touch.error() == Refusal::tooFewSamples ||
                                touch.error() == Refusal::windowNotReached ||
                                touch.error() == Refusal::angleOpposesTorque);
            }
        }
    }
}

TEST(StiffnessStability, aMillionSamplesLoseNoDigits) {
    std::vector<JointSample> log;
    constexpr int kSamples = 1'000'000;
    for (int i = 0; i < kSamples; ++i) {
        const double share = static_cast<double>(i) / (kSamples - 1);
        log.push_back({share, 1e-3 * share, 0.06 * share});
    }
    const auto touch = estimate(log, at(0.17, Method::regression));
    ASSERT_TRUE(touch && touch->total.value_NPerM);
    const double truth_NPerM = 0.06 / (0.17 * 0.17 * 1e-3);
    EXPECT_NEAR(*touch->total.value_NPerM, truth_NPerM, 1e-11 * truth_NPerM);
}

TEST(ContactDetectorStability, tenMillionSamplesOfNoiseAreNoContact) {
    ContactDetector detector;
    std::mt19937_64 random(1);
    std::uint64_t contacts = 0;
    for (int i = 0; i < 10'000'000; ++i) {
        const double torque_Nm = (static_cast<double>(random() >> 11U) * 0x1p-53 - 0.5) * 0.0049;
        contacts += detector.update({0.001 * i, 0.0, torque_Nm}) == ContactPhase::contact ? 1U : 0U;
    }
    EXPECT_EQ(contacts, 0U);
    EXPECT_TRUE(detector.transition().empty());
}

TEST(ContactDetectorStability, nonFiniteReadingsRaiseNothingAndChangeNothing) {
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    ContactDetector detector({.threshold_Nm = nan, .noiseFloor_Nm = nan, .capacity = 10});
    EXPECT_EQ(detector.update({0.0, 0.0, infinity}, infinity), ContactPhase::free);
    EXPECT_EQ(detector.update({nan, 0.0, 1.0}), ContactPhase::free);
    EXPECT_EQ(detector.update({0.0, infinity, 1.0}), ContactPhase::free);
    EXPECT_EQ(detector.samplesLeftOut(), 3U);
}

TEST(MaterialStability, anyNumberHasAClass) {
    EXPECT_EQ(classify(std::numeric_limits<double>::quiet_NaN()), Material::metal);
    EXPECT_EQ(classify(std::numeric_limits<double>::infinity()), Material::metal);
    EXPECT_EQ(classify(std::numeric_limits<double>::denorm_min()), Material::sponge);
    EXPECT_EQ(classify(1e-12), Material::sponge);
    EXPECT_EQ(classify(1e12), Material::metal);
}
