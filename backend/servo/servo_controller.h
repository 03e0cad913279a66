// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/tactile_features.h"
#include "backend/core/device/joint_vector.h"
#include "backend/servo/active_limits.h"
#include "backend/servo/arm/servo_arm.h"
#include "backend/servo/contact_search.h"
#include "backend/servo/pi_regulator.h"
#include "backend/servo/servo_phases.h"
#include "backend/servo/servo_task.h"

#include <tl/expected.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

namespace teleta::servo {

struct ServoInput {
    contact::TactileFeatures features;
    double dt_s = 0.0;                                               ///< time since the previous frame; > 0
    Eigen::Isometry3d X_Base_Sensor = Eigen::Isometry3d::Identity(); ///< measured
    /// Measured joint angles, as many as the arm has joints; without them the joint limits are not checked.
    std::optional<core::JointVector> q_rad;
    bool hold = false; ///< STOP: the measured pose becomes the command and is held
    /// The twist drives the arm, not the pose: but for a search, the measured pose counts as the current one.
    bool bySpeed = false;
};

struct ServoOutput {
    Eigen::Isometry3d X_Base_Sensor = Eigen::Isometry3d::Identity(); ///< desired
    Twist twist_Sensor = Twist::Zero();                              ///< commanded, in {s}
    Twist twist_Base = Twist::Zero();                                ///< the same in the base, eq. (13)
    std::size_t phase = 0;                                           ///< index of the plan's task
    TaskKind kind = TaskKind::freeMotion;
    bool phaseBegan = false; ///< this is the first step of the task
    bool finished = false;   ///< the exit condition of the last task has been reached
    ContactState contact = ContactState::none;
    bool edge = false;                             ///< beta = 1 in the inverse Jacobian
    ActiveLimits limits;                           ///< that acted in this step
    FeatureVector desired = FeatureVector::Zero(); ///< s_d
    FeatureVector actual = FeatureVector::Zero();  ///< J^-1 s; 0 where unknown
    std::array<bool, 6> known{};                   ///< which rows of it are defined and in use
    Vector6 error = Vector6::Zero();               ///< P (s_d - J^-1 s)
    Vector6 integral = Vector6::Zero();            ///< share of the integral in the twist
    Matrix6 inverseJacobian = Matrix6::Identity();
    Matrix6 projection = Matrix6::Zero();

    /// Desired place of the contact along x, as drawn in the paper (Fig. 10c): the pseudo-measurement of
    /// CoP_x that makes the sensor slide, or CoC_x of a point that becomes an edge. Empty when the task does
    /// not control it.
    [[nodiscard]] std::optional<double> desiredCocX_m() const;
    /// Empty when the task does not control the moment.
    [[nodiscard]] std::optional<double> desiredDzmpY_m() const;
};

/// Tactile servo controller: computes the desired pose of the sensor from the features of one frame.
///   ds = s_d - J^-1 s,  ds_task = P ds,  u = K_P ds_task + K_I int ds_task dt        (7)-(10), (13)
/// (the integral is that of PiRegulator).
///   twist_Base = Ad(X_Base_Sensor) u,   X_Base_Sensor <- exp(twist_Base dt) X_Base_Sensor
/// The pose is measured once, in the first step; from then on the commanded pose is taken as the current one
/// (12), (15); not so for an arm that the twist drives (ServoInput::bySpeed), which adds up what it did
/// itself. An undefined feature has no error. Turns keep the centre of contact in place. Limits act after the
/// control law in the order force, saturation, speed, joints, deviation; each one that acts is reported and
/// removes its share from the integrals. Works at any rate: a step longer than the task's longestStep_s
/// counts as longestStep_s. When a task that needs contact has had none for lostAfter_s, it searches
/// (ContactSearch) and finally stands still in the state "lost"; as soon as there is contact again the plan
/// continues. STOP commands the pose measured at that moment, so that the springs of the arm no longer press.
/// Thread: one; step() allocates nothing.
class ServoController {
public:
    /// plan: must pass check(). arm: needed for joint limits and singularities only.
    [[nodiscard]] static tl::expected<ServoController, TaskRefusal>
    create(ServoPlan plan, std::shared_ptr<const ServoArm> arm = nullptr);

    ServoOutput step(const ServoInput& input);

    /// Replaces a task of the plan from the next step on. After an error nothing is changed.
    tl::expected<void, TaskRefusal> setTask(std::size_t index, const ServoTask& task);
    /// Starts a task of the plan now and ends a search. Error: badReference.
    tl::expected<void, TaskRefusal> enter(std::size_t index);
    [[nodiscard]] const ServoPlan& plan() const { return m_plan; }
    [[nodiscard]] std::size_t phase() const { return m_phases.index(); }

    /// Forgets the pose, the contact and the integrals, and restarts the plan.
    void reset();

private:
    ServoController(ServoPlan plan, std::shared_ptr<const ServoArm> arm)
        : m_plan(std::move(plan))
        , m_arm(std::move(arm))
        , m_phases(m_plan) {}

    struct Wanted {
        Twist twist = Twist::Zero();
        Twist cut = Twist::Zero(); ///< what the turn limit removed
        bool regulated = false;    ///< true: computed by the control law, false: by the search
    };

    void updateContact(const ServoInput& input, double dt_s, ServoOutput& output);
    /// Computes features, matrices and errors of a task.
    void observe(const ServoInput& input, const ServoTask& task, ServoOutput& output);
    [[nodiscard]] Wanted law(const ServoInput& input, const ServoTask& task, double dt_s,
                             ServoOutput& output);
    [[nodiscard]] Twist limited(const Twist& wanted, const ServoInput& input, const ServoTask& task,
                                bool regulated, ServoOutput& output) const;
    [[nodiscard]] Twist withinDeviation(const Twist& twist, const ServoInput& input, const ServoTask& task,
                                        double dt_s, ServoOutput& output) const;

    ServoPlan m_plan;
    std::shared_ptr<const ServoArm> m_arm;
    ServoPhases m_phases;
    PiRegulator m_regulator;
    std::optional<Vector6> m_desired; ///< desired components in the last step of the control law
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
