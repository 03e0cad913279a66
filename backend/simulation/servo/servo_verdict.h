// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"
#include "backend/servo/active_limits.h"
#include "backend/servo/task_verdict.h"
#include "backend/simulation/servo/alignment_watch.h"

#include <Eigen/Core>

#include <deque>
#include <optional>

namespace teleta::simulation {

class ServoLoop;

/// Watches a servo run and says, at its end or before, whether the arm does its task. Completed: the array
/// touches the object, the lasting task (explore, comanipulation, roll, point following) has begun and was
/// not interrupted by an earlier phase, a point or roll has been aligned, and an exploring array slides.
/// Otherwise the first reason that applies:
///   stalled            in more than half of the servo cycles of the last 2 s a limit acted, and the array
///                      moved less than a tenth of the way that the task wants: before the first contact, or
///                      where the lasting task was not reached; while exploring, also without a limit
///   never_in_contact   the object was never touched, whatever the array read
///   lost               the search for a lost contact has ended, or nothing has been touched for 0.5 s
///   not_aligned        the lasting task was not reached, or an earlier phase came back
/// Thread: one.
class ServoVerdict {
public:
    explicit ServoVerdict(const scene::Scene& scene);

    /// How fast an exploring array is to slide, where it is not as the scene says; 0: not at all.
    void setSlidingSpeed(double slide_mPerS) { m_task.slide_mPerS = slide_mPerS; }

    /// After every cycle of the loop in which the arm is not held.
    void add(const ServoLoop& loop);

    [[nodiscard]] servo::TaskVerdict verdict() const;

private:
    struct Cycle {
        double time_s;
        Eigen::Vector3d p_Base_Sensor_m;
        servo::ActiveLimits limits;
    };

    /// Path of the array in the last cycles, in m.
    [[nodiscard]] double way_m() const;
    /// The limit that acted in most of the last cycles, if that was in more than half of them.
    [[nodiscard]] std::optional<servo::Limit> limit() const;
    [[nodiscard]] bool tooSlow(double speed_mPerS) const;

    scene::ServoTaskSettings m_task;
    AlignmentWatch m_alignment;
    servo::TaskKind m_lasting;
    servo::TaskKind m_kind = servo::TaskKind::freeMotion;
    std::optional<servo::TaskKind> m_phase;
    double m_phaseBegan_s = 0.0;
    double m_now_s = 0.0;
    double m_touched_s = -1.0; ///< last time; below 0: never
    bool m_searchEnded = false;
    std::deque<Cycle> m_last;
};

} // namespace teleta::simulation
