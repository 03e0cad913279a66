// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/tactile_features.h"
#include "backend/servo/active_limits.h"
#include "backend/servo/contact_search.h"
#include "backend/servo/lwr_inverse.h"
#include "backend/servo/pi_regulator.h"
#include "backend/servo/servo_phases.h"
#include "backend/servo/servo_task.h"

#include <tl/expected.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace teleta::servo {

struct ServoInput {
    contact::TactileFeatures features;
    double dt_s = 0.0;                                               ///< since the frame before; > 0
    Eigen::Isometry3d X_Base_Sensor = Eigen::Isometry3d::Identity(); ///< measured
    std::optional<LwrVector> q_rad; ///< measured joints; without them joint limits are not looked at
    bool hold = false;              ///< STOP: the command becomes the measured pose and stays there
};

struct ServoOutput {
    Eigen::Isometry3d X_Base_Sensor = Eigen::Isometry3d::Identity(); ///< desired
    Twist twist_Sensor = Twist::Zero();                              ///< commanded, in {s}
    Twist twist_Base = Twist::Zero();                                ///< the same by the adjoint (13)
    std::size_t phase = 0;                                           ///< index of the plan's task
    TaskKind kind = TaskKind::freeMotion;
    bool phaseBegan = false; ///< this step is the first of its task
    bool finished = false;   ///< the last task's exit has been reached
    ContactState contact = ContactState::none;
    bool edge = false;                             ///< beta of the inverse Jacobian
    ActiveLimits limits;                           ///< that acted in this step
    FeatureVector desired = FeatureVector::Zero(); ///< s_d
    FeatureVector actual = FeatureVector::Zero();  ///< J^-1 s; 0 where it is not known
    std::array<bool, 6> known{};                   ///< which rows of it are defined and count
    Vector6 error = Vector6::Zero();               ///< P (s_d - J^-1 s)
    Vector6 integral = Vector6::Zero();            ///< share of the integral in the twist
    Matrix6 inverseJacobian = Matrix6::Identity();
    Matrix6 projection = Matrix6::Zero();

    /// Where the contact is wanted along x, as the paper draws it (Fig. 10c): the pseudo-measurement of CoP_x
    /// that makes the sensor slide, or CoC_x of a point that becomes an edge. Nothing: the task has no such
    /// wish.
    [[nodiscard]] std::optional<double> desiredCocX_m() const;
    /// Nothing: the task does not act on the moment.
    [[nodiscard]] std::optional<double> desiredDzmpY_m() const;
};

/// The arm that carries the sensor.
struct ArmGuard {
    LwrKinematics kinematics; ///< its tool is the sensor
    InverseSettings inverse;
};

/// Tactile servo controller: features of one frame -> where the sensor shall be.
///   ds = s_d - J^-1 s,  ds_task = P ds,  u = K_P ds_task + K_I int ds_task dt        (7)-(10), (13)
/// (the integral: of what K_P alone does not explain, PiRegulator).
///   twist_Base = Ad(X_Base_Sensor) u,   X_Base_Sensor <- exp(twist_Base dt) X_Base_Sensor
/// The pose is measured once, in the first step; then the commanded pose is taken as current (12), (15). A
/// feature that is not defined has no error. Turns leave the contact's centre where it is. Limits act after
/// the law, in the order force, saturation, speed, joints, deviation; each that acted is reported, and takes
/// its part back from the integrals. Usable at any rate: a step longer than the task's longestStep_s counts
/// as that. Without contact for lostAfter_s a task that needs it searches (ContactSearch) and in the end
/// stands still and says "lost"; contact at any moment goes on with the plan. STOP commands the pose that was
/// measured when it came: the arm's springs let go of what it presses. Thread: one; step() allocates nothing.
class ServoController {
public:
    /// plan: must be good for check(). arm: for joint limits and singularities.
    [[nodiscard]] static tl::expected<ServoController, TaskRefusal>
    create(ServoPlan plan, const std::optional<ArmGuard>& arm = {});

    ServoOutput step(const ServoInput& input);

    /// A changed task of the plan, used from the next step on; what is not good changes nothing.
    tl::expected<void, TaskRefusal> setTask(std::size_t index, const ServoTask& task);
    /// Begins a task of the plan now; a search ends. Error: badReference.
    tl::expected<void, TaskRefusal> enter(std::size_t index);
    [[nodiscard]] const ServoPlan& plan() const { return m_plan; }
    [[nodiscard]] std::size_t phase() const { return m_phases.index(); }

    /// Forgets the pose, the contact and the integrals and begins the plan anew.
    void reset();

private:
    ServoController(ServoPlan plan, const std::optional<ArmGuard>& arm)
        : m_plan(std::move(plan))
        , m_arm(arm)
        , m_phases(m_plan) {}

    struct Wanted {
        Twist twist = Twist::Zero();
        Twist cut = Twist::Zero(); ///< of the turn, by its limit
        bool regulated = false;    ///< by the law; false: by the search
    };

    void updateContact(const ServoInput& input, double dt_s, ServoOutput& output);
    /// Features, matrices and errors of a task; returns which rows of the error are known.
    std::array<bool, 6> observe(const ServoInput& input, const ServoTask& task, ServoOutput& output);
    [[nodiscard]] Wanted law(const ServoInput& input, const ServoTask& task, const std::array<bool, 6>& known,
                             double dt_s, ServoOutput& output);
    [[nodiscard]] Twist limited(const Twist& wanted, const ServoInput& input, const ServoTask& task,
                                bool regulated, ServoOutput& output) const;
    [[nodiscard]] Twist withinDeviation(const Twist& twist, const ServoInput& input, const ServoTask& task,
                                        double dt_s, ServoOutput& output) const;

    ServoPlan m_plan;
    std::optional<ArmGuard> m_arm;
    ServoPhases m_phases;
    PiRegulator m_regulator;
    std::optional<Vector6> m_desired; ///< of the components, in the last step of the law
    EdgeDirection m_direction;
    ContactSearch m_search;
    bool m_started = false;
    bool m_held = false; ///< in the last step
    bool m_phaseBegan = true;
    double m_untouched_s = 0.0;
    double m_path_m = 0.0; ///< of the last step
    Eigen::Isometry3d m_X_Base_Sensor = Eigen::Isometry3d::Identity();
    Eigen::Vector3d m_velocity_Base_mPerS = Eigen::Vector3d::Zero();
};

} // namespace teleta::servo
