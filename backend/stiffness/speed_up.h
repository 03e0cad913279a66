// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/stiffness/joint_sample.h"

#include <cstddef>
#include <optional>
#include <span>

namespace teleta::stiffness {

/// How a joint takes up its speed before a touch, and the torque that this needs.
struct SpeedUp {
    std::size_t first = 0;     ///< index of the first sample in motion
    std::size_t samples = 0;   ///< from there, without those that may feel the contact
    double rate_radPerS = 0.0; ///< at the end
    double torque_Nm = 0.0;    ///< at the last of them, without that of the acceleration
    double torqueSe_Nm = 0.0;
    double drift_NmPerS = 0.0; ///< of the same torque
    double driftSe_NmPerS = 0.0;
    double inertia_kgm2 = 0.0; ///< torque over acceleration
    double sd_Nm = 0.0;        ///< of the torque about the fit
    double inflation = 1.0;    ///< of the variance by correlated noise, see varianceInflation()
    double halfWidth_s = 0.0;  ///< over which accelerations are fitted, see accelerationAt()
};

/// Tells the torque that accelerates the links from a drift, where a joint takes up its speed shortly before
/// a touch. Fits
///   tau(t) = tau0 + drift t + g (theta - rate t) + J a(t)
/// by least squares, t and theta from the end, a the angle's second derivative behind a low-pass of first
/// order (damped joints, filters) with the time that fits best. g: what changes with the angle, as gravity
/// does. The standard errors include that of the low-pass. Empty when the joint turns evenly, or when angles
/// are too noisy or too few to tell an acceleration. log: sorted by time, finite; contact: index of the first
/// sample of the contact, at most log.size(); later samples tell accelerations only. likelyDrift_NmPerS: the
/// size that a drift may have before anything is seen, > 0. Thread: any (pure).
[[nodiscard]] std::optional<SpeedUp> findSpeedUp(std::span<const JointSample> log, std::size_t contact,
                                                 double likelyDrift_NmPerS);

/// Second derivative of the angle at a time: a parabola through the samples within halfWidth_s of it. Empty
/// for fewer than 5 samples or when they lie on one side. log: sorted by time, finite; halfWidth_s > 0.
/// Thread: any (pure).
[[nodiscard]] std::optional<double> accelerationAt(std::span<const JointSample> log, double time_s,
                                                   double halfWidth_s);

} // namespace teleta::stiffness
