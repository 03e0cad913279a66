// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/arm/flexible_arm.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::simulation {

namespace {

using arm::JointVector;
using Eigen::Vector3d;

constexpr int kMostIterations = 60;
constexpr int kMostHalvings = 40;
/// A step of Gauss-Newton that is smaller is the last one: what is left is smaller by the square.
constexpr double kLastMove_rad = 1e-10;

} // namespace

double TouchedBody::force_N(double depth_m) const {
    const double hardening = doublingDepth_m ? 1.0 + depth_m / *doublingDepth_m : 1.0;
    return stiffness_NPerM * depth_m * hardening;
}

double TouchedBody::energy_J(double depth_m) const {
    const double hardening = doublingDepth_m ? 0.5 + depth_m / (3.0 * *doublingDepth_m) : 0.5;
    return stiffness_NPerM * depth_m * depth_m * hardening;
}

double TouchedBody::tangent_NPerM(double depth_m) const {
    return stiffness_NPerM * (doublingDepth_m ? 1.0 + 2.0 * depth_m / *doublingDepth_m : 1.0);
}

/// What the joints do to the links over one step, the motors eliminated: springs of this stiffness that rest
/// at these angles, and how the motors follow from the links,
///   theta = (motorWeight motorTarget + stiffness (q + twist)) / (motorWeight + stiffness)
struct FlexibleArm::Springs {
    JointVector stiffness_NmPerRad;
    JointVector rest_rad;
    JointVector motorTarget_rad;
    double motorWeight = 0.0; ///< 0: position control, the motors are at their targets
    JointVector twist_rad;
    JointVector twistStiffness_NmPerRad;
};

FlexibleArm::FlexibleArm(const scene::ArmBody& body, const scene::JointControl& control,
                         std::vector<TouchedBody> bodies)
    : m_kinematics(dimensionsOf(body))
    , m_inertia(body)
    , m_control(control)
    , m_stiffness_NmPerRad(Eigen::Map<const JointVector>(body.jointStiffness_NmPerRad.data()))
    , m_damping_NmsPerRad(body.jointDampingTime_s * m_stiffness_NmPerRad)
    , m_bodies(std::move(bodies))
    , m_contacts(m_bodies.size()) {
    rest(Eigen::Map<const JointVector>(body.start_rad.data()));
}

void FlexibleArm::rest(const JointVector& q_rad) {
    ArmState state;
    state.link_rad = state.motor_rad = q_rad;
    setState(state);
}

void FlexibleArm::setState(const ArmState& state) {
    m_state = state;
    m_mass = m_inertia.massMatrix(state.link_rad);
    updateContacts();
}

JointVector FlexibleArm::torque_Nm() const {
    return m_stiffness_NmPerRad.cwiseProduct(m_state.motor_rad - m_state.link_rad);
}

BodyContact FlexibleArm::contactAt(const JointVector& q_rad, const TouchedBody& body) const {
    return contactAt(m_kinematics.X_Base_Link(arm::Link::forearm, q_rad), body);
}

bool FlexibleArm::mayTouch(const Eigen::Isometry3d& X_Base_Forearm, const TouchedBody& body) const {
    return body.present &&
           !isBeyond(body.outline, X_Base_Forearm.translation(), X_Base_Forearm.linear().col(0),
                     m_kinematics.dimensions().forearmLength_m, m_kinematics.dimensions().halfThickness_m);
}

BodyContact FlexibleArm::contactAt(const Eigen::Isometry3d& X_Base_Forearm, const TouchedBody& body) const {
    const AxisDistance axis =
        axisDistance(body.outline, X_Base_Forearm.translation(), X_Base_Forearm.linear().col(0),
                     m_kinematics.dimensions().forearmLength_m);
    BodyContact contact{.depth_m = m_kinematics.dimensions().halfThickness_m - axis.distance_m,
                        .force_N = 0.0,
                        .along_m = axis.along_m,
                        .normal = axis.normal};
    if (contact.depth_m > 0.0)
        contact.force_N = body.force_N(contact.depth_m);
    return contact;
}

