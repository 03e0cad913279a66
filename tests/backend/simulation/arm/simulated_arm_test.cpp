// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/arm/simulated_arm.h"
#include "tests/backend/simulation/arm/arm_scene.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <set>

namespace teleta::simulation::test {

namespace {

const core::ArmDemand kProgram{.drive = core::ArmDrive::program, .rate_radPerS = {}};

struct Log {
    std::vector<core::JointSample> joints;
    std::vector<float> skin; ///< all frames in a row
};

Log run(SimulatedArm& arm, double duration_s, const core::ArmDemand& demand = kProgram) {
    Log log;
    std::vector<float> frame(arm.skinDescription().layout.taxels());
    const double end_s = arm.time_s() + duration_s;
    while (arm.time_s() < end_s - 1e-9) {
        core::JointSample sample;
        arm.next(demand, sample);
        log.joints.push_back(sample);
        if (arm.skinFrame(frame))
            log.skin.insert(log.skin.end(), frame.begin(), frame.end());
    }
    return log;
}

bool same(const Log& a, const Log& b) {
    const auto equal = [](const core::JointSample& x, const core::JointSample& y) {
        return x.angle_rad == y.angle_rad && x.torque_Nm == y.torque_Nm &&
               x.reference_rad == y.reference_rad && x.sourceTime_s == y.sourceTime_s;
    };
    return std::ranges::equal(a.joints, b.joints, equal) && a.skin == b.skin;
}

} // namespace

TEST(SimulatedArm, tellsViewsWhatIsAroundIt) {
    scene::Scene scene = shippedArm("teleta-touch.toml");
    const auto arm = made(scene);
    const core::ArmDescription description = arm->description();
    ASSERT_EQ(description.objects.size(), scene.arm().objects.size());
    for (std::size_t i = 0; i < description.objects.size(); ++i) {
        EXPECT_EQ(description.objects[i].name, scene.arm().objects[i].name);
        ASSERT_GE(description.objects[i].outline_m.size(), 3U);
        for (const auto& [x_m, y_m] : description.objects[i].outline_m) {
            // A strip stands for a wall without end; its other corners are inside of it.
            if (!std::holds_alternative<scene::WallOutline>(scene.arm().objects[i].outline))
                EXPECT_NEAR(arm->outlineDistance_m(i, {x_m, y_m}), 0.0, 1e-9);
            else
                EXPECT_LE(arm->outlineDistance_m(i, {x_m, y_m}), 1e-9);
        }
    }
    // One after the other.
    std::vector<std::uint64_t> seen;
    while (!arm->programDone() && arm->time_s() < scene.duration_s) {
        core::JointSample sample;
        arm->next(kProgram, sample);
        if (seen.empty() || seen.back() != arm->presentObjects())
            seen.push_back(arm->presentObjects());
    }
    ASSERT_EQ(seen.size(), description.objects.size());
    for (std::size_t i = 0; i < seen.size(); ++i)
        EXPECT_EQ(seen[i], std::uint64_t{1} << i);
    // What is to be found is not given away.
    scene.arm().unknown.spread_m = 0.01;
    EXPECT_TRUE(made(scene)->description().objects.empty());
}

TEST(SimulatedArm, measuresSpringsInSeriesInASlowTouch) {
    // Compliances of springs in series add: 1/k_i = 1/k_o + 1/k_ri (TeleTA, eq. (5)).
    for (const double stiffness_NPerM : {1325.9, 7223.9, 8562.9, 1e9}) {
        const auto arm = made(postScene(stiffness_NPerM));
        double low_Nm = 0.0, low_rad = 0.0, high_Nm = 0.0, high_rad = 0.0, distance_m = 0.0;
        core::JointSample sample;
        while (!arm->programDone() && high_Nm < 0.05) {
            arm->next(kProgram, sample);
            if (arm->truth().contacts.empty())
                continue;
            high_Nm = sample.torque_Nm[3];
            high_rad = sample.angle_rad[3];
            if (high_Nm <= 0.02) {
                low_Nm = high_Nm;
                low_rad = high_rad;
            }
            if (high_Nm <= 0.035)
                distance_m = arm->truth().contacts[0].contactDistance_m;
        }
        ASSERT_GE(high_Nm, 0.05);
        EXPECT_NEAR(distance_m, 0.175, 1e-4);
        const double measured_NPerM = (high_Nm - low_Nm) / (distance_m * distance_m * (high_rad - low_rad));
        const double link_NPerM = kLink_NPerM * 0.175 * 0.175 / (distance_m * distance_m);
        const double expected_NPerM = 1.0 / (1.0 / stiffness_NPerM + 1.0 / link_NPerM);
        EXPECT_NEAR(measured_NPerM, expected_NPerM, 1e-3 * expected_NPerM) << stiffness_NPerM;
    }
}

TEST(SimulatedArm, restsWhereTorqueForceAndDepthBalance) {
    for (const double stiffness_NPerM : {10.0, 282.0, 8562.9, 1e9}) {
        scene::Scene scene = postScene(stiffness_NPerM);
        std::get<scene::TouchProgram>(scene.arm().program).hold_s = 100.0;
        const auto arm = made(scene);
        core::JointSample sample;
        while (arm->truth().contacts.empty() || arm->truth().torque_Nm[3] < 0.03)
            arm->next(kProgram, sample);
        for (int i = 0; i < 3000; ++i)
            arm->next({.drive = core::ArmDrive::held, .rate_radPerS = {}}, sample);
        ASSERT_EQ(arm->truth().contacts.size(), 1U);
        const ArmContactTruth& contact = arm->truth().contacts[0];
        EXPECT_NEAR(contact.force_N, stiffness_NPerM * contact.depth_m, 1e-9 * contact.force_N);
        // The force turns the elbow with the lever P_C, and passes by the shoulder.
        EXPECT_NEAR(sample.torque_Nm[3], contact.force_N * contact.contactDistance_m, 1e-6);
        EXPECT_NEAR(sample.torque_Nm[3], 106.225875 * (sample.angle_rad[3] - arm->truth().link_rad[3]), 1e-9);
        // The outline lies as deep in the skin as the object gives way; the post is 2 mm thick.
        if (contact.depth_m < 0.001) {
            EXPECT_NEAR(arm->outlineDistance_m(0, contact.p_Base_Contact_m.head<2>()), -contact.depth_m,
                        1e-12);
        }
    }
}

TEST(SimulatedArm, touchesTheFiveMaterialsOfThePaperOneAfterTheOther) {
    const auto arm = made(shippedArm("teleta-touch.toml"));
    core::JointSample sample;
    std::vector<float> frame(arm->skinDescription().layout.taxels());
    double weight_N = 0.0, worst_m = 0.0;
    while (!arm->programDone()) {
        arm->next(kProgram, sample);
        ASSERT_LE(arm->truth().contacts.size(), 1U);
        if (!arm->skinFrame(frame) || arm->truth().contacts.empty() || arm->truth().contacts[0].force_N < 0.2)
            continue;
        // Centroid of the loads over the skin's own threshold.
        const ArmContactTruth& contact = arm->truth().contacts[0];
        const core::ArrayLayout layout = arm->skinDescription().layout.grid();
        double x_m = 0.0, y_m = 0.0;
        weight_N = 0.0;
        for (int r = 0; r < layout.rows; ++r) {
            for (int c = 0; c < layout.columns; ++c) {
                const double load_N = frame[static_cast<std::size_t>(r * layout.columns + c)];
                if (load_N < 0.02)
                    continue;
                weight_N += load_N;
                x_m += load_N * layout.x_m(c);
                y_m += load_N * layout.y_m(r);
            }
        }
        const core::SkinPlacement skin = arm->description().skin;
        const double side_rad =
            std::remainder(skin.side_rad(y_m / weight_N) - contact.side_rad, 6.283185307179586);
        worst_m = std::max({worst_m, std::abs(skin.distance_m(x_m / weight_N) - contact.contactDistance_m),
                            std::abs(side_rad) * skin.radius_m});
    }
    EXPECT_LT(worst_m, 0.5 * 0.0094);
    EXPECT_LT(arm->time_s(), 40.0);
    const std::vector<ArmTouchTruth>& touches = arm->truth().touches;
    ASSERT_EQ(touches.size(), 5U);
    const std::vector<double> stiffness_NPerM{282.0, 1325.9, 7223.9, 8562.9, 1e9};
    const std::vector<double> distance_m{0.170, 0.170, 0.170, 0.1755, 0.175};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(touches[i].object, i);
        EXPECT_TRUE(touches[i].end_s);
        EXPECT_EQ(arm->objects()[i].stiffness_NPerM, stiffness_NPerM[i]);
        EXPECT_NEAR(touches[i].strongest.contactDistance_m, distance_m[i], 0.001);
        // 0.08 Nm at P_C, and noise of six standard deviations.
        EXPECT_NEAR(touches[i].strongest.force_N, 0.08 / distance_m[i], 0.03 / distance_m[i]);
    }
}

