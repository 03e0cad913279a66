// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/cdr_writer.h"
#include "backend/mcap/mcap_reader.h"
#include "backend/mcap/mcap_writer.h"
#include "backend/mcap/recorded/mcap_export.h"
#include "backend/mcap/recorded/mcap_import.h"
#include "backend/mcap/recorded/picture_decoder.h"
#include "backend/mcap/recorded/png_encoder.h"
#include "backend/mcap/ros_schemas.h"
#include "backend/pipeline/recorded/recorded_layout.h"
#include "backend/recording/recording_writer.h"
#include "backend/recording/stream_columns.h"
#include "tests/backend/recording/recorded_files.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

using namespace teleta;
using core::TappedFrames;
using mcap::CdrWriter;
using mcap::Compression;
using mcap::TopicKind;
using recording::StreamInfo;
using recording::StreamKind;
using recording::ValueType;

namespace {

constexpr std::int64_t kStart_ns = 1'234'567'890'123;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

template <typename Number>
TappedFrames framesOf(const std::vector<std::int64_t>& time_ns, const std::vector<Number>& values) {
    TappedFrames frames;
    frames.time_ns = time_ns;
    for (const std::int64_t time : time_ns)
        frames.sourceTime_s.push_back(static_cast<double>(time - kStart_ns) * 1e-9);
    const auto* bytes = reinterpret_cast<const std::byte*>(values.data());
    frames.values.assign(bytes, bytes + values.size() * sizeof(Number));
    return frames;
}

TappedFrames pictureAt(std::int64_t time_ns, std::uint8_t first, int width = 5) {
    constexpr int kHeight = 3;
    std::shared_ptr<std::uint8_t[]> pixels(new std::uint8_t[static_cast<std::size_t>(width * kHeight)]);
    for (int i = 0; i < width * kHeight; ++i)
        pixels[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(first + i * 7);
    TappedFrames frames = framesOf<float>({time_ns}, {});
    frames.image = {std::shared_ptr<const std::uint8_t>(pixels, pixels.get()), width, kHeight};
    return frames;
}

StreamInfo streamOf(const std::string& name, StreamKind kind, const std::vector<recording::Column>& columns) {
    return {.name = name,
            .kind = kind,
            .type = ValueType::float64,
            .source = "the source of " + name,
            .shape = {columns.size()},
            .columns = columns};
}

/// All frames of a stream, as bytes.
struct StreamContent {
    std::vector<std::int64_t> time_ns;
    std::vector<std::byte> values;
    std::vector<std::vector<std::uint8_t>> pictures;

    bool operator==(const StreamContent&) const = default;
};

StreamContent contentOf(const recording::Recording& recording, std::size_t stream) {
    StreamContent content;
    recording::StreamReader reader = recording.reader(stream);
    TappedFrames block;
    while (reader.next(block).value_or(false)) {
        content.time_ns.insert(content.time_ns.end(), block.time_ns.begin(), block.time_ns.end());
        content.values.insert(content.values.end(), block.values.begin(), block.values.end());
        if (!block.image.isEmpty()) {
            const auto* pixels = block.image.pixels.get();
            content.pictures.emplace_back(pixels, pixels + block.image.width_px * block.image.height_px);
        }
    }
    return content;
}

class McapRecording : public testing::Test {
protected:
    McapRecording() { test::makeApplication(); }

    /// One stream of each kind, odd times and values, two anchors, marks.
    std::string recorded() {
        const std::string path = m_folder.path("run.teleta");
        const QDateTime utc = QDateTime::fromString("2026-11-26T11:05:35.123Z", Qt::ISODateWithMs);
        recording::RecordingWriter writer(
            path, {{kStart_ns + 77, utc}, {kStart_ns + 5'000'000, utc.addSecs(3600)}});
        EXPECT_TRUE(writer.begin(test::headAt(kStart_ns)));
        StreamInfo array = test::arrayInfo("the frames");
        array.details =
            R"({"pitch_m":0.0034,"settings":{"tare":[0.5,0,null,1,2,3],"taxel_gains":[1,1.25,null,1,1,1]}})";
        StreamInfo camera{.name = "camera",
                          .kind = StreamKind::camera,
                          .type = ValueType::grey8,
                          .source = "eye",
                          .shape = {3, 5},
                          .details = R"({"camera":{"mirrored":true}})"};
        StreamInfo contacts = streamOf("contacts", StreamKind::contacts, recording::contactColumns());
        contacts.source = "eye";
        StreamInfo tactors = test::arrayInfo("bracelet");
        tactors.kind = StreamKind::tactors;
        tactors.shape = {6};
        StreamInfo vectors = test::arrayInfo("vectors");
        vectors.shape = {3, 3};
        vectors.columns = pipeline::componentColumns({core::ArrayLayout{1, 3}, 3}, vectors.unit);
        vectors.details = R"({"components":3,"positions_m":[[0,0,0],[0.004,0.001,0],[0.009,0,0.002]]})";
        const StreamInfo all[] = {array,
                                  vectors,
                                  streamOf("features", StreamKind::features, recording::featureColumns()),
                                  recording::jointStream(1000.0, 4),
                                  streamOf("touches", StreamKind::touches, recording::touchColumns()),
                                  camera,
                                  contacts,
                                  tactors,
                                  streamOf("wrench", StreamKind::wrench, recording::wrenchColumns()),
                                  streamOf("chips", StreamKind::numbers, recording::temperatureColumns(5))};
        std::size_t number = 0;
        for (const StreamInfo& info : all) {
            EXPECT_TRUE(writer.addStream(info));
            for (int i = 0; i < 40; ++i)
                writer.take(number, frameOf(info, i));
            ++number;
        }
        writer.take({.time_ns = kStart_ns + 3,
                     .kind = recording::kMark,
                     .text = "a \"mark\", \xc3\xa9",
                     .value = 1.0});
        writer.take({.time_ns = kStart_ns + 50'000'000, .kind = recording::kStopped, .text = {}});
        EXPECT_TRUE(writer.commit());
        EXPECT_TRUE(writer.finish());
        return path;
    }

    static TappedFrames frameOf(const StreamInfo& info, int i) {
        const std::int64_t time_ns = kStart_ns + i * 1'000'003LL;
        if (info.type == ValueType::grey8)
            return pictureAt(time_ns, static_cast<std::uint8_t>(i));
        if (info.type == ValueType::float32) {
            std::vector<float> values(info.channels());
            for (std::size_t channel = 0; channel < values.size(); ++channel)
                values[channel] = static_cast<float>(i) / 3.0F - static_cast<float>(channel);
            values[0] = std::numeric_limits<float>::quiet_NaN();
            values[1] = -std::numeric_limits<float>::infinity();
            return framesOf(std::vector{time_ns}, values);
        }
        // Contacts: two at a time, every other time.
        const bool isTwice = info.kind == StreamKind::contacts && i % 2 == 0;
        std::vector<double> values;
        for (int copy = 0; copy < (isTwice ? 2 : 1); ++copy) {
            for (std::size_t channel = 0; channel < info.channels(); ++channel) {
                double value = static_cast<double>(i + copy) / 3.0 - static_cast<double>(channel);
                if (channel == 0 && info.kind == StreamKind::features)
                    value = i % 3;
                else if (channel == 1)
                    value = 0.0;
                else if (channel + 1 == info.channels())
                    value = kNaN;
                values.push_back(value);
            }
        }
        return framesOf(std::vector<std::int64_t>(isTwice ? 2 : 1, time_ns), values);
    }

    void expectSame(const std::string& path, const std::string& other) {
        const auto a = recording::Recording::open(path);
        const auto b = recording::Recording::open(other);
        ASSERT_TRUE(a) << core::describe(a.error());
        ASSERT_TRUE(b) << core::describe(b.error());
        EXPECT_EQ(a->head().start_ns, b->head().start_ns);
        EXPECT_EQ(a->head().appVersion, b->head().appVersion);
        EXPECT_EQ(a->head().scene, b->head().scene);
        EXPECT_EQ(a->head().sceneText, b->head().sceneText);
        EXPECT_EQ(a->head().configuration, b->head().configuration);
        ASSERT_EQ(a->anchors().size(), b->anchors().size());
        for (std::size_t i = 0; i < a->anchors().size(); ++i) {
            EXPECT_EQ(a->anchors()[i].time_ns, b->anchors()[i].time_ns);
            EXPECT_EQ(a->anchors()[i].utc, b->anchors()[i].utc);
        }
        ASSERT_EQ(a->events().size(), b->events().size());
        for (std::size_t i = 0; i < a->events().size(); ++i) {
            EXPECT_EQ(a->events()[i].time_ns, b->events()[i].time_ns);
            EXPECT_EQ(a->events()[i].kind, b->events()[i].kind);
            EXPECT_EQ(a->events()[i].text, b->events()[i].text);
            EXPECT_EQ(a->events()[i].value, b->events()[i].value);
        }
        ASSERT_EQ(a->streams().size(), b->streams().size());
        for (std::size_t i = 0; i < a->streams().size(); ++i) {
            const StreamInfo& stream = a->streams()[i];
            EXPECT_EQ(stream.name, b->streams()[i].name);
            EXPECT_EQ(stream.kind, b->streams()[i].kind);
            EXPECT_EQ(stream.source, b->streams()[i].source);
            EXPECT_EQ(stream.shape, b->streams()[i].shape);
            EXPECT_EQ(stream.unit, b->streams()[i].unit);
            EXPECT_EQ(stream.nominalRate_Hz, b->streams()[i].nominalRate_Hz);
            EXPECT_EQ(stream.details, b->streams()[i].details);
            ASSERT_EQ(stream.columns.size(), b->streams()[i].columns.size());
            for (std::size_t column = 0; column < stream.columns.size(); ++column) {
                EXPECT_EQ(stream.columns[column].name, b->streams()[i].columns[column].name);
                EXPECT_EQ(stream.columns[column].unit, b->streams()[i].columns[column].unit);
            }
            const StreamContent content = contentOf(*a, i);
            EXPECT_GE(content.time_ns.size(), 40U);
            EXPECT_TRUE(content == contentOf(*b, i)) << stream.name;
        }
    }

    /// A file of another program with one topic.
    template <typename Encode>
    std::string foreign(const std::string& type, const std::string& topic, int messages,
                        const Encode& encode) {
        const std::string path = m_folder.path("foreign.mcap");
        auto writer = mcap::McapWriter::create(path, {});
        EXPECT_TRUE(writer);
        const std::uint16_t channel = writer->addChannel(
            writer->addSchema(type, mcap::schemaText(mcap::rosDefinition(type), "std_msgs")), topic);
        for (int i = 0; i < messages; ++i)
            writer->addMessage(channel, 0, kLog_ns + static_cast<std::uint64_t>(i) * 5'000'001,
                               [&](std::string& bytes) { encode(i, bytes); });
        EXPECT_TRUE(writer->finish());
        return path;
    }

    core::Expected<recording::Recording> importedFrom(const std::string& path,
                                                      const mcap::McapImportOptions& options = {}) {
        std::filesystem::remove(m_folder.path("in.teleta"));
        m_report = mcap::importMcap(path, m_folder.path("in.teleta"), options);
        if (!m_report)
            return core::Unexpected(m_report.error());
        return recording::Recording::open(m_folder.path("in.teleta"));
    }

    static constexpr std::uint64_t kLog_ns = 1'790'000'000'123'456'789U;
    test::TemporaryFolder m_folder;
    core::Expected<mcap::McapImport> m_report;
};

void header(CdrWriter& cdr) {
    cdr.number(std::int32_t{1'790'000'000});
    cdr.number(std::uint32_t{5});
    cdr.text("somewhere");
}

template <typename Pixel>
void image(std::string& bytes, std::uint32_t rows, std::uint32_t columns, const char* encoding,
           std::vector<Pixel> pixels) {
    CdrWriter cdr(bytes);
    header(cdr);
    cdr.number(rows);
    cdr.number(columns);
    cdr.text(encoding);
    cdr.number(std::uint8_t{0});
    cdr.number(static_cast<std::uint32_t>(columns * sizeof(Pixel)));
    cdr.byteSequence({reinterpret_cast<const char*>(pixels.data()), pixels.size() * sizeof(Pixel)});
}

/// Points of doubles, big-endian within, with one field more than is read.
void points(std::string& bytes, const std::vector<std::string>& names, const std::vector<double>& numbers) {
    CdrWriter cdr(bytes);
    header(cdr);
    const auto step = static_cast<std::uint32_t>(names.size() * sizeof(double));
    const auto width = static_cast<std::uint32_t>(numbers.size() / names.size());
    cdr.number(std::uint32_t{1});
    cdr.number(width);
    cdr.number(static_cast<std::uint32_t>(names.size()));
    for (std::size_t i = 0; i < names.size(); ++i) {
        cdr.text(names[i]);
        cdr.number(static_cast<std::uint32_t>(i * sizeof(double)));
        cdr.number(std::uint8_t{8}); // FLOAT64
        cdr.number(std::uint32_t{1});
    }
    cdr.number(std::uint8_t{1}); // is_bigendian
    cdr.number(step);
    cdr.number(step * width);
    std::string data;
    for (const double number : numbers) {
        const auto copy = std::bit_cast<std::array<char, sizeof(double)>>(number);
        data.append(copy.rbegin(), copy.rend());
    }
    cdr.byteSequence({data.data(), data.size()});
    cdr.number(std::uint8_t{1});
}

} // namespace

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
    EXPECT_TRUE(mcap::decodePicture(png, mcap::PngPixel::colour));
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

TEST_F(McapRecording, anImageOfFloatsIsAnArray) {
    const auto recording =
        importedFrom(foreign("sensor_msgs/msg/Image", "/tactile/left", 30, [](int i, std::string& bytes) {
            image<float>(bytes, 2, 3, "32FC1", {0.5F, 1.0F, 2.0F, 3.0F, 4.0F, static_cast<float>(i)});
        }));
    ASSERT_TRUE(recording) << core::describe(recording.error());
    ASSERT_EQ(recording->streams().size(), 1U);
    const StreamInfo& stream = recording->streams()[0];
    EXPECT_EQ(stream.name, "tactile_left");
    EXPECT_EQ(stream.kind, StreamKind::array);
    EXPECT_EQ(stream.shape, (std::vector<std::size_t>{2, 3}));
    EXPECT_NEAR(stream.nominalRate_Hz, 200.0, 0.001);
    EXPECT_TRUE(recording->isComplete());
    const test::ReadFrames frames = test::readAllFrames(recording->reader(0));
    ASSERT_EQ(frames.time_ns.size(), 30U);
    EXPECT_EQ(frames.values[5 + 6 * 29], 29.0F);
    // UTC to 1 ns, though an anchor has milliseconds.
    const auto& anchor = recording->anchors().at(0);
    EXPECT_EQ(frames.time_ns[7] - anchor.time_ns + anchor.utc.toMSecsSinceEpoch() * 1'000'000,
              static_cast<std::int64_t>(kLog_ns) + 7 * 5'000'001);
}

TEST_F(McapRecording, pointsWithForcesAreAnArrayOfVectorsWhereTheyStand) {
    const auto recording =
        importedFrom(foreign("sensor_msgs/msg/PointCloud2", "/skin", 4, [](int i, std::string& bytes) {
            points(bytes, {"force_z", "x", "y", "z", "intensity", "force_x", "force_y"},
                   {-1.5, 0.0, 0.0, 0.0, 9.0, 0.25, 0.5, -static_cast<double>(i), 0.004, 0.001, 0.0, 9.0, 0.0,
                    0.0});
        }));
    ASSERT_TRUE(recording) << core::describe(recording.error());
    ASSERT_EQ(recording->streams().size(), 1U);
    const StreamInfo& stream = recording->streams()[0];
    EXPECT_EQ(stream.kind, StreamKind::array);
    EXPECT_EQ(stream.shape, (std::vector<std::size_t>{2, 3}));
    EXPECT_EQ(stream.unit, "N");
    const auto layout = pipeline::layoutOf(stream);
    ASSERT_TRUE(layout);
    EXPECT_FALSE(layout->isGrid());
    EXPECT_NEAR(layout->x_m(1), 0.004, 1e-12);
    const test::ReadFrames frames = test::readAllFrames(recording->reader(0));
    ASSERT_EQ(frames.time_ns.size(), 4U);
    EXPECT_EQ(frames.values[0], 0.25F);
    EXPECT_EQ(frames.values[2], -1.5F);
    EXPECT_EQ(frames.values[3 * 6 + 5], -3.0F);
}

TEST_F(McapRecording, pointsOfADepthCameraAndDamagedOnesAreNoArray) {
    const auto depth =
        importedFrom(foreign("sensor_msgs/msg/PointCloud2", "/depth", 3, [](int, std::string& bytes) {
            points(bytes, {"x", "y", "z", "intensity"}, {0.0, 0.0, 1.0, 3.0});
        }));
    ASSERT_TRUE(depth) << core::describe(depth.error());
    EXPECT_TRUE(depth->streams().empty());
    EXPECT_EQ(m_report->topics.at(0).messages, 0U);
    const auto other =
        importedFrom(foreign("sensor_msgs/msg/PointCloud2", "/skin", 5, [](int i, std::string& bytes) {
            std::vector<double> numbers{0.0, 0.0, 0.0, 1.0};
            if (i == 1)
                numbers.insert(numbers.end(), {1.0, 0.0, 0.0, 1.0}); // another number of points
            if (i == 2)
                numbers[0] = std::numeric_limits<double>::infinity();
            points(bytes, {"x", "y", "z", "value"}, numbers);
            if (i == 3)
                bytes.resize(bytes.size() - 20);
        }));
    ASSERT_TRUE(other) << core::describe(other.error());
    EXPECT_EQ(m_report->topics.at(0).messages, 2U);
    EXPECT_EQ(m_report->topics.at(0).bad, 3U);
}

/// The fields say what a cloud is, not its first points.
TEST_F(McapRecording, pointsOfTaxelsMayBeginWithADamagedMessage) {
    for (const int kind : {0, 1, 2}) {
        const auto recording = importedFrom(
            foreign("sensor_msgs/msg/PointCloud2", "/skin", 4, [kind](int i, std::string& bytes) {
                std::vector<double> numbers{0.0, 0.0, 0.0, 1.0};
                if (i == 0 && kind == 0)
                    numbers[0] = std::numeric_limits<double>::infinity();
                if (i == 0 && kind == 1)
                    numbers.clear(); // no point yet
                points(bytes, {"x", "y", "z", "value"}, numbers);
                if (i == 0 && kind == 2)
                    bytes.resize(bytes.size() - 90); // within the fields
            }));
        ASSERT_TRUE(recording) << core::describe(recording.error());
        ASSERT_EQ(recording->streams().size(), 1U) << kind;
        EXPECT_EQ(recording->streams()[0].kind, StreamKind::array);
        EXPECT_EQ(m_report->topics.at(0).messages, 3U) << kind;
        EXPECT_EQ(m_report->topics.at(0).bad, 1U) << kind;
    }
}

TEST_F(McapRecording, numbersWithOtherNamesAreBad) {
    const auto recording =
        importedFrom(foreign("teleta_msgs/msg/Numbers", "/chips", 4, [](int i, std::string& bytes) {
            CdrWriter cdr(bytes);
            header(cdr);
            cdr.number(std::uint32_t{2});
            cdr.text("one");
            cdr.text(i == 2 ? "other" : "two");
            cdr.number(std::uint32_t{2});
            cdr.number(1.5);
            cdr.number(static_cast<double>(i));
        }));
    ASSERT_TRUE(recording) << core::describe(recording.error());
    EXPECT_EQ(m_report->topics.at(0).messages, 3U);
    EXPECT_EQ(m_report->topics.at(0).bad, 1U);
    ASSERT_EQ(recording->streams().size(), 1U);
    EXPECT_EQ(recording->streams()[0].columns.at(1).name, "two");
}

TEST_F(McapRecording, plainGreyImagesAreACameraUnlessAPersonSaysOtherwise) {
    const auto write = [](int i, std::string& bytes) {
        image<std::uint8_t>(bytes, 2, 2, "mono8", {1, 2, 3, static_cast<std::uint8_t>(i)});
    };
    const std::string file = foreign("sensor_msgs/msg/Image", "/eye", 3, write);
    auto recording = importedFrom(file);
    ASSERT_TRUE(recording);
    EXPECT_EQ(recording->streams().at(0).kind, StreamKind::camera);
    EXPECT_EQ(contentOf(*recording, 0).pictures.at(2), (std::vector<std::uint8_t>{1, 2, 3, 2}));
    recording = importedFrom(file, {.topics = {{"/eye", TopicKind::array}}});
    ASSERT_TRUE(recording);
    EXPECT_EQ(recording->streams().at(0).kind, StreamKind::array);
    const auto refused = importedFrom(file, {.topics = {{"/eye", TopicKind::joints}}});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, core::ErrorKind::refused);
    const auto unknown = importedFrom(file, {.topics = {{"/nose", TopicKind::array}}});
    ASSERT_FALSE(unknown);
    EXPECT_NE(unknown.error().expected.find("/eye"), std::string::npos);
}

TEST_F(McapRecording, imagesOf16BitsKeepTheirValues) {
    const auto recording =
        importedFrom(foreign("sensor_msgs/msg/Image", "/mat", 1, [](int, std::string& bytes) {
            image<std::uint16_t>(bytes, 1, 6, "16UC1", {0, 1, 256, 1000, 65534, 65535});
        }));
    ASSERT_TRUE(recording);
    const StreamContent content = contentOf(*recording, 0);
    std::vector<float> values(6);
    std::memcpy(values.data(), content.values.data(), content.values.size());
    EXPECT_EQ(values, (std::vector<float>{0.0F, 1.0F, 256.0F, 1000.0F, 65534.0F, 65535.0F}));
}

TEST_F(McapRecording, jointStatesWithoutEffortHaveNoTorque) {
    const auto recording =
        importedFrom(foreign("sensor_msgs/msg/JointState", "/joint_states", 3, [](int i, std::string& bytes) {
            CdrWriter cdr(bytes);
            header(cdr);
            cdr.number(std::uint32_t{2});
            cdr.text("a");
            cdr.text("b");
            const std::array<double, 2> position{static_cast<double>(i), 2.0};
            cdr.sequence(std::span<const double>(position));
            cdr.sequence(std::span<const double>());
            cdr.sequence(std::span<const double>());
        }));
    ASSERT_TRUE(recording);
    EXPECT_EQ(recording->streams().at(0).kind, StreamKind::joints);
    const StreamContent content = contentOf(*recording, 0);
    std::vector<double> values(content.values.size() / sizeof(double));
    std::memcpy(values.data(), content.values.data(), content.values.size());
    ASSERT_EQ(values.size(), 18U);
    EXPECT_EQ(values[6], 1.0);
    EXPECT_TRUE(std::isnan(values[8]));
}

TEST_F(McapRecording, aMultiArrayOfTwoDimensionsIsAnArrayRowByRow) {
    const auto write = [](int i, std::string& bytes) {
        CdrWriter cdr(bytes);
        cdr.number(std::uint32_t{i == 2 ? 1U : 2U});
        for (int dimension = 0; dimension < (i == 2 ? 1 : 2); ++dimension) {
            cdr.text("d");
            cdr.number(std::uint32_t{2});
            cdr.number(std::uint32_t{dimension == 0 ? 6U : 3U});
        }
        cdr.number(std::uint32_t{1}); // data_offset
        constexpr std::array<float, 7> kData{9.0F, 1.0F, 2.0F, 9.0F, 3.0F, 4.0F, 9.0F};
        cdr.sequence(std::span<const float>(kData));
    };
    const auto recording = importedFrom(foreign("std_msgs/msg/Float32MultiArray", "/grid", 3, write));
    ASSERT_TRUE(recording);
    const StreamContent content = contentOf(*recording, 0);
    ASSERT_EQ(content.time_ns.size(), 2U) << "one of a single dimension is none";
    std::vector<float> values(8);
    std::memcpy(values.data(), content.values.data(), content.values.size());
    EXPECT_EQ(values, (std::vector<float>{1.0F, 2.0F, 3.0F, 4.0F, 1.0F, 2.0F, 3.0F, 4.0F}));
    EXPECT_EQ(m_report->topics.at(0).bad, 1U);
}

TEST_F(McapRecording, messagesOfAnotherShapeAndDamagedOnesAreCounted) {
    const auto recording =
        importedFrom(foreign("sensor_msgs/msg/Image", "/mat", 4, [](int i, std::string& bytes) {
            if (i == 1)
                bytes += "rubbish";
            else
                image<float>(bytes, i == 2 ? 2 : 1, 1, "32FC1", std::vector<float>(i == 2 ? 2 : 1, 1.0F));
        }));
    ASSERT_TRUE(recording);
    EXPECT_EQ(m_report->topics.at(0).messages, 2U);
    EXPECT_EQ(m_report->topics.at(0).bad, 2U);
}

TEST_F(McapRecording, aFileWithoutReadableTopicsIsRefusedWithItsList) {
    const auto refused = importedFrom(
        foreign("std_msgs/msg/Header", "/chatter", 1, [](int, std::string& bytes) { bytes += "x"; }));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, core::ErrorKind::refused);
    EXPECT_NE(refused.error().message.find("/chatter (cdr, std_msgs/msg/Header)"), std::string::npos)
        << refused.error().message;
    EXPECT_FALSE(std::filesystem::exists(m_folder.path("in.teleta")));
    EXPECT_FALSE(std::filesystem::exists(m_folder.path("in.teleta.part")));
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
