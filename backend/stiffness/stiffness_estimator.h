// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/stiffness/joint_sample.h"
#include "backend/stiffness/material.h"
#include "backend/stiffness/refusal.h"
#include "backend/stiffness/touch_equations.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace teleta::stiffness {

enum class Method {
    twoPoint,   ///< the paper's method: the samples nearest to both borders of the window
    regression, ///< all samples in the window, with errors in torque and angle
};

/// Name in files and on the command line: "two-point", "regression".
[[nodiscard]] const char* toString(Method method);
[[nodiscard]] std::optional<Method> methodFromString(std::string_view text);

/// What is known about a touch besides its samples.
struct TouchSettings {
    double contactDistance_m = 0.0; ///< P_C, from the joint's axis along the link; > 0
    double linkStiffness_NPerM = kPaperLinkStiffness_NPerM; ///< k_ri; > 0
    double linkStiffnessSe_NPerM = 0.0;                     ///< standard error of k_ri; >= 0
    TorqueWindow window;
    double torqueReference_Nm = 0.0; ///< torque of the joint without the touch
    Method method = Method::regression;
    std::optional<double>
        torqueNoise_Nm; ///< standard deviation if known; otherwise estimated from the samples
    std::optional<double> angleNoise_rad;
};

/// Stiffness of one touch.
struct TouchStiffness {
    Method method = Method::regression;
    std::size_t samples = 0; ///< number of samples that the answer is based on
    double deltaTheta_rad =
        0.0; ///< rotation over the evaluated samples; for a regression that of the fitted line
    double deltaTorque_Nm = 0.0; ///< torque rise over the same; k_i = deltaTorque / (P_C^2 deltaTheta)
    Compliance totalCompliance;
    Compliance objectCompliance;
    Stiffness total;                     ///< k_i
    Stiffness object;                    ///< k_o
    Material material = Material::metal; ///< class of k_o; metal when only a bound of k_o is known
    bool materialCertain = false;        ///< the whole 95 % interval lies in this class
    /// The touch is stiffer than the link alone by more than its noise: some setting must be wrong.
    bool stifferThanLink = false;
};

/// Estimates the stiffness of an object from the log of one touch.
///   two-point   c_i = P_C^2 dTheta / dTau,  se = P_C^2 sqrt(2 (s_theta^2 + (dTheta/dTau s_tau)^2)) / dTau
///   regression  c_i = P_C^2 slope of the line angle over torque, errors in both readings
/// The regression uses the samples whose torque *on the line* lies in the window. Selecting by the measured
/// torque would prefer positive noise at the lower border and negative noise at the upper one, which biases
/// the slope. Its standard error comes from the scatter about the line (Student's t, n - 2); a known noise
/// replaces it unless the scatter is larger. Noise is assumed to be white. A noise that is not given is
/// estimated from the samples; if that is impossible, the angle counts as exact and a two-point answer has no
/// standard error. samples: the log of one touch in any order; repeated rows count once. Free motion,
/// unloading and later touches are ignored. Thread: any (pure). Error: see Refusal. Source: TeleTA, section
/// 2.
[[nodiscard]] tl::expected<TouchStiffness, Refusal> estimateStiffness(std::span<const JointSample> samples,
                                                                      const TouchSettings& settings);

} // namespace teleta::stiffness