TEST(SimulatedArm, repeatsItselfToTheLastBit) {
    const scene::Scene scene = shippedArm("teleta-touch.toml");
    const auto arm = made(scene, 7);
    const Log first = run(*arm, 3.0);
    arm->restart();
    EXPECT_EQ(arm->time_s(), 0.0);
    EXPECT_TRUE(same(first, run(*arm, 3.0)));
    EXPECT_TRUE(same(first, run(*made(scene, 7), 3.0)));
    EXPECT_FALSE(same(first, run(*made(scene, 8), 3.0)));
}

TEST(SimulatedArm, keepsTheNoiseOfOneEffectWhenAnotherGoes) {
    scene::Scene scene = shippedArm("teleta-touch.toml");
    const Log all = run(*made(scene), 1.0);
    std::erase_if(scene.effects, [](const scene::Effect& effect) { return nameOf(effect) == "gear_ripple"; });
    const Log without = run(*made(scene), 1.0);
    EXPECT_EQ(all.skin, without.skin);
    double worst_Nm = 0.0;
    for (std::size_t i = 0; i < all.joints.size(); ++i)
        worst_Nm = std::max(worst_Nm, std::abs(all.joints[i].torque_Nm[3] - without.joints[i].torque_Nm[3]));
    EXPECT_GT(worst_Nm, 0.0001);
    EXPECT_LE(worst_Nm, 0.0003 + 1e-12); // its amplitude
}

