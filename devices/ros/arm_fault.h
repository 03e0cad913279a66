// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

namespace teleta::ros_arm {

/// Why an arm is not commanded any more until its cause is gone and the dead-man switch was let go.
enum class ArmFaultKind {
    otherWriter,  ///< another program publishes on the command topic; what: the topic
    notFinite,    ///< a position is no number; what: the topic
    jumped,       ///< a joint moved faster than any arm can; what: the joint
    backward,     ///< the stamps went back; what: the topic
    silent,       ///< the positions have not been told for long; what: the topic
    notFollowing, ///< the arm lags; what: empty
};

struct ArmFault {
    ArmFaultKind kind = ArmFaultKind::notFollowing;
    std::string what;

    [[nodiscard]] bool operator==(const ArmFault&) const = default;
};

/// One sentence without a full stop, translated. Thread: any.
[[nodiscard]] QString describe(const ArmFault& fault);

} // namespace teleta::ros_arm
