// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_servo/rehearsal_world.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace teleta::arm_servo {

namespace {

constexpr double kRigid_NPerM = 1e9;

} // namespace

RehearsalWorld::RehearsalWorld(std::shared_ptr<const arm_model::SerialChain> chain,
                               std::shared_ptr<const PadArm> pad, const core::ArrayLayout& layout,
                               const contact::FeatureSettings& features)
    : m_pad(std::move(pad))
    , m_governor(std::move(chain), {}, 0.0)
    , m_array(layout, kTaxelStiffness_NPerM, kRigid_NPerM, {}, {})
    , m_extractor(layout, features)
    , m_load_N(layout.taxels())
    , m_frame_N(layout.taxels()) {
}

void RehearsalWorld::begin(ArmTask task, const core::JointVector& q_rad, bool touches) {
    m_q_rad = q_rad;
    m_governor.reset(q_rad);
    m_extractor.reset();
    if (task == ArmTask::point || task == ArmTask::roll)
        m_shape = simulation::BallSurface{kBall_m};
    else
        m_shape = simulation::EdgeSurface{};
    m_array.forget(); // the last one was at the same place
    // The body looks at the pad: its z is out of its surface, as that of the pad is.
    m_X_Base_Object = m_pad->X_Base_Sensor(q_rad) * Eigen::Translation3d(0.0, 0.0, touches ? 0.0 : kGap_m) *
                      Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX());
}

bool RehearsalWorld::move(const core::JointVector& rate, double dt_s) {
    const arm_model::MotionStep step =
        m_governor.step({.rate = rate}, {.position = m_q_rad, .effort = {}, .force_Base_N = {}}, dt_s);
    m_q_rad = step.commanded;
    return !step.fault;
}

contact::TactileFeatures RehearsalWorld::feel() {
    const Eigen::Isometry3d X_Sensor_Object = m_pad->X_Base_Sensor(m_q_rad).inverse() * m_X_Base_Object;
    (void)m_array.readLoads(X_Sensor_Object, m_shape, m_load_N);
    std::ranges::transform(m_load_N, m_frame_N.begin(),
                           [](double load_N) { return std::max(0.0F, static_cast<float>(load_N)); });
    return m_extractor.compute(m_frame_N);
}

} // namespace teleta::arm_servo
