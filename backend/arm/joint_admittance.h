// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tl/expected.hpp>

namespace teleta::arm {

/// Mechanical impedance that the joint imitates; each finite and >= 0, not all zero.
struct AdmittanceParameters {
    double inertia_kgm2 = 0.1;        ///< M
    double damping_NmsPerRad = 2.0;   ///< D
    double stiffness_NmPerRad = 10.0; ///< K
};

struct JointState {
    double angle_rad = 0.0;
    double rate_radPerS = 0.0;
};

enum class AdmittanceRefusal {
    notFinite,    ///< a parameter, an input or the state is NaN or infinite
    negative,     ///< M, D or K is below zero
    undetermined, ///< M = D = K = 0: there is no law of motion
    badStep,      ///< the step is not within [kShortestStep_s, kLongestStep_s]
    outOfRange,   ///< a number, or the new state, exceeds 1e100
};

/// Local admittance control of one joint, which yields to the external torque like a mass on a damped spring:
///   M qdd + D qd + K (q - q_ref) = tau_ext
/// Integrated with the two-stage diagonally implicit Runge-Kutta method of order 2 (gamma = 1 - 1/sqrt 2),
/// inputs held over the step. It is A- and L-stable, so for any M, D, K and step the energy
///   M qd^2/2 + K (q - q_ref)^2/2
/// never grows without input, and a stiff spring settles instead of ringing.
///   M = 0          first order; the rate follows from the balance at the new angle
///   M = D = 0      the angle is q_ref + tau/K at once; the rate is the mean over the step
///   K = 0          no preferred position; with M = 0 as well it creeps at tau/D
///   D = 0          an undamped spring; the method removes a little energy and never adds any
/// Thread: one; step() allocates nothing.
/// Source: TeleTA, section 1 (local admittance controllers); Alexander, SIAM J. Numer. Anal. 14 (1977) 1006.
class JointAdmittance {
public:
    static constexpr double kShortestStep_s = 1e-6;
    static constexpr double kLongestStep_s = 1.0;

    /// Error: notFinite, negative, undetermined.
    [[nodiscard]] static tl::expected<JointAdmittance, AdmittanceRefusal>
    create(const AdmittanceParameters& parameters, const JointState& state = {});

    /// Advances by one step. step_s: kShortestStep_s to kLongestStep_s. After an error the state is
    /// unchanged.
    tl::expected<JointState, AdmittanceRefusal> step(double externalTorque_Nm, double reference_rad,
                                                     double step_s);

    /// Changes the law of motion and keeps the state. After an error nothing is changed.
    tl::expected<void, AdmittanceRefusal> setParameters(const AdmittanceParameters& parameters);
    tl::expected<void, AdmittanceRefusal> setState(const JointState& state);

    [[nodiscard]] const AdmittanceParameters& parameters() const { return m_parameters; }
    [[nodiscard]] const JointState& state() const { return m_state; }

    /// M qd^2/2 + K (q - q_ref)^2/2, in J.
    [[nodiscard]] double energy_J(double reference_rad) const;

private:
    JointAdmittance(const AdmittanceParameters& parameters, const JointState& state)
        : m_parameters(parameters)
        , m_state(state) {}

    AdmittanceParameters m_parameters;
    JointState m_state;
};

} // namespace teleta::arm
