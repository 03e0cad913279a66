// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm/joint_admittance.h"

#include "backend/arm/largest_input.h"

#include <cmath>
#include <numbers>
#include <optional>

namespace teleta::arm {

namespace {

constexpr double kGamma = 1.0 - 1.0 / std::numbers::sqrt2;

std::optional<AdmittanceRefusal> refuse(const AdmittanceParameters& parameters) {
    const double inertia = parameters.inertia_kgm2;
    const double damping = parameters.damping_NmsPerRad;
    const double stiffness = parameters.stiffness_NmPerRad;
    if (!std::isfinite(inertia) || !std::isfinite(damping) || !std::isfinite(stiffness))
        return AdmittanceRefusal::notFinite;
    if (inertia < 0.0 || damping < 0.0 || stiffness < 0.0)
        return AdmittanceRefusal::negative;
    if (inertia == 0.0 && damping == 0.0 && stiffness == 0.0)
        return AdmittanceRefusal::undetermined;
    if (inertia > kLargestInput || damping > kLargestInput || stiffness > kLargestInput)
        return AdmittanceRefusal::outOfRange;
    return std::nullopt;
}

std::optional<AdmittanceRefusal> refuse(const JointState& state) {
    if (!std::isfinite(state.angle_rad) || !std::isfinite(state.rate_radPerS))
        return AdmittanceRefusal::notFinite;
    if (std::abs(state.angle_rad) > kLargestInput || std::abs(state.rate_radPerS) > kLargestInput)
        return AdmittanceRefusal::outOfRange;
    return std::nullopt;
}

} // namespace

tl::expected<JointAdmittance, AdmittanceRefusal>
JointAdmittance::create(const AdmittanceParameters& parameters, const JointState& state) {
    if (const std::optional<AdmittanceRefusal> refusal = refuse(parameters))
        return tl::unexpected(*refusal);
    if (const std::optional<AdmittanceRefusal> refusal = refuse(state))
        return tl::unexpected(*refusal);
    return JointAdmittance(parameters, state);
}

tl::expected<void, AdmittanceRefusal> JointAdmittance::setParameters(const AdmittanceParameters& parameters) {
    if (const std::optional<AdmittanceRefusal> refusal = refuse(parameters))
        return tl::unexpected(*refusal);
    m_parameters = parameters;
    return {};
}

tl::expected<void, AdmittanceRefusal> JointAdmittance::setState(const JointState& state) {
    if (const std::optional<AdmittanceRefusal> refusal = refuse(state))
        return tl::unexpected(*refusal);
    m_state = state;
    return {};
}

tl::expected<JointState, AdmittanceRefusal> JointAdmittance::step(double externalTorque_Nm,
                                                                  double reference_rad, double step_s) {
    if (!std::isfinite(externalTorque_Nm) || !std::isfinite(reference_rad) || !std::isfinite(step_s))
        return tl::unexpected(AdmittanceRefusal::notFinite);
    if (step_s < kShortestStep_s || step_s > kLongestStep_s)
        return tl::unexpected(AdmittanceRefusal::badStep);
    if (std::abs(externalTorque_Nm) > kLargestInput || std::abs(reference_rad) > kLargestInput)
        return tl::unexpected(AdmittanceRefusal::outOfRange);

    const double inertia = m_parameters.inertia_kgm2;
    const double stiffness = m_parameters.stiffness_NmPerRad;
    const double stage_s = kGamma * step_s;
    const double implicitInertia = inertia + stage_s * (m_parameters.damping_NmsPerRad + stage_s * stiffness);
    if (!std::isnormal(implicitInertia))
        return tl::unexpected(AdmittanceRefusal::outOfRange);
    // Both stages solve M (v - v0)/(g h) + D v + K (q0 + g h v - q_ref) = tau for their rate v.
    const auto stageRate = [&](double angle_rad, double rate_radPerS) {
        return (inertia * rate_radPerS +
                stage_s * (externalTorque_Nm - stiffness * (angle_rad - reference_rad))) /
               implicitInertia;
    };

    const double firstRate = stageRate(m_state.angle_rad, m_state.rate_radPerS);
    const double angle_rad = m_state.angle_rad + (step_s - stage_s) * firstRate;
    const double rate_radPerS =
        m_state.rate_radPerS + (1.0 - kGamma) / kGamma * (firstRate - m_state.rate_radPerS);
    if (refuse(JointState{angle_rad, rate_radPerS}))
        return tl::unexpected(AdmittanceRefusal::outOfRange);
    const double secondRate = stageRate(angle_rad, rate_radPerS);

    JointState next{angle_rad + stage_s * secondRate, secondRate};
    if (inertia == 0.0 && m_parameters.damping_NmsPerRad == 0.0)
        next.rate_radPerS = (next.angle_rad - m_state.angle_rad) / step_s;
    if (refuse(next))
        return tl::unexpected(AdmittanceRefusal::outOfRange);
    m_state = next;
    return m_state;
}

double JointAdmittance::energy_J(double reference_rad) const {
    const double deviation_rad = m_state.angle_rad - reference_rad;
    return 0.5 * m_parameters.inertia_kgm2 * m_state.rate_radPerS * m_state.rate_radPerS +
           0.5 * m_parameters.stiffness_NmPerRad * deviation_rad * deviation_rad;
}

} // namespace teleta::arm
