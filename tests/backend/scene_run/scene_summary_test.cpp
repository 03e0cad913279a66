// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/base/scene_summary.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

using nlohmann::ordered_json;
using teleta::scene_run::errorStatistics;
using teleta::scene_run::SceneSummary;

TEST(SceneSummary, hasTheKeysOfTheFormatInTheirOrder) {
    SceneSummary summary;
    summary.scene = "s";
    summary.effects = {{"noise", 0.25}};
    std::vector<std::string> keys;
    const ordered_json document = summary.toJson();
    for (const auto& [key, value] : document.items())
        keys.push_back(key);
    EXPECT_EQ(keys, (std::vector<std::string>{"scene", "seed", "simulated_s", "wall_s", "effects", "measures",
                                              "events"}));
    EXPECT_EQ(document["effects"].dump(), R"([{"name":"noise","time_s":0.25}])");
    EXPECT_TRUE(document["measures"].is_object());
    EXPECT_TRUE(document["events"].is_array());
}

TEST(SceneSummary, writesANumberThatIsNotFiniteAsNull) {
    EXPECT_TRUE(teleta::scene_run::jsonNumber(std::numeric_limits<double>::quiet_NaN()).is_null());
    EXPECT_TRUE(teleta::scene_run::jsonNumber(std::numeric_limits<double>::infinity()).is_null());
    EXPECT_EQ(teleta::scene_run::jsonNumber(0.5), ordered_json(0.5));
}

TEST(SceneSummary, saysWhereAFileCannotBeWritten) {
    const auto written = teleta::scene_run::writeJson("/nowhere/summary.json", ordered_json::object());
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().kind, teleta::core::ErrorKind::ioFailed);
    EXPECT_EQ(written.error().where.file, "/nowhere/summary.json");
}

TEST(ErrorStatistics, ofNoErrorsAreNull) {
    std::vector<double> none;
    EXPECT_TRUE(errorStatistics(none).mean.is_null());
    EXPECT_TRUE(errorStatistics(none).p95.is_null());
}

TEST(ErrorStatistics, ofOneErrorAreThatError) {
    std::vector<double> one{0.25};
    EXPECT_EQ(errorStatistics(one).mean, ordered_json(0.25));
    EXPECT_EQ(errorStatistics(one).p95, ordered_json(0.25));
}

TEST(ErrorStatistics, haveTheQuantileOfR) {
    // R: x <- c(1:7)^2; mean(x); quantile(x, 0.95, type = 7)
    std::vector<double> squares{25, 1, 49, 9, 4, 36, 16};
    const auto statistics = errorStatistics(squares);
    EXPECT_DOUBLE_EQ(statistics.mean.get<double>(), 20.0);
    EXPECT_NEAR(statistics.p95.get<double>(), 45.1, 1e-12);
}

TEST(ErrorStatistics, doNotDependOnTheOrder) {
    std::vector<double> rising(101);
    std::iota(rising.begin(), rising.end(), 0.0);
    std::vector<double> falling(rising.rbegin(), rising.rend());
    EXPECT_EQ(errorStatistics(rising).p95, ordered_json(95.0));
    EXPECT_EQ(errorStatistics(falling).p95, ordered_json(95.0));
}
