// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/stiffness/joint_sample.h"
#include "backend/stiffness/material.h"
#include "backend/stiffness/refusal.h"
#include "backend/stiffness/relaxation_fit.h"
#include "backend/stiffness/touch_equations.h"
#include "backend/stiffness/touch_warning.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace teleta::stiffness {

enum class Method {
    twoPoint,   ///< the paper's method: the samples nearest to both borders of the window
    regression, ///< all samples in the window, with errors in torque and angle
};

/// Name in files and on the command line: "two-point", "regression".
[[nodiscard]] const char* toString(Method method);
[[nodiscard]] std::optional<Method> methodFromString(std::string_view text);

/// Standard error of a contact distance that is told without one, over the distance: no distance is known
/// better. The paper's own factors are rounded to as much.
inline constexpr double kLeastDistanceSe = 0.0005;

/// A regression needs so many independent samples in the window.
inline constexpr double kLeastEffectiveSamples = 20.0;

/// What is known about a touch besides its samples.
struct TouchSettings {
    double contactDistance_m = 0.0; ///< P_C, from the joint's axis along the link; > 0
    /// Standard error of P_C; >= 0; empty: kLeastDistanceSe of it.
    std::optional<double> contactDistanceSe_m;
    double linkStiffness_NPerM = kPaperLinkStiffness_NPerM; ///< k_ri; > 0
    double linkStiffnessSe_NPerM = 0.0;                     ///< standard error of k_ri; >= 0
    /// Standard error of the object's compliance from the place of the contact, where more depends on it than
    /// the distance: instead of contactDistanceSe_m.
    std::optional<double> placeSe_mPerN;
    TorqueWindow window;
    /// The arm's own motion bends the line, too, as where several joints yield: a bend, a softening and
    /// correlated residuals widen the interval, instead of making the answer unreliable or refused.
    bool patternsAreErrors = false;
    /// Torque of the joint without the touch; empty: that of the free motion before the touch, or 0 when the
    /// log has none.
    std::optional<double> torqueReference_Nm;
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

    bool reliable = true; ///< false: what the samples show is not a spring, or too coarse; see warnings
    std::vector<TouchWarning> warnings; ///< what was seen, each once, in the order of kTouchWarnings
    ErrorBudget errorBudget;            ///< of the object's compliance
    double effectiveSamples = 0.0;      ///< independent samples among them
    double torqueReference_Nm = 0.0;    ///< taken off, at the contact
    double torqueDrift_NmPerS = 0.0;    ///< taken off
    /// Where the window's line bends: the object's stiffness between the ends of the window, and at its upper
    /// end. Empty without TouchWarning::nonlinear, or where the object cannot be told from rigid.
    std::optional<double> secant_NPerM;
    std::optional<double> tangent_NPerM;
    /// Where the force depends on the rate and the log has a hold: then material is the class of the static
    /// stiffness.
    std::optional<StandardLinearSolid> solid;

    /// Whether material and materialCertain can be told to people.
    [[nodiscard]] bool materialKnown() const { return reliable || solid.has_value(); }
    [[nodiscard]] bool has(TouchWarning warning) const;
};

/// Estimates the stiffness of an object from the log of one touch.
///   two-point   c_i = P_C^2 dTheta / dTau,  se = P_C^2 sqrt(2 (s_theta^2 + (dTheta/dTau s_tau)^2)) / dTau
///   regression  c_i = P_C^2 slope of the line angle over torque, errors in both readings
/// The regression uses the samples whose torque *on the line* lies in the window. Selecting by the measured
/// torque would prefer positive noise at the lower border and negative noise at the upper one, which biases
/// the slope. Its standard error comes from the scatter about the line (Student's t, n - 2); a known noise
/// replaces it unless the scatter is larger. A noise that is not given is estimated from the samples; if that
/// is impossible, the angle counts as exact and a two-point answer has no standard error.
///
/// The torque of the free motion is taken off, and its slope where it is over 3.5 standard errors. A smaller
/// one enters the error, with no more than the noise has. The other parts of the error are those of
/// ErrorSource; the distance enters squared. Patterns that a spring does not have are told as warnings, see
/// examineTouch(). A bend of the line within the window by more than a tenth, coarse steps, rate dependence
/// and stick-slip make the answer unreliable; offset, drift and correlation, which were taken care of, do
/// not. samples: the log of one touch in any order; repeated rows count once. Unloading and later touches do
/// not move the value. Thread: any (pure). Error: see Refusal. Source: TeleTA, section 2.
[[nodiscard]] tl::expected<TouchStiffness, Refusal> estimateStiffness(std::span<const JointSample> samples,
                                                                      const TouchSettings& settings);

/// The value of TouchStiffness::objectCompliance alone, in m/N, without its error. For looking at the same
/// touch with other settings: it takes half of the time. Thread: any (pure). Error: a Refusal of the
/// samples, the settings or the line; what estimateStiffness() refuses for its error is not seen here.
[[nodiscard]] tl::expected<double, Refusal> estimateObjectCompliance(std::span<const JointSample> samples,
                                                                     const TouchSettings& settings);

} // namespace teleta::stiffness
