// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/stimulus_set.h"
#include "backend/study/session/run_checks.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/study/small_protocol.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace teleta::study {

namespace {

class RunChecksTest : public testing::Test {
protected:
    RunChecksTest() {
        m_protocol.noiseColour = "pink";
        m_protocol.noise_dBA = 65.0;
        m_now.protocol = &m_protocol;
        m_now.participant = "P07";
        m_now.bracelet = BraceletCondition::live;
        m_now.braceletName = "TeleTA bracelet";
        m_now.folder = {"/data/study", true, true, {}, 2 * kNeededSpace_B};
        m_now.noiseConfirmed = true;
    }

    /// The one check that failed; all others passed.
    [[nodiscard]] RunCheck onlyFailure() const {
        const std::vector<RunCheck> checks = preRunChecks(m_now);
        EXPECT_FALSE(allPassed(checks));
        EXPECT_EQ(std::count_if(checks.begin(), checks.end(), [](const auto& c) { return !c.passed; }), 1);
        const auto failed =
            std::find_if(checks.begin(), checks.end(), [](const RunCheck& check) { return !check.passed; });
        if (failed == checks.end())
            return {};
        EXPECT_NE(failed->name, "");
        EXPECT_NE(failed->finding, "");
        EXPECT_NE(failed->remedy, "");
        return *failed;
    }

    Protocol m_protocol = smallProtocol();
    RunConditions m_now;
};

} // namespace

TEST_F(RunChecksTest, intervalsHaveToBeFurtherApartThanMotorsTurnOn) {
    StudyTask& task = m_protocol.tasks[0];
    task.design = Design::interval;
    task.levels.gap_s = 0.3;
    m_now.slowestFall_s = 0.31;
    const RunCheck check = onlyFailure();
    EXPECT_EQ(check.kind, RunCheckKind::stimuli);
    EXPECT_NE(check.finding.find("0.31"), std::string::npos) << check.finding;
    m_now.slowestFall_s = 0.3;
    EXPECT_TRUE(allPassed(preRunChecks(m_now)));
    m_now.slowestFall_s.reset();
    EXPECT_TRUE(allPassed(preRunChecks(m_now))) << "nothing is known of the motors";
    // A trial of one interval has no gap.
    m_now.slowestFall_s = 0.31;
    task.design = Design::yesNo;
    EXPECT_TRUE(allPassed(preRunChecks(m_now)));
}

TEST_F(RunChecksTest, aRunMayBeginWhenEverythingIsReady) {
    const std::vector<RunCheck> checks = preRunChecks(m_now);
    EXPECT_EQ(checks.size(), 8U);
    EXPECT_TRUE(allPassed(checks));
    for (const RunCheck& check : checks) {
        EXPECT_NE(check.finding, "") << check.name;
        EXPECT_EQ(check.remedy, "") << check.name;
    }
}

TEST_F(RunChecksTest, refusesStimuliThatAreMissingOrNotThoseOfTheBeginning) {
    m_now.stimuliChanged = true;
    m_now.madeBy = "0.7.1";
    EXPECT_EQ(onlyFailure().kind, RunCheckKind::stimuli);
    EXPECT_NE(onlyFailure().remedy.find("0.7.1"), std::string::npos);
    m_now.stimuliChanged.reset();
    const auto checks = preRunChecks(m_now);
    EXPECT_TRUE(allPassed(checks));
    EXPECT_NE(std::find_if(checks.begin(), checks.end(),
                           [](const RunCheck& check) { return check.kind == RunCheckKind::stimuli; })
                  ->finding.find("unknown"),
              std::string::npos);
    m_now.missingStimuli = {"taste.A.static"};
    EXPECT_NE(onlyFailure().finding.find("taste.A.static"), std::string::npos);
    EXPECT_EQ(missingStimuli(*paperProtocol()), std::vector<std::string>());
    Protocol other = *paperProtocol();
    other.tasks.front().patterns.front().letter = "Z";
    EXPECT_EQ(missingStimuli(other), (std::vector<std::string>{"shape.Z.static", "shape.Z.dynamic"}));
}

TEST_F(RunChecksTest, refusesAMissingALostAndAStoppedBracelet) {
    for (const BraceletCondition condition :
         {BraceletCondition::missing, BraceletCondition::notLive, BraceletCondition::stopped}) {
        m_now.bracelet = condition;
        EXPECT_EQ(onlyFailure().kind, RunCheckKind::bracelet);
    }
}

TEST_F(RunChecksTest, aSimulatedBraceletDoesForAPilotButNotForARun) {
    m_now.braceletIsSimulated = true;
    EXPECT_EQ(onlyFailure().kind, RunCheckKind::bracelet);
    m_now.mode = Mode::pilot;
    EXPECT_TRUE(allPassed(preRunChecks(m_now)));
}

