// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/motion_limits.h"
#include "backend/arm_model/serial_chain.h"
#include "backend/arm_servo/arm_plans.h"
#include "backend/arm_servo/pad_arm.h"
#include "backend/contact/tactile_features.h"
#include "backend/core/data/array_layout.h"
#include "backend/core/device/joint_vector.h"
#include "backend/simulation/servo/elastic_array.h"
#include "backend/simulation/servo/touched_shape.h"

#include <Eigen/Geometry>

#include <memory>
#include <vector>

namespace teleta::arm_servo {

/// What a servo task is rehearsed in: a shadow of the arm that follows every commanded rate within the usual
/// limits (arm_model::MotionLimits), and a rigid body that is assumed in front of the pad, since nobody knows
/// what is really there: the edge of a box along x of the pad, or for a point a ball. The pad is an elastic
/// array. Deterministic. Thread: one.
class RehearsalWorld {
public:
    static constexpr double kGap_m = 0.005; ///< to the body, where nothing touches the pad when it begins
    static constexpr double kBall_m = 0.010;

    /// chain, pad: of the same arm, not null. layout: of the pad's taxels.
    RehearsalWorld(std::shared_ptr<const arm_model::SerialChain> chain, std::shared_ptr<const PadArm> pad,
                   const core::ArrayLayout& layout, const contact::FeatureSettings& features);

    /// Puts the shadow where the arm is and the body in front of it. q_rad: one finite number a joint.
    /// touches: something touches the pad now, so the body begins at the pad.
    void begin(ArmTask task, const core::JointVector& q_rad, bool touches);
    /// Moves the shadow on. dt_s: > 0. Returns false when it cannot follow.
    [[nodiscard]] bool move(const core::JointVector& rate, double dt_s);
    /// What the shadow's pad feels.
    [[nodiscard]] contact::TactileFeatures feel();

    [[nodiscard]] const core::JointVector& q_rad() const { return m_q_rad; }
    [[nodiscard]] const Eigen::Isometry3d& X_Base_Object() const { return m_X_Base_Object; }

private:
    std::shared_ptr<const PadArm> m_pad;
    arm_model::MotionGovernor m_governor;
    simulation::ElasticArray m_array;
    simulation::TouchedShape m_shape = simulation::WallSurface{};
    contact::FeatureExtractor m_extractor;
    Eigen::Isometry3d m_X_Base_Object = Eigen::Isometry3d::Identity();
    core::JointVector m_q_rad;
    std::vector<double> m_load_N;
    std::vector<float> m_frame_N;
};

} // namespace teleta::arm_servo
