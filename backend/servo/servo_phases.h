// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/servo_task.h"

#include <cstddef>

namespace teleta::servo {

/// Decides from the measurements which task of a plan runs. An exit condition must hold for its hold_s. A
/// contact that has been a point for pointFor_s switches to the task's ifPoint, if it has one. Times are sums
/// of the steps as the controller counts them. Thread: one; allocates nothing. Source: phases I-IV of section
/// 5.2.
class ServoPhases {
public:
    explicit ServoPhases(const ServoPlan& plan)
        : m_index(plan.start) {}

    /// Takes the next frame. alphaError_rad: desired minus followed direction, 0 when there is none. path_m:
    /// distance that the sensor moved in this step. Returns true when another task begins.
    bool update(const ServoPlan& plan, const contact::TactileFeatures& features, double alphaError_rad,
                double path_m, double dt_s);

    /// To be called when a search has found the contact again. Returns true when another task begins.
    bool foundAgain(const ServoPlan& plan);

    /// Starts a task now. index: of a task of the plan.
    void enter(std::size_t index);

    [[nodiscard]] std::size_t index() const { return m_index; }
    [[nodiscard]] double timeInTask_s() const { return m_time_s; }
    /// The exit condition of the current task has been reached and there is no next task.
    [[nodiscard]] bool finished() const { return m_finished; }

private:
    std::size_t m_index;
    double m_time_s = 0.0;
    double m_path_m = 0.0;
    double m_held_s = 0.0;
    double m_point_s = 0.0;
    bool m_finished = false;
};

} // namespace teleta::servo
