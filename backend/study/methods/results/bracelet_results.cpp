// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/results/bracelet_results.h"

#include "backend/study/methods/bracelet/intensity_steps.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace teleta::study {

std::vector<StepsLine> intensityStepsOf(const ThresholdResults& results) {
    struct Levels {
        std::size_t references = 0;
        std::vector<JndAt> known;
    };
    std::map<std::tuple<std::string, std::string, std::string>, Levels> people;
    for (const ThresholdLine& line : results.lines) {
        if (!line.isComparison() || line.facts.unit != unitOf(Vary::intensity))
            continue;
        Levels& own = people[{line.task, line.track, line.participant}];
        ++own.references;
        if (const std::optional<double> jnd = line.justNoticeable())
            own.known.push_back({line.reference, *jnd});
    }
    std::vector<StepsLine> lines;
    for (auto& [key, own] : people) {
        if (own.references < 2)
            continue;
        std::ranges::sort(own.known, {}, &JndAt::level);
        StepsLine line{std::get<2>(key), std::get<0>(key), std::get<1>(key), own.known.size(), {}};
        // The first level is where the motor starts, and no step.
        if (const auto levels = intensitySteps(own.known, 0.0, 1.0))
            line.steps = levels->size() - 1;
        lines.push_back(std::move(line));
    }
    return lines;
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
