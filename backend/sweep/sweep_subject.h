// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/core/error.h"
#include "backend/cost/ladder.h"
#include "backend/scene_run/base/labelled_frame.h"
#include "backend/sweep/sweep_plan.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace teleta::sweep {

/// Measures of a run in the order of its summary; NaN: it could not be determined.
using RunMeasures = std::vector<std::pair<std::string, double>>;

/// Runs the cells of a sweep, one run a call. Thread: one.
class SweepWorker {
public:
    virtual ~SweepWorker() = default;
    /// onFrame: called with each tactile frame, if there is one. Error: why the run failed.
    [[nodiscard]] virtual core::Expected<RunMeasures>
    run(const SweepPlan& plan, std::uint64_t cell, std::uint64_t seed,
        const std::function<void(const scene_run::LabelledFrame&)>& onFrame) = 0;
    /// The tactile array of a cell; empty when it has none or the run will fail.
    [[nodiscard]] virtual std::optional<core::ArrayLayout> layoutOf(const SweepPlan&, std::uint64_t) {
        return {};
    }
};

/// What a sweep runs, checked for each of its cells. Thread: any.
class SweepSubject {
public:
    virtual ~SweepSubject() = default;
    [[nodiscard]] virtual std::unique_ptr<SweepWorker> makeWorker() const = 0;
    /// Texts of the files that it was read from: what a result depends on besides the sweep file.
    [[nodiscard]] virtual std::string source() const = 0;
    /// Its runs have tactile frames.
    [[nodiscard]] virtual bool hasFrames() const { return false; }
};

/// Where subjects come from.
struct SubjectSources {
    /// The text of a scene by file or name, and the name for errors.
    std::function<core::Expected<std::string>(const std::string& fileOrName)> sceneText;
    std::vector<cost::Ladder> ladders;
    bool checked = false; ///< every cell was tried before, as for the tasks of an array
};

/// Reads what the plan runs and tries the settings of every cell. A path is relative to the folder of the
/// sweep file. A ladder without axes gets one, "rung". Error: notFound, ioFailed, badInput with the place of
/// the key in the sweep file.
[[nodiscard]] core::Expected<std::unique_ptr<SweepSubject>> makeSubject(SweepPlan& plan,
                                                                        const SubjectSources& sources);

} // namespace teleta::sweep
