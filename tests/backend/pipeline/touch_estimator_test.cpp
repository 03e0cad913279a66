// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/touch_estimator.h"
#include "tests/backend/pipeline/touch_run.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <optional>
#include <vector>

using namespace teleta;

using pipeline::TouchEstimator;
using pipeline::TouchEstimatorSettings;
using pipeline::TouchRecord;
using stiffness::ContactPhase;
using stiffness::Refusal;
using test::paperArm;
using test::ScriptedArm;
using test::TouchRun;

namespace {

constexpr std::size_t kElbow = 3;
constexpr double kMaterials_NPerM[] = {stiffness::kSpongeStiffness_NPerM,
                                       stiffness::kRubberSpongeStiffness_NPerM,
                                       stiffness::kRubberStiffness_NPerM, stiffness::kWoodStiffness_NPerM};

} // namespace

TEST(TouchEstimator, measuresTheStiffnessOfThePapersObjects) {
    for (const auto method : {stiffness::Method::regression, stiffness::Method::twoPoint}) {
        for (const double stiffness_NPerM : kMaterials_NPerM) {
            TouchEstimatorSettings settings = TouchRun::withoutInertia();
            settings.method = method;
            TouchRun run(ScriptedArm(0.175, std::numbers::pi, stiffness_NPerM), settings);
            run.idle(100);
            run.elbowTo(0.08, 80);
            run.idle(100);
            ASSERT_EQ(run.records.size(), 1U);
            const TouchRecord& touch = run.records.front();
            EXPECT_EQ(touch.number, 1U);
            EXPECT_EQ(touch.joint, kElbow);
            ASSERT_TRUE(touch.stiffness && touch.stiffness->object.value_NPerM);
            EXPECT_NEAR(*touch.stiffness->object.value_NPerM, stiffness_NPerM, 1e-6 * stiffness_NPerM);
            EXPECT_EQ(touch.stiffness->method, method);
            EXPECT_EQ(touch.stiffness->material, stiffness::classify(stiffness_NPerM));
            EXPECT_FALSE(touch.refusal);
        }
    }
}

TEST(TouchEstimator, saysOfARigidObjectThatItIsAtLeastSoStiff) {
    TouchRun run(ScriptedArm(0.175, std::numbers::pi, 1e12));
    run.arm.torqueNoise_Nm = 0.0005;
    run.idle(100);
    run.elbowTo(0.08, 80);
    ASSERT_EQ(run.records.size(), 1U);
    ASSERT_TRUE(run.records[0].stiffness);
    EXPECT_TRUE(run.records[0].stiffness->object.onlyBound());
    EXPECT_EQ(run.records[0].stiffness->material, stiffness::Material::metal);
    EXPECT_FALSE(run.records[0].stiffness->stifferThanLink);
}

TEST(TouchEstimator, staysWithinItsIntervalUnderTheNoiseOfTheTorqueSensor) {
    // 95 % intervals of 200 touches: 190 expected, standard deviation 3.1; four of them below.
    int inside = 0;
    TouchRun run(ScriptedArm(0.175, std::numbers::pi, 1325.9));
    run.arm.torqueNoise_Nm = 0.0005;
    run.idle(1000);
    for (int touch = 0; touch < 200; ++touch) {
        run.elbowTo(0.08, 80);
        run.elbowTo(0.0, 40);
        run.idle(100);
    }
    ASSERT_EQ(run.records.size(), 200U);
    for (const TouchRecord& touch : run.records) {
        ASSERT_TRUE(touch.stiffness && touch.stiffness->object.lower95_NPerM);
        inside += *touch.stiffness->object.lower95_NPerM <= 1325.9 &&
                  touch.stiffness->object.upper95_NPerM.value_or(1e300) >= 1325.9;
    }
    EXPECT_GE(inside, 178);
}

