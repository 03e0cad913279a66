// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/scene/scene.h"
#include "backend/study/session/study_scene.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace teleta::scene_run {

struct AblationOptions {
    std::uint64_t firstSeed = 1;
    std::uint64_t seeds = 8; ///< >= 2
    std::optional<double> duration_s;
    /// Called now and then with the number of finished runs; false ends it early.
    std::function<bool(double runs, double allRuns)> goOn;
};

/// What an effect does to a measure.
enum class Moves {
    no,
    yes,    ///< |change| is larger than spreadWith, or more than half of the seeds differ
    spread, ///< not that, but one spread is at least twice the other, and pSpread < 0.05
};

/// "no", "yes", "spread".
[[nodiscard]] const char* toString(Moves moves);

/// How a measure moves when an effect is left out. All over the same seeds, which give the same world but for
/// the effect.
struct MeasureChange {
    std::string measure;     ///< a list has one for each entry: "phases.align", "contact_error_m[2]"
    double mean = 0.0;       ///< of the scene as it is; NaN: not a number, or in no run
    double spreadWith = 0.0; ///< its standard deviation over the seeds; NaN: fewer than two have it
    double meanWithout = 0.0;
    double spreadWithout = 0.0;
    /// Mean difference, seed by seed, of the runs that have the number with and without the effect.
    double change = 0.0;
    double pMean = 0.0;          ///< pairedMeanTest() of the differences; NaN: fewer than two
    double pSpread = 0.0;        ///< pairedSpreadTest() of the same runs
    std::uint64_t differing = 0; ///< seeds of another text, or of a number that came or went
    Moves moves = Moves::no;
};

/// One effect left out.
struct EffectAblation {
    std::string effect;
    double own_s = 0.0; ///< mean time that the effect took by itself, of a run
    double run_s = 0.0; ///< median computing time of a run without it
    std::vector<MeasureChange> changes;

    /// Some measure moves, or its spread: the scene needs the effect.
    [[nodiscard]] bool moves() const;
};

struct Ablation {
    double run_s = 0.0; ///< median computing time of a run with all effects
    std::vector<EffectAblation> effects;
};

/// Runs a scene with all its effects and with each one left out, several seeds each.
/// Error: as runScene or runStudyScene; cancelled when goOn said so; badInput for less than two seeds.
/// Thread: any; keeps one core busy.
[[nodiscard]] core::Expected<Ablation> ablateEffects(const scene::Scene& scene,
                                                     const AblationOptions& options);
[[nodiscard]] core::Expected<Ablation> ablateEffects(const study::StudyScene& scene,
                                                     const AblationOptions& options);

} // namespace teleta::scene_run
