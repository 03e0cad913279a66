// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/servo_task.h"

#include <cstddef>

namespace teleta::servo {

/// Which task of a plan runs, decided by what was measured.
/// An exit condition must hold for its time; a contact that has been a point for pointFor_s sends the tasks
/// that say so back. Times are sums of steps as long as the controller counts them. Thread: one; nothing
/// allocates. Source: phases I-IV of section 5.2.
class ServoPhases {
public:
    explicit ServoPhases(const ServoPlan& plan)
        : m_index(plan.start) {}

    /// Looks at the next frame. alphaError_rad: desired minus followed direction, 0 when there is none.
    /// path_m: way of the sensor in this step. True when another task begins.
    bool update(const ServoPlan& plan, const contact::TactileFeatures& features, double alphaError_rad,
                double path_m, double dt_s);

    /// The contact was found again by a search. True when another task begins.
    bool foundAgain(const ServoPlan& plan);

    /// Begins a task now. index: one of the plan's.
    void enter(std::size_t index);

    [[nodiscard]] std::size_t index() const { return m_index; }
    [[nodiscard]] double timeInTask_s() const { return m_time_s; }
    /// The current task's exit has been reached, and there is no further one.
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
