// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/signal/live_source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace teleta;
using namespace teleta::signal;

namespace {

recording::StreamInfo twoColumns(const std::string& name) {
    return {.name = name,
            .kind = recording::StreamKind::features,
            .type = recording::ValueType::float64,
            .shape = {2},
            .columns = {{"force_n", "N"}, {"q1", "rad"}},
            .nominalRate_Hz = 100.0};
}

void append(core::StreamTap& tap, double time_s, std::vector<double> values, bool jump = false) {
    tap.append(static_cast<std::int64_t>(1e9 * time_s), time_s, std::span<const double>(values), jump);
}

} // namespace

TEST(LiveSource, makesASeriesOfEachColumn) {
    LiveSource source("skin", 1'000'000'000);
    const auto tap = source.addStream(twoColumns("skin-features"));
    EXPECT_TRUE(source.take());
    append(*tap, 3.0, {1.5, 0.1});
    append(*tap, 3.01, {2.5, 0.2});
    EXPECT_FALSE(source.take());
    ASSERT_EQ(source.streams().size(), 1U);
    const LiveSource::Stream& stream = source.streams().front();
    EXPECT_EQ(stream.name, "features");
    ASSERT_EQ(stream.columns.size(), 2U);
    EXPECT_EQ(stream.columns[1].column.unit, "rad");
    const Series& force = *stream.columns[0].series;
    ASSERT_EQ(force.size(), 2U);
    EXPECT_DOUBLE_EQ(force.time_s(0), 2.0);
    EXPECT_EQ(force.value(1), 2.5);
    EXPECT_EQ(stream.columns[1].series->newest(), 0.2);
}

TEST(LiveSource, aJumpAndMissingFramesAreGaps) {
    LiveSource source("arm", 0);
    const auto tap = source.addStream(twoColumns("arm-joints"));
    append(*tap, 0.0, {1.0, 1.0});
    append(*tap, 0.01, {1.0, 1.0}, /*jump=*/true);
    append(*tap, 0.4, {1.0, 1.0});
    source.take();
    const Series& series = *source.streams().front().columns.front().series;
    ASSERT_EQ(series.size(), 5U);
    EXPECT_TRUE(std::isnan(series.value(1)));
    EXPECT_TRUE(std::isnan(series.value(3)));
}

TEST(LiveSource, namesTheValuesOfAnArrayAndTakesNoPictures) {
    LiveSource source("skin", 0);
    const auto pictures = source.addStream({.name = "skin-camera",
                                            .kind = recording::StreamKind::camera,
                                            .type = recording::ValueType::grey8,
                                            .shape = {0, 0}});
    EXPECT_TRUE(pictures->isClosed()) << "nobody copies pictures for it";
    const auto frames =
        source.addStream({.name = "skin-frames", .shape = {2, 3}, .unit = "N", .nominalRate_Hz = 200.0});
    source.take();
    ASSERT_EQ(source.streams().size(), 1U);
    const auto& columns = source.streams().front().columns;
    ASSERT_EQ(columns.size(), 6U);
    EXPECT_EQ(columns[5].column.name, "t5");
    EXPECT_EQ(columns[5].column.unit, "N");
    const std::vector<float> values{1, 2, 3, 4, 5, 6};
    frames->append(0, 0.0, std::span<const float>(values));
    source.take();
    EXPECT_EQ(columns[5].series->newest(), 6.0);
}

TEST(LiveSource, countsWhatWasNotTakenInTime) {
    LiveSource source("arm", 0);
    const auto tap = source.addStream(twoColumns("arm-joints"));
    source.take();
    for (int i = 0; i < 5000; ++i)
        append(*tap, 0.001 * i, {0.0, 0.0});
    source.take();
    EXPECT_GT(source.lost(), 0U);
    EXPECT_EQ(source.lost() + source.streams().front().columns.front().series->size(), 5000U);
}

TEST(LiveSource, whatNobodyLooksAtIsBounded) {
    LiveSource source("arm", 0);
    const auto tap = source.addStream(twoColumns("arm-joints"));
    source.take();
    EXPECT_EQ(source.streams().front().capacity, LiveSource::kBytesOfAStream / (2 * sizeof(Sample)));
}

TEST(LiveSource, aWideStreamKeepsWhatIsPlotted) {
    LiveSource source("mat", 0);
    const auto tap = source.addStream({.name = "mat-frames", .shape = {20, 10}, .nominalRate_Hz = 200.0});
    source.take();
    const std::vector<float> values(200, 7.0F);
    const auto appendFrame = [&](double time_s) {
        tap->append(static_cast<std::int64_t>(1e9 * time_s), time_s, std::span<const float>(values));
        source.take();
    };
    appendFrame(0.0);
    const auto& columns = source.streams().front().columns;
    EXPECT_TRUE(columns[3].series->empty());
    EXPECT_EQ(columns[3].newest, 7.0);
    source.keep([](const std::string&, const std::string& column) { return column == "t3"; }, 1000);
    appendFrame(0.005);
    EXPECT_EQ(columns[3].series->size(), 1U);
    EXPECT_TRUE(columns[4].series->empty());
}

TEST(SignalName, hasTheUnitOnce) {
    EXPECT_EQ(nameWithUnit("force_n", "N"), "force_n");
    EXPECT_EQ(nameWithUnit("tau1", "Nm"), "tau1_nm");
    EXPECT_EQ(nameWithUnit("lower_95", "N/m"), "lower_95_n_per_m");
    EXPECT_EQ(nameWithUnit("active", ""), "active");
    EXPECT_EQ(nameWithUnit("b_x", "\u00b5T"), "b_x_ut");
}
