// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"
#include "tests/support/generated_locale.h"
#include "tests/support/small_disk.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <filesystem>
#include <set>
#include <string>
#include <thread>
#include <unistd.h>

using nlohmann::ordered_json;
using teleta::test::GeneratedLocale;
using teleta::test::ProgramResult;
using teleta::test::ProgramSettings;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::RunningProgram;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

class StudyFaults : public testing::Test {
protected:
    /// All files of an analysis, name and content.
    static std::string contentOf(const std::string& folder) {
        std::set<std::string> paths;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
            if (entry.is_regular_file())
                paths.insert(entry.path().string());
        }
        std::string all;
        for (const std::string& path : paths)
            all += path.substr(folder.size()) + '\n' + readAll(path);
        return all;
    }

    TemporaryFolder m_folder;
};

} // namespace

TEST_F(StudyFaults, germanAndTurkishLocalesChangeNoFile) {
    const std::string study = m_folder.path("study");
    ASSERT_EQ(run({"study", "rehearse", "--participants", "2", "--out", study}).exitCode, 0);
    const std::string csv = m_folder.path("plain");
    ASSERT_EQ(run({"study", "analyze", study, "--out", csv}).exitCode, 0);
    const std::string expected = contentOf(csv);
    for (const char* language : {"de_DE", "tr_TR"}) {
        const GeneratedLocale locale(language);
        if (!locale.exists())
            GTEST_SKIP() << "the sources of locales are not installed (package locales)";
        const ProgramSettings settings{
            {{"LC_ALL", locale.name()}, {"LOCPATH", locale.path()}, {"LANGUAGE", "en"}}, {}, false};
        // The C library takes the locale: a program that writes numbers in it has a comma.
        ASSERT_EQ(std::system(("test \"$(LOCPATH='" + locale.path() + "' LC_ALL=" + locale.name() +
                               " /usr/bin/printf %.1f 1,5)\" = 1,5")
                                  .c_str()),
                  0)
            << language;
        const std::string local = m_folder.path(language);
        const ProgramResult rehearsed =
            run({"study", "rehearse", "--participants", "2", "--out", local}, settings);
        ASSERT_EQ(rehearsed.exitCode, 0) << rehearsed.err;
        const std::string out = m_folder.path(std::string(language) + "-out");
        // The report names its sources, so that the folder has to have the same name.
        std::filesystem::rename(study, m_folder.path("kept"));
        std::filesystem::rename(local, study);
        ASSERT_EQ(run({"study", "analyze", study, "--out", out}, settings).exitCode, 0);
        EXPECT_EQ(contentOf(out), expected) << language;
        std::filesystem::rename(study, local);
        std::filesystem::rename(m_folder.path("kept"), study);
        // A decimal comma would make more fields.
        for (const auto& entry : std::filesystem::recursive_directory_iterator(local + "/data")) {
            if (entry.path().extension() != ".csv")
                continue;
            const auto rows = splitCsv(readAll(entry.path().string()));
            for (const auto& row : rows)
                EXPECT_EQ(row.size(), 48U) << entry.path();
        }
    }
}

TEST_F(StudyFaults, ctrlCFinishesTheFilesAndTheRehearsalGoesOnFromThere) {
    const std::string study = m_folder.path("study");
    RunningProgram program({"study", "rehearse", "--participants", "200", "--out", study});
    // The first exported session shows that trials are being kept.
    while (!program.ended() && !std::filesystem::exists(study + "/data/subject-P01"))
        std::this_thread::yield();
    program.send(SIGINT);
    const ProgramResult result = program.wait();
    EXPECT_EQ(result.exitCode, 1) << result.err;
    EXPECT_NE(result.err.find("interrupted"), std::string::npos) << result.err;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(study)) {
        if (entry.path().extension() != ".csv")
            continue;
        const auto rows = splitCsv(readAll(entry.path().string()));
        ASSERT_GT(rows.size(), 1U) << entry.path();
        EXPECT_EQ(rows.back().size(), rows.front().size()) << entry.path();
    }
    const ProgramResult analyzed = run({"study", "analyze", study, "--out", m_folder.path("out"), "--json"});
    EXPECT_EQ(analyzed.exitCode, 0) << analyzed.err;
}

TEST_F(StudyFaults, aRehearsalShowsItsProgressOnATerminal) {
    ProgramSettings settings;
    settings.terminal = true;
    const ProgramResult result =
        run({"study", "rehearse", "--participants", "20", "--out", m_folder.path("study")}, settings);
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.out.find("trials/s"), std::string::npos) << result.out;
}

TEST_F(StudyFaults, aFolderThatCannotBeWrittenIsAnErrorAndChangesNothing) {
    const std::string blocked = m_folder.write("blocked", "a file stands in the way");
    const ProgramResult rehearsed =
        run({"study", "rehearse", "--participants", "1", "--out", blocked + "/study"});
    EXPECT_EQ(rehearsed.exitCode, 1);
    EXPECT_NE(rehearsed.err.find("blocked"), std::string::npos) << rehearsed.err;
    const std::string csv = m_folder.write(
        "trials.csv",
        "participant_id,task,condition,phase,stimulus,response\nP,t,c,test,A,A\nP,t,c,test,B,A\n");
    EXPECT_EQ(run({"study", "analyze", csv, "--out", blocked + "/out"}).exitCode, 1);
    EXPECT_EQ(readAll(blocked), "a file stands in the way");
}

