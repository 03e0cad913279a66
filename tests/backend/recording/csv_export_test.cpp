// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/csv_reader.h"
#include "backend/core/data/frame_file.h"
#include "backend/recording/csv_export.h"
#include "backend/recording/stream_columns.h"
#include "tests/backend/recording/recorded_files.h"

#include <QCryptographicHash>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <limits>

using namespace teleta;
using namespace teleta::recording;
using namespace teleta::test;

namespace {

class CsvExportTest : public testing::Test {
protected:
    CsvExportTest() { makeApplication(); }

    std::unique_ptr<Recorder> start() {
        return Recorder::start(m_folder.path("run.teleta"), headAt(kStart_ns), {.simulatedTime = true})
            .value();
    }
    [[nodiscard]] std::vector<ExportedFile> exported() const {
        const auto recording = Recording::open(m_folder.path("run.teleta"));
        const auto done = exportCsv(*recording, m_folder.path("csv"));
        EXPECT_TRUE(done) << core::describe(done.error());
        return done.value_or(std::vector<ExportedFile>());
    }

    static constexpr std::int64_t kStart_ns = 77'000'000'000;
    TemporaryFolder m_folder;
};

} // namespace

TEST_F(CsvExportTest, anArrayIsReadBackAsFramesFromTheStartOn) {
    {
        auto recorder = start();
        const auto tap = recorder->addStream(arrayInfo());
        appendFrame(*tap, kStart_ns + 5'000'000, 0.1F);
        appendFrame(*tap, kStart_ns + 10'000'000, std::numeric_limits<float>::quiet_NaN());
        ASSERT_TRUE(recorder->stop());
    }
    const auto files = exported();
    ASSERT_EQ(files.size(), 3U);
    EXPECT_EQ(files[0].rows, 2U);
    EXPECT_EQ(readAll(m_folder.path("csv/frames.csv")), "time_s,t0,t1,t2,t3,t4,t5\n"
                                                        "0.005,0.1,0.225,0.35,0.475,0.6,0.725\n"
                                                        "0.01,NA,NA,NA,NA,NA,NA\n");
    auto file = core::FrameFile::open(m_folder.path("csv/frames.csv"), {.rows = 2, .columns = 3});
    ASSERT_TRUE(file) << core::describe(file.error());
    double time_s = 0.0;
    std::vector<float> values(kTaxels);
    EXPECT_TRUE(file->next(time_s, values).value());
    EXPECT_EQ(values[5], 0.725F);
}

TEST_F(CsvExportTest, jointsHaveTheColumnsOfAStiffnessLog) {
    {
        auto recorder = start();
        const auto tap = recorder->addStream(jointStream(1000.0, 4));
        core::JointSample sample;
        sample.angle_rad = {0.1, 0.2, 0.3, 0.4};
        sample.torque_Nm = {1.0, 2.0, 3.0, 4.0};
        sample.reference_rad = {0.5, 0.6, 0.7, 0.8};
        const auto values = jointValues(sample, 4);
        tap->append(kStart_ns + 1'000'000, 0.0, std::span<const double>(values));
        ASSERT_TRUE(recorder->stop());
    }
    (void)exported();
    EXPECT_EQ(readAll(m_folder.path("csv/joints.csv")),
              "time_s,joint_angle_rad,joint_torque_nm,q1,q2,q3,q4,tau1,tau2,tau3,tau4,ref1,ref2,ref3,ref4\n"
              "0.001,0.4,4,0.1,0.2,0.3,0.4,1,2,3,4,0.5,0.6,0.7,0.8\n");
}

