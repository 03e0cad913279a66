// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/wrench_watch.h"

#include "backend/ros/stamps.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::ros_arm {

WrenchWatch::WrenchWatch(const RosWrenchFile& file, std::shared_ptr<const arm_model::SerialChain> chain)
    : m_chain(std::move(chain))
    , m_frame(file.frame.empty() ? m_chain->tipLink() : file.frame)
    , m_sign(file.sign)
    , m_timeout_ns(std::llround(file.timeout_s * 1e9)) {
}

void WrenchWatch::takeFixed(const ros::TFMessage& message) {
    m_frames.takeFixed(message);
    if (!m_lastFrame.empty())
        findPlace();
}

void WrenchWatch::takeMoving(const ros::TFMessage& message, std::int64_t read_ns) {
    m_frames.takeMoving(message, read_ns);
    // Most of /tf tells where links are, which the joints tell sooner.
    if (!m_lastFrame.empty() && (!m_place || m_place->read_ns))
        findPlace();
}

void WrenchWatch::findPlace() {
    m_place = m_frames.placeOf(m_lastFrame, m_chain->model());
    m_unknownFrame = m_place ? std::string() : m_lastFrame;
}

void WrenchWatch::take(const ros::WrenchStamped& message, std::int64_t read_ns) {
    ++m_messages;
    const char* told = message.header.frame_id;
    std::string frame = told == nullptr || *told == '\0' ? m_frame : told;
    if (frame != m_lastFrame || !m_place) {
        m_lastFrame = std::move(frame);
        findPlace();
        m_isNew = false; // what came before has other axes
    }
    if (m_place && !m_place->isKnown(read_ns)) {
        m_place.reset();
        m_unknownFrame = m_lastFrame;
    }
    const auto& force = message.wrench.force;
    m_force_N = m_sign * Eigen::Vector3d(force.x, force.y, force.z);
    const auto& torque = message.wrench.torque;
    m_torque_Nm = m_sign * Eigen::Vector3d(torque.x, torque.y, torque.z);
    m_stamp_s = ros::seconds(message.header.stamp);
    // What is not finite counts as strongest.
    if (!m_isNew || (m_strongest_N.allFinite() && !(m_force_N.stableNorm() <= m_strongest_N.stableNorm())))
        m_strongest_N = m_force_N;
    m_isNew = true;
    m_read_ns = read_ns;
}

std::optional<Eigen::Vector3d> WrenchWatch::takeForce_Base_N(const core::JointVector& q,
                                                             std::int64_t now_ns) {
    const Eigen::Vector3d force_N = std::exchange(m_isNew, false) ? m_strongest_N : m_force_N;
    if (!m_read_ns || now_ns - *m_read_ns > m_timeout_ns || !m_place)
        return std::nullopt;
    return m_chain->linkPoses(q)[m_place->link].linear() * (m_place->X_Link_Frame.linear() * force_N);
}

std::optional<core::WrenchSample> WrenchWatch::atTip(const core::JointVector& q) const {
    if (!m_read_ns || !m_place || !m_force_N.allFinite() || !m_torque_Nm.allFinite())
        return std::nullopt;
    const Eigen::Isometry3d X_Base_Frame = m_chain->linkPoses(q)[m_place->link] * m_place->X_Link_Frame;
    const Eigen::Isometry3d X_Tip_Frame = m_chain->X_Base_Tip(q).inverse() * X_Base_Frame;
    const Eigen::Vector3d force_N = X_Tip_Frame.linear() * m_force_N;
    const Eigen::Vector3d torque_Nm =
        X_Tip_Frame.linear() * m_torque_Nm + X_Tip_Frame.translation().cross(force_N);
    core::WrenchSample sample;
    sample.time_ns = *m_read_ns;
    sample.sourceTime_s = m_stamp_s;
    std::ranges::copy(force_N, sample.force_N.begin());
    std::ranges::copy(torque_Nm, sample.torque_Nm.begin());
    return sample;
}

} // namespace teleta::ros_arm
