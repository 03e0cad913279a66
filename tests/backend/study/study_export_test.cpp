// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/trials/trial_source.h"
#include "backend/study/protocol/stimulus_set.h"
#include "backend/study/report/exports/study_export.h"
#include "backend/study/session/rehearsal.h"
#include "backend/study/store/trial_table.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/study/small_protocol.h"

#include <QLocale>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

namespace teleta::study {

namespace {

const QDateTime kNow(QDate(2026, 11, 3), QTime(14, 22, 33), Qt::UTC);

class StudyExportTest : public testing::Test {
protected:
    StudyStore create(Mode mode, std::size_t participants = 0) {
        StudyHead head;
        head.protocol = smallProtocol();
        head.seed = 5;
        head.mode = mode;
        head.plannedParticipants = participants;
        head.created = kNow;
        head.appVersion = "0.1.0";
        return std::move(StudyStore::create(m_folder.path("study"), head).value());
    }

    /// Enrols a participant who answers one trial in time and misses one.
    static void addSession(StudyStore& store, const std::string& id) {
        const Participant participant = store.enrol(id).value();
        const PlannedSession plan = planSessions(store.head().protocol, 5, participant.enrolment)[0];
        const SessionRecord session = store.beginSession(participant, 0, plan, kNow).value();
        TrialResult result;
        result.planned = {Phase::test, 1, 1, 1, 0};
        result.response = 1;
        result.outcome = Outcome::incorrect;
        result.responseTime_s = 1.25;
        result.responseTimeOffset_s = -0.75;
        result.responseDevice = "keyboard";
        result.responseKey = ";";
        ASSERT_TRUE(store.keepTrial(session, result, kNow));
        TrialResult silent;
        silent.planned = {Phase::test, 2, 1, 1, 2};
        silent.trialInBlock = 2;
        ASSERT_TRUE(store.keepTrial(session, silent, kNow));
    }

    [[nodiscard]] std::string read(const std::string& path) const {
        return test::readAll(m_folder.path("study/" + path));
    }