TEST_F(RunChecksTest, refusesAFolderThatIsGoneFullOrNotWritable) {
    m_now.folder.free_B = kNeededSpace_B - 1;
    EXPECT_EQ(onlyFailure().kind, RunCheckKind::space);
    m_now.folder.free_B = kNeededSpace_B;
    m_now.folder.writable = false;
    m_now.folder.reason = "Read-only file system";
    EXPECT_EQ(onlyFailure().kind, RunCheckKind::folder);
    EXPECT_NE(onlyFailure().finding.find("Read-only file system"), std::string::npos);
    m_now.folder.exists = false;
    EXPECT_EQ(onlyFailure().kind, RunCheckKind::folder);
}

TEST_F(RunChecksTest, waitsForTheNoiseWherePeopleAndProtocolHaveIt) {
    m_now.noiseConfirmed = false;
    const RunCheck check = onlyFailure();
    EXPECT_EQ(check.kind, RunCheckKind::noise);
    EXPECT_NE(check.remedy.find("65 dBA"), std::string::npos) << check.remedy;
    m_now.mode = Mode::simulated;
    EXPECT_TRUE(allPassed(preRunChecks(m_now)));
    m_now.mode = Mode::run;
    m_protocol.noiseColour = "none";
    EXPECT_TRUE(allPassed(preRunChecks(m_now)));
}

TEST_F(RunChecksTest, refusesAProtocolThatIsWrongMissingOrEmpty) {
    const auto wrong = parseProtocol("name = 3\n", "mine.toml");
    ASSERT_FALSE(wrong);
    m_now.protocol = core::Unexpected(wrong.error());
    EXPECT_EQ(onlyFailure().kind, RunCheckKind::protocol);
    EXPECT_NE(onlyFailure().finding.find("mine.toml:1"), std::string::npos) << onlyFailure().finding;
    m_now.protocol = nullptr;
    EXPECT_EQ(onlyFailure().kind, RunCheckKind::protocol);
    m_protocol.practice.repetitions = 0;
    m_protocol.test.repetitions = 0;
    m_now.protocol = &m_protocol;
    EXPECT_EQ(onlyFailure().kind, RunCheckKind::protocol);
}

TEST_F(RunChecksTest, refusesAParticipantWhoIsNotChosenRunsAlreadyOrHasFinished) {
    m_now.participant.clear();
    EXPECT_EQ(onlyFailure().kind, RunCheckKind::participant);
    m_now.participant = "P07";
    m_now.runner = "laboratory 2";
    EXPECT_EQ(onlyFailure().kind, RunCheckKind::participant);
    EXPECT_NE(onlyFailure().finding.find("laboratory 2"), std::string::npos);
    m_now.runner.reset();
    m_now.finished = true;
    EXPECT_EQ(onlyFailure().kind, RunCheckKind::participant);
}

TEST_F(RunChecksTest, refusesAStoreThatIsAway) {
    m_now.store = core::Error{core::ErrorKind::unavailable, "no connection", {}, {}};
    EXPECT_EQ(onlyFailure().kind, RunCheckKind::store);
}

TEST_F(RunChecksTest, tellsWhetherTheScreenStaysOnButRefusesNothingForIt) {
    for (const bool held : {true, false}) {
        m_now.screenHeld = held;
        const std::vector<RunCheck> checks = preRunChecks(m_now);
        ASSERT_EQ(checks.size(), 9U);
        EXPECT_TRUE(allPassed(checks));
        EXPECT_EQ(checks.back().kind, RunCheckKind::screen);
        EXPECT_NE(checks.back().finding, "");
        EXPECT_EQ(checks.back().remedy.empty(), held);
    }
}

TEST(LookAtFolder, tellsWhatAFolderCanTake) {
    const test::TemporaryFolder folder;
    const FolderCondition there = lookAtFolder(folder.path("."));
    EXPECT_TRUE(there.exists);
    EXPECT_TRUE(there.writable) << there.reason;
    EXPECT_GT(there.free_B, 0);
    EXPECT_EQ(folder.entries(), 0U);
    EXPECT_FALSE(lookAtFolder(folder.path("missing")).exists);
    EXPECT_FALSE(lookAtFolder(folder.write("file", "a file is no folder")).exists);
}

// Root may write anywhere, so another user has to check.
TEST(LookAtFolder, seesThatAFolderIsReadOnly) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directory(folder.path("data"));
    std::filesystem::permissions(folder.path("."), std::filesystem::perms(0755));
    std::filesystem::permissions(folder.path("data"), std::filesystem::perms(0555));
    constexpr uid_t kNobody = 65'534;
    const uid_t user = geteuid();
    if (user == 0) {
        ASSERT_EQ(seteuid(kNobody), 0);
    }
    const FolderCondition seen = lookAtFolder(folder.path("data"));
    ASSERT_EQ(seteuid(user), 0);
    EXPECT_TRUE(seen.exists);
    EXPECT_FALSE(seen.writable);
    EXPECT_NE(seen.reason, "");
}

} // namespace teleta::study
