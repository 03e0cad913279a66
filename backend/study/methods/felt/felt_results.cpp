// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/felt/felt_results.h"

#include "backend/pattern/model/laws.h"
#include "backend/study/analysis/proportion.h"

#include <algorithm>
#include <map>
#include <utility>

namespace teleta::study {

namespace {

std::optional<FeltStrength> strengthOf(const FeltTask& felt, const pattern::MotorProfiles& motors,
                                       const std::string& track, std::optional<double> level,
                                       double reference, std::optional<double> difference) {
    const auto where = felt.tracks.find(track);
    if (where == felt.tracks.end() || !level)
        return std::nullopt;
    const auto at = [&](const std::vector<std::size_t>& tactors, double one) {
        return motorStrength(motors, tactors, one * felt.strongest);
    };
    const std::optional<MotorStrength> strength = at(where->second.tactors, *level);
    if (!strength)
        return std::nullopt;
    FeltStrength line;
    line.track = track;
    line.level = *level;
    line.strength = *strength;
    const std::optional<MotorStrength> standard = at(where->second.tactors, reference);
    const std::optional<MotorStrength> more =
        difference ? at(where->second.tactors, reference + *difference) : std::nullopt;
    if (standard && more && standard->speed_Hz > 0.0) {
        line.weberSpeed = more->speed_Hz / standard->speed_Hz - 1.0;
        line.weberForce = more->force / standard->force - 1.0;
    }
    return line;
}

FeltOnset meanOnset(const std::string& condition, const std::string& track,
                    const std::vector<double>& onsets_s, std::optional<double> law_s) {
    FeltOnset mean{{}, condition, track, {}, onsets_s.size(), law_s};
    const std::optional<GroupMean> all = groupMean(onsets_s);
    mean.best.doubt = all ? OnsetDoubt::none : OnsetDoubt::tooFewTimes;
    if (all) {
        mean.best.onset_s = all->mean;
        mean.best.low_s = all->interval ? all->interval->low : all->mean;
        mean.best.high_s = all->interval ? all->interval->high : all->mean;
    }
    return mean;
}

} // namespace

std::vector<FeltStrength> feltStrengths(const ThresholdResults& results, const FeltTask& felt,
                                        const pattern::MotorProfiles& motors) {
    std::vector<FeltStrength> lines;
    if (felt.vary != Vary::intensity)
        return lines;
    const auto add = [&](std::optional<FeltStrength> line, const std::string& participant,
                         const std::string& condition) {
        if (!line)
            return;
        line->participant = participant;
        line->condition = condition;
        lines.push_back(std::move(*line));
    };
    for (const ThresholdLine& line : results.lines) {
        if (line.task == felt.task)
            add(strengthOf(felt, motors, line.track, line.fit.threshold, line.reference,
                           line.justNoticeable()),
                line.participant, line.condition);
    }
    for (const ThresholdGroup& group : results.groups) {
        if (group.task == felt.task)
            add(strengthOf(felt, motors, group.track, group.threshold, group.reference, group.justNoticeable),
                {}, group.condition);
    }
    return lines;
}

std::vector<FeltOnset> feltOnsets(const ThresholdResults& results, const FeltTask& felt) {
    std::vector<FeltOnset> lines;
    if (felt.vary != Vary::onset || felt.design != Design::yesNo)
        return lines;
    const std::optional<double> law_s =
        felt.burst_s ? std::optional(pattern::apparentMotionOnset_s(*felt.burst_s)) : std::nullopt;
    std::map<std::pair<std::string, std::string>, std::vector<double>> found_s;
    for (const OnsetLine& line : bestOnsetsOf(results)) {
        if (line.task != felt.task)
            continue;
        lines.push_back({line.participant, line.condition, line.track, line.best, 1, law_s});
        std::vector<double>& of_s = found_s[{line.condition, line.track}];
        if (line.best.doubt == OnsetDoubt::none)
            of_s.push_back(line.best.onset_s);
    }
    for (const auto& [place, onsets_s] : found_s)
        lines.push_back(meanOnset(place.first, place.second, onsets_s, law_s));
    return lines;
}

std::vector<StepsLine> feltSteps(const ThresholdResults& results, const FeltTask& felt) {
    std::vector<StepsLine> lines;
    // Where the reference is felt elsewhere the study balances tactors, and does not count steps.
    const auto add = [&](std::vector<StepsLine> found) {
        for (StepsLine& line : found) {
            const auto where = felt.tracks.find(line.track);
            if (line.task == felt.task && where != felt.tracks.end() &&
                where->second.reference == where->second.tactors)
                lines.push_back(std::move(line));
        }
    };
    add(intensityStepsOf(results));
    add(meanIntensityStepsOf(results));
    return lines;
}

} // namespace teleta::study
