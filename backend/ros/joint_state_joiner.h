// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/joint_vector.h"
#include "backend/ros/messages.h"
#include "backend/ros/stamps.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::ros {

/// All joints of an arm at a time. Numbers are in rad, rad/s and Nm or, for prismatic joints, m, m/s and N,
/// unless the driver says otherwise of its effort.
struct JoinedJoints {
    core::JointVector position;
    core::JointVector velocity; ///< empty: not told for every joint, or not finite
    core::JointVector effort;   ///< empty: as velocity
    double stamp_s = 0.0;       ///< of the message that completed it
};

/// What the joiner has seen since it was made.
struct JointCounters {
    std::uint64_t messages = 0;
    /// As many positions, velocities or efforts as names, or none, were expected; or a name stands twice.
    std::uint64_t malformed = 0;
    std::uint64_t notFinite = 0; ///< positions of the arm's joints that were no numbers
    std::uint64_t unknown = 0;   ///< values of joints that are not the arm's
};

/// Puts messages of joint states together to samples of an arm. Values are joined by name, never by place:
/// the order may differ in each message, and a message may hold some of the joints or those of other arms. A
/// position that is not finite does not count, so its joint grows old. Thread: one; memory is bounded,
/// whatever is received.
class JointStateJoiner {
public:
    /// Distinct unknown names that are remembered, to be told once each.
    static constexpr std::size_t kMostUnknownNames = 64;

    /// names: of the arm's joints on the wire, in the arm's order; distinct, 1 to JointVector::kCapacity.
    /// timeout_s: > 0; a joint whose newest position is older makes the sample incomplete.
    JointStateJoiner(const std::vector<std::string>& names, double timeout_s);

    /// Takes what a message says, read at this steady time (not decreasing). Nothing: it holds no position of
    /// the arm, or another joint is missing or too old.
    [[nodiscard]] std::optional<JoinedJoints> take(const JointState& message, std::int64_t read_ns);

    /// Joints that are missing or too old at a time, by their places.
    [[nodiscard]] std::vector<std::size_t> missing(std::int64_t now_ns) const;

    /// Unknown names since the last call; each name is told once.
    [[nodiscard]] std::vector<std::string> takeUnknownNames();

    [[nodiscard]] const JointCounters& counters() const { return m_counters; }
    [[nodiscard]] const StampCheck& stamps() const { return m_stamps; }

private:
    struct Joint {
        std::optional<std::int64_t> read_ns; ///< of the newest position
        double position = 0.0;
        double velocity = 0.0; ///< NaN: not told with the newest position
        double effort = 0.0;
    };

    [[nodiscard]] bool wellFormed(const JointState& message) const;
    [[nodiscard]] bool isFresh(const Joint& joint, std::int64_t now_ns) const;
    void noteUnknown(std::string_view name);

    std::map<std::string, std::size_t, std::less<>> m_places;
    std::vector<Joint> m_joints;
    std::int64_t m_timeout_ns;
    JointCounters m_counters;
    StampCheck m_stamps;
    std::set<std::string, std::less<>> m_unknownNames;
    std::vector<std::string> m_newUnknownNames;
};

} // namespace teleta::ros
