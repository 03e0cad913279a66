// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/keys/toml_value.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace teleta::sweep {

/// What a sweep runs.
enum class SubjectKind {
    scene,  ///< a scene of a world or of simulated participants
    study,  ///< a possible study of a protocol, drawn and tested once a run
    ladder, ///< one timed trial of a rung a run
};

/// One dimension of the grid: a key, or several that go together.
struct SweepAxis {
    struct Key {
        std::string name;        ///< dotted: "arm.control.bandwidth_rad_per_s"
        core::SourcePlace place; ///< of its values in the sweep file
    };
    std::vector<Key> keys;
    std::vector<std::vector<core::TomlValue>> values; ///< at [i][k] of keys[k]
    bool logarithmic = false;                         ///< equal steps of the logarithm

    /// Its values are numbers of one key.
    [[nodiscard]] bool isNumeric() const;
};

/// A value under each varied key.
using CellSettings = std::vector<std::pair<std::string, core::TomlValue>>;

/// A sweep as its file describes it: the grid is the product of its axes, a cell is one point of it, and each
/// cell runs once with each seed. Run i has the cell i / seeds() and the seed firstSeed + i % seeds(),
/// however many workers there are.
struct SweepPlan {
    SubjectKind kind = SubjectKind::scene;
    std::string subject;             ///< scene, protocol or ladder, as the file names it
    std::string truth;               ///< of a study: file with what is assumed
    std::string test;                ///< of a study: TASK:EFFECT
    std::uint64_t participants = 12; ///< of a study
    std::uint64_t firstSeed = 1;
    std::uint64_t lastSeed = 1;
    std::vector<std::string> measures; ///< empty: all numbers
    core::SourcePlace measuresPlace;
    std::vector<SweepAxis> axes; ///< the last one runs fastest
    std::string file;
    std::string text; ///< of the file

    [[nodiscard]] std::uint64_t seeds() const { return lastSeed - firstSeed + 1; }
    [[nodiscard]] std::uint64_t cells() const;
    [[nodiscard]] std::uint64_t runs() const { return cells() * seeds(); }
    [[nodiscard]] std::uint64_t cellOf(std::uint64_t run) const { return run / seeds(); }
    [[nodiscard]] std::uint64_t seedOf(std::uint64_t run) const { return firstSeed + run % seeds(); }
    /// Place of a cell on each axis.
    [[nodiscard]] std::vector<std::size_t> placeOf(std::uint64_t cell) const;
    /// cell: < cells().
    [[nodiscard]] CellSettings settingsOf(std::uint64_t cell) const;
    [[nodiscard]] std::vector<std::string> keys() const;
};

/// The most runs of a sweep.
inline constexpr std::uint64_t kMostRuns = 100'000'000;

/// Reads a sweep file (TOML):
///   [sweep]  scene | study, truth, test, participants | ladder; seeds = "1:200"; measures = ["a", "b"]
///   [sweep.vary]   key = [1, 2] or { from, to, steps, scale = "linear" | "log10" }
///   [sweep.pairs]  keys of the same number of values, which go together
/// Error: notFound, ioFailed, badInput with file, line, column and what was expected. Thread: any.
[[nodiscard]] core::Expected<SweepPlan> readSweepPlan(const std::string& path);
[[nodiscard]] core::Expected<SweepPlan> parseSweepPlan(std::string_view text, const std::string& file);

} // namespace teleta::sweep
