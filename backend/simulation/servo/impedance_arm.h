// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/arm/lwr_kinematics.h"
#include "backend/servo/cycle_times.h"
#include "backend/simulation/servo/elastic_array.h"
#include "backend/simulation/servo/lwr_inertia.h"
#include "backend/simulation/servo/touched_shape.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

namespace teleta::simulation {

/// Cartesian impedance of the controller (eq. 11); weight is compensated.
struct Impedance {
    double stiffness_NPerM = 1000.0;
    double rotationalStiffness_NmPerRad = 200.0;
    double dampingRatio = 0.7;
    double jointDamping_NmsPerRad = 1.0; ///< of the joints themselves; keeps the elbow from swinging
    double contactDampingTime_s = 0.0;   ///< a damper k time beside each pressed spring k; 0: none
    double friction = 0.0;               ///< coefficient between array and object; >= 0
};

/// The body that the array touches: rigid in shape, fixed or turning about an axis of the base.
struct TouchedObject {
    TouchedShape shape = WallSurface{};
    Eigen::Isometry3d X_Base_Object = Eigen::Isometry3d::Identity(); ///< at angle 0
    bool turns = false;
    Eigen::Vector3d axis_Base = Eigen::Vector3d::UnitY(); ///< unit vector
    Eigen::Vector3d p_Base_Hinge = Eigen::Vector3d::Zero();
    double damping_NmsPerRad = 0.0;
};

struct ImpedanceState {
    servo::LwrVector q_rad = servo::LwrVector::Zero();
    servo::LwrVector rate_radPerS = servo::LwrVector::Zero();
    double hinge_rad = 0.0;
    double hingeRate_radPerS = 0.0;
};

/// The arm under Cartesian impedance with an elastic array in its hand, in contact with an object that may
/// turn about a hinge.
///   M qdd = J^T (K (x_d - x)) - D qd + J^T w,    I hdd = -c hd + t - S^T w
/// x_d - x: translation in the base and rotation vector; D: modalDamping. One step is a backward Euler step,
/// taken as the minimum of
///   |q+ - q - h v|^2_M / 2h^2 + |q+ - q|^2_D / 2h (D with the dampers of the springs that are pressed at q)
///   + impedance, contact and hinge energy at q+
///   + mu sum over the springs pressed at q, of N (sqrt(s^2 + e^2) - e), s the way of the array on the object
/// (dry friction: mu N against the way, and below the speed e/h of 0.1 mm/s in proportion to it, so that what
/// sticks creeps) by Gauss-Newton with a line search from q. The potential energy after the step is never
/// above the energy before it, and what nonlinearity would add to the kinetic energy is taken off; a change
/// of the inertia with the posture keeps the kinetic energy. Energy therefore never grows unless the
/// reference, the torque on the hinge or its inertia is moved, for any step and any contact stiffness.
/// Coriolis torques are left out: below 0.1 rad/s they are under a thousandth of a Nm. Inertia and damping
/// follow the posture whenever a joint has turned by 5 mrad. Thread: one; step() allocates nothing. Source:
/// as FlexibleArm.
class ImpedanceArm {
public:
    ImpedanceArm(const Eigen::Isometry3d& X_Flange_Sensor, const Impedance& impedance, ElasticArray array,
                 TouchedObject object);

    /// Sets posture and rates; the reference is the array's pose there.
    void setState(const ImpedanceState& state);
    void setReference(const Eigen::Isometry3d& X_Base_Reference) { m_X_Base_Reference = X_Base_Reference; }
    /// Of the object about its hinge, from the next step on; kg m^2 > 0 and Nm.
    void setHinge(double inertia_kgm2, double torque_Nm);

    /// step_s > 0. times: null, or what contact and kinematics take is added there.
    void step(double step_s, servo::CycleTimes* times = nullptr);

    [[nodiscard]] const ImpedanceState& state() const { return m_state; }
    [[nodiscard]] const servo::LwrPosture& posture() const { return m_posture; }
    [[nodiscard]] const Eigen::Isometry3d& X_Base_Sensor() const { return m_posture.X_Base_Tool; }
    [[nodiscard]] const Eigen::Isometry3d& X_Base_Reference() const { return m_X_Base_Reference; }
    [[nodiscard]] Eigen::Isometry3d X_Base_Object() const { return objectAt(m_state.hinge_rad); }
    [[nodiscard]] const ArrayContact& contact() const { return m_contact; }
    [[nodiscard]] const ElasticArray& array() const { return m_array; }
    [[nodiscard]] const TouchedObject& object() const { return m_object; }
    [[nodiscard]] const servo::LwrKinematics& kinematics() const { return m_kinematics; }
    /// Kinetic energy, impedance springs, contact, and the torque on the hinge as a potential.
    [[nodiscard]] double energy_J() const;

private:
    static constexpr int kFreedoms = servo::kLwrJoints + 1;
    using Freedoms = Eigen::Matrix<double, kFreedoms, 1>;
    using FreedomsMatrix = Eigen::Matrix<double, kFreedoms, kFreedoms>;

    using Relative = Eigen::Matrix<double, 6, kFreedoms>;

    /// Posture, contact and potential energy at one set of coordinates.
    struct Place {
        Freedoms at;
        servo::LwrPosture posture;
        ArrayContact contact;
        servo::Vector6 spring_Base; ///< force and moment of the impedance on the array
        double potential_J;
    };

    [[nodiscard]] Eigen::Isometry3d objectAt(double hinge_rad) const;
    void evaluate(const Freedoms& at, Place& place, servo::CycleTimes* times) const;
    void evaluateSprings(Place& place) const;
    /// What the second derivative of the potential energy is made of. It does not depend on where the
    /// reference is, so that a step begins with that of the last one's end.
    struct Curvature {
        FreedomsMatrix hessian;
        FreedomsMatrix ofContact; ///< defined where springs are pressed, as is relative
        Relative relative;
        bool isOfState = false; ///< of the place at which the step is
    };
    /// Fills m_curvature.
    void findCurvature(const Place& place);
    /// Of the potential energy, where m_curvature has been found.
    [[nodiscard]] Freedoms gradientAt(const Place& place) const;
    void followPosture();
    /// Twist of the array relative to the object in {s}, for rates of the freedoms.
    [[nodiscard]] Relative relativeTwist(const Place& place) const;
    /// What friction dissipates on a way of the array on the object, with its derivatives over it.
    [[nodiscard]] double friction_J(const servo::Twist& way_Sensor, double creep_m, servo::Vector6* gradient,
                                    servo::Matrix6* hessian) const;
    [[nodiscard]] double kinetic_J(const Freedoms& rate) const;

    servo::LwrKinematics m_kinematics;
    Impedance m_impedance;
    Curvature m_curvature;
    servo::Vector6 m_stiffness;
    ElasticArray m_array;
    TouchedObject m_object;
    Eigen::Isometry3d m_X_Base_Reference = Eigen::Isometry3d::Identity();
    double m_hingeTorque_Nm = 0.0;

    std::vector<PressedPoint> m_rubbing; ///< at the start of the step

    ImpedanceState m_state;
    servo::LwrPosture m_posture;
    ArrayContact m_contact;
    FreedomsMatrix m_mass = FreedomsMatrix::Identity();
    FreedomsMatrix m_damping = FreedomsMatrix::Zero();
    servo::LwrVector m_inertiaAt_rad = servo::LwrVector::Zero();
};

} // namespace teleta::simulation
