// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/results/detection_results.h"

#include <algorithm>
#include <set>

namespace teleta::study {

namespace {

/// Counts of "the first answer" by what was right.
DetectionCounts countsOf(const std::vector<LevelTrial>& trials, std::size_t signal) {
    DetectionCounts counts;
    for (const LevelTrial& trial : trials) {
        const bool isSignal = trial.right == signal;
        const bool said = trial.answer == signal;
        (isSignal ? counts.signalTrials : counts.noiseTrials) += 1;
        (isSignal ? counts.hits : counts.falseAlarms) += said ? 1 : 0;
    }
    return counts;
}

bool isOfOneLevel(const std::vector<LevelTrial>& trials) {
    std::set<double> levels;
    for (const LevelTrial& trial : trials) {
        if (trial.kept.counts)
            levels.insert(trial.kept.level);
    }
    return levels.size() <= 1;
}

void setCounts(DetectionLine& line, const DetectionCounts& counts) {
    line.hits = counts.hits;
    line.signalTrials = counts.signalTrials;
    line.falseAlarms = counts.falseAlarms;
    line.noiseTrials = counts.noiseTrials;
}

void detectIntervals(DetectionLine& line, const LevelTaskFacts& facts,
                     const std::vector<LevelTrial>& trials) {
    const std::size_t intervals = std::max<std::size_t>(facts.intervals, 2);
    line.method = std::to_string(intervals) + " intervals";
    const bool isKnown =
        std::ranges::all_of(trials, [](const LevelTrial& trial) { return trial.right.has_value(); });
    if (intervals == 2 && isKnown) {
        const DetectionCounts counts = countsOf(trials, 0);
        setCounts(line, counts);
        line.detection = twoIntervalDetection(counts);
        return;
    }
    line.signalTrials = static_cast<std::int64_t>(trials.size());
    line.hits = std::ranges::count_if(trials, [](const LevelTrial& trial) { return trial.kept.correct; });
    line.detection = intervalDetection(line.hits, line.signalTrials, static_cast<int>(intervals));
}

} // namespace

DetectionResults detectionResults(const LevelTrials& trials) {
    DetectionResults results;
    for (const auto& [key, track] : trials.tracks()) {
        const LevelTaskFacts& facts = trials.factsOf(key.task);
        if (!facts.design || *facts.design == Design::compare || *facts.design == Design::identification)
            continue;
        const std::vector<LevelTrial> left = track.left();
        if (left.empty())
            continue;
        DetectionLine line{key.participant, key.task, key.condition, key.track, 0, 0, {}, {}, {}, {}};
        if (*facts.design == Design::interval) {
            detectIntervals(line, facts, left);
        } else if (*facts.design == Design::yesNo) {
            const DetectionCounts counts = countsOf(left, 0);
            setCounts(line, counts);
            line.method = "yes/no";
            line.detection = yesNoDetection(counts);
        } else {
            const DetectionCounts counts = countsOf(left, 1);
            setCounts(line, counts);
            const SameDifferentRule rule =
                isOfOneLevel(left) ? SameDifferentRule::independent : SameDifferentRule::differencing;
            line.method = rule == SameDifferentRule::independent ? "independent" : "differencing";
            line.detection = sameDifferentDetection(counts, rule);
        }
        results.lines.push_back(std::move(line));
    }
    for (std::size_t i = 0; i < results.lines.size();) {
        const DetectionLine& first = results.lines[i];
        DetectionGroup group{first.task, first.condition, first.track, 0, {}, {}};
        std::vector<double> values;
        for (; i < results.lines.size() && results.lines[i].task == group.task &&
               results.lines[i].condition == group.condition && results.lines[i].track == group.track;
             ++i) {
            if (results.lines[i].detection)
                values.push_back(results.lines[i].detection->sensitivity);
        }
        group.participants = values.size();
        if (const std::optional<GroupMean> mean = groupMean(values)) {
            group.sensitivity = mean->mean;
            group.interval = mean->interval;
        }
        results.groups.push_back(std::move(group));
    }
    return results;
}

} // namespace teleta::study
