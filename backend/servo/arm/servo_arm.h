// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/joint_vector.h"
#include "backend/core/interface.h"
#include "backend/servo/arm/rigid_motion.h"

#include <cstddef>

namespace teleta::servo {

/// How the joints of an arm carry out a motion of its sensor, and what kept them from it.
struct SensorMotion {
    core::JointVector rate;         ///< rad/s, prismatic m/s
    Twist achieved = Twist::Zero(); ///< of the sensor: [v; w] of its origin in base axes
    bool slowed = false;            ///< all joints were slowed down to the speed limit of one
    bool atEnd = false;             ///< a joint is held back by the end of its range
    bool singular = false;          ///< the arm is near a singularity, and its motion is damped

    /// The motion is not the one that was wanted.
    [[nodiscard]] bool isLimited() const { return slowed || atEnd || singular; }
};

/// The joints of the arm that carries the sensor, as far as the servo controller has to know them. Thread:
/// any (const); nothing allocates.
class ServoArm : public core::Interface {
public:
    [[nodiscard]] virtual std::size_t joints() const = 0;
    /// Joint rates for a twist of the sensor, [v; w] of its origin in base axes, within the limits of the
    /// joints. q_rad: as many finite numbers as joints().
    [[nodiscard]] virtual SensorMotion carryOut(const core::JointVector& q_rad,
                                                const Twist& twist_Base) const = 0;
};

} // namespace teleta::servo
