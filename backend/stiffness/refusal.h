// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::stiffness {

/// Why there is no answer. The callers that show it to people put it into words.
enum class Refusal {
    notFinite,           ///< a sample or a setting is NaN or infinite
    notPositive,         ///< contact distance, link stiffness or a divisor is zero or negative
    negativeUncertainty, ///< a noise or a standard error is below zero
    outOfRange,          ///< numbers are so large or small that the result cannot be represented
    badWindow,           ///< not 0 <= low < high
    noSamples,           ///< there is nothing to evaluate
    windowNotReached,    ///< the torque never enters the window, or (two-point) misses one of its halves
    tooFewSamples,       ///< fewer than 20 independent samples in the window, for a regression
    torqueUnchanged,     ///< all samples in the window have the same torque
    angleOpposesTorque,  ///< the joint turns against the rising torque by more than the noise explains
    tooQuick,            ///< the torque rises so quickly that it includes the inertia of the link
    noTorques,           ///< the arm measures none
};

/// Name of the code, for logs and tests.
[[nodiscard]] const char* toString(Refusal refusal);

} // namespace teleta::stiffness
