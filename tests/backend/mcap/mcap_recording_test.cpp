// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/picture/raw_picture.h"
#include "tests/backend/mcap/mcap_recordings.h"

using namespace teleta;
using namespace teleta::test;

TEST_F(McapRecording, importOfAnExportGivesBackEveryValueAndTime) {
    const std::string path = recorded();
    const auto recording = recording::Recording::open(path);
    ASSERT_TRUE(recording);
    int number = 0;
    for (const Compression compression : {Compression::none, Compression::lz4, Compression::zstd}) {
        for (const std::size_t chunkBytes : {std::size_t{500}, std::size_t{4} << 20U}) {
            const std::string file = m_folder.path("run" + std::to_string(++number) + ".mcap");
            const auto exported =
                mcap::exportMcap(*recording, file, {.compression = compression, .chunkBytes = chunkBytes});
            ASSERT_TRUE(exported) << core::describe(exported.error());
            EXPECT_EQ(exported->turned, std::vector<std::string>{"contacts"});
            EXPECT_TRUE(exported->leftOut.empty());
            const auto imported = mcap::importMcap(file, file + ".teleta");
            ASSERT_TRUE(imported) << core::describe(imported.error());
            EXPECT_EQ(imported->badChunks + imported->badRecords, 0U);
            EXPECT_FALSE(imported->isDataSectionDamaged);
            for (const auto& topic : imported->topics)
                EXPECT_EQ(topic.bad, 0U) << topic.name;
            expectSame(path, file + ".teleta");
        }
    }
}

TEST_F(McapRecording, anExportCarriesTareGainsCameraAndScene) {
    const auto recording = recording::Recording::open(recorded());
    ASSERT_TRUE(mcap::exportMcap(*recording, m_folder.path("run.mcap")));
    auto source = mcap::openFile(m_folder.path("run.mcap"));
    auto reader = mcap::McapReader::open(std::move(*source), "run.mcap");
    ASSERT_TRUE(reader);
    std::map<std::string, std::string> files;
    for (const auto& place : reader->map().attachments)
        files[place.name] = reader->attachment(place)->data;
    EXPECT_EQ(files["the_frames/tare.csv"], "time_s,t0,t1,t2,t3,t4,t5\n0,0.5,0,NA,1,2,3\n");
    EXPECT_EQ(files["the_frames/gains.csv"], "taxel,row,column,gain,gain_se,state\n"
                                             "0,0,0,1,NA,good\n1,0,1,1.25,NA,good\n2,0,2,NA,NA,dead\n"
                                             "3,1,0,1,NA,good\n4,1,1,1,NA,good\n5,1,2,1,NA,good\n");
    EXPECT_EQ(files["scene.toml"], "[scene]\n");
    EXPECT_EQ(files["configuration.json"], "{}");
    EXPECT_TRUE(files.contains("camera/camera.json"));
    const auto& note = reader->map().metadata.at(0);
    EXPECT_EQ(note.name, "teleta");
    // 77 ns before the anchor at 11:05:35.123.
    EXPECT_EQ(note.values.at("start_utc"), "2026-11-26T11:05:35.122999923Z");
    EXPECT_EQ(note.values.at("app_version"), "1.2.3");
}