double FlexibleArm::addContacts(const JointVector& q_rad, JointVector* gradient, MassMatrix* hessian) const {
    const Eigen::Isometry3d X_Base_Forearm = m_kinematics.X_Base_Link(arm::Link::forearm, q_rad);
    double energy_J = 0.0;
    for (const TouchedBody& body : m_bodies) {
        if (!mayTouch(X_Base_Forearm, body))
            continue;
        const BodyContact contact = contactAt(X_Base_Forearm, body);
        if (contact.depth_m <= 0.0)
            continue;
        energy_J += body.energy_J(contact.depth_m);
        if (gradient == nullptr)
            continue;
        const JointVector slope =
            m_kinematics.pointJacobian(arm::Link::forearm, q_rad, {contact.along_m, 0.0, 0.0}).transpose() *
            contact.normal;
        *gradient -= contact.force_N * slope;
        *hessian += body.tangent_NPerM(contact.depth_m) * slope * slope.transpose();
    }
    return energy_J;
}

FlexibleArm::Springs FlexibleArm::springsFor(double step_s, const JointVector& reference_rad) const {
    Springs springs;
    springs.twistStiffness_NmPerRad = m_stiffness_NmPerRad + m_damping_NmsPerRad / step_s;
    const JointVector twist_rad = m_state.motor_rad - m_state.link_rad;
    springs.twist_rad =
        (m_damping_NmsPerRad / step_s).cwiseProduct(twist_rad).cwiseQuotient(springs.twistStiffness_NmPerRad);
    if (const auto* position = std::get_if<scene::PositionControl>(&m_control)) {
        const double share = step_s * position->bandwidth_radPerS;
        const JointVector rate_radPerS =
            (m_state.motorRate_radPerS +
             share * position->bandwidth_radPerS * (reference_rad - m_state.motor_rad)) /
            ((1.0 + share) * (1.0 + share));
        springs.motorTarget_rad = m_state.motor_rad + step_s * rate_radPerS;
        springs.stiffness_NmPerRad = springs.twistStiffness_NmPerRad;
    } else {
        const auto& admittance = std::get<scene::AdmittanceControl>(m_control);
        const double mass = admittance.inertia_kgm2 / (step_s * step_s);
        const double damping = admittance.damping_NmsPerRad / step_s;
        springs.motorWeight = mass + damping + admittance.stiffness_NmPerRad;
        springs.motorTarget_rad =
            (mass * (m_state.motor_rad + step_s * m_state.motorRate_radPerS) + damping * m_state.motor_rad +
             admittance.stiffness_NmPerRad * reference_rad) /
            springs.motorWeight;
        springs.stiffness_NmPerRad = (springs.motorWeight * springs.twistStiffness_NmPerRad.array() /
                                      (springs.motorWeight + springs.twistStiffness_NmPerRad.array()))
                                         .matrix();
    }
    springs.rest_rad = springs.motorTarget_rad - springs.twist_rad;
    return springs;
}

