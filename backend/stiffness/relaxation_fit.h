// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/stiffness/joint_sample.h"

#include <optional>
#include <span>

namespace teleta::stiffness {

/// A number with its 95 % interval.
struct Interval95 {
    double value = 0.0;
    double lower = 0.0;
    double upper = 0.0;
};

/// A standard linear solid: a spring beside another spring with a damper in series.
struct StandardLinearSolid {
    Interval95 static_NPerM; ///< what remains when the force has decayed
    Interval95 ratio;        ///< of the decaying spring to the static one
    Interval95 relaxation_s; ///< time constant of the decay of the force
};

/// Where a touch of a standard linear solid was, and what presses it.
struct RelaxationSettings {
    double joint_NmPerRad = 0.0;    ///< of the link in series, k_ri P_C^2; > 0
    double contactDistance_m = 0.0; ///< > 0
    /// Relative standard error of the static stiffness from distance and link.
    double relativeSe = 0.0;
    double inflation = 1.0; ///< of the variance by correlated noise
};

/// Fits a standard linear solid in series with the link to a rise and the hold after it.
///   torque = K_s x + m,  m' = K_m x' - m / T,  x = angle - contact - torque / joint_NmPerRad
/// by least squares in K_s, K_m, T and the angle of contact (Levenberg and Marquardt; each logarithm but the
/// angle's). Empty unless all intervals are bounded, T lies between 3 samples and 3 times the log, and the
/// residuals are those of the noise (within a factor of 1.5 of noise_Nm). samples: from the contact to the
/// end of the hold, by time, torque positive; at least 40. Thread: any (pure). Source of the body: Zener
/// 1948; of the method: Marquardt, J. SIAM 11 (1963) 431.
[[nodiscard]] std::optional<StandardLinearSolid> fitStandardLinearSolid(std::span<const JointSample> samples,
                                                                        double noise_Nm,
                                                                        const RelaxationSettings& settings);

} // namespace teleta::stiffness
