// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/methods/adaptive/bayes_grid.h"
#include "backend/study/methods/results/level_trials.h"
#include "backend/study/planning/power.h"
#include "backend/study/planning/study_truth.h"
#include "backend/study/protocol/protocol.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace teleta::study {

/// The interval of a threshold that is wanted.
struct ThresholdWish {
    double halfWidth = 0.1; ///< of the group's 95 % interval at most, on the scale of the levels; > 0
    std::optional<std::size_t>
        trials; ///< of a track, of constant stimuli at each level; empty: the protocol's
};

/// A task with levels, of which one track in one condition is run, fitted and averaged over the participants
/// as thresholdResults() does. A study is "significant" if Student's t interval of the mean threshold is as
/// narrow as wished; it has no analysis with fewer than two thresholds.
class ThresholdPlan : public PossibleStudy {
public:
    /// test: TASK:threshold. Error: badInput where protocol and truth do not have what the test names, or the
    /// task tells patterns apart.
    [[nodiscard]] static core::Expected<ThresholdPlan> make(const Protocol& protocol, const StudyTruth& truth,
                                                            const std::string& test,
                                                            const ThresholdWish& wish);
    /// Whether a test is of this kind: it ends with ":threshold".
    [[nodiscard]] static bool isTest(const std::string& test);

    /// The threshold of one participant on the scale; NaN: the fit has none.
    [[nodiscard]] std::vector<double> participant(core::RandomStream& random) const override;
    [[nodiscard]] std::optional<double> p(std::span<const std::vector<double>> participants) const override;

private:
    [[nodiscard]] std::vector<LevelTrial> trialsOf(const PsychometricFunction& function,
                                                   core::RandomStream& random) const;

    Design m_design = Design::interval;
    double m_reference = 0.0;
    double m_catchShare = 0.0;
    LevelTaskFacts m_facts;
    std::shared_ptr<const BayesGrid> m_grid; ///< of bayes
    PsychometricFunction m_middle;           ///< of the middle participant
    double m_sd = 0.0;                       ///< of the thresholds, on the scale
    double m_halfWidth = 0.1;
};

/// 0 if the t interval of the mean of these values is at most that wide to each side, otherwise 1; values
/// that are NaN are left out, and with fewer than two others it is empty. Thread: any (pure).
[[nodiscard]] std::optional<double> narrowEnough(std::span<const double> values, double halfWidth);

} // namespace teleta::study
