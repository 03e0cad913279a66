// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/results/level_trials.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace teleta::study {

namespace {

bool isSameLevel(double level, double reference) {
    return std::abs(level - reference) <= 1e-9 * std::abs(reference);
}

} // namespace

std::optional<LevelTrial> levelTrialOf(Design design, double level, double reference, std::size_t right,
                                       std::optional<std::size_t> answer) {
    LevelTrial trial{{level, answer.value_or(0), answer == right, true}, right, answer};
    switch (design) {
    case Design::yesNo: // yes, no
        trial.kept.counts = right == 0;
        trial.kept.correct = answer == 0U;
        break;
    case Design::sameDifferent: // same, different
        trial.kept.counts = right == 1;
        trial.kept.correct = answer == 1U;
        break;
    case Design::compare:
        if (!answer)
            return std::nullopt;
        trial.scored = !isSameLevel(level, reference);
        // The right answer is the one that has more: the varied one, unless it is below the reference.
        trial.kept.correct = (answer == right) == (level >= reference || !trial.scored);
        break;
    case Design::interval:
    case Design::identification:
        break;
    }
    return trial;
}

LevelTrial levelTrialOf(std::optional<Design> design, double level, double reference, bool correct) {
    LevelTrial trial{{level, 0, correct, true}, std::nullopt, std::nullopt};
    if (design == Design::yesNo || design == Design::sameDifferent) {
        const bool nothing = isSameLevel(level, reference);
        trial.kept.counts = !nothing;
        trial.kept.correct = correct != nothing;
        const bool isYesNo = design == Design::yesNo;
        // The answers yes and different have the indices 0 and 1.
        const std::size_t there = isYesNo ? 0 : 1;
        trial.right = nothing ? 1 - there : there;
        trial.answer = trial.kept.correct ? there : 1 - there;
    } else if (design == Design::compare) {
        trial.scored = !isSameLevel(level, reference);
        trial.kept.correct = correct == (level >= reference || !trial.scored);
    }
    return trial;
}

std::vector<LevelTrial> LevelTrials::Track::left() const {
    std::vector<LevelTrial> counted;
    std::ranges::remove_copy_if(trials, std::back_inserter(counted), &LevelTrial::isExcluded);
    return counted;
}

std::optional<LevelTrials> LevelTrials::withoutRules() const {
    LevelTrials all = *this;
    bool isAny = false;
    for (auto& [key, track] : all.m_tracks) {
        for (LevelTrial& trial : track.trials)
            isAny = std::exchange(trial.isExcluded, false) || isAny;
    }
    return isAny ? std::optional(std::move(all)) : std::nullopt;
}

LevelTaskFacts& LevelTrials::factsOf(std::string_view task) {
    const auto found = m_facts.find(task);
    return found != m_facts.end() ? found->second : m_facts[std::string(task)];
}

LevelScale usualScale(const LevelTaskFacts& facts, double lowestLevel) {
    const bool isDrive = facts.unit.empty() || facts.unit == "drive";
    return isDrive && facts.design != Design::compare && lowestLevel > 0.0 ? LevelScale::log10
                                                                           : LevelScale::linear;
}

} // namespace teleta::study
