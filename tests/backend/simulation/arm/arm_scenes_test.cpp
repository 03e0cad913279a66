// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm/arm4_kinematics.h"
#include "backend/simulation/arm/simulated_arm.h"
#include "tests/backend/simulation/arm/arm_scene.h"
#include "tests/support/sanitized.h"

#include <algorithm>
#include <functional>
#include <optional>

namespace teleta::simulation::test {

namespace {

const core::ArmDemand kProgram{.drive = core::ArmDrive::program, .rate_radPerS = {}};

/// Contact point on the skin from the loads around the highest taxel, in the base.
std::optional<Eigen::Vector3d> skinPoint(const SimulatedArm& arm, const core::JointSample& sample,
                                         const std::vector<float>& frame) {
    const core::ArrayLayout layout = arm.skinDescription().layout.grid();
    const auto highest = std::ranges::max_element(frame);
    const int row = static_cast<int>(highest - frame.begin()) / layout.columns;
    const int column = static_cast<int>(highest - frame.begin()) % layout.columns;
    double sum_N = 0.0, x_m = 0.0, y_m = 0.0;
    for (int r = std::max(row - 2, 0); r <= std::min(row + 2, layout.rows - 1); ++r) {
        for (int c = std::max(column - 2, 0); c <= std::min(column + 2, layout.columns - 1); ++c) {
            const double load_N = frame[static_cast<std::size_t>(r * layout.columns + c)];
            sum_N += load_N;
            x_m += load_N * layout.x_m(c);
            y_m += load_N * layout.y_m(r);
        }
    }
    if (sum_N < 0.1)
        return {};
    const core::ArmDescription description = arm.description();
    const arm::Arm4Kinematics kinematics({.upperArmLength_m = description.upperArmLength_m,
                                          .forearmLength_m = description.forearmLength_m,
                                          .halfThickness_m = description.halfThickness_m});
    return kinematics.p_Base_Point(arm::Link::forearm,
                                   Eigen::Map<const arm::JointVector>(sample.angle_rad.data()),
                                   kinematics.p_Link_Skin(description.skin.distance_m(x_m / sum_N),
                                                          description.skin.side_rad(y_m / sum_N)));
}

/// Runs a scene until its program is done or so many touches have begun; after each step the visitor.
void run(SimulatedArm& arm, std::size_t touches,
         const std::function<void(const core::JointSample&, const std::vector<float>*)>& visit) {
    core::JointSample sample;
    std::vector<float> frame(arm.skinDescription().layout.taxels());
    while (!arm.programDone() && arm.truth().touches.size() < touches) {
        arm.next(kProgram, sample);
        visit(sample, arm.skinFrame(frame) ? &frame : nullptr);
    }
}

/// Root mean square distance of the skin's contact points from the true ones, over some touches.
double contactError_m(const scene::Scene& scene, std::size_t touches) {
    const auto arm = made(scene, 3);
    double sum_m2 = 0.0;
    std::size_t points = 0;
    run(*arm, touches, [&](const core::JointSample& sample, const std::vector<float>* frame) {
        if (frame == nullptr || arm->truth().contacts.empty() || arm->truth().contacts[0].force_N < 0.25)
            return;
        if (const auto point = skinPoint(*arm, sample, *frame)) {
            sum_m2 += (*point - arm->truth().contacts[0].p_Base_Contact_m).squaredNorm();
            ++points;
        }
    });
    EXPECT_GT(points, 0U);
    return std::sqrt(sum_m2 / static_cast<double>(points));
}

scene::Scene without(scene::Scene scene, std::string_view effect) {
    std::erase_if(scene.effects, [&](const scene::Effect& listed) { return nameOf(listed) == effect; });
    return scene;
}

/// Two-point total stiffness of the first touch of teleta-touch, from readings.
double firstStiffness_NPerM(const scene::Scene& scene, std::uint64_t seed) {
    const auto arm = made(scene, seed);
    double low_Nm = 0.0, low_rad = 0.0, high_Nm = 0.0, high_rad = 0.0, distance_m = 0.0;
    run(*arm, 2, [&](const core::JointSample& sample, const std::vector<float>*) {
        if (arm->truth().contacts.empty() || high_Nm >= 0.05)
            return;
        high_Nm = sample.torque_Nm[3];
        high_rad = sample.angle_rad[3];
        distance_m = arm->truth().contacts[0].contactDistance_m;
        if (high_Nm <= 0.02) {
            low_Nm = high_Nm;
            low_rad = high_rad;
        }
    });
    return (high_Nm - low_Nm) / (distance_m * distance_m * (high_rad - low_rad));
}

class ContourScene : public testing::TestWithParam<const char*> {};

} // namespace

TEST_P(ContourScene, touchesTheOutlineFromAllAroundInOnePlane) {
    const scene::Scene scene = shippedArm(GetParam());
    const auto arm = made(scene);
    double worst_m = 0.0, sum_m2 = 0.0, highest_Nm = 0.0;
    std::size_t points = 0;
    run(*arm, 1000, [&](const core::JointSample& sample, const std::vector<float>* frame) {
        if (arm->truth().contacts.empty()) {
            // Moving without contact must not look like one (threshold 0.05 Nm), once the joints have relaxed
            // from the last touch.
            const std::vector<ArmTouchTruth>& touched = arm->truth().touches;
            if (touched.empty() || arm->time_s() > *touched.back().end_s + 0.2)
                highest_Nm = std::max(highest_Nm, arm->truth().torque_Nm.lpNorm<Eigen::Infinity>());
            return;
        }
        if (frame == nullptr || arm->truth().contacts[0].force_N < 0.25)
            return;
        if (const auto point = skinPoint(*arm, sample, *frame)) {
            const double error_m = std::abs(arm->outlineDistance_m(0, point->head<2>()));
            worst_m = std::max(worst_m, error_m);
            sum_m2 += error_m * error_m;
            ++points;
        }
    });
    EXPECT_LT(arm->time_s(), scene.duration_s);
    const auto& program = std::get<scene::ContourProgram>(scene.arm().program);
    const std::vector<ArmTouchTruth>& touches = arm->truth().touches;
    std::vector<bool> quadrants(4, false);
    const scene::ArmObject& object = scene.arm().objects[0];
    for (const ArmTouchTruth& touch : touches) {
        const Eigen::Vector3d& point_m = touch.strongest.p_Base_Contact_m;
        EXPECT_NEAR(point_m.z(), object.z_m, 1e-3);
        EXPECT_NEAR(arm->outlineDistance_m(0, point_m.head<2>()), 0.0, 2e-4);
        quadrants[(point_m.x() > object.x_m ? 1U : 0U) + (point_m.y() > object.y_m ? 2U : 0U)] = true;
    }
    EXPECT_EQ(touches.size(), static_cast<std::size_t>(program.directions));
    EXPECT_EQ(std::ranges::count(quadrants, true), 4);
    EXPECT_LT(highest_Nm, 0.05);
    // A point on the skin is known to a fraction of the pitch of 9.4 mm.
    EXPECT_LT(std::sqrt(sum_m2 / static_cast<double>(points)), 0.001);
    EXPECT_LT(worst_m, 0.004);
}

INSTANTIATE_TEST_SUITE_P(Shipped, ContourScene,
                         testing::Values("teleta-contour-circle.toml", "teleta-contour-rectangle.toml",
                                         "teleta-contour-triangle.toml"));

TEST(AdmittanceScene, yieldsAndComesBack) {
    const scene::Scene scene = shippedArm("teleta-admittance.toml");
    const auto arm = made(scene);
    const auto& control = std::get<scene::AdmittanceControl>(scene.arm().control);
    double pushed_rad = 0.0, back_rad = 1.0, leaning_Nm = 0.0, leaning_rad = 0.0, force_N = 0.0;
    run(*arm, 1000, [&](const core::JointSample& sample, const std::vector<float>*) {
        const double away_rad = sample.angle_rad[3] - sample.reference_rad[3];
        if (sample.sourceTime_s < 4.0)
            pushed_rad = std::max(pushed_rad, std::abs(away_rad));
        if (sample.sourceTime_s < 4.4)
            back_rad = std::abs(away_rad);
        if (std::abs(sample.sourceTime_s - 13.4) < 5e-4) {
            leaning_Nm = arm->truth().torque_Nm[3];
            leaning_rad = -away_rad;
            force_N = arm->truth().contacts.at(0).force_N;
        }
    });
    EXPECT_NEAR(arm->time_s(), 18.0, 2e-3);
    EXPECT_GT(pushed_rad, 0.02);
    EXPECT_LT(back_rad, 1e-3);
    // At rest the joint's torque is that of its virtual spring.
    EXPECT_GT(force_N, 2.0);
    EXPECT_NEAR(leaning_Nm, control.stiffness_NmPerRad * leaning_rad, 1e-3);
    EXPECT_EQ(arm->truth().touches.size(), 1U);
    EXPECT_TRUE(arm->truth().contacts.empty());
}

TEST(ArmScenes, listNoEffectThatMovesNothing) {
    if (teleta::test::kSanitized)
        GTEST_SKIP() << "the same scenes again and again";
    // Each effect's absence moves a measure by more than another seed does, or by more than rounding where
    // the effect draws no random number.
    const scene::Scene touch = shippedArm("teleta-touch.toml");
    const double all_NPerM = firstStiffness_NPerM(touch, 1);
    for (const char* effect : {"torque_noise", "gear_ripple"})
        EXPECT_GT(std::abs(firstStiffness_NPerM(without(touch, effect), 1) - all_NPerM), 1e-4 * all_NPerM)
            << effect;
    EXPECT_LT(contactError_m(without(touch, "noise"), 2), 0.9 * contactError_m(touch, 2));
    const scene::Scene contour = shippedArm("teleta-contour-circle.toml");
    const double all_m = contactError_m(contour, 3);
    EXPECT_LT(contactError_m(without(contour, "noise"), 3), 0.8 * all_m) << all_m;
}

} // namespace teleta::simulation::test
