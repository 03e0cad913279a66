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
    twoPoint,   ///< the paper's: the samples nearest to both borders of the window
    regression, ///< all samples of the window, errors in torque and angle
};

/// Value in files and on the command line: "two-point", "regression".
[[nodiscard]] const char* toString(Method method);
[[nodiscard]] std::optional<Method> methodFromString(std::string_view text);

/// What is known of a touch besides its samples.
struct TouchSettings {
    double contactDistance_m = 0.0; ///< P_C, from the joint's axis along the link; > 0
    double linkStiffness_NPerM = kPaperLinkStiffness_NPerM; ///< k_ri; > 0
    double linkStiffnessSe_NPerM = 0.0;                     ///< standard error of k_ri; >= 0
    TorqueWindow window;
    double torqueReference_Nm = 0.0; ///< torque of the joint without the touch
    Method method = Method::regression;
    std::optional<double> torqueNoise_Nm; ///< standard deviations when known; else estimated from the samples
    std::optional<double> angleNoise_rad;
};

/// Stiffness of one touch.
struct TouchStiffness {
    Method method = Method::regression;
    std::size_t samples = 0;     ///< samples that the answer rests on
    double deltaTheta_rad = 0.0; ///< rotation over the evaluated samples; of the fitted line for a regression
    double deltaTorque_Nm = 0.0; ///< torque rise over the same; k_i = deltaTorque / (P_C^2 deltaTheta)
    Compliance totalCompliance;
    Compliance objectCompliance;
    Stiffness total;                     ///< k_i
    Stiffness object;                    ///< k_o
    Material material = Material::metal; ///< of k_o; metal when k_o is only bounded
    bool materialCertain = false;        ///< the whole 95 % interval lies in that class
    /// The touch is stiffer than the link allows, by more than its noise: some setting is wrong.
    bool stifferThanLink = false;
};

/// Stiffness of the object from the log of one touch.
///   two-point   c_i = P_C^2 dTheta / dTau,  se = P_C^2 sqrt(2 (s_theta^2 + (dTheta/dTau s_tau)^2)) / dTau
///   regression  c_i = P_C^2 slope of the line angle over torque, errors in both readings
/// The regression runs over the samples whose torque *on the line* lies in the window: choosing by the
/// measured torque would keep high noise at the lower border and low noise at the upper one and so bend the
/// line. Its standard error comes from the scatter about the line (Student's t, n - 2); known noise replaces
/// that, unless the scatter is larger. Noise is taken as white. A noise that is not given is estimated from
/// the samples; where they do not tell, the angle counts as exact and a two-point answer has no error.
/// samples: one log, any order of rows, repeated rows count once. Free motion, unloading and later touches
/// are left out. Thread: any (pure). Error: see Refusal. Source: TeleTA, section 2.
[[nodiscard]] tl::expected<TouchStiffness, Refusal> estimateStiffness(std::span<const JointSample> samples,
                                                                      const TouchSettings& settings);

} // namespace teleta::stiffness