TEST(TouchEstimator, findsPointAndForceOfTheContact) {
    TouchRun run(ScriptedArm(0.21, std::numbers::pi, 282.0));
    run.idle(100);
    run.elbowTo(0.08, 80);
    ASSERT_EQ(run.records.size(), 1U);
    const TouchRecord& touch = run.records[0];
    ASSERT_TRUE(touch.located);
    EXPECT_NEAR(touch.contactDistance_m, 0.21, 1e-12);
    EXPECT_NEAR(touch.side_rad, std::numbers::pi, 1e-12);

    const arm::Arm4Kinematics kinematics;
    const double dTheta_rad =
        touch.torque_Nm * (1.0 / paperArm().elbowStiffness_NmPerRad + 1.0 / 282.0 / (0.21 * 0.21));
    Eigen::Vector4d pose(run.arm.pose_rad.data());
    pose[3] += dTheta_rad;
    const Eigen::Vector3d expected_m =
        kinematics.p_Base_Point(arm::Link::forearm, pose, kinematics.p_Link_Skin(0.21, std::numbers::pi));
    // The reference follows the first samples of the rise by 31 uNm, which is 0.5 um here.
    EXPECT_LT((touch.p_Base_Contact_m - expected_m).norm(), 1e-6);

    // The scripted torques belong to the pose without the deflection of about 6 mrad.
    ASSERT_TRUE(touch.force);
    const double force_N = touch.torque_Nm / 0.21;
    EXPECT_LT((touch.force->force_N - force_N * run.arm.normal_Base()).norm(), 0.02 * force_N);
}

TEST(TouchEstimator, recordsATouchTenMillisecondsAfterTheWindowOrWhenItIsFarBeyond) {
    for (const int samples : {400, 20}) {
        TouchRun run(ScriptedArm{});
        run.idle(100);
        run.elbowTo(0.08, samples);
        ASSERT_EQ(run.records.size(), 1U);
        const TouchRecord& touch = run.records[0];
        // torque = 0.08 n / samples, first above 0.05 and, in the fast touch, above 0.065.
        const int passed = samples == 400 ? 251 : 13;
        const int ready = samples == 400 ? passed + 10 : 17;
        EXPECT_NEAR(touch.ready_s, 1e-3 * (100 + ready), 1e-9) << samples;
        EXPECT_EQ(touch.ready_ns, run.arm.clockOffset_ns + (100 + ready) * 1'000'000) << samples;
        EXPECT_EQ(touch.arrived_ns, touch.ready_ns + 3'000'000) << samples;
        // The reference follows the first 12 samples of the rise: 2.5 mNm / 2 * 12 ms / 0.5 s.
        EXPECT_NEAR(touch.torque_Nm, 0.08 * ready / samples, 31e-6);
    }
}

TEST(TouchEstimator, beginsATouchAtTheFirstSampleAboveTheNoise) {
    TouchRun run(ScriptedArm{});
    run.idle(100);
    run.elbowTo(0.08, 400); // 0.2 mNm a sample, the shoulder's up to (0.3 + 0.175) / 0.175 times as much
    ASSERT_EQ(run.records.size(), 1U);
    const double start_samples = (run.records[0].start_s - 0.1) / 1e-3;
    EXPECT_LE(start_samples, 13.0); // 12.5 samples are 2.5 mNm of the elbow
    EXPECT_GE(start_samples, 13.0 * 0.175 / 0.475 - 1.0);
}

TEST(TouchEstimator, takesTheLeverOfAContactBesideTheCrest) {
    const double side_rad = std::numbers::pi - 0.8;
    TouchRun run(ScriptedArm(0.175, side_rad, 1325.9));
    run.idle(100);
    run.elbowTo(0.08, 200);
    ASSERT_EQ(run.records.size(), 1U);
    EXPECT_NEAR(run.records[0].side_rad, side_rad, 1e-12);
    ASSERT_TRUE(run.records[0].stiffness);
    EXPECT_NEAR(*run.records[0].stiffness->object.value_NPerM, 1325.9, 1e-6 * 1325.9);
}

TEST(TouchEstimator, countsTheMotionOfAllJointsIntoTheDepth) {
    // The shoulder presses the forearm into the object while the elbow keeps still: torque and depth are
    // those of an elbow that turns.
    TouchRun run(ScriptedArm(0.175, std::numbers::pi, 1325.9));
    const arm::Arm4Kinematics kinematics;
    const Eigen::Vector4d pose(run.arm.pose_rad.data());
    const Eigen::Vector4d depthPerAngle_m =
        kinematics.pointJacobian(arm::Link::forearm, pose, kinematics.p_Link_Skin(0.175, std::numbers::pi))
            .transpose() *
        run.arm.normal_Base();
    run.corrupt = [&](core::JointSample& sample) {
        const double turned_rad = sample.angle_rad[kElbow] - run.arm.pose_rad[kElbow];
        sample.angle_rad[kElbow] = run.arm.pose_rad[kElbow];
        sample.angle_rad[1] += turned_rad * depthPerAngle_m[3] / depthPerAngle_m[1];
    };
    run.idle(100);
    run.elbowTo(0.08, 80);
    ASSERT_EQ(run.records.size(), 1U);
    ASSERT_TRUE(run.records[0].stiffness && run.records[0].stiffness->object.value_NPerM);
    // The Jacobian is that of the evaluated pose, some mrad from the scripted one.
    EXPECT_NEAR(*run.records[0].stiffness->object.value_NPerM, 1325.9, 0.02 * 1325.9);
}

