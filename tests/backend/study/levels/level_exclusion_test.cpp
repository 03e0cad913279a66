// SPDX-License-Identifier: GPL-3.0-or-later
// Rules of exclusion in a study with levels: what they leave out of a store says nothing in fits and d'.
#include "backend/study/methods/results/detection_results.h"
#include "backend/study/methods/results/level_trial_source.h"
#include "backend/study/methods/results/level_trial_store.h"
#include "backend/study/methods/results/threshold_results.h"
#include "backend/study/report/exports/study_export.h"
#include "backend/study/session/rehearsal.h"
#include "tests/backend/core/temporary_folder.h"

#include <QCoreApplication>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace teleta::study {

namespace {

class LevelExclusion : public testing::Test {
protected:
    LevelExclusion() {
        static int argc = 1;
        static char name[] = "test";
        static char* argv[] = {name, nullptr};
        if (QCoreApplication::instance() == nullptr)
            new QCoreApplication(argc, argv);
    }

    /// A rehearsed study of two participants, with these rules.
    StudyStore rehearsed(const std::vector<ExclusionRule>& rules) {
        StudyHead head;
        head.protocol = readProtocol(":/studies/two-or-one.toml").value();
        head.protocol.exclusions = rules;
        // A store keeps the text.
        head.protocol = parseProtocol(protocolText(head.protocol), ":/studies/two-or-one.toml").value();
        head.seed = 3;
        head.mode = Mode::simulated;
        head.plannedParticipants = 2;
        head.observer = "t=0.1,slope=0.04,lapse=0.02";
        head.created = QDateTime(QDate(2026, 11, 3), QTime(14, 0), Qt::UTC);
        head.appVersion = "0.1.0";
        StudyStore store = std::move(StudyStore::create(m_folder.path("study"), head).value());
        EXPECT_TRUE(rehearse(store));
        return store;
    }

    static std::size_t countOf(const LevelTrials& trials, bool excluded) {
        std::size_t count = 0;
        for (const auto& [key, track] : trials.tracks())
            count +=
                static_cast<std::size_t>(std::ranges::count(track.trials, excluded, &LevelTrial::isExcluded));
        return count;
    }

    /// Test trials that were answered sooner than this.
    static std::size_t soonerThan(const StudyStore& store, double time_s) {
        std::size_t count = 0;
        const std::vector<Participant> participants = store.participants().value();
        for (const Participant& participant : participants) {
            const std::vector<SessionRecord> sessions = store.sessions(participant).value();
            for (const SessionRecord& session : sessions) {
                const std::vector<StoredTrial> trials = store.trials(session).value();
                for (const StoredTrial& one : trials)
                    count += one.result.isComplete() && one.result.planned.phase == Phase::test &&
                                     one.result.responseTime_s && *one.result.responseTime_s < time_s
                                 ? 1
                                 : 0;
            }
        }
        return count;
    }

    test::TemporaryFolder m_folder;
};

const std::vector<ExclusionRule> kHasty{parseExclusion("response_time_below_s=1").value()};

} // namespace

TEST_F(LevelExclusion, rulesOfTheProtocolReachTheFits) {
    const StudyStore store = rehearsed(kHasty);
    LevelTrials trials;
    ModeFilter modes;
    ASSERT_TRUE(addLevelTrials(store, modes, trials));
    const std::size_t hasty = soonerThan(store, 1.0);
    ASSERT_GT(hasty, 20U) << "otherwise there is nothing to leave out";
    EXPECT_EQ(countOf(trials, true), hasty);
    std::int64_t fitted = 0;
    for (const ThresholdLine& line : thresholdResults(trials).lines)
        fitted += line.fit.trials;
    std::size_t counted = 0;
    for (const auto& [key, track] : trials.tracks())
        counted += static_cast<std::size_t>(std::ranges::count_if(
            track.trials, [](const LevelTrial& one) { return one.kept.counts && !one.isExcluded; }));
    EXPECT_EQ(fitted, static_cast<std::int64_t>(counted));
    std::int64_t asked = 0;
    for (const DetectionLine& line : detectionResults(trials).lines)
        asked += line.signalTrials + line.noiseTrials.value_or(0);
    EXPECT_EQ(asked, static_cast<std::int64_t>(countOf(trials, false)));
}

// A rule that is made after the data leaves out the same as one of the protocol.
TEST_F(LevelExclusion, rulesMadeAfterTheDataDoTheSame) {
    const StudyStore store = rehearsed({});
    LevelTrials all;
    LevelTrials left;
    ModeFilter modes;
    ASSERT_TRUE(addLevelTrials(store, modes, all));
    ASSERT_TRUE(addLevelTrials(store, modes, left, kHasty));
    EXPECT_EQ(countOf(all, true), 0U);
    EXPECT_EQ(countOf(left, true), soonerThan(store, 1.0));
    EXPECT_EQ(countOf(left, true) + countOf(left, false), countOf(all, false));
}

// The exported trials name the rule, so that the table has the same fits as the store.
TEST_F(LevelExclusion, theExportedTableHasTheSameFits) {
    const StudyStore store = rehearsed(kHasty);
    ASSERT_TRUE(exportStudy(store, ExportFormat::psychds));
    LevelTrials ofStore;
    LevelTrials ofTable;
    ModeFilter modes;
    ASSERT_TRUE(addLevelTrials(store, modes, ofStore));
    for (const auto& entry : std::filesystem::recursive_directory_iterator(m_folder.path("study/data"))) {
        if (entry.path().string().ends_with("_data.csv")) {
            ASSERT_TRUE(
                addLevelTrials(entry.path().string(), modes, ofTable, [](std::uint64_t) { return true; }));
        }
    }
    const ThresholdResults expected = thresholdResults(ofStore);
    const ThresholdResults results = thresholdResults(ofTable);
    ASSERT_EQ(results.lines.size(), expected.lines.size());
    for (std::size_t i = 0; i < results.lines.size(); ++i) {
        EXPECT_EQ(results.lines[i].fit.trials, expected.lines[i].fit.trials);
        EXPECT_EQ(results.lines[i].fit.threshold, expected.lines[i].fit.threshold);
    }
}

TEST_F(LevelExclusion, whoIsExcludedHasNoThreshold) {
    ExclusionRule everybody = parseExclusion("accuracy_not_above_chance=0.05").value();
    everybody.value = 0.0; // p is never 0
    const StudyStore store = rehearsed({everybody});
    LevelTrials trials;
    ModeFilter modes;
    ASSERT_TRUE(addLevelTrials(store, modes, trials));
    EXPECT_EQ(countOf(trials, false), 0U);
    EXPECT_TRUE(thresholdResults(trials).empty());
    EXPECT_TRUE(detectionResults(trials).empty());
}

} // namespace teleta::study
