// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/study/running/study_runner.h"

namespace teleta::test {

/// The session that a runner is in; the test ends where there is none.
inline const study::Session& sessionOf(const console::StudyRunner& runner) {
    const study::Session* active = runner.session();
    if (active == nullptr)
        qFatal("there is no session");
    return *active;
}

/// The trial at hand; the test ends where there is none.
inline const study::PlannedTrial& trialOf(const console::StudyRunner& runner) {
    const study::PlannedTrial* trial = sessionOf(runner).current();
    if (trial == nullptr)
        qFatal("there is no trial");
    return *trial;
}

} // namespace teleta::test