TEST(TouchEstimator, endsATouchWhenTheSkinFeelsItNoMore) {
    TouchRun run(ScriptedArm{});
    run.idle(100);
    run.elbowTo(0.04, 40); // the shoulder is over the threshold, the elbow is not
    run.elbowTo(0.04, 100);
    ASSERT_TRUE(run.records.empty());
    // The arm leaves: its inertia is felt, the skin is free, the point is that of before.
    run.arm.pose_rad[1] += 0.1;
    run.skinWorks = false;
    EXPECT_FALSE(run.estimator.update(run.arm.skin(0.0)));
    run.forceTo(1.0, 1);
    ASSERT_EQ(run.records.size(), 1U);
    EXPECT_NEAR(run.records[0].torque_Nm, 0.04, 1e-3);
    const arm::Arm4Kinematics kinematics;
    Eigen::Vector4d pose(run.arm.pose_rad.data());
    pose[1] -= 0.1;
    const Eigen::Vector3d expected_m =
        kinematics.p_Base_Point(arm::Link::forearm, pose, kinematics.p_Link_Skin(0.175, std::numbers::pi));
    EXPECT_LT((run.records[0].p_Base_Contact_m - expected_m).norm(), 1e-3);
}

TEST(TouchEstimator, evaluatesATouchFromTheOtherSideAlike) {
    TouchRun run(ScriptedArm(0.175, 0.0, 282.0));
    run.idle(100);
    run.elbowTo(-0.08, 80);
    ASSERT_EQ(run.records.size(), 1U);
    EXPECT_LT(run.records[0].torque_Nm, -0.05);
    ASSERT_TRUE(run.records[0].stiffness);
    EXPECT_NEAR(*run.records[0].stiffness->object.value_NPerM, 282.0, 1e-6 * 282.0);
}

TEST(TouchEstimator, leavesTheStiffnessOutWhenTheElbowHasNoLever) {
    TouchRun run(ScriptedArm(0.0, std::numbers::pi, 1325.9)); // on the axis of the elbow
    run.idle(100);
    run.forceTo(1.0, 100);
    ASSERT_EQ(run.records.size(), 1U);
    const TouchRecord& touch = run.records[0];
    EXPECT_NE(touch.joint, kElbow);
    EXPECT_GT(std::abs(touch.torque_Nm), 0.05);
    EXPECT_TRUE(touch.located);
    EXPECT_TRUE(touch.force);
    EXPECT_FALSE(touch.stiffness);
    EXPECT_EQ(touch.refusal, Refusal::notPositive);
    // The skin told at once, nobody waited for the elbow.
    EXPECT_LT(touch.ready_s, 0.2);
}

TEST(TouchEstimator, waitsForTheElbowWhenAnotherJointFeelsTheTouchFirst) {
    TouchEstimatorSettings settings = TouchRun::withoutInertia();
    settings.elbowWait_s = 0.5;
    TouchRun run(ScriptedArm{}, settings);
    run.idle(100);
    run.elbowTo(0.04, 200);
    run.elbowTo(0.04, 600); // the shoulder is over the threshold, the elbow stays within the window
    ASSERT_EQ(run.records.size(), 1U);
    EXPECT_GT(run.records[0].ready_s, 0.5);
    // What the elbow felt of the window is evaluated.
    EXPECT_EQ(run.records[0].joint, kElbow);
    ASSERT_TRUE(run.records[0].stiffness);
    EXPECT_NEAR(*run.records[0].stiffness->object.value_NPerM, 1325.9, 1e-6 * 1325.9);
    run.elbowTo(0.08, 100);
    EXPECT_EQ(run.records.size(), 1U) << "one record a touch";
}

