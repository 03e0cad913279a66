// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/active_limits.h"
#include "backend/servo/servo_task.h"

#include <array>
#include <cstddef>
#include <optional>

namespace teleta::servo {

/// Why a servo has not done its task.
enum class NotCompleted {
    neverInContact, ///< the object was never touched
    lost,           ///< the contact was lost and not found again
    stalled,        ///< the arm stands still, held back by TaskVerdict::limit if that names one
    notAligned,     ///< the array did not come into the place that the task needs
};

/// Name in files: "never_in_contact", "lost", "stalled", "not_aligned".
[[nodiscard]] inline const char* toString(NotCompleted reason) {
    static constexpr std::array kNames{"never_in_contact", "lost", "stalled", "not_aligned"};
    return kNames[static_cast<std::size_t>(reason)];
}

/// Whether a servo has done its task, if its run ended now.
struct TaskVerdict {
    bool completed = true;
    TaskKind phase = TaskKind::freeMotion;              ///< the present task of the plan
    NotCompleted reason = NotCompleted::neverInContact; ///< unless completed
    std::optional<Limit> limit;                         ///< that acts most of the time
};

} // namespace teleta::servo
