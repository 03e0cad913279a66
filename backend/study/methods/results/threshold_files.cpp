// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/results/threshold_files.h"

#include "backend/core/data/csv_writer.h"
#include "backend/core/data/private_files.h"
#include "backend/core/number_text.h"

#include <optional>
#include <string_view>

namespace teleta::study {

namespace {

constexpr std::string_view kThresholdHeader =
    "participant_id,task,condition,track,design,function,n,threshold,lo,hi,interval,unit,spread,guess,lapse,"
    "deviance,p_deviance,jnd,weber,pse,stair_estimate,stair_reversals,bayes_mean,bayes_sd,note";
constexpr std::string_view kDetectionHeader =
    "participant_id,task,condition,track,hits,n_signal,false_alarms,n_noise,dprime,lo,hi,c,method";
constexpr std::string_view kLevelHeader =
    "participant_id,task,condition,track,design,function,scale,guess,lapse_lo,lapse_hi,level,level_unit,"
    "reference,n,n_positive";
constexpr std::optional<double> kNoNumber;

std::string_view orMissing(std::string_view text) {
    return text.empty() ? "NA" : text;
}

std::string_view designWord(const LevelTaskFacts& facts) {
    return facts.design ? toString(*facts.design) : "NA";
}

void writeLine(const ThresholdLine& line, core::CsvWriter& csv) {
    const PsychometricFit& fit = line.fit;
    csv.row(line.participant, line.task, line.condition, line.track, designWord(line.facts),
            line.guessIsKnown ? toString(line.model.shape) : "NA", fit.trials, fit.threshold,
            fit.thresholdInterval.low, fit.thresholdInterval.high, toString(line.interval),
            orMissing(line.facts.unit), fit.spread, line.guessIsKnown ? fit.guess : kNoNumber, fit.lapse,
            fit.deviance, fit.goodness ? std::optional(fit.goodness->pDeviance) : kNoNumber,
            line.justNoticeable(), line.weber(), line.equality(), line.procedure.staircase,
            line.procedure.reversals, line.procedure.bayesMean, line.procedure.bayesSd,
            orMissing(line.note()));
}

void writeGroup(const ThresholdGroup& group, core::CsvWriter& csv) {
    csv.row("GROUP", group.task, group.condition, group.track, designWord(group.facts),
            toString(group.function), group.participants, group.threshold,
            group.interval ? std::optional(group.interval->low) : kNoNumber,
            group.interval ? std::optional(group.interval->high) : kNoNumber, "t",
            orMissing(group.facts.unit), kNoNumber, kNoNumber, kNoNumber, kNoNumber, kNoNumber,
            group.justNoticeable, group.weber, group.isComparison() ? group.threshold : kNoNumber, kNoNumber,
            kNoNumber, kNoNumber, kNoNumber, orMissing(group.note()));
}

/// The fit of all participants at once, below the mean of their thresholds.
void writeHierarchical(const ThresholdGroup& group, core::CsvWriter& csv) {
    if (!group.hierarchical)
        return;
    const HierarchicalThreshold& fit = *group.hierarchical;
    csv.row("GROUP", group.task, group.condition, group.track, designWord(group.facts),
            toString(RiseShape::gauss), fit.participants, fit.threshold, fit.interval.low, fit.interval.high,
            toString(FitInterval::profile), orMissing(group.facts.unit), kNoNumber, fit.guess, fit.lapse,
            kNoNumber, kNoNumber, kNoNumber, kNoNumber,
            group.isComparison() ? std::optional(fit.threshold) : kNoNumber, kNoNumber, kNoNumber, kNoNumber,
            kNoNumber,
            "hierarchical; sd of participants " + std::string(core::NumberText(fit.participantSd).view()));
}

core::Expected<void> writeThresholdTable(const ThresholdResults& results, const std::string& path) {
    TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(path, kThresholdHeader));
    for (const ThresholdLine& line : results.lines)
        writeLine(line, csv);
    for (const ThresholdGroup& group : results.groups) {
        writeGroup(group, csv);
        writeHierarchical(group, csv);
    }
    return csv.finish();
}

core::Expected<void> writeLevelTable(const ThresholdResults& results, const std::string& path) {
    TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(path, kLevelHeader));
    for (const ThresholdLine& line : results.lines) {
        if (!line.guessIsKnown)
            continue;
        for (const LevelCount& count : line.counts) {
            csv.row(line.participant, line.task, line.condition, line.track, designWord(line.facts),
                    toString(line.model.shape), toString(line.model.scale), line.model.guess,
                    line.model.lapseLow, line.model.lapseHigh, count.level, orMissing(line.facts.unit),
                    line.reference, count.trials, count.correct);
        }
    }
    return csv.finish();
}

core::Expected<void> writeDetectionTable(const DetectionResults& results, const std::string& path) {
    TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(path, kDetectionHeader));
    const auto low = [](const std::optional<Interval>& interval) {
        return interval ? std::optional(interval->low) : kNoNumber;
    };
    const auto high = [](const std::optional<Interval>& interval) {
        return interval ? std::optional(interval->high) : kNoNumber;
    };
    for (const DetectionLine& line : results.lines) {
        const std::optional<Detection>& detection = line.detection;
        const bool isWorse = detection && detection->worseThanNothing;
        csv.row(line.participant, line.task, line.condition, line.track, line.hits, line.signalTrials,
                line.falseAlarms, line.noiseTrials,
                detection ? std::optional(detection->sensitivity) : kNoNumber,
                low(detection ? detection->interval : std::nullopt),
                high(detection ? detection->interval : std::nullopt),
                detection ? detection->criterion : kNoNumber,
                isWorse ? line.method + ", no more hits than false alarms" : line.method);
    }
    for (const DetectionGroup& group : results.groups) {
        csv.row("GROUP", group.task, group.condition, group.track, kNoNumber, kNoNumber, kNoNumber, kNoNumber,
                group.sensitivity, low(group.interval), high(group.interval), kNoNumber, "t");
    }
    return csv.finish();
}

} // namespace

core::Expected<void> writeThresholds(const ThresholdResults& thresholds, const DetectionResults& detection,
                                     const std::string& folder) {
    if (thresholds.empty())
        return {};
    const core::PrivateFiles forOwner;
    TELETA_CHECK(writeThresholdTable(thresholds, folder + "/thresholds.csv"));
    TELETA_CHECK(writeLevelTable(thresholds, folder + "/levels.csv"));
    if (detection.empty())
        return {};
    return writeDetectionTable(detection, folder + "/sdt.csv");
}

} // namespace teleta::study