TEST(TouchEstimator, recordsNoTouchThatIsReleasedBeforeTheThreshold) {
    TouchRun run(ScriptedArm{});
    run.idle(100);
    const double threshold_N = run.arm.forceFor_N(0.05) * 0.175 / 0.475; // under that of the shoulder too
    run.forceTo(0.9 * threshold_N, 50);
    run.forceTo(0.0, 50);
    run.idle(100);
    EXPECT_TRUE(run.records.empty());
    EXPECT_EQ(run.estimator.touchesTooGentle(), 1U);
    EXPECT_EQ(run.estimator.touches(), 0U);
}

TEST(TouchEstimator, evaluatesATouchThatIsReleasedAtOnce) {
    TouchRun run(ScriptedArm{});
    run.idle(100);
    run.elbowTo(0.052, 52);
    run.elbowTo(0.0, 3);
    run.idle(50);
    ASSERT_EQ(run.records.size(), 1U);
    ASSERT_TRUE(run.records[0].stiffness);
    EXPECT_NEAR(*run.records[0].stiffness->object.value_NPerM, 1325.9, 1e-6 * 1325.9);
    EXPECT_GT(run.records[0].torque_Nm, 0.05) << "the force is that of the touch, not of the release";
}

TEST(TouchEstimator, recordsATouchThatTheSkinDoesNotFeelWithoutItsPlace) {
    TouchRun run(ScriptedArm{});
    run.skinWorks = false;
    run.idle(100);
    run.elbowTo(0.08, 80);
    EXPECT_TRUE(run.records.empty()) << "the skin may be late";
    run.elbowTo(0.08, 100);
    ASSERT_EQ(run.records.size(), 1U);
    EXPECT_FALSE(run.records[0].located);
    EXPECT_FALSE(run.records[0].force);
    EXPECT_FALSE(run.records[0].stiffness);
    EXPECT_FALSE(run.records[0].refusal);
    EXPECT_EQ(run.records[0].joint, kElbow);
}

TEST(TouchEstimator, takesWeakContactsOfTheSkinForNoise) {
    TouchRun run(ScriptedArm{});
    run.skinWorks = false;
    run.idle(100);
    for (int i = 0; i < 200; ++i) {
        run.elbowTo(std::min(0.08, 0.001 * i), 1);
        pipeline::SkinContact noise = run.arm.skin(0.049);
        noise.x_m = 0.1;
        EXPECT_FALSE(run.estimator.update(noise));
        EXPECT_FALSE(run.estimator.liveContact());
    }
    ASSERT_EQ(run.records.size(), 1U);
    EXPECT_FALSE(run.records[0].located);
}

TEST(TouchEstimator, doesNotTakeTheInertiaOfTheArmForATouch) {
    // 0.1 kg m^2 at 1 rad/s^2 is twice the threshold. Speeds up for 0.2 s, moves on, and slows down.
    const auto accelerate = [](TouchRun& run, double acceleration_radPerS2, double& rate_radPerS) {
        for (int i = 0; i < 200; ++i) {
            rate_radPerS += 1e-3 * acceleration_radPerS2;
            run.arm.reference_rad[1] += 1e-3 * rate_radPerS;
            run.arm.offset_Nm[1] = 0.1 * acceleration_radPerS2;
            run.step(0.0);
        }
        run.arm.offset_Nm[1] = 0.0;
        for (int i = 0; i < 500; ++i) {
            run.arm.reference_rad[1] += 1e-3 * rate_radPerS;
            run.step(0.0);
        }
    };
    TouchRun run(ScriptedArm{});
    run.idle(100);
    double rate_radPerS = 0.0;
    accelerate(run, 1.0, rate_radPerS);
    accelerate(run, -1.0, rate_radPerS);
    EXPECT_TRUE(run.records.empty());
    EXPECT_EQ(run.estimator.touchesByInertia(), 2U);
    // The same torque while the arm stands still is a touch of something that has no skin.
    run.arm.offset_Nm[1] = 0.1;
    run.idle(1500);
    EXPECT_EQ(run.records.size(), 1U);
    EXPECT_EQ(run.estimator.touchesByInertia(), 2U);
}

