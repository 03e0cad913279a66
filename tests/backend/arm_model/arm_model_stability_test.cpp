// SPDX-License-Identifier: GPL-3.0-or-later
// Poses where directions are lost, extreme twists and endless rides, with floating-point exceptions trapped.
#include "backend/arm_model/motion_limits.h"
#include "backend/arm_model/tip_motion.h"
#include "backend/arm_model/urdf_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

using namespace teleta;
using namespace teleta::arm_model;

namespace {

std::shared_ptr<const SerialChain> chain(const std::string& name, const std::string& tip) {
    const auto model = readUrdf(TELETA_SOURCE_DIR "/tests/data/urdf/" + name);
    EXPECT_TRUE(model) << core::describe(model.error());
    const auto made = SerialChain::create(std::make_shared<const ArmModel>(*model), "base_link", tip);
    EXPECT_TRUE(made) << core::describe(made.error());
    return std::make_shared<const SerialChain>(*made);
}

} // namespace

TEST(ArmModelStability, ratesAreContinuousThroughAStretchedArm) {
    const auto arm = chain("gripper.urdf", "tool0");
    const TipTwist twist{.velocity_mPerS = {0.05, 0.0, 0.02}};
    // On the way from bent through stretched to bent the other way: no jump between neighbours.
    TipRates before = tipRates(*arm, {0.3, -0.05}, twist);
    for (double elbow = -0.05; elbow <= 0.05; elbow += 1e-5) {
        const TipRates now = tipRates(*arm, {0.3, elbow}, twist);
        for (std::size_t i = 0; i < 2; ++i)
            EXPECT_NEAR(now.rate[i], before.rate[i], 0.01) << elbow;
        before = now;
    }
}

TEST(ArmModelStability, extremeTwistsGiveFiniteRates) {
    const auto arm = chain("crooked_arm.urdf", "hand");
    const core::JointVector zeros = core::JointVector::zeros(arm->joints());
    for (const double size : {1e-300, 1e-20, 1.0, 1e20, 1e100}) {
        const TipRates rates = tipRates(*arm, zeros, {{size, -size, size}, {0.0, size, 0.0}});
        for (const double rate : rates.rate)
            EXPECT_TRUE(std::isfinite(rate)) << size;
    }
}

TEST(ArmModelStability, aMillionStepsOfRandomDemandsStayWithinTheLimits) {
    const auto arm = chain("gripper.urdf", "tool0");
    MotionLimits limits;
    limits.box_m = Eigen::AlignedBox3d(Eigen::Vector3d(0.05, -1.0, -0.4), Eigen::Vector3d(0.5, 1.0, 0.4));
    MotionGovernor governor(arm, limits, 0.04);
    core::JointVector at{0.5, -1.0};
    governor.reset(at);
    std::mt19937_64 random(17);
    std::normal_distribution<double> any(0.0, 5.0);
    MotionDemand demand{{0.0, 0.0}};
    for (int i = 0; i < 1'000'000; ++i) {
        if (i % 37 == 0)
            demand = {{any(random), any(random)}, random() % 50 == 0};
        const MotionStep step = governor.step(demand, {at, {}, {}}, 0.02);
        ASSERT_FALSE(step.fault);
        const core::JointVector before = at;
        at = step.commanded;
        ASSERT_LE(std::abs(step.rate[0]), 0.25 * 2.0 + 1e-12);
        ASSERT_LE(std::abs(step.rate[1]), 0.25 * 3.0 + 1e-12);
        ASSERT_LE(std::abs(at[0]), 3.0 - 0.05 + 1e-9);
        ASSERT_LE(std::abs(at[1]), 2.0 - 0.05 + 1e-9);
        ASSERT_LE(limits.box_m->exteriorDistance(arm->X_Base_Tip(at).translation()), 1e-3);
        ASSERT_LE(
            (arm->jacobian(before).topRows<3>() * Eigen::Map<const Eigen::VectorXd>(step.rate.data(), 2))
                .norm(),
            0.1 * (1.0 + 1e-12));
    }
}
