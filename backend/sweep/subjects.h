// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/sweep/sweep_subject.h"

namespace teleta::sweep {

/// A scene of a world or of simulated participants. Measures: the numbers of its summary, and "completed", 1
/// or 0, of one with a task. Error: as makeSubject().
[[nodiscard]] core::Expected<std::unique_ptr<SweepSubject>> makeSceneSubject(const SweepPlan& plan,
                                                                             const SubjectSources& sources);

/// A study that is drawn and tested once a run, as `teleta study plan` draws it: the seed of the run is the
/// number of the study, and the plan's seed is 1. Keys: "participants", and keys of the truth file and the
/// protocol behind "truth." and "protocol.". Measures: significant, refused, p. Error: as makeSubject().
[[nodiscard]] core::Expected<std::unique_ptr<SweepSubject>> makeStudySubject(const SweepPlan& plan,
                                                                             const SubjectSources& sources);

/// One trial of a rung a run, its index the seed. Key: "rung", all rungs when it is not varied. Measures:
/// error (mean over the trial), time_s, taken_away. Error: as makeSubject().
[[nodiscard]] core::Expected<std::unique_ptr<SweepSubject>> makeLadderSubject(SweepPlan& plan,
                                                                              const SubjectSources& sources);

/// An error of a cell's settings, at the place of the key of the sweep file that it most likely comes from:
/// one that its message names, otherwise the first.
[[nodiscard]] core::Error atKeyOf(const SweepPlan& plan, std::uint64_t cell, core::Error error);

/// Tries each value of each axis with the first values of the others, so that an error is found at its own
/// key, and then the other cells, up to so many. checked: that was done before, and nothing is tried. check:
/// of one cell.
[[nodiscard]] core::Expected<void>
checkCells(const SweepPlan& plan, bool checked,
           const std::function<core::Expected<void>(std::uint64_t cell)>& check);

/// A path of the sweep file, relative to its folder.
[[nodiscard]] std::string pathBeside(const SweepPlan& plan, const std::string& path);

} // namespace teleta::sweep