TEST(TouchEstimator, waitsForALateSkin) {
    TouchRun run(ScriptedArm{});
    run.skinWorks = false;
    run.idle(100);
    run.elbowTo(0.08, 80);
    const auto record = run.estimator.update(run.arm.skin(0.4));
    ASSERT_TRUE(record);
    EXPECT_TRUE(record->located);
    EXPECT_TRUE(record->stiffness);
    run.elbowTo(0.08, 200);
    EXPECT_TRUE(run.records.empty());
}

TEST(TouchEstimator, doesNotTakeAnOldContactOfTheSkinForThisOne) {
    TouchRun run(ScriptedArm{});
    run.skinWorks = false;
    run.idle(100);
    EXPECT_FALSE(run.estimator.update(run.arm.skin(0.4)));
    run.idle(300);
    run.elbowTo(0.08, 80);
    run.elbowTo(0.08, 200);
    ASSERT_EQ(run.records.size(), 1U);
    EXPECT_FALSE(run.records[0].located);
}

TEST(TouchEstimator, countsLoadingUnloadingAndLoadingAgainAsOneTouch) {
    TouchRun run(ScriptedArm(0.175, std::numbers::pi, 282.0));
    run.idle(100);
    run.elbowTo(0.04, 80);
    run.elbowTo(0.008, 60); // not released
    run.elbowTo(0.08, 80);
    run.elbowTo(0.03, 80);
    run.elbowTo(0.09, 80);
    run.elbowTo(0.0, 50);
    run.idle(100);
    ASSERT_EQ(run.records.size(), 1U);
    ASSERT_TRUE(run.records[0].stiffness);
    EXPECT_NEAR(*run.records[0].stiffness->object.value_NPerM, 282.0, 1e-6 * 282.0);
    run.elbowTo(0.08, 80);
    EXPECT_EQ(run.records.size(), 2U) << "after the release a new touch begins";
    EXPECT_EQ(run.records.back().number, 2U);
}

TEST(TouchEstimator, countsABounceAsTheSameTouch) {
    TouchRun run(ScriptedArm{});
    run.idle(100);
    run.elbowTo(0.08, 40);
    run.elbowTo(0.0, 5);
    run.idle(10);
    run.elbowTo(0.08, 40);
    EXPECT_EQ(run.records.size(), 1U);
}

TEST(TouchEstimator, followsSlowDriftOfAFreeJoint) {
    TouchRun run(ScriptedArm{});
    run.idle(100);
    // 0.2 Nm in 100 s: four times the threshold.
    for (int sample = 0; sample < 100'000; ++sample) {
        run.arm.offset_Nm[kElbow] += 0.002e-3;
        run.step(0.0);
    }
    EXPECT_TRUE(run.records.empty());
    // The mean of an exponential window lags by drift times time constant.
    EXPECT_NEAR(run.estimator.reference_Nm()[kElbow], 0.2 - 0.002 * 0.5, 1e-4);
    // It goes on during the touch.
    for (int sample = 1; sample <= 80; ++sample) {
        run.arm.offset_Nm[kElbow] += 0.002e-3;
        run.elbowTo(0.001 * sample, 1);
    }
    ASSERT_EQ(run.records.size(), 1U);
    ASSERT_TRUE(run.records[0].stiffness);
    EXPECT_NEAR(*run.records[0].stiffness->object.value_NPerM, 1325.9, 0.001 * 1325.9);
}

// c_o = P_C^2 (dTheta/dTau - 1/K): 2 c_o dP_C / P_C for the skin, P_C^2 dK / K^2 for the elbow.
TEST(TouchEstimator, standardErrorsOfSkinAndElbowEnterThatOfTheObject) {
    const auto touch = [](double centreSe_m, double elbowSe_NmPerRad) {
        core::ArmDescription description = paperArm();
        description.skin.centreSe_m = centreSe_m;
        description.elbowStiffnessSe_NmPerRad = elbowSe_NmPerRad;
        TouchRun run(ScriptedArm{});
        run.estimator = TouchEstimator(description, TouchRun::withoutInertia());
        run.idle(100);
        run.elbowTo(0.08, 80);
        return run.records.at(0);
    };
    const TouchRecord exact = touch(0.0, 0.0);
    ASSERT_TRUE(exact.stiffness);
    const double distance_m = exact.contactDistance_m;
    const stiffness::Compliance& object = exact.stiffness->objectCompliance;
    const double ofSkin_mPerN = 2.0 * object.value_mPerN * 1e-4 / distance_m;
    EXPECT_NEAR(touch(1e-4, 0.0).stiffness->objectCompliance.se_mPerN.value(),
                std::hypot(object.se_mPerN.value(), ofSkin_mPerN), 0.01 * ofSkin_mPerN);
    EXPECT_EQ(touch(1e-4, 0.0).contactDistanceSe_m, 1e-4);
    const double ofElbow_mPerN = std::pow(distance_m / paperArm().elbowStiffness_NmPerRad, 2);
    EXPECT_NEAR(touch(0.0, 1.0).stiffness->objectCompliance.se_mPerN.value(),
                std::hypot(object.se_mPerN.value(), ofElbow_mPerN), 0.01 * ofElbow_mPerN);
}