    test::TemporaryFolder m_folder;
};

std::string firstLine(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

} // namespace

TEST_F(StudyExportTest, psychDsHasTheNamesAndColumnsOfTheFormat) {
    StudyStore store = create(Mode::run);
    addSession(store, "P07");
    ASSERT_EQ(exportStudy(store, ExportFormat::psychds), 1U);
    const std::string path = "data/subject-P07/subject-P07_session-20261103T142233_task-shape_data";
    const std::string table = read(path + ".csv");
    EXPECT_EQ(
        firstLine(table),
        "schema,participant_id,session_id,mode,task,condition,condition_position,sequence_row,phase,"
        "block,trial,"
        "trial_in_block,repetition,attempt,stimulus,response,outcome,correct,response_time_s,"
        "response_time_offset_s,response_limit_s,n_alternatives,response_device,response_key,n_replays,"
        "early_presses,onset_s,duration_s,device_latency_ms,device_faults,feedback,masking_noise,time_"
        "utc,seed,"
        "order_method,stimulus_set_sha256,app_version,design,track,level,level_unit,reference,procedure,"
        "excluded,trigger_ms,recording,recording_s,device_latency_spread_ms");
    const std::string seed = std::to_string(planSessions(store.head().protocol, 5, 0)[0].seed);
    const std::string common = ",none,2026-11-03T14:22:33.000Z," + seed + ",full_random," +
                               stimulusSetSha256(store.head().protocol) +
                               ",0.1.0,identification,NA,NA,NA,NA,NA,NA,NA,NA,NA,NA\n";
    EXPECT_EQ(table.substr(table.find('\n') + 1), "3,P07,20261103T142233,run,shape,static,1,1,test,2,1,1,1,1,"
                                                  "A,B,incorrect,0,1.25,-0.75,10,3,keyboard,;,0,"
                                                  "0,0,0,NA,0,0" +
                                                      common +
                                                      "3,P07,20261103T142233,run,shape,static,1,1,test,2,2,2,"
                                                      "1,1,C,NA,timeout,0,NA,NA,10,3,NA,NA,0,0,0,0,"
                                                      "NA,0,0" +
                                                      common);
    const auto sidecar = nlohmann::json::parse(read(path + ".json"));
    ASSERT_EQ(sidecar["variableMeasured"].size(), kTrialColumns.size());
    for (const auto& variable : sidecar["variableMeasured"]) {
        EXPECT_EQ(variable["@type"], "PropertyValue");
        EXPECT_TRUE(variable.contains("description")) << variable;
    }
    EXPECT_EQ(sidecar["session"]["stimuli"]["A"]["pattern"], "shape.A.static");
    const auto description = nlohmann::json::parse(read("dataset_description.json"));
    EXPECT_EQ(description["@type"], "Dataset");
    EXPECT_EQ(description["name"], "small");
}

TEST_F(StudyExportTest, bidsHasTabsAndItsOwnWordForMissing) {
    StudyStore store = create(Mode::run);
    addSession(store, "P07");
    ASSERT_TRUE(exportStudy(store, ExportFormat::bids));
    const std::string path = "bids/sub-P07/ses-shapestatic/beh/sub-P07_ses-shapestatic_task-shape_beh";
    const std::string table = read(path + ".tsv");
    EXPECT_NE(table.find("\tC\tn/a\ttimeout\t0\tn/a\t"), std::string::npos) << table;
    EXPECT_EQ(table.find("NA\t"), std::string::npos);
    const auto sidecar = nlohmann::json::parse(read(path + ".json"));
    EXPECT_EQ(sidecar["TaskName"], "shape");
    for (const std::string_view column : kTrialColumns)
        EXPECT_TRUE(sidecar[std::string(column)].contains("Description")) << column;
    EXPECT_EQ(sidecar["response_time_s"]["Units"], "s");
    EXPECT_EQ(sidecar["outcome"]["Levels"]["timeout"], "no answer in time");
    EXPECT_TRUE(nlohmann::json::parse(read("bids/dataset_description.json")).contains("BIDSVersion"));
    EXPECT_EQ(read("bids/participants.tsv"),
              "participant_id\tstudy_id\tenrolment\tmode\nsub-P07\tP07\t1\trun\n");
    EXPECT_EQ(read("bids/sub-P07/sub-P07_sessions.tsv"),
              "session_id\tacq_time\nses-shapestatic\t2026-11-03T14:22:33Z\n");
}

TEST_F(StudyExportTest, sessionsInBidsHaveNamesOfTheirOwnWhateverTheIds) {
    Protocol protocol = smallProtocol();
    protocol.tasks.push_back(protocol.tasks[0]);
    protocol.tasks[0].id = "sh-ape";
    protocol.tasks[1].id = "sh_ape";
    for (StudyTask& task : protocol.tasks) {
        for (StudyPattern& pattern : task.patterns)
            pattern.files = {{"static", "shape.A.static"}, {"dynamic", "shape.A.dynamic"}};
    }
    protocol.source = protocolText(protocol);
    StudyHead head;
    head.protocol = protocol;
    head.mode = Mode::simulated;
    head.plannedParticipants = 2;
    head.created = kNow;
    StudyStore store = std::move(StudyStore::create(m_folder.path("study"), head).value());
    ASSERT_TRUE(rehearse(store));
    ASSERT_EQ(exportStudy(store, ExportFormat::bids), 8U);
    std::set<std::string> folders;
    for (const auto& entry : std::filesystem::directory_iterator(m_folder.path("study/bids/sub-P02"))) {
        if (entry.is_directory())
            folders.insert(entry.path().filename());
    }
    EXPECT_EQ(folders.size(), 4U);
}

TEST_F(StudyExportTest, theExcelCopyHasTheDecimalSignOfTheLocale) {
    StudyStore store = create(Mode::run);
    addSession(store, "P07");
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    const auto written = exportStudy(store, ExportFormat::excel);
    QLocale::setDefault(before);
    ASSERT_TRUE(written);
    const std::string table = read("excel/P07_20261103T142233_shape.csv");
    EXPECT_EQ(table.substr(0, 3), "\xEF\xBB\xBF");
    EXPECT_NE(table.find(";1,25;-0,75;10;3;keyboard;\";\";"), std::string::npos) << table;
}

TEST(TableText, ofASpreadsheetHasNothingThatItWouldComputeWithOrRound) {
    constexpr std::array<std::string_view, 1> kOne{"x"};
    const auto cell = [&](TrialCell::Kind kind, const std::string& text, bool guarded) {
        const std::vector<TrialRow> rows{TrialRow{TrialCell{kind, text}}};
        const std::string table = tableText(rows, {';', "NA", ',', false, true, guarded}, kOne);
        return table.substr(2, table.size() - 3);
    };
    const auto text = [&](const std::string& value) { return cell(TrialCell::Kind::text, value, true); };
    for (const char* formula : {"=1+2", "+cmd", "-x", "@SUM(A1)", "-inf", "=-1", "-1-1", "\t=1"})
        EXPECT_EQ(text(formula), '\'' + std::string(formula));
    EXPECT_EQ(text("=\"a\";1"), "\"'=\"\"a\"\";1\"");
    EXPECT_EQ(text("\r=1"), "\"'\r=1\"");
    EXPECT_EQ(text("18000000000000000001"), "'18000000000000000001");
    EXPECT_EQ(text("1234567890123456"), "'1234567890123456");
    for (const char* plain : {"123456789012345", "-1.5", "+3", "-7", "P-1", "a=b", "4"})
        EXPECT_EQ(text(plain), plain);
    EXPECT_EQ(cell(TrialCell::Kind::number, "-0.30000000000000004", true), "-0,30000000000000004");
    EXPECT_EQ(cell(TrialCell::Kind::text, "=1+2", false), "=1+2");
}

TEST_F(StudyExportTest, theExcelCopyIsGuardedAndTheOthersAreAsTheyWere) {
    StudyStore store = create(Mode::run);
    addSession(store, "1234567890123456");
    ASSERT_TRUE(exportStudy(store, ExportFormat::excel));
    ASSERT_TRUE(exportStudy(store, ExportFormat::psychds));
    const std::string id = "1234567890123456";
    EXPECT_NE(read("excel/" + id + "_20261103T142233_shape.csv").find("\n3;'" + id + ";20261103T142233;run;"),
              std::string::npos);
    EXPECT_NE(read("data/subject-" + id + "/subject-" + id + "_session-20261103T142233_task-shape_data.csv")
                  .find("\n3," + id + ",20261103T142233,run,"),
              std::string::npos);
}

TEST_F(StudyExportTest, whatPeopleWroteRunsNeitherInASpreadsheetNorInATerminal) {
    StudyStore store = create(Mode::run);
    addSession(store, "P07");
    const SessionRecord session = store.sessions(store.participants()->front())->front();
    ASSERT_TRUE(store.keepNote(session, "=HYPERLINK(\"http://x\")", kNow));
    ASSERT_TRUE(store.keepNote(session, "red \x1b[31m text", kNow));
    for (const ExportFormat format : {ExportFormat::psychds, ExportFormat::excel})
        ASSERT_TRUE(exportStudy(store, format));
    for (const char* file :
         {"data/subject-P07/subject-P07_description-notes_data.csv", "excel/P07_notes.csv"}) {
        const std::string table = read(file);
        EXPECT_NE(table.find("'=HYPERLINK("), std::string::npos) << table;
        EXPECT_NE(table.find("red  [31m text"), std::string::npos) << table;
        EXPECT_EQ(table.find('\x1b'), std::string::npos) << table;
    }
}

TEST_F(StudyExportTest, otherFormatsDoNotDependOnTheLocale) {
    StudyStore store = create(Mode::run);
    addSession(store, "P07");
    const QLocale before;
    for (const QLocale& locale : {QLocale(QLocale::German), QLocale(QLocale::Turkish)}) {
        QLocale::setDefault(locale);
        const auto written = exportStudy(store, ExportFormat::psychds);
        QLocale::setDefault(before);
        ASSERT_TRUE(written);
        const std::string table =
            read("data/subject-P07/subject-P07_session-20261103T142233_task-shape_data.csv");
        EXPECT_NE(table.find(",1.25,-0.75,10,3,"), std::string::npos);
        EXPECT_NE(table.find(",timeout,"), std::string::npos);
    }
}

TEST_F(StudyExportTest, oddNamesOfParticipantsStayApartAndReadBackAsTheyWere) {
    StudyStore store = create(Mode::run);
    const std::vector<std::string> names = {"a,b",    "ab",   "a\"b",      "two\nlines",
                                            "参加者", "Ünal", "../../etc", "abx1"};
    for (const std::string& name : names)
        addSession(store, name);
    ASSERT_EQ(exportStudy(store, ExportFormat::psychds), names.size());
    std::set<std::string> readBack;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(m_folder.path("study/data"))) {
        if (entry.path().extension() != ".csv")
            continue;
        TrialTally tally;
        ModeFilter modes;
        const auto read = tallyCsv(entry.path().string(), modes, tally, [](std::uint64_t) { return true; });
        ASSERT_TRUE(read) << core::describe(read.error());
        ASSERT_EQ(tally.cells().size(), 1U);
        readBack.insert(tally.cells().begin()->first.participant);
    }
    EXPECT_EQ(readBack, std::set<std::string>(names.begin(), names.end()));
}

TEST(FileLabels, doNotChangeWhenMorePeopleEnrol) {
    std::vector<Participant> people;
    std::vector<std::string> before;
    for (const char* id : {"a,b", "ab", "\u53c2\u52a0\u8005", "abx1", "a-b", "abx5", "P07"}) {
        people.push_back({static_cast<long long>(people.size()) + 1, id, people.size()});
        const std::vector<std::string> labels = fileLabels(people);
        ASSERT_EQ(labels.size(), people.size());
        EXPECT_TRUE(std::equal(before.begin(), before.end(), labels.begin())) << id;
        EXPECT_EQ(std::set<std::string>(labels.begin(), labels.end()).size(), labels.size()) << id;
        before = labels;
    }
    EXPECT_EQ(before, (std::vector<std::string>{"abx1", "ab", "x3", "abx1x4", "abx5", "abx5x6", "P07"}));
}

TEST(FileLabels, areNotTheSameWhereTheCaseOfLettersDoesNotCount) {
    std::set<QString> files;
    const auto labels = fileLabels({{1, "P7", 0}, {2, "p7", 1}, {3, "p7x2", 2}, {4, "P 7", 3}});
    for (const std::string& label : labels)
        EXPECT_TRUE(files.insert(QString::fromStdString(label).toLower()).second) << label;
    EXPECT_EQ(labels.front(), "P7");
}

TEST_F(StudyExportTest, theSidecarTellsHowTheFramesOfEachStimulusWerePlayed) {
    StudyStore store = create(Mode::run);
    addSession(store, "P07");
    const Participant participant = store.participants()->front();
    const SessionRecord session = store.sessions(participant)->front();
    TrialResult played;
    played.planned = {Phase::test, 3, 1, 2, 1};
    played.trialInBlock = 3;
    played.frameWrite_ms = 0.75;
    played.framesMissed = 2;
    ASSERT_TRUE(store.keepTrial(session, played, kNow));
    ASSERT_TRUE(exportStudy(store, ExportFormat::psychds));
    const auto frames = nlohmann::json::parse(read(
        "data/subject-P07/subject-P07_session-20261103T142233_task-shape_data.json"))["session"]["frames"];
    ASSERT_EQ(frames.size(), 1U) << "of what was played";
    EXPECT_EQ(frames[0], nlohmann::json({{"phase", "test"},
                                         {"trial", 3},
                                         {"attempt", 2},
                                         {"longest_frame_write_ms", 0.75},
                                         {"frames_missed", 2}}));
    TrialTally tally;
    ModeFilter modes;
    ASSERT_TRUE(tallyStore(store, modes, tally));
    EXPECT_EQ(tally.frames().trials, 1U);
    EXPECT_EQ(tally.frames().missed, 2U);
    EXPECT_EQ(tally.frames().longestWrite_ms, 0.75);
}

TEST_F(StudyExportTest, aParticipantThatTheStudyDoesNotHaveIsAnErrorAndNoFile) {
    StudyStore store = create(Mode::run);
    addSession(store, "P07");
    const Participant stranger{4711, "P99", 40};
    EXPECT_EQ(exportNotes(store, stranger).error().kind, core::ErrorKind::notFound);
    EXPECT_EQ(exportAnswers(store, stranger).error().kind, core::ErrorKind::notFound);
}

TEST_F(StudyExportTest, aRehearsedStudyExportsWhatItsStoreHolds) {
    StudyStore store = create(Mode::simulated, 3);
    ASSERT_TRUE(rehearse(store));
    TrialTally ofStore;
    TrialTally ofFiles;
    ModeFilter storeModes;
    ModeFilter fileModes;
    ASSERT_TRUE(tallyStore(store, storeModes, ofStore));
    for (const auto& entry : std::filesystem::recursive_directory_iterator(m_folder.path("study/data"))) {
        if (entry.path().extension() == ".csv") {
            ASSERT_TRUE(
                tallyCsv(entry.path().string(), fileModes, ofFiles, [](std::uint64_t) { return true; }));
        }
    }
    EXPECT_EQ(fileModes.seen, Mode::simulated);
    ASSERT_EQ(ofFiles.cells().size(), ofStore.cells().size());
    for (const auto& [key, cell] : ofStore.cells()) {
        const TrialTally::Cell& other = ofFiles.cells().at(key);
        EXPECT_EQ(other.correctTimes_s, cell.correctTimes_s);
        std::map<std::pair<std::string, std::string>, std::int64_t> counts;
        const auto name = [](const TrialTally& tally, std::size_t i) {
            return i == TrialTally::kNone ? std::string() : tally.names()[i];
        };
        for (const auto& [answer, count] : cell.counts)
            counts[{name(ofStore, answer.first), name(ofStore, answer.second)}] += count;
        for (const auto& [answer, count] : other.counts)
            counts[{name(ofFiles, answer.first), name(ofFiles, answer.second)}] -= count;
        for (const auto& [answer, difference] : counts)
            EXPECT_EQ(difference, 0);
    }
}

TEST_F(StudyExportTest, aFileInTheWayIsAnErrorAndLosesNothing) {
    StudyStore store = create(Mode::run);
    addSession(store, "P07");
    m_folder.write("study/data", "in the way");
    const auto written = exportStudy(store, ExportFormat::psychds);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().kind, core::ErrorKind::ioFailed);
    EXPECT_EQ(read("data"), "in the way");
}

