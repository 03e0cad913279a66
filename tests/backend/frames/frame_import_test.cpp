// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/recorded/frame_import.h"
#include "backend/pipeline/recorded/recorded_sources.h"
#include "backend/recording/recording.h"
#include "tests/backend/frames/frame_reading.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace teleta::frames {
namespace {

/// A recording that was read back.
struct ReadBack {
    std::vector<double> time_s;
    std::vector<float> values;
};

class FrameImportTest : public test::FrameReadingTest {
protected:
    core::Expected<FrameImport> import(const std::string& content, FrameRequest request = {},
                                       const FrameImportOptions& options = {}) {
        request.path = m_folder.write("frames.csv", content);
        TELETA_TRY(auto reader, FrameReader::open(request));
        return importFrames(std::move(reader), request.path, out(), options);
    }

    ReadBack readBack() {
        const auto recording = recording::Recording::open(out());
        EXPECT_TRUE(recording) << core::describe(recording.error());
        EXPECT_TRUE(recording->isComplete());
        ReadBack all;
        recording::StreamReader reader = recording->reader(0);
        core::TappedFrames block;
        const std::size_t channels = recording->streams()[0].channels();
        while (reader.next(block).value_or(false))
            for (std::size_t i = 0; i < block.frames(); ++i) {
                all.time_s.push_back(recording->time_s(block.time_ns[i]));
                const auto values = recording::valuesOf<float>(block, i, channels);
                all.values.insert(all.values.end(), values.begin(), values.end());
            }
        return all;
    }

    [[nodiscard]] std::string out() const { return m_folder.path("made.teleta"); }
    [[nodiscard]] bool isClean() const {
        return !std::filesystem::exists(out()) && !std::filesystem::exists(out() + ".part");
    }
};

/// Own CSV of two taxels: frame i at first + i / 100 s has the values i and -i.
std::string csv(int frames, double first_s = 5.0) {
    std::string text = "time_s,t0,t1\n";
    for (int i = 0; i < frames; ++i) {
        char row[64];
        std::snprintf(row, sizeof row, "%.6f,%d,%d\n", first_s + 0.01 * i, i, -i);
        text += row;
    }
    return text;
}

FrameRequest twoTaxels() {
    FrameRequest request;
    request.rows = 1;
    request.columns = 2;
    return request;
}

} // namespace

TEST_F(FrameImportTest, everyFrameIsThereAtItsTimeSinceTheFirst) {
    constexpr int kFrames = 1000; // several blocks
    const auto made = import(csv(kFrames), twoTaxels());
    ASSERT_TRUE(made) << core::describe(made.error());
    EXPECT_EQ(made->frames, 1000U);
    EXPECT_NEAR(made->rate_Hz, 100.0, 1e-6);
    EXPECT_EQ(made->stream, "frames-frames");
    const ReadBack back = readBack();
    ASSERT_EQ(back.time_s.size(), 1000U);
    for (int i = 0; i < kFrames; ++i) {
        const auto at = static_cast<std::size_t>(i);
        EXPECT_NEAR(back.time_s[at], 0.01 * i, 1e-9);
        EXPECT_EQ(back.values[2 * at], static_cast<float>(i));
        EXPECT_EQ(back.values[2 * at + 1], static_cast<float>(-i));
    }
    EXPECT_FALSE(std::filesystem::exists(out() + ".part"));
}

TEST_F(FrameImportTest, itIsPlayedAsTheOptionsSay) {
    FrameImportOptions options;
    options.name = "glove";
    options.settings.loadUnit = "counts";
    options.settings.conditioning.gain = 0.5;
    options.settings.conditioning.tare = {1.0F, 2.0F};
    options.settings.features.threshold_N = 7.0;
    FrameRequest request = twoTaxels();
    request.pitch_m = 0.002;
    ASSERT_TRUE(import(csv(3), request, options));
    const auto recording = recording::Recording::open(out());
    ASSERT_TRUE(recording);
    const auto sources = pipeline::recordedSources(*recording);
    ASSERT_TRUE(sources) << core::describe(sources.error());
    ASSERT_EQ(sources->arrays.size(), 1U);
    const pipeline::RecordedArray& array = sources->arrays[0].array;
    EXPECT_EQ(array.description.name, "glove");
    EXPECT_EQ(array.description.layout.grid().columns, 2);
    EXPECT_EQ(array.description.layout.grid().pitchX_m, 0.002);
    EXPECT_FALSE(array.description.simulated);
    EXPECT_NEAR(array.description.nominalRate_Hz, 100.0, 1e-6);
    EXPECT_EQ(array.settings.loadUnit, "counts");
    EXPECT_EQ(array.settings.conditioning.gain, 0.5);
    EXPECT_EQ(array.settings.conditioning.tare, (std::vector<float>{1.0F, 2.0F}));
    EXPECT_EQ(array.settings.features.threshold_N, 7.0);
}

TEST_F(FrameImportTest, theWallClockIsKnownWhereTheTimesAreSecondsSince1970) {
    ASSERT_TRUE(import(csv(3, 1'790'000'000.5), twoTaxels()));
    const auto recording = recording::Recording::open(out());
    ASSERT_TRUE(recording);
    ASSERT_EQ(recording->anchors().size(), 1U);
    EXPECT_EQ(recording->anchors()[0].time_ns, 0);
    EXPECT_EQ(recording->anchors()[0].utc.toMSecsSinceEpoch(), 1'790'000'000'500);
}

TEST_F(FrameImportTest, otherwiseItIsNotKnown) {
    ASSERT_TRUE(import(csv(3), twoTaxels()));
    const auto recording = recording::Recording::open(out());
    ASSERT_TRUE(recording);
    EXPECT_TRUE(recording->anchors().empty());
}

TEST_F(FrameImportTest, aSingleFrameHasNoRate) {
    const auto made = import(csv(1), twoTaxels());
    ASSERT_TRUE(made) << core::describe(made.error());
    EXPECT_EQ(made->rate_Hz, 0.0);
    EXPECT_EQ(readBack().time_s, std::vector<double>{0.0});
}

TEST_F(FrameImportTest, deadTaxelsStayNoNumbers) {
    ASSERT_TRUE(import("time_s,t0,t1\n0,1,nan\n1,2,nan\n", twoTaxels()));
    const ReadBack back = readBack();
    ASSERT_EQ(back.values.size(), 4U);
    EXPECT_EQ(back.values[2], 2.0F);
    EXPECT_TRUE(std::isnan(back.values[1]) && std::isnan(back.values[3]));
}

TEST_F(FrameImportTest, aDamagedRowLeavesNoRecording) {
    const auto made = import(csv(600) + "6.0,1\n", twoTaxels());
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().where.line, 602);
    EXPECT_TRUE(isClean());
}

TEST_F(FrameImportTest, aNameThatIsTakenIsRefused) {
    const std::string there = m_folder.write("made.teleta", "mine");
    const auto made = import(csv(3), twoTaxels());
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().kind, core::ErrorKind::refused);
    EXPECT_EQ(std::filesystem::file_size(there), 4U);
}

TEST_F(FrameImportTest, oneThatIsCancelledLeavesNothing) {
    FrameImportOptions options;
    options.goOn = [](double) { return false; };
    const auto made = import(csv(3), twoTaxels(), options);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().kind, core::ErrorKind::cancelled);
    EXPECT_TRUE(isClean());
}

} // namespace teleta::frames
