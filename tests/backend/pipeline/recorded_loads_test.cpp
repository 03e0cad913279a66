// SPDX-License-Identifier: GPL-3.0-or-later
// The calibration of an array's loads in the details of its stream.
#include "backend/pipeline/recorded/recorded_streams.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace teleta::pipeline {
namespace {

using equilibration::LoadCalibration;
using nlohmann::json;

constexpr core::ArrayLayout kLayout{.rows = 1, .columns = 2, .pitchX_m = 0.01};

core::SourceDescription described() {
    core::SourceDescription description;
    description.name = "pad";
    description.layout = kLayout;
    description.unit = "counts";
    return description;
}

ChannelSettings inCounts() {
    ChannelSettings settings;
    settings.loadUnit = "counts";
    return settings;
}

/// force_n = 0.5 (t0 - 10) + 0.25 (force_counts - 20), shear_x_n = 0.125 (t0 - 10) - 2 (force_counts - 20)
LoadCalibration twoLoads() {
    LoadCalibration calibration{.loads = {"force_n", "shear_x_n"}, .channels = {"t0", "force_counts"}};
    calibration.gain = (Eigen::MatrixXd(2, 2) << 0.5, 0.25, 0.125, -2.0).finished();
    calibration.error = (Eigen::MatrixXd(2, 2) << 0.01, 0.02, 0.0, 0.04).finished();
    calibration.rest = Eigen::Vector2d(10.0, 20.0);
    calibration.least = Eigen::Vector2d(8.0, 18.0);
    calibration.greatest = Eigen::Vector2d(30.0, 60.0);
    calibration.scatter = Eigen::Vector2d(0.03, 0.07);
    return calibration;
}

recording::StreamInfo calibrated() {
    const FrameLoads loads(twoLoads(), kLayout, "counts");
    return arrayStream("pad-frames", described(), inCounts(), &loads);
}

TEST(RecordedLoads, comeBackAsTheyWere) {
    const auto array = recordedArray(calibrated(), "file.teleta");
    ASSERT_TRUE(array) << core::describe(array.error());
    ASSERT_TRUE(array->loads);
    const LoadCalibration& found = array->loads->calibration();
    const LoadCalibration expected = twoLoads();
    EXPECT_EQ(found.loads, expected.loads);
    EXPECT_EQ(found.channels, expected.channels);
    EXPECT_EQ(found.gain, expected.gain);
    EXPECT_EQ(found.error, expected.error);
    EXPECT_EQ(found.rest, expected.rest);
    EXPECT_EQ(found.least, expected.least);
    EXPECT_EQ(found.greatest, expected.greatest);
    EXPECT_EQ(found.scatter, expected.scatter);
}

TEST(RecordedLoads, anArrayWithoutACalibrationHasNone) {
    const recording::StreamInfo stream = arrayStream("pad-frames", described(), inCounts());
    EXPECT_FALSE(json::parse(stream.details).contains("loads"));
    const auto array = recordedArray(stream, "file.teleta");
    ASSERT_TRUE(array) << core::describe(array.error());
    EXPECT_FALSE(array->loads);
}

TEST(RecordedLoads, anArraySaysWhetherItsLossesAreCounted) {
    for (const bool isCounted : {true, false}) {
        const auto array = recordedArray(
            arrayStream("pad-frames", described(), inCounts(), /*loads=*/nullptr, isCounted), "file.teleta");
        ASSERT_TRUE(array) << core::describe(array.error());
        EXPECT_EQ(array->countsLosses, isCounted);
    }
    // Files and sites of older versions do not say it.
    const recording::StreamInfo stream = arrayStream("pad-frames", described(), inCounts());
    EXPECT_FALSE(json::parse(stream.details).contains("counts_losses"));
}

TEST(RecordedLoads, refusesWhatIsNoCalibrationOfTheArray) {
    struct Case {
        const char* key;
        const char* value;
    };
    for (const Case& known :
         {Case{"names", R"(["force_n"])"}, Case{"names", R"(["force_n", "weight_n"])"},
          Case{"names", R"(["force_n", "force_n"])"}, Case{"names", "[]"}, Case{"signals", R"(["t0", "t2"])"},
          Case{"signals", R"(["t0", "t0"])"}, Case{"signals", R"(["t0", "force_n"])"},
          Case{"gain", "[[1, 2]]"}, Case{"gain", "[[1, 2], [3]]"}, Case{"gain", R"([[1, 2], [3, "4"]])"},
          Case{"gain", "[[1, 2], [3, null]]"}, Case{"gain_se", "[[0, 0], [0, -1]]"}, Case{"rest", "[1]"},
          Case{"least", "[31, 18]"}, Case{"greatest", "7"}, Case{"scatter", "[-0.1, 0.1]"}}) {
        recording::StreamInfo stream = calibrated();
        json details = json::parse(stream.details);
        details["loads"][known.key] = json::parse(known.value);
        stream.details = details.dump();
        const auto array = recordedArray(stream, "file.teleta");
        EXPECT_FALSE(array) << known.key << ": " << known.value;
        if (!array) {
            EXPECT_EQ(array.error().kind, core::ErrorKind::badInput);
            EXPECT_NE(core::describe(array.error()).find("pad-frames"), std::string::npos);
        }
        details["loads"].erase(known.key);
        stream.details = details.dump();
        EXPECT_FALSE(recordedArray(stream, "file.teleta")) << "without " << known.key;
    }
}

TEST(RecordedLoads, theTemperaturesOfTheTareComeBack) {
    ChannelSettings settings = inCounts();
    settings.conditioning.tare = {1.0F, 2.0F};
    settings.tareTemperatures_degC = {25.5F, -3.25F, 30.0F};
    const auto array = recordedArray(arrayStream("pad-frames", described(), settings), "file.teleta");
    ASSERT_TRUE(array) << core::describe(array.error());
    EXPECT_EQ(array->settings.tareTemperatures_degC, settings.tareTemperatures_degC);
}

} // namespace
} // namespace teleta::pipeline
