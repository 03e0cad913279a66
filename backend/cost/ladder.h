// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/cost/trial.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace teleta::cost {

/// One way to do a job.
struct Rung {
    std::string name;      ///< unique in its ladder, as in files
    std::string parameter; ///< what sets it apart: "scale 1/2", "100 samples"
    /// Makes one trial. All but its time depends on the trial's index only, however often it runs.
    std::function<void(Trial&)> run;
};

/// What a job is about.
enum class Topic { camera, tactileArray, touchedObject, simulation, study };

/// Ways to do the same job, from cheap to exact. Truth is computed independently of what is measured.
struct Ladder {
    std::string name;             ///< as in files and on the command line: "contact-flow"
    std::string title;            ///< for people, translated
    std::optional<Topic> topic{}; ///< among which it is listed; empty: by itself
    std::string truth;            ///< what an error is the distance from, translated
    std::string errorUnit;        ///< SI; "1" for a share
    std::size_t trials = 30;      ///< timed for each rung; >= kFewestTrials
    /// Makes what the rungs have in common, which may take seconds, and the rungs.
    std::function<core::Expected<std::vector<Rung>>()> makeRungs;
};

inline constexpr std::size_t kFewestTrials = 30;

} // namespace teleta::cost