JointVector FlexibleArm::minimise(double step_s, const Springs& springs,
                                  const JointVector& externalTorque_Nm) const {
    const MassMatrix inertia = m_mass / (step_s * step_s);
    const JointVector coast_rad = m_state.link_rad + step_s * m_state.linkRate_radPerS;
    const auto withoutContacts = [&](const JointVector& q_rad) {
        const JointVector away_rad = q_rad - coast_rad;
        const JointVector stretch_rad = q_rad - springs.rest_rad;
        return 0.5 * away_rad.dot(inertia * away_rad) +
               0.5 * stretch_rad.dot(springs.stiffness_NmPerRad.cwiseProduct(stretch_rad)) -
               externalTorque_Nm.dot(q_rad - m_state.link_rad);
    };
    JointVector q_rad = m_state.link_rad;
    for (int i = 0; i < kMostIterations; ++i) {
        JointVector gradient = inertia * (q_rad - coast_rad) +
                               springs.stiffness_NmPerRad.cwiseProduct(q_rad - springs.rest_rad) -
                               externalTorque_Nm;
        MassMatrix hessian = inertia;
        hessian.diagonal() += springs.stiffness_NmPerRad;
        const double energy_J = addContacts(q_rad, &gradient, &hessian) + withoutContacts(q_rad);
        const JointVector move_rad = -hessian.llt().solve(gradient);
        // The last step is below what rounding lets the energy show.
        if (move_rad.lpNorm<Eigen::Infinity>() < kLastMove_rad)
            return q_rad + move_rad;
        double share = 1.0;
        for (int halving = 0;; ++halving, share *= 0.5) {
            const JointVector next_rad = q_rad + share * move_rad;
            if (withoutContacts(next_rad) + addContacts(next_rad, nullptr, nullptr) <= energy_J) {
                q_rad = next_rad;
                break;
            }
            if (halving == kMostHalvings)
                return q_rad;
        }
    }
    return q_rad;
}

double FlexibleArm::twistEnergy_J(const JointVector& q_rad, const JointVector& motor_rad) const {
    const JointVector twist_rad = motor_rad - q_rad;
    return 0.5 * twist_rad.dot(m_stiffness_NmPerRad.cwiseProduct(twist_rad));
}

double FlexibleArm::controlEnergy_J(const ArmState& state, const JointVector& reference_rad,
                                    bool kinetic) const {
    const auto* admittance = std::get_if<scene::AdmittanceControl>(&m_control);
    if (admittance == nullptr)
        return 0.0;
    return kinetic ? 0.5 * admittance->inertia_kgm2 * state.motorRate_radPerS.squaredNorm()
                   : 0.5 * admittance->stiffness_NmPerRad * (state.motor_rad - reference_rad).squaredNorm();
}

double FlexibleArm::energy_J(const JointVector& reference_rad) const {
    const JointVector& rate = m_state.linkRate_radPerS;
    return 0.5 * rate.dot(m_mass * rate) + twistEnergy_J(m_state.link_rad, m_state.motor_rad) +
           contactEnergy_J() + controlEnergy_J(m_state, reference_rad, false) +
           controlEnergy_J(m_state, reference_rad, true);
}

void FlexibleArm::step(double step_s, const JointVector& reference_rad,
                       const JointVector& externalTorque_Nm) {
    const Springs springs = springsFor(step_s, reference_rad);
    const bool positionControl = springs.motorWeight == 0.0;

    ArmState next;
    next.link_rad = minimise(step_s, springs, externalTorque_Nm);
    const JointVector moved_rad = next.link_rad - m_state.link_rad;
    next.linkRate_radPerS = moved_rad / step_s;
    next.motor_rad =
        positionControl
            ? springs.motorTarget_rad
            : JointVector((springs.motorWeight * springs.motorTarget_rad +
                           springs.twistStiffness_NmPerRad.cwiseProduct(next.link_rad + springs.twist_rad))
                              .cwiseQuotient(JointVector::Constant(springs.motorWeight) +
                                             springs.twistStiffness_NmPerRad));
    next.motorRate_radPerS = (next.motor_rad - m_state.motor_rad) / step_s;

    const auto kinetic = [](const MassMatrix& matrix, const JointVector& rate) {
        return 0.5 * rate.dot(matrix * rate);
    };
    double linkEnergy_J = kinetic(m_mass, next.linkRate_radPerS);

    // Energy that may be there: what was there, and what motors and forces put in. A motor under position
    // control works on spring and damper when it moves to its target.
    const JointVector& motor_rad = positionControl ? next.motor_rad : m_state.motor_rad;
    const double allowed_J =
        kinetic(m_mass, m_state.linkRate_radPerS) + twistEnergy_J(m_state.link_rad, motor_rad) +
        0.5 * (motor_rad - m_state.motor_rad).cwiseAbs2().dot(m_damping_NmsPerRad) / step_s +
        contactEnergy_J() + controlEnergy_J(m_state, reference_rad, false) +
        controlEnergy_J(m_state, reference_rad, true) + externalTorque_Nm.dot(moved_rad);
    setState(next);
    const double potential_J = twistEnergy_J(next.link_rad, next.motor_rad) + contactEnergy_J() +
                               controlEnergy_J(next, reference_rad, false);
    const double motion_J = linkEnergy_J + controlEnergy_J(next, reference_rad, true);
    if (motion_J + potential_J > allowed_J && motion_J > 0.0) {
        const double share = std::max(allowed_J - potential_J, 0.0) / motion_J;
        linkEnergy_J *= share;
        m_state.linkRate_radPerS *= std::sqrt(share);
        if (!positionControl)
            m_state.motorRate_radPerS *= std::sqrt(share);
    }

    // The links coast on: c turns the velocity and changes no energy.
    JointVector& rate = m_state.linkRate_radPerS;
    rate -= step_s * m_mass.llt().solve(m_inertia.velocityTorque(m_state.link_rad, rate));
    const double turnedEnergy_J = kinetic(m_mass, rate);
    if (turnedEnergy_J > 0.0)
        rate *= std::sqrt(linkEnergy_J / turnedEnergy_J);
}