TEST_F(McapRecording, picturesInColourComeBackInColour) {
    const std::string path = m_folder.path("looking.teleta");
    {
        recording::RecordingWriter writer(
            path, {{kStart_ns, QDateTime::fromString("2026-11-26T11:05:35.123Z", Qt::ISODateWithMs)}});
        ASSERT_TRUE(writer.begin(test::headAt(kStart_ns)));
        ASSERT_TRUE(writer.addStream({.name = "front-scene",
                                      .kind = StreamKind::camera,
                                      .type = ValueType::grey8,
                                      .source = "front",
                                      .shape = {0, 0, 3},
                                      .nominalRate_Hz = 30.0,
                                      .details = R"({"simulated":false})"}));
        for (int i = 0; i < 40; ++i)
            writer.take(0, pictureAt(kStart_ns + i * 1'000'003LL, static_cast<std::uint8_t>(i), 12));
        ASSERT_TRUE(writer.commit());
        ASSERT_TRUE(writer.finish());
    }
    const auto recording = recording::Recording::open(path);
    ASSERT_TRUE(recording) << core::describe(recording.error());
    const std::string file = m_folder.path("looking.mcap");
    ASSERT_TRUE(mcap::exportMcap(*recording, file, {}));
    const auto imported = mcap::importMcap(file, file + ".teleta");
    ASSERT_TRUE(imported) << core::describe(imported.error());
    expectSame(path, file + ".teleta");
    // Other programs see four pixels a row with 8 bits of each colour: type 2 of the PNG specification.
    const std::string png = mcap::encodePng(pictureAt(0, 1, 12).image, 6, mcap::PngPixel::colour);
    EXPECT_EQ(png.substr(12, 14), std::string("IHDR\0\0\0\4\0\0\0\3\x08\x02", 14));
    EXPECT_TRUE(picture::colourOfCoded(png));
}

TEST_F(McapRecording, onlyTheChosenStreamsAreWritten) {
    const auto recording = recording::Recording::open(recorded());
    const auto exported =
        mcap::exportMcap(*recording, m_folder.path("two.mcap"), {.streams = {"joints", "camera"}});
    ASSERT_TRUE(exported);
    ASSERT_EQ(exported->topics.size(), 4U);
    EXPECT_EQ(exported->topics[0].name, "/joints/joint_states");
    EXPECT_EQ(exported->topics[2].name, "/camera/image/compressed");
    EXPECT_EQ(exported->topics[2].messages, 40U);
    const auto unknown = mcap::exportMcap(*recording, m_folder.path("no.mcap"), {.streams = {"joint"}});
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().kind, core::ErrorKind::refused);
    EXPECT_NE(unknown.error().expected.find("joints"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(m_folder.path("no.mcap")));
}

TEST_F(McapRecording, cancelledWorkLeavesNoFileAndAnExistingOneStays) {
    const auto recording = recording::Recording::open(recorded());
    const std::size_t entries = m_folder.entries();
    const auto cancelled = mcap::exportMcap(*recording, m_folder.path("no.mcap"),
                                            {.goOn = [](double, double) { return false; }});
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().kind, core::ErrorKind::cancelled);
    EXPECT_EQ(m_folder.entries(), entries);
    const std::string file = m_folder.write("there.mcap", "old");
    const auto refused = mcap::exportMcap(*recording, file);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, core::ErrorKind::refused);
    EXPECT_EQ(test::readAll(file), "old");
    ASSERT_TRUE(mcap::exportMcap(*recording, file, {.overwrite = true}));
    const auto stopped =
        mcap::importMcap(file, m_folder.path("no.teleta"), {.goOn = [](double) { return false; }});
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().kind, core::ErrorKind::cancelled);
    EXPECT_EQ(m_folder.entries(), entries + 1);
}

TEST_F(McapRecording, aCutFileGivesWhatItHas) {
    const auto recording = recording::Recording::open(recorded());
    const std::string file = m_folder.path("run.mcap");
    ASSERT_TRUE(mcap::exportMcap(*recording, file, {.chunkBytes = 2000}));
    const std::string bytes = test::readAll(file);
    const auto cut = importedFrom(m_folder.write("cut.mcap", bytes.substr(0, bytes.size() / 2)));
    ASSERT_TRUE(cut) << core::describe(cut.error());
    EXPECT_FALSE(m_report->isComplete);
    EXPECT_LT(m_report->wholeBytes, m_report->bytes);
    EXPECT_GT(m_report->frames, 0U);
    EXPECT_FALSE(cut->isComplete());
}