TEST(SimulatedArm, standsStillWhenItIsHeldOrStopped) {
    const auto arm = made(postScene(8562.9));
    core::JointSample sample;
    for (int i = 0; i < 300; ++i)
        arm->next(kProgram, sample);
    const core::JointVector reference_rad = sample.reference_rad;
    for (const core::ArmDrive drive : {core::ArmDrive::stopped, core::ArmDrive::held}) {
        for (int i = 0; i < 1000; ++i) {
            arm->next({.drive = drive, .rate_radPerS = {1.0, 1.0, 1.0, 1.0}}, sample);
            ASSERT_EQ(sample.reference_rad, reference_rad);
        }
        for (std::size_t j = 0; j < 4; ++j)
            EXPECT_NEAR(sample.angle_rad[j], reference_rad[j], 1e-9);
    }
    EXPECT_NEAR(arm->time_s(), 2.3, 1e-9);
    arm->next(kProgram, sample);
    EXPECT_NE(sample.reference_rad, reference_rad);
    EXPECT_NEAR(sample.reference_rad[3], reference_rad[3], 1e-3);
}

TEST(SimulatedArm, followsTheOperatorWithinItsLimits) {
    const scene::Scene scene = postScene(8562.9);
    const auto arm = made(scene);
    core::JointSample sample;
    const core::JointVector start_rad = scene.arm().body.start_rad;
    for (int i = 0; i < 1000; ++i)
        arm->next({.drive = core::ArmDrive::jog, .rate_radPerS = {0.0, 0.1, std::nan(""), -5.0}}, sample);
    EXPECT_NEAR(sample.reference_rad[1], start_rad[1] + 0.1, 1e-9);
    EXPECT_EQ(sample.reference_rad[2], start_rad[2]);
    EXPECT_NEAR(sample.reference_rad[3], start_rad[3] - 1.0, 1e-9); // fastest_radPerS
    for (int i = 0; i < 5000; ++i)
        arm->next({.drive = core::ArmDrive::jog, .rate_radPerS = {0.0, 0.0, 0.0, -1.0}}, sample);
    EXPECT_EQ(sample.reference_rad[3], scene.arm().body.lowest_rad[3]);
    // The program takes the arm back without a jump, and finishes its touch.
    const core::JointVector before_rad = sample.reference_rad;
    arm->next(kProgram, sample);
    for (std::size_t j = 0; j < 4; ++j)
        EXPECT_NEAR(sample.reference_rad[j], before_rad[j], 1e-3);
    run(*arm, 80.0);
    EXPECT_TRUE(arm->programDone());
    EXPECT_EQ(arm->truth().touches.size(), 1U);
}