TEST_F(StudyFaults, aFullDiskIsToldWithItsPlaceAndLosesNothing) {
    const teleta::test::SmallDisk disk(m_folder.path("disk"), 4);
    if (!disk.exists())
        GTEST_SKIP() << "no disk can be mounted here";
    const std::string study = disk.path("study");
    ASSERT_EQ(run({"study", "rehearse", "--participants", "1", "--out", study}).exitCode, 0);
    const std::string before = contentOf(study + "/data");
    ASSERT_TRUE(disk.fill());
    const ProgramResult full = run({"study", "export", study, "--format", "bids"});
    EXPECT_EQ(full.exitCode, 1);
    EXPECT_NE(full.err.find(study + "/bids"), std::string::npos) << full.err;
    const ProgramResult resumed =
        run({"study", "rehearse", "--participants", "1", "--out", disk.path("other")});
    EXPECT_EQ(resumed.exitCode, 1);
    EXPECT_NE(resumed.err.find(disk.path("other")), std::string::npos) << resumed.err;
    EXPECT_EQ(contentOf(study + "/data"), before);
    disk.empty();
    const ProgramResult room = run({"study", "export", study, "--format", "bids"});
    EXPECT_EQ(room.exitCode, 0) << room.err;
    EXPECT_EQ(run({"study", "analyze", study, "--out", m_folder.path("results")}).exitCode, 0);
}

TEST_F(StudyFaults, figuresComeInTheFormatsThatWereAskedFor) {
    const std::string csv = m_folder.write(
        "trials.csv",
        "participant_id,task,condition,phase,stimulus,response\nP,t,c,test,A,A\nP,t,c,test,B,A\n");
    const std::string out = m_folder.path("out");
    const ProgramResult result = run({"study", "analyze", csv, "--out", out, "--figures", "svg,pdf,png"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(readAll(out + "/figures/confusion_t_c.svg").substr(0, 4), "<svg");
    EXPECT_EQ(readAll(out + "/figures/confusion_t_c.pdf").substr(0, 5), "%PDF-");
    EXPECT_EQ(readAll(out + "/figures/confusion_t_c.png").substr(1, 3), "PNG");
    EXPECT_TRUE(std::filesystem::exists(out + "/report.html"));
    EXPECT_EQ(run({"study", "analyze", csv, "--out", out, "--figures", "gif"}).exitCode, 2);
    EXPECT_EQ(run({"study", "analyze", "--out", out}).exitCode, 3);
}

TEST_F(StudyFaults, questionnairesOfASimulatedStudyAreExportedApartFromTheTrials) {
    const std::string protocol = m_folder.write("p.toml", R"(name = "asked"
stimulus_s = 2.0
response_limit_s = 10.0
response_window = "from_onset"
order = "full_random"
[practice]
repetitions = 0
[test]
repetitions = 1
[masking_noise]
colour = "none"
[[task]]
id = "shape"
pattern = [{ letter = "A" }, { letter = "B" }]
condition = [{ id = "static" }]
[[questionnaire]]
id = "effort"
when = "after_session"
item = [{ id = "hard", kind = "likert", question = "How hard, from 1 to 5?", points = 5 }]
[[questionnaire]]
id = "person"
when = "after_study"
item = [{ id = "remarks", kind = "text", question = "Anything else?" }]
)");
    const std::string study = m_folder.path("study");
    ASSERT_EQ(run({"study", "rehearse", protocol, "--participants", "2", "--out", study}).exitCode, 0);
    const auto rows =
        splitCsv(readAll(study + "/data/subject-P02/subject-P02_description-questionnaire_data.csv"));
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0][1], "participant_id");
    EXPECT_EQ(rows[1][1], "P02");
    EXPECT_EQ(rows[1][4], "shape");
    EXPECT_EQ(rows[2][4], "NA");
    for (const char* format : {"bids", "excel"})
        EXPECT_EQ(run({"study", "export", study, "--format", format}).exitCode, 0);
    // A file for each questionnaire and place in the plan, with a row for each participant.
    std::size_t tables = 0;
    for (const auto& entry : std::filesystem::directory_iterator(study + "/bids/phenotype")) {
        if (entry.path().extension() != ".tsv")
            continue;
        ++tables;
        EXPECT_NE(readAll(entry.path().string()).find("sub-P01"), std::string::npos) << entry.path();
    }
    EXPECT_GE(tables, 1U);
    EXPECT_TRUE(std::filesystem::exists(study + "/excel/P01_questionnaire.csv"));
}

TEST_F(StudyFaults, noiseIsASoundFileOfTheLengthThatIsTold) {
    const std::string path = m_folder.path("noise.wav");
    const ProgramResult result = run({"study", "noise", "--out", path, "--level", "-23", "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const ordered_json answer = ordered_json::parse(result.out);
    EXPECT_EQ(std::filesystem::file_size(path),
              44U + 2U * static_cast<std::size_t>(answer["duration_s"].get<double>() * 48'000.0 + 0.5));
    EXPECT_EQ(run({"study", "noise", "--out", path, "--level", "-1"}).exitCode, 1) << "it would be clipped";
    EXPECT_EQ(run({"study", "noise", "--out", path, "--level", "3"}).exitCode, 2);
}
