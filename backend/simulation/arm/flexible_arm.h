// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/arm_world.h"
#include "backend/simulation/arm/outline_geometry.h"
#include "backend/simulation/base/arm_inertia.h"

#include <optional>
#include <vector>

namespace teleta::simulation {

/// An object that the forearm meets: its outline and how hard it is.
///   F = k d (1 + d / doublingDepth)
struct TouchedBody {
    OutlineGeometry outline;
    double stiffness_NPerM = 0.0;
    std::optional<double> doublingDepth_m; ///< empty: F = k d
    bool present = true;

    [[nodiscard]] double force_N(double depth_m) const;
    [[nodiscard]] double energy_J(double depth_m) const;
    [[nodiscard]] double tangent_NPerM(double depth_m) const;
};

/// Contact of the forearm with one body.
struct BodyContact {
    double depth_m = 0.0;                              ///< > 0: they touch
    double force_N = 0.0;                              ///< 0 without contact
    double along_m = 0.0;                              ///< from the elbow along the forearm's axis
    Eigen::Vector3d normal = Eigen::Vector3d::UnitX(); ///< from the body to the forearm
};

struct ArmState {
    arm::JointVector link_rad = arm::JointVector::Zero();
    arm::JointVector linkRate_radPerS = arm::JointVector::Zero();
    arm::JointVector motor_rad = arm::JointVector::Zero();
    arm::JointVector motorRate_radPerS = arm::JointVector::Zero();
};

/// The arm behind twisting joints, in contact with bodies. Weight is compensated and contact is without
/// friction.
///   links   M(q) qdd + c(q, qd) = K (theta - q) + d (thetad - qd) + J^T n F + tau_ext
///   motors  thetadd = w^2 (ref - theta) - 2 w thetad                        (position control)
///           M_a thetadd + D_a thetad + K_a (theta - ref) = -K (theta - q)   (admittance control)
/// One step is a backward Euler step, taken as what it is: the minimum of
///   |q+ - q - h v|^2_M / 2h^2 + energy of springs and contacts at q+
/// by Gauss-Newton with a line search that begins at q, so that the potential energy after the step is never
/// above the energy before it; the turn of the velocity by c keeps the kinetic energy, and what nonlinearity
/// would add to it is taken off. Energy therefore never grows without a motor or a force that works, for any
/// step and any contact stiffness. The control law of the motors is integrated together with the links: held
/// over a step, as in a sampled controller, the torque of a stiff joint would add energy.
/// Thread: one; step() allocates nothing.
/// Source: Hairer, Wanner, Solving Ordinary Differential Equations II (1996), IV.12 (backward Euler);
/// Martin et al., Example-based elastic materials, ACM TOG 30 (2011) 72 (its variational form).
class FlexibleArm {
public:
    FlexibleArm(const scene::ArmBody& body, const scene::JointControl& control,
                std::vector<TouchedBody> bodies);

    /// Links and motors rest at the angles.
    void rest(const arm::JointVector& q_rad);

    /// One step of step_s > 0. externalTorque_Nm: of forces other than contact, on the links.
    void step(double step_s, const arm::JointVector& reference_rad,
              const arm::JointVector& externalTorque_Nm = arm::JointVector::Zero());

    /// The same equations by an explicit step of first order (the velocities first, then the angles with
    /// them). Cheap, but stable only while step_s is well below the shortest time of the arm, for stiff
    /// joints some 10 us; beyond, the energy grows without bound. For comparison and as fine-step solution.
    /// Source: Hairer, Lubich, Wanner, Geometric Numerical Integration (2006), I.1.2 (symplectic Euler).
    void stepExplicitly(double step_s, const arm::JointVector& reference_rad,
                        const arm::JointVector& externalTorque_Nm = arm::JointVector::Zero());

    void setPresent(std::size_t body, bool present);

    [[nodiscard]] const ArmState& state() const { return m_state; }
    void setState(const ArmState& state);
    /// K (theta - q): what the joints press on the links.
    [[nodiscard]] arm::JointVector torque_Nm() const;
    [[nodiscard]] const std::vector<TouchedBody>& bodies() const { return m_bodies; }
    /// One a body; of those that do not touch nothing else counts.
    [[nodiscard]] const std::vector<BodyContact>& contacts() const { return m_contacts; }
    /// Of links, springs, contacts, and under admittance control of the virtual masses and springs.
    [[nodiscard]] double energy_J(const arm::JointVector& reference_rad) const;
    [[nodiscard]] const arm::Arm4Kinematics& kinematics() const { return m_kinematics; }
    [[nodiscard]] const ArmInertia& inertia() const { return m_inertia; }
    [[nodiscard]] BodyContact contactAt(const arm::JointVector& q_rad, const TouchedBody& body) const;

private:
    struct Springs;
    [[nodiscard]] BodyContact contactAt(const Eigen::Isometry3d& X_Base_Forearm,
                                        const TouchedBody& body) const;
    /// Cheap: a body that is present and near enough that it may touch.
    [[nodiscard]] bool mayTouch(const Eigen::Isometry3d& X_Base_Forearm, const TouchedBody& body) const;
    [[nodiscard]] Springs springsFor(double step_s, const arm::JointVector& reference_rad) const;
    /// Energy of the contacts at q, into gradient and hessian when they are given.
    double addContacts(const arm::JointVector& q_rad, arm::JointVector* gradient, MassMatrix* hessian) const;
    [[nodiscard]] double twistEnergy_J(const arm::JointVector& q_rad,
                                       const arm::JointVector& motor_rad) const;
    [[nodiscard]] double controlEnergy_J(const ArmState& state, const arm::JointVector& reference_rad,
                                         bool kinetic) const;
    [[nodiscard]] arm::JointVector minimise(double step_s, const Springs& springs,
                                            const arm::JointVector& externalTorque_Nm) const;
    [[nodiscard]] double contactEnergy_J() const; ///< of m_contacts
    void updateContacts();

    arm::Arm4Kinematics m_kinematics;
    ArmInertia m_inertia;
    scene::JointControl m_control;
    arm::JointVector m_stiffness_NmPerRad;
    arm::JointVector m_damping_NmsPerRad;
    std::vector<TouchedBody> m_bodies;
    std::vector<BodyContact> m_contacts;
    ArmState m_state;
    MassMatrix m_mass = MassMatrix::Identity(); ///< at m_state
};

} // namespace teleta::simulation
