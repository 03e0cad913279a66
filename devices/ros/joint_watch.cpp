// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/joint_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::ros_arm {

namespace {

/// After such a pause an arm may be anywhere.
constexpr double kLongestCompared_s = 1.0;

} // namespace

JointWatch::JointWatch(std::vector<std::string> names, std::string topic, double timeout_s)
    : m_names(std::move(names))
    , m_topic(std::move(topic))
    , m_timeout_s(timeout_s)
    , m_joiner(m_names, timeout_s) {
}

std::optional<ros::JoinedJoints> JointWatch::take(const ros::JointState& message, std::int64_t read_ns) {
    const std::uint64_t notFinite = m_joiner.counters().notFinite;
    const std::uint64_t backward = m_joiner.stamps().backward();
    std::optional<ros::JoinedJoints> sample = m_joiner.take(message, read_ns);
    if (m_joiner.counters().notFinite > notFinite)
        note(ArmFaultKind::notFinite, m_topic);
    if (m_joiner.stamps().backward() > backward)
        note(ArmFaultKind::backward, m_topic);
    if (sample) {
        compare(*sample, read_ns);
        m_last = sample;
        m_last_ns = read_ns;
    }
    return sample;
}

void JointWatch::compare(const ros::JoinedJoints& sample, std::int64_t read_ns) {
    if (!m_last)
        return;
    const double read_s = static_cast<double>(read_ns - m_last_ns) * 1e-9;
    if (read_s > kLongestCompared_s)
        return;
    // Messages that were held up are read together, but their stamps are not. Stamps that leap, such as those
    // of a second publisher that tells none, excuse no more than the arm may be silent.
    const double time_s = std::max(read_s, std::min(sample.stamp_s - m_last->stamp_s, m_timeout_s));
    const double most = kJump * std::max(1.0, time_s / (static_cast<double>(kJumpTime_ns) * 1e-9));
    for (std::size_t i = 0; i < m_names.size(); ++i) {
        if (!(std::abs(sample.position[i] - m_last->position[i]) <= most))
            note(ArmFaultKind::jumped, m_names[i]);
    }
}

void JointWatch::note(ArmFaultKind kind, const std::string& what) {
    if (!m_fault)
        m_fault = ArmFault{kind, what};
}

std::optional<ArmFault> JointWatch::takeFault() {
    return std::exchange(m_fault, std::nullopt);
}

std::optional<ros::JoinedJoints> JointWatch::sampleAt(std::int64_t now_ns) const {
    return m_last && m_joiner.missing(now_ns).empty() ? m_last : std::nullopt;
}

std::vector<std::string> JointWatch::missing(std::int64_t now_ns) const {
    std::vector<std::string> names;
    for (const std::size_t place : m_joiner.missing(now_ns))
        names.push_back(m_names[place]);
    return names;
}

} // namespace teleta::ros_arm
