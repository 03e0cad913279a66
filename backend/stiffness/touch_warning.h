// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace teleta::stiffness {

/// What was seen in the samples of a touch that makes its stiffness less certain.
enum class TouchWarning {
    correlatedNoise, ///< fewer than a quarter of the samples are independent
    coarseTorque,    ///< one step of the torque reading is over a tenth of the window
    coarseAngle,     ///< one step of the angle reading is over a tenth of the rotation in the window
    torqueOffset,    ///< the free joint has a torque; it was taken off
    torqueDrift,     ///< the torque of the free joint changes; the change was taken off
    nonlinear,       ///< the object becomes stiffer or softer within the window
    rateDependent,   ///< the force depends on how quickly the object is pressed
    stickSlip,       ///< the torque jumps or falls back, or the joint has play where it turns round
};

/// All of them, in the order in which they are told. Thread: any.
inline constexpr std::array kTouchWarnings{TouchWarning::correlatedNoise, TouchWarning::coarseTorque,
                                           TouchWarning::coarseAngle,     TouchWarning::torqueOffset,
                                           TouchWarning::torqueDrift,     TouchWarning::nonlinear,
                                           TouchWarning::rateDependent,   TouchWarning::stickSlip};

/// Name in files and on the command line, such as "correlated_noise".
[[nodiscard]] const char* toString(TouchWarning warning);

/// Where the error of a compliance comes from.
enum class ErrorSource {
    noise,           ///< white noise of both readings
    correlatedNoise, ///< what the noise has more because its samples depend on each other
    quantization,    ///< steps of the readings
    torqueReference, ///< torque of the free joint
    torqueDrift,     ///< change of it during the touch
    contactDistance, ///< where the contact is
    linkStiffness,   ///< the link's own
    curvature,       ///< the line of angle over torque bends
    inertia,         ///< the joint changes its speed within the window
};

/// Name in files, such as "contact_distance".
[[nodiscard]] const char* toString(ErrorSource source);

/// A part of the variance of the object's compliance.
struct ErrorShare {
    ErrorSource source = ErrorSource::noise;
    double share = 0.0; ///< 0 .. 1; those of one touch add up to 1
};

/// The parts of an error, the largest first; empty when there is none.
using ErrorBudget = std::vector<ErrorShare>;

} // namespace teleta::stiffness