TEST_F(CsvExportTest, marksAreEventsWithTheTimeOfTheWallClock) {
    {
        auto recorder =
            Recorder::start(m_folder.path("run.teleta"), headAt(kStart_ns),
                            {.utcNow = [] { return QDateTime(QDate(2030, 1, 1), QTime(12, 0), Qt::UTC); },
                             .simulatedTime = true})
                .value();
        recorder->add({.time_ns = kStart_ns + 1'500'000'000, .kind = kMark, .text = "a, \"note\""});
        ASSERT_TRUE(recorder->stop());
    }
    (void)exported();
    EXPECT_EQ(readAll(m_folder.path("csv/events.csv")),
              "time_s,utc,event,text,value\n"
              "0,2030-01-01T12:00:00.000Z,stopped,,0\n"
              "1.5,2030-01-01T12:00:01.500Z,mark,\"a, \"\"note\"\"\",0\n");
}

TEST_F(CsvExportTest, theUnixTimeIsALastColumnThatReadersOfFramesPassOver) {
    {
        auto recorder =
            Recorder::start(m_folder.path("run.teleta"), headAt(kStart_ns),
                            {.utcNow = [] { return QDateTime(QDate(2030, 1, 1), QTime(12, 0), Qt::UTC); },
                             .simulatedTime = true})
                .value();
        const auto tap = recorder->addStream(arrayInfo());
        appendFrame(*tap, kStart_ns + 5'000'001, 0.1F);
        appendFrame(*tap, kStart_ns + 1'010'000'000, 0.2F);
        recorder->add({.time_ns = kStart_ns + 1'500'000'000, .kind = kMark, .text = "note"});
        ASSERT_TRUE(recorder->stop());
    }
    const auto recording = Recording::open(m_folder.path("run.teleta"));
    ASSERT_TRUE(exportCsv(*recording, m_folder.path("csv"), {.utc = true}));
    // 2030-01-01T12:00:00Z is 1893499200 s after 1970 (date -u -d 2030-01-01T12:00 +%s).
    EXPECT_EQ(readAll(m_folder.path("csv/frames.csv")),
              "time_s,t0,t1,t2,t3,t4,t5,utc_s\n"
              "0.005000001,0.1,0.225,0.35,0.475,0.6,0.725,1893499200.005000001\n"
              "1.01,0.2,0.325,0.45,0.575,0.7,0.825,1893499201.010000000\n");
    EXPECT_NE(readAll(m_folder.path("csv/events.csv")).find(",mark,note,0,1893499201.500000000\n"),
              std::string::npos);
    EXPECT_EQ(core::FrameFile::countTaxels(m_folder.path("csv/frames.csv")), kTaxels);
    auto file = core::FrameFile::open(m_folder.path("csv/frames.csv"), {.rows = 2, .columns = 3});
    ASSERT_TRUE(file) << core::describe(file.error());
    double time_s = 0.0;
    std::vector<float> values(kTaxels);
    EXPECT_TRUE(file->next(time_s, values).value());
    EXPECT_EQ(values[5], 0.725F);
}

TEST_F(CsvExportTest, theDescriptionBesideTheFilesHasStartUnitsAndTheSumOfTheRecording) {
    {
        auto recorder =
            Recorder::start(m_folder.path("run.teleta"), headAt(kStart_ns),
                            {.utcNow = [] { return QDateTime(QDate(2030, 1, 1), QTime(12, 0), Qt::UTC); },
                             .simulatedTime = true})
                .value();
        appendFrame(*recorder->addStream(arrayInfo()), kStart_ns, 0.1F);
        const auto values = jointValues({}, 4);
        recorder->addStream(jointStream(1000.0, 4))->append(kStart_ns, 0.0, std::span<const double>(values));
        ASSERT_TRUE(recorder->stop());
    }
    (void)exported();
    const auto document = nlohmann::json::parse(readAll(m_folder.path("csv/recording.json")));
    EXPECT_EQ(document["recording"], "run.teleta");
    EXPECT_EQ(document["complete"], true);
    EXPECT_EQ(document["app_version"], "1.2.3");
    EXPECT_EQ(document["start_utc"], "2030-01-01T12:00:00.000Z");
    EXPECT_EQ(document["anchors"][0]["time_s"], 0.0);
    EXPECT_EQ(document["anchors"][0]["utc"], "2030-01-01T12:00:00.000Z");
    const std::string recorded = readAll(m_folder.path("run.teleta"));
    EXPECT_EQ(document["sha256"],
              QCryptographicHash::hash({recorded.data(), static_cast<qsizetype>(recorded.size())},
                                       QCryptographicHash::Sha256)
                  .toHex()
                  .toStdString());
    ASSERT_EQ(document["tables"].size(), 3U);
    const auto& frames = document["tables"][0];
    EXPECT_EQ(frames["file"], "frames.csv");
    EXPECT_EQ(frames["rows"], 1);
    EXPECT_EQ(frames["columns"][0], (nlohmann::json{{"name", "time_s"}, {"unit", "s"}}));
    EXPECT_EQ(frames["columns"][6], (nlohmann::json{{"name", "t5"}, {"unit", "N"}}));
    const auto& joints = document["tables"][1];
    EXPECT_EQ(joints["columns"][2], (nlohmann::json{{"name", "joint_torque_nm"}, {"unit", "N m"}}));
    EXPECT_EQ(joints["columns"][10], (nlohmann::json{{"name", "tau4"}, {"unit", "N m"}}));
    EXPECT_EQ(document["tables"][2]["columns"][2], (nlohmann::json{{"name", "event"}, {"unit", nullptr}}));
}

TEST_F(CsvExportTest, featuresHaveTheirWordsAndDamagedBlocksAreLeftOutAndCounted) {
    {
        auto recorder = start();
        StreamInfo info;
        info.name = "features/of the skin";
        info.kind = StreamKind::features;
        info.type = ValueType::float64;
        info.columns = {{"contact_type", ""}, {"force_n", "N"}};
        info.shape = {2};
        const auto tap = recorder->addStream(info);
        for (int i = 0; i < 4; ++i) {
            const std::array<double, 2> values{static_cast<double>(i), 0.5 * i};
            tap->append(kStart_ns + i * 1'000'000'000LL, 0.0, std::span<const double>(values), true);
        }
        ASSERT_TRUE(recorder->stop());
    }
    askFile(m_folder.path("run.teleta"), QStringLiteral("UPDATE block SET data = x'00' WHERE key = 2"));
    const auto files = exported();
    EXPECT_EQ(files[0].rows, 3U);
    EXPECT_EQ(files[0].damagedBlocks, 1U);
    EXPECT_EQ(readAll(m_folder.path("csv/features_of the skin.csv")), "time_s,contact_type,force_n\n"
                                                                      "0,none,0\n"
                                                                      "2,edge,1\n"
                                                                      "3,NA,1.5\n");
}

TEST_F(CsvExportTest, pagesThatCannotBeReadTakeOnlyTheirBlocks) {
    const std::string path = m_folder.path("run.teleta");
    recordLargeBlocks(path, kStart_ns, 6);
    damageLargeBlock(path, 0);
    damageLargeBlock(path, 3);
    const auto files = exported();
    ASSERT_EQ(files.size(), 3U);
    EXPECT_EQ(files[0].damagedBlocks, 2U);
    EXPECT_EQ(files[0].rows, 4U * kLargeFrames);
}

TEST_F(CsvExportTest, anExportOfDamagedBlocksAloneCanBeStopped) {
    recordLargeBlocks(m_folder.path("run.teleta"), kStart_ns, 3);
    askFile(m_folder.path("run.teleta"), QStringLiteral("UPDATE block SET data = x'00'"));
    const auto recording = Recording::open(m_folder.path("run.teleta"));
    const auto done =
        exportCsv(*recording, m_folder.path("csv"), {.goOn = [](double, double) { return false; }});
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().kind, core::ErrorKind::cancelled);
}

TEST_F(CsvExportTest, anExportThatIsStoppedLeavesNoFileUnlessItFinishesThem) {
    {
        auto recorder = start();
        const auto tap = recorder->addStream(arrayInfo());
        for (int i = 0; i < 3; ++i) {
            const std::array<float, kTaxels> values{static_cast<float>(i)};
            tap->append(kStart_ns + i, 0.0, std::span<const float>(values), /*discontinuity=*/true);
        }
        appendFrame(*recorder->addStream(arrayInfo("later")), kStart_ns, 1.0F);
        ASSERT_TRUE(recorder->stop());
    }
    const auto recording = Recording::open(m_folder.path("run.teleta"));
    // In the middle of the first stream, at its end, and with the last frame of all.
    for (const double last : {2.0, 3.0, 4.0}) {
        const auto done = exportCsv(*recording, m_folder.path("csv"),
                                    {.goOn = [last](double frames, double) { return frames < last; }});
        ASSERT_FALSE(done);
        EXPECT_EQ(done.error().kind, core::ErrorKind::cancelled);
        EXPECT_FALSE(std::filesystem::exists(m_folder.path("csv"))) << "the folder was made for it";
    }
    std::filesystem::create_directory(m_folder.path("csv"));
    m_folder.write("csv/frames.csv", "of before");
    EXPECT_FALSE(exportCsv(*recording, m_folder.path("csv"),
                           {.goOn = [](double frames, double) { return frames < 4.0; }, .overwrite = true}));
    EXPECT_EQ(readAll(m_folder.path("csv/frames.csv")), "of before");
    EXPECT_FALSE(std::filesystem::exists(m_folder.path("csv/later.csv")));
    EXPECT_FALSE(std::filesystem::exists(m_folder.path("csv/events.csv")));

    // Or it finishes what it has.
    const auto done =
        exportCsv(*recording, m_folder.path("part"),
                  {.goOn = [](double frames, double) { return frames < 2.0; }, .finishesWhenEnded = true});
    ASSERT_TRUE(done) << core::describe(done.error());
    ASSERT_EQ(done->size(), 3U);
    EXPECT_EQ(done->at(0).rows, 2U);
    EXPECT_EQ(readAll(m_folder.path("part/frames.csv")), "time_s,t0,t1,t2,t3,t4,t5\n0,0,0,0,0,0,0\n"
                                                         "1e-09,1,0,0,0,0,0\n");
    EXPECT_TRUE(std::filesystem::exists(m_folder.path("part/events.csv")));
}

TEST_F(CsvExportTest, aFileThatCannotTakeItsNameLeavesNoneOfTheOthers) {
    {
        auto recorder = start();
        appendFrame(*recorder->addStream(arrayInfo()), kStart_ns, 1.0F);
        appendFrame(*recorder->addStream(arrayInfo("later")), kStart_ns, 1.0F);
        ASSERT_TRUE(recorder->stop());
    }
    const auto recording = Recording::open(m_folder.path("run.teleta"));
    // When its rows are written already a folder takes the name of the second one.
    const auto done = exportCsv(*recording, m_folder.path("csv"), {.goOn = [&](double frames, double) {
        if (frames >= 2.0)
            std::filesystem::create_directory(m_folder.path("csv/later.csv"));
        return true;
    }});
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().kind, core::ErrorKind::ioFailed) << core::describe(done.error());
    EXPECT_FALSE(std::filesystem::exists(m_folder.path("csv/frames.csv")));
    EXPECT_FALSE(std::filesystem::exists(m_folder.path("csv/events.csv")));
}

TEST_F(CsvExportTest, streamsWhoseFilesWouldHaveOneNameGetNumbers) {
    {
        auto recorder = start();
        float value = 0.0F;
        for (const char* name : {"a/b", "a_b", "A_B", "events"})
            appendFrame(*recorder->addStream(arrayInfo(name)), kStart_ns, value++);
        ASSERT_TRUE(recorder->stop());
    }
    std::vector<std::string> names;
    for (const ExportedFile& file : exported())
        names.push_back(file.path.substr(file.path.rfind('/') + 1));
    EXPECT_EQ(names, (std::vector<std::string>{"a_b.csv", "a_b-2.csv", "A_B-3.csv", "events-2.csv",
                                               "events.csv", "recording.json"}));
    EXPECT_NE(readAll(m_folder.path("csv/A_B-3.csv")).find("\n0,2,"), std::string::npos);
    EXPECT_EQ(readAll(m_folder.path("csv/events.csv")).substr(0, 10), "time_s,utc");
}

TEST_F(CsvExportTest, nobodysFileIsWrittenOverUnlessItMayBe) {
    {
        auto recorder = start();
        appendFrame(*recorder->addStream(arrayInfo("first")), kStart_ns, 1.0F);
        appendFrame(*recorder->addStream(arrayInfo()), kStart_ns, 1.0F);
        ASSERT_TRUE(recorder->stop());
    }
    std::filesystem::create_directory(m_folder.path("csv"));
    const std::string mine = m_folder.write("csv/frames.csv", "somebody's");
    const auto recording = Recording::open(m_folder.path("run.teleta"));
    const auto refused = exportCsv(*recording, m_folder.path("csv"));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, core::ErrorKind::refused);
    EXPECT_EQ(refused.error().where.file, mine);
    EXPECT_EQ(readAll(mine), "somebody's");
    EXPECT_FALSE(std::filesystem::exists(m_folder.path("csv/first.csv")));
    EXPECT_TRUE(exportCsv(*recording, m_folder.path("csv"), {.overwrite = true}));
    EXPECT_NE(readAll(mine), "somebody's");
}
