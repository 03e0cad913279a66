// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/bounded_queue.h"
#include "backend/core/threads/latest_exchange.h"
#include "backend/core/threads/mailbox.h"
#include "backend/servo/arm/lwr_kinematics.h"
#include "backend/servo/cycle_times.h"
#include "backend/servo/servo_controller.h"
#include "backend/servo/servo_step.h"
#include "backend/servo/servo_tuning.h"
#include "backend/servo/task_verdict.h"
#include "backend/servo/touched_body.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace teleta::servo {

/// What a running servo publishes about its newest step.
struct ServoReport {
    static constexpr std::size_t kLongestPlan = 8;

    double time_s = 0.0; ///< time of the source
    ServoOutput output;
    ActiveLimits recentLimits; ///< limits that acted within the last second, so that one that acts in a
                               ///< single step is seen
    Eigen::Isometry3d X_Base_Sensor = Eigen::Isometry3d::Identity(); ///< measured
    Eigen::Isometry3d X_Base_Object = Eigen::Isometry3d::Identity(); ///< of ServoLink::body
    /// Of the joints, measured; NaN: not told.
    LwrVector angle_rad = LwrVector::Constant(std::numeric_limits<double>::quiet_NaN());
    /// Positions of the joints from the base to the flange, and of the sensor; m, for drawing.
    std::array<Eigen::Vector3d, kLwrJoints> p_Base_Joint{};
    double normalCompliance_mPerN = 1.0;       ///< of the running task; force is d_z divided by it
    ServoTuning tuning;                        ///< in use
    ServoTuning planned;                       ///< of the plan itself, before anybody changed it
    TuningBounds bounds;                       ///< limits of what an operator can set
    bool stopped = false;                      ///< STOP is engaged
    std::array<TaskKind, kLongestPlan> plan{}; ///< the tasks
    std::size_t tasks = 0;                     ///< how many of them there are
    CycleTimes times;                          ///< of a simulated servo since its start; zero cycles: unknown
    double rate_Hz = 0.0;                      ///< of the control cycles
    std::uint64_t restarts = 0;                ///< number of restarts of the world, that is, of earlier runs
    std::optional<TaskVerdict> verdict;        ///< of this run, if it ended now; empty: unknown
};

/// Data exchange between the servo of a source and its operator. Thread: reports.back/publish, steps.push,
/// tuning.take and task.take by the source's worker, body by whoever makes the source; reports.update/front,
/// steps.pop, tuning.post and task.post by one operator (the GUI).
struct ServoLink {
    static constexpr std::size_t kSteps = 16384;

    core::LatestExchange<ServoReport> reports;
    /// Every servo step, room for 160 s at 100 Hz; overflow is counted.
    core::BoundedQueue<ServoStep> steps{kSteps};
    core::Mailbox<ServoTuning> tuning;
    core::Mailbox<std::size_t> task; ///< start this task of the plan now
    TouchedBody body;                ///< what the array touches, where a simulation knows it
};

} // namespace teleta::servo
