// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/ros/joint_state_joiner.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace teleta::ros {

namespace {

constexpr std::size_t kLongestUnknownName = 256;
constexpr double kNotTold = std::numeric_limits<double>::quiet_NaN();

std::string_view textOf(const char* name) {
    return name == nullptr ? std::string_view() : std::string_view(name);
}

} // namespace

JointStateJoiner::JointStateJoiner(const std::vector<std::string>& names, double timeout_s)
    : m_joints(names.size())
    , m_timeout_ns(static_cast<std::int64_t>(timeout_s * 1e9)) {
    assert(!names.empty() && names.size() <= core::JointVector::kCapacity);
    for (std::size_t i = 0; i < names.size(); ++i)
        m_places.emplace(names[i], i);
    assert(m_places.size() == names.size());
}

bool JointStateJoiner::wellFormed(const JointState& message) const {
    const std::size_t count = view(message.name).size();
    for (const std::size_t other :
         {view(message.position).size(), view(message.velocity).size(), view(message.effort).size()}) {
        if (other != 0 && other != count)
            return false;
    }
    std::vector<bool> seen(m_joints.size(), false);
    for (const char* name : view(message.name)) {
        const auto found = m_places.find(textOf(name));
        if (found == m_places.end())
            continue;
        if (seen[found->second])
            return false;
        seen[found->second] = true;
    }
    return true;
}

bool JointStateJoiner::isFresh(const Joint& joint, std::int64_t now_ns) const {
    return joint.read_ns && now_ns - *joint.read_ns <= m_timeout_ns;
}

void JointStateJoiner::noteUnknown(std::string_view name) {
    ++m_counters.unknown;
    if (m_unknownNames.size() >= kMostUnknownNames)
        return;
    name = name.substr(0, kLongestUnknownName);
    if (m_unknownNames.find(name) != m_unknownNames.end())
        return;
    m_unknownNames.emplace(name);
    m_newUnknownNames.emplace_back(name);
}

std::optional<JoinedJoints> JointStateJoiner::take(const JointState& message, std::int64_t read_ns) {
    ++m_counters.messages;
    m_stamps.see(message.header.stamp);
    if (!wellFormed(message)) {
        ++m_counters.malformed;
        return std::nullopt;
    }
    const auto names = view(message.name);
    const auto positions = view(message.position);
    const auto velocities = view(message.velocity);
    const auto efforts = view(message.effort);
    bool changed = false;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string_view name = textOf(names[i]);
        const auto found = m_places.find(name);
        if (found == m_places.end()) {
            noteUnknown(name);
            continue;
        }
        if (positions.empty())
            continue;
        if (!std::isfinite(positions[i])) {
            ++m_counters.notFinite;
            continue;
        }
        Joint& joint = m_joints[found->second];
        joint.read_ns = read_ns;
        joint.position = positions[i];
        joint.velocity = velocities.empty() ? kNotTold : velocities[i];
        joint.effort = efforts.empty() ? kNotTold : efforts[i];
        changed = true;
    }
    if (!changed ||
        !std::ranges::all_of(m_joints, [&](const Joint& joint) { return isFresh(joint, read_ns); }))
        return std::nullopt;

    JoinedJoints joined{.position = core::JointVector::zeros(m_joints.size()),
                        .velocity = core::JointVector::zeros(m_joints.size()),
                        .effort = core::JointVector::zeros(m_joints.size()),
                        .stamp_s = seconds(message.header.stamp)};
    for (std::size_t i = 0; i < m_joints.size(); ++i) {
        joined.position[i] = m_joints[i].position;
        joined.velocity[i] = m_joints[i].velocity;
        joined.effort[i] = m_joints[i].effort;
    }
    const auto finite = [](double value) { return std::isfinite(value); };
    if (!std::ranges::all_of(joined.velocity, finite))
        joined.velocity = {};
    if (!std::ranges::all_of(joined.effort, finite))
        joined.effort = {};
    return joined;
}

std::vector<std::size_t> JointStateJoiner::missing(std::int64_t now_ns) const {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < m_joints.size(); ++i) {
        if (!isFresh(m_joints[i], now_ns))
            places.push_back(i);
    }
    return places;
}

std::vector<std::string> JointStateJoiner::takeUnknownNames() {
    return std::exchange(m_newUnknownNames, {});
}

} // namespace teleta::ros
