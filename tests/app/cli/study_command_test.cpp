// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <sys/stat.h>

using nlohmann::ordered_json;
using teleta::test::ProgramResult;
using teleta::test::run;
using teleta::test::TemporaryFolder;

namespace {

class StudyCommand : public testing::Test {
protected:
    [[nodiscard]] std::string folder() const { return m_folder.path("study"); }

    TemporaryFolder m_folder;
};

} // namespace

// 6 participants: 110 test and 66 practice trials each (TeleTA, 5.3).
TEST_F(StudyCommand, rehearsesTheStudyOfThePaper) {
    const ProgramResult result =
        run({"study", "rehearse", "--participants", "6", "--out", folder(), "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const ordered_json answer = ordered_json::parse(result.out);
    EXPECT_EQ(answer["participants"], 6);
    EXPECT_EQ(answer["trials"], 6 * (110 + 66));
    EXPECT_EQ(answer["mode"], "simulated");
    EXPECT_TRUE(std::filesystem::exists(folder() + "/study.sqlite"));
}

TEST_F(StudyCommand, doesNotBeginAStudyTwice) {
    ASSERT_EQ(run({"study", "rehearse", "--participants", "1", "--out", folder()}).exitCode, 0);
    const ProgramResult again = run({"study", "rehearse", "--participants", "1", "--out", folder()});
    EXPECT_EQ(again.exitCode, 1);
    EXPECT_NE(again.err.find("study"), std::string::npos);
}

TEST_F(StudyCommand, resumingAFinishedRehearsalAddsNothing) {
    ASSERT_EQ(run({"study", "rehearse", "--participants", "1", "--out", folder()}).exitCode, 0);
    const ProgramResult resumed = run({"study", "resume", folder(), "--json"});
    ASSERT_EQ(resumed.exitCode, 0) << resumed.err;
    const ordered_json answer = ordered_json::parse(resumed.out);
    EXPECT_EQ(answer["trials"], 176);
    EXPECT_EQ(answer["trials_before"], 176);
}

TEST_F(StudyCommand, rehearsesABuiltInProtocolWithAnObserver) {
    const ProgramResult result =
        run({"study", "rehearse", "motion-timing", "--participants", "1", "--seed", "2", "--observer",
             "t=0.1,slope=0.03,lapse=0.02,sd=0.01", "--out", folder(), "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const ordered_json answer = ordered_json::parse(result.out);
    EXPECT_EQ(answer["protocol"], "Motion timing");
    EXPECT_EQ(answer["trials"], 2 + 84);
    const ProgramResult analyzed = run({"study", "analyze", folder(), "--out", m_folder.path("results")});
    EXPECT_EQ(analyzed.exitCode, 0) << analyzed.err;
}

TEST_F(StudyCommand, anObserverThatCannotBeIsBadInput) {
    const ProgramResult result =
        run({"study", "rehearse", "motion-timing", "--observer", "t=loud", "--out", folder()});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_NE(result.err.find("t=loud"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("slope"), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder()));
    const ProgramResult unknown = run({"study", "rehearse", "no-such-protocol", "--out", folder()});
    EXPECT_EQ(unknown.exitCode, 3);
}

TEST_F(StudyCommand, aMistakeInTheProtocolIsShownWithItsPlace) {
    const std::string path = m_folder.write("p.toml", "name = \"x\"\nstimulus_s = 0.0\n");
    const ProgramResult result = run({"study", "rehearse", path, "--out", folder()});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_NE(result.err.find("p.toml:2:"), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder()));
}

TEST_F(StudyCommand, aFolderWithoutStudyIsBadInput) {
    EXPECT_EQ(run({"study", "resume", folder()}).exitCode, 3);
}

TEST_F(StudyCommand, wrongUsageIsTold) {
    EXPECT_EQ(run({"study"}).exitCode, 2);
    EXPECT_EQ(run({"study", "rehearse"}).exitCode, 2);
    EXPECT_EQ(run({"study", "rehearse", "--participants", "0", "--out", folder()}).exitCode, 2);
    EXPECT_EQ(run({"study", "rehearse", "--seed", "-1", "--out", folder()}).exitCode, 2);
}

TEST_F(StudyCommand, analyzesAStudyAndHandMadeFiles) {
    ASSERT_EQ(run({"study", "rehearse", "--participants", "3", "--out", folder()}).exitCode, 0);
    const ProgramResult analyzed = run({"study", "analyze", folder(), "--out", m_folder.path("r"), "--json"});
    ASSERT_EQ(analyzed.exitCode, 0) << analyzed.err;
    const ordered_json tasks = ordered_json::parse(analyzed.out)["tasks"];
    ASSERT_EQ(tasks.size(), 2U);
    EXPECT_EQ(tasks[0]["task"], "shape");
    EXPECT_EQ(tasks[0]["groups"][0]["participants"], 3);
    EXPECT_TRUE(std::filesystem::exists(m_folder.path("r/anova.csv")));
    EXPECT_EQ(ordered_json::parse(analyzed.out)["report"], m_folder.path("r/report.html"));
    const ProgramResult table = run({"study", "analyze", folder(), "--out", m_folder.path("t")});
    EXPECT_NE(table.out.find(m_folder.path("t/report.html")), std::string::npos) << table.out;

    const std::string csv =
        m_folder.write("hand.csv", "participant_id,task,condition,phase,stimulus,response\n"
                                   "P1,shape,static,test,A,A\nP1,shape,static,test,B,A\n");
    const ProgramResult byHand = run({"study", "analyze", csv, "--out", m_folder.path("h"), "--json"});
    ASSERT_EQ(byHand.exitCode, 0) << byHand.err;
    const ordered_json group = ordered_json::parse(byHand.out)["tasks"][0]["groups"][0];
    EXPECT_EQ(group["accuracy"], 0.5);
    EXPECT_TRUE(group["t_interval_95"].is_null());
}

TEST_F(StudyCommand, aDamagedFileLeavesNoResults) {
    const std::string good =
        "participant_id,task,condition,phase,stimulus,response\nP1,shape,static,test,A,A\n";
    const std::string csv = m_folder.write("good.csv", good);
    const std::string damaged = m_folder.write("damaged.csv", good + "P1,shape,static,test,A\n");
    const ProgramResult result = run({"study", "analyze", csv, damaged, "--out", m_folder.path("r")});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_NE(result.err.find("damaged.csv:3:"), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(m_folder.path("r")));
    EXPECT_EQ(run({"study", "analyze", csv, csv, "--out", m_folder.path("r")}).exitCode, 3);
}

TEST_F(StudyCommand, exportsAStudyInEachFormat) {
    ASSERT_EQ(run({"study", "rehearse", "--participants", "2", "--out", folder()}).exitCode, 0);
    EXPECT_TRUE(std::filesystem::exists(folder() + "/dataset_description.json"));
    for (const char* format : {"psychds", "bids", "excel"}) {
        const ProgramResult result = run({"study", "export", folder(), "--format", format, "--json"});
        ASSERT_EQ(result.exitCode, 0) << result.err;
        EXPECT_EQ(ordered_json::parse(result.out)["sessions"], 8);
    }
    EXPECT_TRUE(std::filesystem::exists(folder() + "/bids/sub-P01"));
    EXPECT_TRUE(std::filesystem::exists(folder() + "/excel"));
    EXPECT_EQ(run({"study", "export", folder(), "--format", "spss"}).exitCode, 2);
}

TEST_F(StudyCommand, enrolsUnderAPseudonymAndKeepsThePersonInAKeyApart) {
    ASSERT_EQ(run({"study", "rehearse", "--participants", "1", "--out", folder()}).exitCode, 0);
    const std::string key = m_folder.path("key.csv");
    const ProgramResult enrolled =
        run({"study", "enrol", folder(), "--key", key, "--name", "Anna Example", "--json"});
    ASSERT_EQ(enrolled.exitCode, 0) << enrolled.err;
    const std::string id = ordered_json::parse(enrolled.out)["participant"];
    EXPECT_EQ(id.size(), 6U);
    EXPECT_NE(teleta::test::readAll(key).find(id + ",Anna Example,"), std::string::npos);
    EXPECT_EQ(std::filesystem::status(key).permissions(), std::filesystem::perms(0600));
    const ProgramResult people = run({"study", "participants", folder(), "--key", key, "--json"});
    ASSERT_EQ(people.exitCode, 0) << people.err;
    const ordered_json list = ordered_json::parse(people.out);
    ASSERT_EQ(list["participants"].size(), 2U);
    EXPECT_TRUE(list["participants"][0]["name"].is_null());
    EXPECT_EQ(list["participants"][1]["name"], "Anna Example");
    EXPECT_TRUE(list["deleted"].empty());
    EXPECT_EQ(run({"study", "participants", folder()}).out.find("Anna"), std::string::npos);
    // The study itself does not know her.
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder()))
        if (entry.is_regular_file()) {
            EXPECT_EQ(teleta::test::readAll(entry.path().string()).find("Anna"), std::string::npos)
                << entry.path();
        }
    const ProgramResult inside =
        run({"study", "enrol", folder(), "--key", folder() + "/key.csv", "--name", "Bert"});
    EXPECT_EQ(inside.exitCode, 1);
    EXPECT_NE(inside.err.find("apart from the data"), std::string::npos) << inside.err;
    EXPECT_EQ(run({"study", "enrol", folder(), "--name", "Bert"}).exitCode, 2);
    EXPECT_EQ(run({"study", "enrol", folder(), "--key", key}).exitCode, 2);
}

TEST_F(StudyCommand, deletesAParticipantOnlyWhenItIsMeant) {
    ASSERT_EQ(run({"study", "rehearse", "--participants", "2", "--out", folder()}).exitCode, 0);
    ASSERT_TRUE(std::filesystem::exists(folder() + "/data/subject-P01"));
    const ProgramResult asked = run({"study", "delete", folder(), "--participant", "P01"});
    EXPECT_EQ(asked.exitCode, 2);
    EXPECT_NE(asked.err.find("cannot be undone"), std::string::npos) << asked.err;
    EXPECT_TRUE(std::filesystem::exists(folder() + "/data/subject-P01"));
    const ProgramResult deleted = run({"study", "delete", folder(), "--participant", "P01", "--reason",
                                       "consent withdrawn", "--yes", "--json"});
    ASSERT_EQ(deleted.exitCode, 0) << deleted.err;
    const ordered_json answer = ordered_json::parse(deleted.out);
    EXPECT_EQ(answer["trials"], 176);
    EXPECT_GT(answer["files"], 0);
    EXPECT_FALSE(std::filesystem::exists(folder() + "/data/subject-P01"));
    const ordered_json list = ordered_json::parse(run({"study", "participants", folder(), "--json"}).out);
    ASSERT_EQ(list["participants"].size(), 1U);
    EXPECT_EQ(list["participants"][0]["participant"], "P02");
    ASSERT_EQ(list["deleted"].size(), 1U);
    EXPECT_EQ(list["deleted"][0]["enrolment"], 1);
    EXPECT_EQ(list["deleted"][0]["reason"], "consent withdrawn");
    EXPECT_EQ(run({"study", "delete", folder(), "--participant", "P01", "--yes"}).exitCode, 3);
    EXPECT_EQ(run({"study", "analyze", folder(), "--out", m_folder.path("results")}).exitCode, 0);
}

TEST_F(StudyCommand, whatItWritesIsForItsOwnerAloneUnlessItIsToBeShared) {
    const mode_t before = ::umask(022);
    ASSERT_EQ(run({"study", "rehearse", "--participants", "1", "--out", folder()}).exitCode, 0);
    const std::string results = m_folder.path("results");
    ASSERT_EQ(run({"study", "analyze", folder(), "--out", results}).exitCode, 0);
    ASSERT_EQ(run({"study", "export", folder(), "--format", "excel"}).exitCode, 0);
    const auto mode = [](const std::string& path) {
        return static_cast<int>(std::filesystem::status(path).permissions());
    };
    EXPECT_EQ(mode(folder()), 0700);
    EXPECT_EQ(mode(results), 0700);
    EXPECT_EQ(mode(results + "/report.html"), 0600);
    EXPECT_EQ(mode(folder() + "/excel"), 0700);
    ASSERT_EQ(run({"study", "analyze", folder(), "--out", results, "--shared"}).exitCode, 0);
    ASSERT_EQ(run({"study", "export", folder(), "--format", "excel", "--shared"}).exitCode, 0);
    ::umask(before);
    EXPECT_EQ(mode(results + "/report.html"), 0644);
    EXPECT_EQ(mode(results + "/figures"), 0755);
    EXPECT_EQ(mode(folder() + "/excel"), 0755);
    EXPECT_EQ(mode(folder()), 0711) << "others can go through it, and see no more than what is shared";
    EXPECT_EQ(mode(folder() + "/study.sqlite"), 0600);
    EXPECT_EQ(mode(folder() + "/data"), 0700);
}

TEST_F(StudyCommand, writesTheReportOfOneParticipant) {
    ASSERT_EQ(run({"study", "rehearse", "--participants", "2", "--out", folder()}).exitCode, 0);
    const ProgramResult whole = run({"study", "report", folder(), "--participant", "P02", "--json"});
    ASSERT_EQ(whole.exitCode, 0) << whole.err;
    EXPECT_EQ(ordered_json::parse(whole.out)["report"], folder() + "/report-P02.html");
    const std::string page = teleta::test::readAll(folder() + "/report-P02.html");
    EXPECT_NE(page.find("SIMULATED"), std::string::npos);
    EXPECT_EQ(page.find("P01"), std::string::npos);
    const std::string path = m_folder.path("theirs.html");
    ASSERT_EQ(
        run({"study", "report", folder(), "--participant", "P02", "--for", "participant", "--out", path})
            .exitCode,
        0);
    EXPECT_NE(teleta::test::readAll(path).find("of 30 trials correctly"), std::string::npos);
    const ProgramResult stranger = run({"study", "report", folder(), "--participant", "P99"});
    EXPECT_EQ(stranger.exitCode, 3);
    EXPECT_NE(stranger.err.find("P99"), std::string::npos) << stranger.err;
    EXPECT_EQ(run({"study", "report", folder()}).exitCode, 2);
    EXPECT_EQ(run({"study", "report", folder(), "--participant", "P01", "--for", "press"}).exitCode, 2);
}

TEST_F(StudyCommand, printsTheCodebook) {
    const ProgramResult printed = run({"study", "codebook"});
    ASSERT_EQ(printed.exitCode, 0) << printed.err;
    EXPECT_TRUE(printed.out.starts_with("file,column,description,unit,levels,missing\n"));
    EXPECT_NE(printed.out.find("\nanova.csv,p_gg,"), std::string::npos);
    const ProgramResult json = run({"study", "codebook", "--json"});
    EXPECT_EQ(ordered_json::parse(json.out)[0]["column"], "schema");
    ASSERT_EQ(run({"study", "codebook", "--out", m_folder.path("c.csv")}).exitCode, 0);
    EXPECT_EQ(teleta::test::readAll(m_folder.path("c.csv")), printed.out);
    EXPECT_EQ(run({"study", "codebook", m_folder.path("no-study")}).exitCode, 3);
}

TEST_F(StudyCommand, testsATriggerDevice) {
    const ProgramResult sent = run({"study", "trigger", "--test", "127.0.0.1:9", "--json"});
    ASSERT_EQ(sent.exitCode, 0) << sent.err;
    const ordered_json events = ordered_json::parse(sent.out)["events"];
    ASSERT_EQ(events.size(), 5U);
    EXPECT_EQ(events[1]["byte"], 101);
    EXPECT_EQ(events[2]["event"], "answer_1");
    EXPECT_EQ(run({"study", "trigger", "--test", m_folder.path("ttyUSB0")}).exitCode, 3);
    EXPECT_EQ(run({"study", "trigger", "--test", "nothing"}).exitCode, 3);
    EXPECT_EQ(run({"study", "trigger"}).exitCode, 2);
}

TEST_F(StudyCommand, saysWhatIsOddAboutAFile) {
    const std::string head = "participant_id,task,condition,phase,stimulus,response\n";
    const std::string practice = m_folder.write("practice.csv", head + "P1,shape,static,practice,A,A\n");
    const ProgramResult onlyPractice = run({"study", "analyze", practice, "--out", m_folder.path("p")});
    EXPECT_EQ(onlyPractice.exitCode, 0);
    EXPECT_NE(onlyPractice.err.find("no test trials"), std::string::npos) << onlyPractice.err;
    const std::string small =
        m_folder.write("small.csv", head + "P1,shape,static,test,A,a\nP1,shape,static,test,B,B\n");
    const ProgramResult lower = run({"study", "analyze", small, "--out", m_folder.path("l")});
    EXPECT_NE(lower.err.find("\"a\" counts as wrong: the pattern is \"A\""), std::string::npos) << lower.err;
}

TEST_F(StudyCommand, saysThatTheCopyForSpreadsheetsHasOtherSeparators) {
    ASSERT_EQ(run({"study", "rehearse", "--participants", "1", "--out", folder()}).exitCode, 0);
    ASSERT_EQ(run({"study", "export", folder(), "--format", "excel"}).exitCode, 0);
    const auto first = std::filesystem::directory_iterator(folder() + "/excel");
    const ProgramResult result =
        run({"study", "analyze", first->path().string(), "--out", m_folder.path("r")});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_NE(result.err.find("semicolons"), std::string::npos) << result.err;
}