void FlexibleArm::stepExplicitly(double step_s, const JointVector& reference_rad,
                                 const JointVector& externalTorque_Nm) {
    const JointVector spring_Nm =
        torque_Nm() + m_damping_NmsPerRad.cwiseProduct(m_state.motorRate_radPerS - m_state.linkRate_radPerS);
    JointVector gradient = JointVector::Zero();
    MassMatrix unused = MassMatrix::Zero();
    addContacts(m_state.link_rad, &gradient, &unused);
    const JointVector linkAcceleration =
        m_mass.llt().solve(spring_Nm - gradient + externalTorque_Nm -
                           m_inertia.velocityTorque(m_state.link_rad, m_state.linkRate_radPerS));
    JointVector motorAcceleration;
    const JointVector away_rad = reference_rad - m_state.motor_rad;
    if (const auto* position = std::get_if<scene::PositionControl>(&m_control)) {
        const double w = position->bandwidth_radPerS;
        motorAcceleration = w * w * away_rad - 2.0 * w * m_state.motorRate_radPerS;
    } else {
        const auto& admittance = std::get<scene::AdmittanceControl>(m_control);
        motorAcceleration = (admittance.stiffness_NmPerRad * away_rad -
                             admittance.damping_NmsPerRad * m_state.motorRate_radPerS - spring_Nm) /
                            admittance.inertia_kgm2;
    }
    ArmState next = m_state;
    next.linkRate_radPerS += step_s * linkAcceleration;
    next.motorRate_radPerS += step_s * motorAcceleration;
    next.link_rad += step_s * next.linkRate_radPerS;
    next.motor_rad += step_s * next.motorRate_radPerS;
    setState(next);
}

double FlexibleArm::contactEnergy_J() const {
    double energy_J = 0.0;
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        if (m_contacts[i].depth_m > 0.0)
            energy_J += m_bodies[i].energy_J(m_contacts[i].depth_m);
    }
    return energy_J;
}

void FlexibleArm::setPresent(std::size_t body, bool present) {
    if (std::exchange(m_bodies[body].present, present) != present)
        updateContacts();
}

void FlexibleArm::updateContacts() {
    const Eigen::Isometry3d X_Base_Forearm = m_kinematics.X_Base_Link(arm::Link::forearm, m_state.link_rad);
    for (std::size_t i = 0; i < m_bodies.size(); ++i)
        m_contacts[i] =
            mayTouch(X_Base_Forearm, m_bodies[i]) ? contactAt(X_Base_Forearm, m_bodies[i]) : BodyContact{};
}

} // namespace teleta::simulation
