// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/stiffness/joint_sample.h"

#include <cstddef>
#include <optional>
#include <span>

namespace teleta::stiffness {

/// The joint before it touches: its torque as a line over time.
struct FreeMotion {
    std::size_t first = 0;   ///< index of its first sample
    std::size_t samples = 0; ///< from there, without those close to the contact
    std::size_t contact = 0; ///< index of the first sample of the contact, as far as the noise tells
    double middle_s = 0.0;   ///< mean time
    double middle_rad = 0.0; ///< mean angle
    double torque_Nm = 0.0;  ///< mean torque
    double torqueSe_Nm = 0.0;
    double drift_NmPerS = 0.0;
    double driftSe_NmPerS = 0.0;
    double rate_radPerS = 0.0; ///< of the angle
    double sd_Nm = 0.0;        ///< of the torque about the line
    double inflation = 1.0;    ///< of the variance by correlated noise, see varianceInflation()
    /// Where the joint took up its speed before the contact: torque over acceleration, and the half width
    /// over which accelerations are fitted, see SpeedUp; else 0.
    double inertia_kgm2 = 0.0;
    double accelerationWidth_s = 0.0;

    [[nodiscard]] bool spedUp() const { return accelerationWidth_s > 0.0; }
    /// How much later than the middle a sample is: the mean of its time, and of the time that the angle would
    /// have taken at the rate of the free motion.
    [[nodiscard]] double later_s(const JointSample& sample) const;
};

/// Finds the free motion before a touch: the bend in the torque over time, and before it the stretch in which
/// the joint turns as quickly as just before the contact (within a factor of 2), or, where it takes up its
/// speed, moves at all; the torque of the acceleration is then no part of torque and drift (findSpeedUp()).
/// Empty when the torque rises from the start, does not reach the middle of the window, or fewer than 10
/// samples are free. log: sorted by time, finite. Thread: any (pure). Source of the bend: Hinkley, Biometrika
/// 56 (1969) 495.
[[nodiscard]] std::optional<FreeMotion> findFreeMotion(std::span<const JointSample> log,
                                                       const TorqueWindow& window);

} // namespace teleta::stiffness