TEST(TouchEstimator, anEmptyFrameOfTheSkinEndsNoTouch) {
    TouchRun run(ScriptedArm{});
    run.idle(100);
    run.elbowTo(0.03, 300);
    const auto phases = run.estimator.phases();
    ASSERT_TRUE(std::ranges::count(phases, ContactPhase::contact) > 0) << "another joint is beyond it";
    ASSERT_EQ(phases[kElbow], ContactPhase::transition);
    EXPECT_FALSE(run.estimator.update(run.arm.skin(0.0)));
    run.elbowTo(0.08, 500);
    ASSERT_EQ(run.records.size(), 1U);
    EXPECT_EQ(run.records.front().joint, kElbow);
    EXPECT_TRUE(run.records.front().stiffness);
}

TEST(TouchEstimator, doesNotLearnAHeldTouchAsReference) {
    TouchRun run(ScriptedArm{});
    run.idle(100);
    run.elbowTo(0.08, 80);
    run.elbowTo(0.08, 10'000);
    EXPECT_NEAR(run.estimator.reference_Nm()[kElbow], 0.0, 1e-4);
    EXPECT_EQ(run.estimator.phases()[kElbow], ContactPhase::contact);
    EXPECT_EQ(run.records.size(), 1U);
}

TEST(TouchEstimator, takesATorqueThatStaysWithoutTheSkinAsNewReference) {
    TouchRun run(ScriptedArm{});
    run.idle(100);
    run.arm.offset_Nm[kElbow] = 0.03; // somebody hung a weight on the arm
    run.idle(1900);
    EXPECT_EQ(run.estimator.phases()[kElbow], ContactPhase::transition);
    run.idle(200);
    EXPECT_EQ(run.estimator.phases()[kElbow], ContactPhase::free);
    EXPECT_NEAR(run.estimator.reference_Nm()[kElbow], 0.03, 1e-6);
    run.elbowTo(0.08, 80);
    ASSERT_EQ(run.records.size(), 1U);
    EXPECT_NEAR(*run.records[0].stiffness->object.value_NPerM, 1325.9, 1e-3 * 1325.9);
}

TEST(TouchEstimator, leavesOutSamplesThatAreNoNumbers) {
    TouchRun run(ScriptedArm{});
    int count = 0;
    int bad = 0;
    run.corrupt = [&](core::JointSample& sample) {
        if (++count % 7 != 0)
            return;
        ++bad;
        const double values[] = {std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::infinity()};
        (bad % 2 == 0 ? sample.torque_Nm : sample.angle_rad)[static_cast<std::size_t>(bad % 4)] =
            values[bad % 2];
    };
    run.idle(100);
    run.elbowTo(0.08, 80);
    ASSERT_EQ(run.records.size(), 1U);
    ASSERT_TRUE(run.records[0].stiffness);
    EXPECT_NEAR(*run.records[0].stiffness->object.value_NPerM, 1325.9, 1e-6 * 1325.9);
    EXPECT_EQ(run.estimator.samplesLeftOut(), static_cast<std::uint64_t>(bad));
    const auto nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(run.estimator.update(
        pipeline::SkinContact{.touching = true, .x_m = nan, .y_m = 0.0, .force_N = 1.0}));
    EXPECT_FALSE(run.estimator.liveContact());
}

TEST(TouchEstimator, beginsAnewAfterADiscontinuity) {
    TouchRun run(ScriptedArm{});
    run.idle(100);
    run.elbowTo(0.045, 45);
    bool jumped = false;
    run.corrupt = [&](core::JointSample& sample) { sample.discontinuity = !std::exchange(jumped, true); };
    run.arm.offset_Nm[kElbow] = 0.5; // of another place in the stream
    run.idle(100);
    EXPECT_TRUE(run.records.empty()) << "half a touch on either side of the jump is none";
    EXPECT_EQ(run.estimator.phases()[kElbow], ContactPhase::free);
    EXPECT_NEAR(run.estimator.reference_Nm()[kElbow], 0.5, 1e-12);
    run.elbowTo(0.08, 80);
    EXPECT_EQ(run.records.size(), 1U);
}

TEST(TouchEstimator, recordsACompleteTouchBeforeAJump) {
    TouchRun run(ScriptedArm{});
    run.skinWorks = false;
    run.idle(100);
    run.elbowTo(0.08, 80);
    ASSERT_TRUE(run.records.empty());
    core::JointSample jump = run.arm.next(0.0);
    jump.sourceTime_s = 0.0; // the time runs back
    const auto record = run.estimator.update(jump);
    ASSERT_TRUE(record);
    EXPECT_FALSE(record->located);
    EXPECT_NEAR(record->ready_s, 0.18, 1e-9);
}

TEST(TouchEstimator, showsTheContactOfTheMoment) {
    TouchRun run(ScriptedArm{});
    run.idle(100);
    EXPECT_FALSE(run.estimator.liveContact());
    run.elbowTo(0.08, 100);
    const auto contact = run.estimator.liveContact();
    ASSERT_TRUE(contact && contact->force);
    EXPECT_NEAR(contact->contactDistance_m, 0.175, 1e-12);
    EXPECT_NEAR(contact->force->force_N.dot(run.arm.normal_Base()), 0.08 / 0.175, 0.01);
    run.skinWorks = false;
    run.elbowTo(0.08, 300);
    EXPECT_FALSE(run.estimator.liveContact()) << "a skin that fell silent feels nothing";
}

TEST(TouchEstimator, beginsThePlaceAnewWhenTheContactIsElsewhere) {
    TouchRun run(ScriptedArm{});
    run.idle(100);
    run.skinWorks = false;
    run.elbowTo(0.04, 40);
    pipeline::SkinContact wrong = run.arm.skin(10.0);
    wrong.x_m += 0.02;
    EXPECT_FALSE(run.estimator.update(wrong));
    EXPECT_FALSE(run.estimator.update(run.arm.skin(0.2)));
    run.elbowTo(0.08, 40);
    ASSERT_EQ(run.records.size(), 1U);
    EXPECT_NEAR(run.records[0].contactDistance_m, 0.175, 1e-12);
}

TEST(TouchEstimator, aTouchThatIsQuickerThanTheArmsInertiaAllowsTellsNoStiffness) {
    // From 0.02 to 0.05 Nm within 78 and within 72 ms.
    for (const int samples : {208, 192}) {
        TouchRun run(ScriptedArm{}, TouchEstimatorSettings{});
        run.idle(100);
        run.elbowTo(0.08, samples);
        run.idle(100);
        ASSERT_EQ(run.records.size(), 1U);
        EXPECT_TRUE(run.records[0].located);
        EXPECT_EQ(run.records[0].stiffness.has_value(), samples == 208);
        EXPECT_EQ(run.records[0].refusal == stiffness::Refusal::tooQuick, samples == 192);
    }
}

TEST(TouchEstimator, takesNewSettingsWhileItRuns) {
    TouchRun run(ScriptedArm{});
    run.idle(100);
    TouchEstimatorSettings settings = TouchRun::withoutInertia();
    settings.method = stiffness::Method::twoPoint;
    run.estimator.setSettings(settings);
    run.elbowTo(0.08, 80);
    ASSERT_EQ(run.records.size(), 1U);
    EXPECT_EQ(run.records[0].stiffness->method, stiffness::Method::twoPoint);
    settings.detection.threshold_Nm = 0.1;
    run.estimator.setSettings(settings);
    EXPECT_EQ(run.estimator.phases()[kElbow], ContactPhase::free);
    run.idle(100);
    run.forceTo(run.arm.forceFor_N(0.09) * 0.175 / 0.475, 80);
    run.idle(100);
    EXPECT_EQ(run.records.size(), 1U);
}
