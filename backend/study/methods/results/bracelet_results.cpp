// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/results/bracelet_results.h"

#include "backend/study/methods/bracelet/intensity_steps.h"

#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace teleta::study {

namespace {

/// Just noticeable difference by reference, of each task, track and participant.
using Differences =
    std::map<std::tuple<std::string, std::string, std::string>, std::map<double, std::optional<double>>>;

std::vector<StepsLine> stepsOf(const Differences& differences) {
    std::vector<StepsLine> lines;
    for (const auto& [key, byReference] : differences) {
        if (byReference.size() < 2)
            continue;
        std::vector<JndAt> known;
        for (const auto& [reference, difference] : byReference) {
            if (difference)
                known.push_back({reference, *difference});
        }
        const auto& [task, track, participant] = key;
        StepsLine line{participant, task, track, known.size(), byReference.size(), {}};
        // The others say nothing of the region of one that is missing. The first level is where the motor
        // starts, and no step.
        if (known.size() == byReference.size()) {
            if (const auto levels = intensitySteps(known, 0.0, 1.0))
                line.steps = levels->size() - 1;
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

} // namespace

std::vector<StepsLine> intensityStepsOf(const ThresholdResults& results) {
    Differences people;
    for (const ThresholdLine& line : results.lines) {
        if (line.isComparison() && line.facts.unit == unitOf(Vary::intensity))
            people[{line.task, line.track, line.participant}][line.reference] = line.justNoticeable();
    }
    return stepsOf(people);
}

std::vector<StepsLine> meanIntensityStepsOf(const ThresholdResults& results) {
    Differences all;
    for (const ThresholdGroup& group : results.groups) {
        if (group.isComparison() && group.facts.unit == unitOf(Vary::intensity))
            all[{group.task, group.track, {}}][group.reference] = group.justNoticeable;
    }
    return stepsOf(all);
}

std::vector<OnsetLine> bestOnsetsOf(const ThresholdResults& results) {
    std::vector<OnsetLine> lines;
    for (const ThresholdLine& line : results.lines) {
        if (line.facts.design != Design::yesNo || line.facts.unit != unitOf(Vary::onset) ||
            line.facts.procedure != "constant")
            continue;
        std::vector<OnsetCount> counts;
        for (const LevelCount& count : line.counts)
            counts.push_back(
                {count.level, static_cast<double>(count.trials), static_cast<double>(count.correct)});
        lines.push_back({line.participant, line.task, line.condition, line.track, bestOnset(counts)});
    }
    return lines;
}

} // namespace teleta::study
