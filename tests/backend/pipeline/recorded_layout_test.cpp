// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/recording/stream_columns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace teleta::pipeline {
namespace {

using core::ArrayLayout;
using core::TaxelLayout;
using core::TaxelPlace;
using core::TaxelPlaces;

core::SourceDescription described(const TaxelLayout& layout, const std::string& unit = "N") {
    core::SourceDescription description;
    description.name = "pad";
    description.layout = layout;
    description.unit = unit;
    return description;
}

std::shared_ptr<const TaxelPlaces> somePlaces() {
    return std::make_shared<const TaxelPlaces>(
        std::vector<TaxelPlace>{{0.001, 0.002, 0.0003}, {-0.004, 0.0, 0.0, {0.6, 0.0, 0.8}}});
}

TEST(RecordedLayout, comesBackAsItWas) {
    TaxelLayout masked(ArrayLayout{2, 2, 0.004}, 3);
    masked.setAbsent({0, 0, 1, 0});
    const std::vector<TaxelLayout> layouts{
        ArrayLayout{2, 3, 0.004},
        ArrayLayout{2, 3, 0.004, 0.010},
        TaxelLayout(ArrayLayout{2, 3, 0.004}, 3),
        TaxelLayout(ArrayLayout{2, 3, 0.004, 0.010}, 3),
        masked,
        TaxelLayout(somePlaces()),
        TaxelLayout(somePlaces(), 3),
    };
    for (const TaxelLayout& layout : layouts) {
        ChannelSettings settings;
        settings.conditioning.tare.assign(layout.values(), 0.25F);
        const recording::StreamInfo stream = arrayStream("pad-frames", described(layout, "counts"), settings);
        EXPECT_EQ(stream.channels(), layout.values());
        EXPECT_EQ(recording::isVectorArray(stream), layout.isVector());
        const auto array = recordedArray(stream, "file.teleta");
        ASSERT_TRUE(array) << core::describe(array.error());
        EXPECT_EQ(array->description.layout, layout) << stream.details;
        EXPECT_EQ(array->description.unit, "counts");
        EXPECT_EQ(array->settings.conditioning.tare, settings.conditioning.tare);
    }
}

TEST(RecordedLayout, readsTheFilesOfOlderVersions) {
    recording::StreamInfo stream{.name = "pad-frames", .shape = {2, 3}};
    stream.details = R"({"pitch_m": 0.0034, "settings": {}})";
    const auto array = recordedArray(stream, "file.teleta");
    ASSERT_TRUE(array) << core::describe(array.error());
    EXPECT_EQ(array->description.layout, (ArrayLayout{2, 3, 0.0034}));
}

TEST(RecordedLayout, refusesWhatIsNoLayout) {
    struct Case {
        std::vector<std::size_t> shape;
        const char* details;
    };
    for (
        const Case& known : {
            Case{{2, 3}, R"({"settings": {}})"},
            Case{{2, 3, 3}, R"({"pitch_m": 0.004, "settings": {}})"},
            Case{{0, 3}, R"({"pitch_m": 0.004, "settings": {}})"},
            Case{{1025, 1}, R"({"pitch_m": 0.004, "settings": {}})"},
            Case{{2, 3}, R"({"pitch_x_m": 0.004, "settings": {}})"},
            Case{{2, 3}, R"({"pitch_x_m": 0.004, "pitch_y_m": 0, "settings": {}})"},
            Case{{2, 3}, R"({"pitch_m": 0.004, "mask": [6], "settings": {}})"},
            Case{
                {5, 3},
                R"({"components": 3, "rows": 2, "columns": 3, "pitch_x_m": 1, "pitch_y_m": 1, "settings": {}})"},
            Case{
                {6, 2},
                R"({"components": 3, "rows": 2, "columns": 3, "pitch_x_m": 1, "pitch_y_m": 1, "settings": {}})"},
            Case{{2}, R"({"positions_m": [[0, 0, 0]], "settings": {}})"},
            Case{{2}, R"({"positions_m": [[0, 0, 0], [0, 0]], "settings": {}})"},
            Case{{2}, R"({"positions_m": [[0, 0, 0], [0, 0, 0]], "settings": {}})"},
            Case{{1}, R"({"positions_m": [[0, 0, 0]], "normals": [[0, 0, 2]], "settings": {}})"},
            Case{{1}, R"({"positions_m": [[0, 0, 0]], "normals": [[0, 0, 0.5]], "settings": {}})"},
        }) {
        recording::StreamInfo stream{.name = "pad-frames", .shape = known.shape};
        stream.details = known.details;
        EXPECT_FALSE(recordedArray(stream, "file.teleta")) << known.details;
    }
}

TEST(RecordedLayout, namesTheComponentsOfEachTaxel) {
    const auto stream = arrayStream("pad-frames", described(TaxelLayout(somePlaces(), 3)), {});
    EXPECT_EQ(stream.shape, (std::vector<std::size_t>{2, 3}));
    std::vector<std::string> names;
    for (const recording::Column& column : stream.columns)
        names.push_back(column.name);
    EXPECT_EQ(names, (std::vector<std::string>{"t0_x", "t0_y", "t0_z", "t1_x", "t1_y", "t1_z"}));
}

TEST(RecordedLayout, shearIsRecordedWithTheUnitOfTheLoads) {
    const auto columnsOf = [](const std::string& unit, int components) {
        const auto stream =
            featureStream("pad-features", described(TaxelLayout(ArrayLayout{2, 2, 0.004}, components)), unit);
        EXPECT_EQ(stream.shape, std::vector<std::size_t>{stream.columns.size()});
        std::vector<std::pair<std::string, std::string>> last;
        for (const recording::Column& column : stream.columns)
            last.emplace_back(column.name, column.unit);
        return last;
    };
    using Column = std::pair<std::string, std::string>;
    const auto loads = columnsOf("N", 1);
    EXPECT_EQ(loads.size(), kFeatureValues);
    EXPECT_EQ(loads[1], Column("force_n", "N"));
    const auto vectors = columnsOf("N", 3);
    ASSERT_EQ(vectors.size(), kFeatureValues + kShearValues);
    EXPECT_EQ(vectors[12], Column("shear_x_n", "N"));
    EXPECT_EQ(vectors[13], Column("shear_y_n", "N"));
    EXPECT_EQ(vectors[14], Column("moment_z_nm", "Nm"));
    EXPECT_EQ(vectors[15], Column("friction_ratio", ""));
    const auto field = columnsOf("µT", 3);
    EXPECT_EQ(field[1], Column("force_ut", "µT")) << "a unit that is no force is never exported as N";
    EXPECT_EQ(field[12], Column("shear_x_ut", "µT"));
    EXPECT_EQ(field[14], Column("moment_z_ut_m", "µT m"));
}

TEST(RecordedLayout, shearIsUndefinedWithoutAContact) {
    contact::TactileFeatures features;
    std::vector<double> values;
    appendFeatures(features, true, values);
    ASSERT_EQ(values.size(), kFeatureValues + kShearValues);
    EXPECT_TRUE(std::isnan(values[12]) && std::isnan(values[15]));
    features.shear = contact::ShearLoad{1.0, -2.0, 3.0, 0.5};
    appendFeatures(features, true, values);
    EXPECT_EQ(std::vector<double>(values.end() - 4, values.end()),
              (std::vector<double>{1.0, -2.0, 3.0, 0.5}));
    values.clear();
    appendFeatures(features, false, values);
    EXPECT_EQ(values.size(), kFeatureValues);
}

} // namespace
} // namespace teleta::pipeline