TEST(SimulatedArm, letsNoJointGoOnAgainstTooMuchTorque) {
    const auto arm = made(postScene(1e9));
    core::JointSample sample;
    double highest_Nm = 0.0;
    for (int i = 0; i < 3000; ++i) {
        arm->next({.drive = core::ArmDrive::jog, .rate_radPerS = {0.0, 0.0, 0.0, 1.0}}, sample);
        highest_Nm = std::max(highest_Nm, arm->truth().torque_Nm[3]);
    }
    EXPECT_GT(highest_Nm, 9.0);
    EXPECT_LT(highest_Nm, 20.0);
}

TEST(SimulatedArm, readsTheSkinAtItsOwnRate) {
    const auto arm = made(postScene(282.0));
    EXPECT_EQ(arm->skinDescription().nominalRate_Hz, 200.0);
    const Log log = run(*arm, 1.0);
    EXPECT_EQ(log.skin.size(), 200 * arm->skinDescription().layout.taxels());
    std::vector<float> frame(arm->skinDescription().layout.taxels(), 7.0F);
    core::JointSample sample;
    arm->next(kProgram, sample);
    EXPECT_FALSE(arm->skinFrame(frame));
    EXPECT_EQ(frame[0], 7.0F);
}

TEST(SimulatedArm, readsWhatEachJointEffectAdds) {
    scene::Scene scene = postScene(282.0);
    std::unique_ptr<SimulatedArm> arm;
    const auto sampleWith = [&](const scene::Effect& effect) {
        scene.effects = {effect};
        arm = made(scene);
        core::JointSample sample;
        for (int i = 0; i < 400; ++i)
            arm->next(kProgram, sample);
        return sample;
    };
    const core::JointSample heavy = sampleWith({.why = "w", .parameters = scene::GravityErrorSpec{0.01}});
    // The forearm sweeps in a level plane. Shoulder axes there: roll x, pitch up, yaw -y; the elbow's is up.
    // Moments of weight: about x 0.5 kg at the forearm's middle, across; none about an upright axis.
    const double elbow_rad = arm->truth().link_rad[3];
    const double across_m = 0.5 * 0.27 * std::sin(elbow_rad);
    EXPECT_NEAR(heavy.torque_Nm[0] - arm->truth().torque_Nm[0], 0.01 * 9.80665 * 0.5 * across_m, 1e-6);
    EXPECT_NEAR(heavy.torque_Nm[3] - arm->truth().torque_Nm[3], 0.0, 1e-6);

    const core::JointSample waving =
        sampleWith({.why = "w", .parameters = scene::GearRippleSpec{0.001, 100.0}});
    for (std::size_t j = 0; j < 4; ++j)
        EXPECT_NEAR(waving.torque_Nm[j] - arm->truth().torque_Nm[static_cast<Eigen::Index>(j)],
                    0.001 * std::sin(100.0 * waving.angle_rad[j]), 1e-12);

    const core::JointSample stepped =
        sampleWith({.why = "w", .parameters = scene::EncoderQuantizationSpec{0.001}});
    for (const double angle_rad : stepped.angle_rad)
        EXPECT_NEAR(std::remainder(angle_rad, 0.001), 0.0, 1e-12);
}

TEST(SimulatedArm, pressesObjectsThatHarden) {
    scene::Scene scene = postScene(282.0);
    scene.effects = {{.why = "w", .parameters = scene::NonlinearObjectSpec{0.001}}};
    const auto arm = made(scene);
    core::JointSample sample;
    while (arm->truth().contacts.empty() || arm->truth().torque_Nm[3] < 0.05)
        arm->next(kProgram, sample);
    for (int i = 0; i < 3000; ++i)
        arm->next({.drive = core::ArmDrive::held, .rate_radPerS = {}}, sample);
    const ArmContactTruth& contact = arm->truth().contacts.at(0);
    const double expected_N = 282.0 * contact.depth_m * (1.0 + contact.depth_m / 0.001);
    EXPECT_NEAR(contact.force_N, expected_N, 1e-12);
    EXPECT_NEAR(sample.torque_Nm[3], expected_N * contact.contactDistance_m, 1e-6);
    EXPECT_EQ(arm->effectTimes().at(0).name, "nonlinear_object");
}

TEST(SimulatedArm, refusesTheSceneOfAnArray) {
    const scene::Scene scene = shippedArm("tactile-indenter.toml");
    const auto arm = SimulatedArm::make(scene, 1);
    ASSERT_FALSE(arm);
    EXPECT_EQ(arm.error().kind, core::ErrorKind::badInput);
}

} // namespace teleta::simulation::test