TEST(StimulusSet, hashChangesWithThePatternsThatAreShown) {
    const Protocol protocol = smallProtocol();
    Protocol other = protocol;
    other.tasks[0].patterns.pop_back();
    EXPECT_EQ(stimulusSetSha256(protocol), stimulusSetSha256(smallProtocol("from_end")));
    EXPECT_NE(stimulusSetSha256(protocol), stimulusSetSha256(other));
}

TEST_F(StudyExportTest, notesOfTheExperimenterComeAsATableOfTheirOwn) {
    StudyStore store = create(Mode::pilot);
    addSession(store, "P07");
    addSession(store, "P08");
    const Participant noted = store.participants()->front();
    const SessionRecord session = store.sessions(noted)->front();
    ASSERT_TRUE(store.keepNote(session, "the noise, \"pink\",\nwas off", kNow));
    ASSERT_TRUE(store.keepNote(session, "on again", kNow.addSecs(9)));
    ASSERT_EQ(exportStudy(store, ExportFormat::psychds), 2U);
    const std::string path = "data/subject-P07/subject-P07_description-notes_data";
    EXPECT_EQ(read(path + ".csv"),
              "schema,participant_id,session_id,mode,task,condition,note,time_utc,app_version\n"
              "1,P07,20261103T142233,pilot,shape,static,\"the noise, \"\"pink\"\",\nwas off\","
              "2026-11-03T14:22:33.000Z,0.1.0\n"
              "1,P07,20261103T142233,pilot,shape,static,on again,2026-11-03T14:22:42.000Z,0.1.0\n");
    EXPECT_EQ(nlohmann::json::parse(read(path + ".json"))["variableMeasured"].size(), kNoteColumns.size());
    EXPECT_FALSE(std::filesystem::exists(
        m_folder.path("study/data/subject-P08/subject-P08_description-notes_data.csv")))
        << "nothing was noted";

    ASSERT_EQ(exportStudy(store, ExportFormat::bids), 2U);
    const auto beside = nlohmann::json::parse(
        read("bids/sub-P07/ses-shapestatic/beh/sub-P07_ses-shapestatic_task-shape_beh.json"));
    ASSERT_EQ(beside["Notes"].size(), 2U);
    EXPECT_EQ(beside["Notes"][1]["note"], "on again");
    ASSERT_EQ(exportStudy(store, ExportFormat::excel), 2U);
    EXPECT_NE(read("excel/P07_notes.csv").find(";on again;"), std::string::npos);

    ASSERT_TRUE(store.keepNote(session, "later", kNow.addSecs(20)));
    ASSERT_TRUE(exportNotes(store, noted));
    EXPECT_NE(read(path + ".csv").find(",later,"), std::string::npos);
}

} // namespace teleta::study
