// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/study_results.h"
#include "backend/study/analysis/trials/trial_source.h"
#include "backend/study/methods/results/detection_results.h"
#include "backend/study/methods/results/level_trial_source.h"
#include "backend/study/methods/results/threshold_results.h"
#include "backend/study/protocol/protocol.h"
#include "backend/study/session/study_scene.h"
#include "backend/study/store/trial_journal.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/fuzz/memory_file.h"
#include "tests/support/floating_point_traps.h"

#include <cmath>

namespace teleta::fuzz {

using namespace study;

bool trialCsv(Bytes bytes) {
    const MemoryFile file(bytes);
    ModeFilter modes;
    TrialTally tally;
    const core::Expected<void> counted =
        tallyCsv(file.path(), modes, tally, [](std::uint64_t) { return true; });
    if (!counted) {
        requireExplained(counted.error(), file.path());
        return false;
    }
    constexpr std::size_t kMostNames = 12; // of patterns; the results are matrices of them
    if (tally.names().size() > kMostNames)
        return true;
    const test::FloatingPointTraps traps;
    for (const TaskResults& task : studyResults(tally)) {
        for (const ParticipantSummary& summary : task.participants)
            require(!summary.medianTime_s || std::isfinite(*summary.medianTime_s), "a median is a time");
        for (const GroupSummary& group : task.groups)
            require(!group.accuracy || (group.accuracy->mean >= 0.0 && group.accuracy->mean <= 1.0),
                    "an accuracy is 0..1");
    }
    return true;
}

bool levelCsv(Bytes bytes) {
    const MemoryFile file(bytes);
    ModeFilter modes;
    LevelTrials trials;
    const core::Expected<void> added =
        addLevelTrials(file.path(), modes, trials, [](std::uint64_t) { return true; });
    if (!added) {
        requireExplained(added.error(), file.path());
        return false;
    }
    if (trials.tracks().empty())
        return false;                      // a table without levels
    constexpr std::size_t kMostTracks = 4; // the rest are fitted like these
    if (trials.tracks().size() > kMostTracks)
        return true;
    FitChoices choices;
    choices.resamples = 5;
    for (const ThresholdLine& line : thresholdResults(trials, choices).lines) {
        const PsychometricFit& fit = line.fit;
        require(!fit.threshold || std::isfinite(*fit.threshold), "a threshold is a number");
        require(!fit.deviance || *fit.deviance >= 0.0, "a deviance is not negative");
        require(!fit.lapse || (*fit.lapse >= 0.0 && *fit.lapse <= 0.06), "a lapse rate is in its range");
    }
    for (const DetectionLine& line : detectionResults(trials).lines)
        require(!line.detection || std::isfinite(line.detection->sensitivity), "a d' is a number");
    return true;
}

bool studyProtocol(Bytes bytes) {
    const core::Expected<Protocol> protocol = parseProtocol(textOf(bytes), kInput);
    if (!protocol) {
        requireExplained(protocol.error());
        return false;
    }
    const std::string text = protocolText(*protocol);
    const core::Expected<Protocol> again = parseProtocol(text, kInput);
    require(again.has_value(), again ? "" : describe(again.error()));
    require(protocolText(*again) == text, "a protocol comes back as it was written");
    constexpr std::size_t kMostTrials = 10'000;
    if (protocol->testTrials() > kMostTrials || protocol->practice.repetitions > 100)
        return true;
    for (const PlannedSession& session : planSessions(*protocol, 1, 3)) {
        const StudyTask& task = protocol->tasks.at(session.task);
        require(session.condition < task.conditions.size(), "a planned condition is one of the task's");
        for (const std::size_t stimulus : session.test)
            require(stimulus < task.patterns.size(), "a planned pattern is one of the task's");
    }
    return true;
}

bool studyScene(Bytes bytes) {
    const std::string text = textOf(bytes);
    const core::Expected<StudyScene> scene = parseStudyScene(text, kInput);
    if (!scene) {
        // It may name a protocol; the error is then in that file.
        require(!scene.error().message.empty(), "an error has a message");
        require(!scene.error().where.file.empty(), "an error names a file");
        return false;
    }
    require(isStudyScene(text), "what is read as a scene of a study is one");
    return true;
}

bool trialJournal(Bytes bytes) {
    static const test::TemporaryFolder folder;
    const TrialJournal journal(folder.path(""), 7);
    folder.write("pending-7.jsonl", textOf(bytes));
    const core::Expected<std::vector<PendingTrial>> trials = journal.read();
    if (!trials) {
        requireExplained(trials.error(), journal.path());
        return false;
    }
    return !trials->empty();
}

} // namespace teleta::fuzz
