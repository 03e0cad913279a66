// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/mcap/cdr_writer.h"
#include "backend/mcap/mcap_reader.h"
#include "backend/mcap/mcap_writer.h"
#include "backend/mcap/recorded/mcap_export.h"
#include "backend/mcap/recorded/mcap_import.h"
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

namespace teleta::test {

using core::TappedFrames;
using mcap::CdrWriter;
using mcap::Compression;
using mcap::TopicKind;
using recording::StreamInfo;
using recording::StreamKind;
using recording::ValueType;

inline constexpr std::int64_t kStart_ns = 1'234'567'890'123;
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

template <typename Number>
inline TappedFrames framesOf(const std::vector<std::int64_t>& time_ns, const std::vector<Number>& values) {
    TappedFrames frames;
    frames.time_ns = time_ns;
    for (const std::int64_t time : time_ns)
        frames.sourceTime_s.push_back(static_cast<double>(time - kStart_ns) * 1e-9);
    const auto* bytes = reinterpret_cast<const std::byte*>(values.data());
    frames.values.assign(bytes, bytes + values.size() * sizeof(Number));
    return frames;
}

inline TappedFrames pictureAt(std::int64_t time_ns, std::uint8_t first, int width = 5) {
    constexpr int kHeight = 3;
    std::shared_ptr<std::uint8_t[]> pixels(new std::uint8_t[static_cast<std::size_t>(width * kHeight)]);
    for (int i = 0; i < width * kHeight; ++i)
        pixels[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(first + i * 7);
    TappedFrames frames = framesOf<float>({time_ns}, {});
    frames.image = {std::shared_ptr<const std::uint8_t>(pixels, pixels.get()), width, kHeight};
    return frames;
}

inline StreamInfo streamOf(const std::string& name, StreamKind kind,
                           const std::vector<recording::Column>& columns) {
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

inline StreamContent contentOf(const recording::Recording& recording, std::size_t stream) {
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

/// Recordings with a stream of each kind, and what became of them as MCAP.
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

inline void header(CdrWriter& cdr) {
    cdr.number(std::int32_t{1'790'000'000});
    cdr.number(std::uint32_t{5});
    cdr.text("somewhere");
}

template <typename Pixel>
inline void image(std::string& bytes, std::uint32_t rows, std::uint32_t columns, const char* encoding,
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
inline void points(std::string& bytes, const std::vector<std::string>& names,
                   const std::vector<double>& numbers) {
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

} // namespace teleta::test
