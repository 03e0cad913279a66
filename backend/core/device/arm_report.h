// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/joint_vector.h"

#include <cstdint>
#include <string>
#include <vector>

namespace teleta::core {

/// What some arms tell of themselves besides their samples.
struct ArmReport {
    std::uint32_t activeLimits = 0; ///< limits that act now, arm_model::MotionFlag
    JointVector rate_radPerS;       ///< of each joint as it tells (prismatic: m/s); empty: not told
    JointVector effort;             ///< of each joint in Nm (prismatic: N), or in A; empty: not told
    bool effortIsCurrent = false;   ///< effort is in A
    /// Joints that it tells and that its description does not have, each once, since the start.
    std::vector<std::string> unknownJoints;
};

/// An ArmSource that tells more may be one of these, too. Thread: any.
class ReportingArm {
public:
    virtual ~ReportingArm() = default;
    ReportingArm(const ReportingArm&) = delete;
    ReportingArm& operator=(const ReportingArm&) = delete;

    [[nodiscard]] virtual ArmReport report() const = 0;

protected:
    ReportingArm() = default;
};

} // namespace teleta::core
