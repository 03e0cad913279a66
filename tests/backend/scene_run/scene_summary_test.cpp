// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/base/scene_summary.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

using nlohmann::ordered_json;
using teleta::scene_run::SceneSummary;

namespace {

ordered_json reported(const std::vector<double>& errors_m) {
    ordered_json measures;
    teleta::scene_run::reportContactErrors(errors_m, measures);
    return measures;
}

} // namespace

TEST(SceneSummary, hasTheKeysOfTheFormatInTheirOrder) {
    SceneSummary summary;
    summary.scene = "s";
    summary.effects = {{"noise", 0.25}};
    std::vector<std::string> keys;
    const ordered_json document = summary.toJson();
    for (const auto& [key, value] : document.items())
        keys.push_back(key);
    EXPECT_EQ(keys, (std::vector<std::string>{"scene", "app_version", "seed", "simulated_s", "wall_s",
                                              "effects", "measures", "events"}));
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

TEST(ContactErrorMeasures, ofNoErrorsAreNull) {
    const ordered_json measures = reported({});
    EXPECT_TRUE(measures["contact_error_mean_m"].is_null());
    EXPECT_TRUE(measures["contact_error_p95_m"].is_null());
}

TEST(ContactErrorMeasures, ofOneErrorAreThatError) {
    const ordered_json measures = reported({0.25});
    EXPECT_EQ(measures["contact_error_mean_m"], ordered_json(0.25));
    EXPECT_EQ(measures["contact_error_p95_m"], ordered_json(0.25));
}

TEST(ContactErrorMeasures, haveTheQuantileOfR) {
    // R: x <- c(1:7)^2; mean(x); quantile(x, 0.95, type = 7)
    const ordered_json measures = reported({25, 1, 49, 9, 4, 36, 16});
    EXPECT_DOUBLE_EQ(measures["contact_error_mean_m"].get<double>(), 20.0);
    EXPECT_NEAR(measures["contact_error_p95_m"].get<double>(), 45.1, 1e-12);
}

TEST(ContactErrorMeasures, doNotDependOnTheOrder) {
    std::vector<double> rising(101);
    std::iota(rising.begin(), rising.end(), 0.0);
    const std::vector<double> falling(rising.rbegin(), rising.rend());
    EXPECT_EQ(reported(rising)["contact_error_p95_m"], ordered_json(95.0));
    EXPECT_EQ(reported(falling)["contact_error_p95_m"], ordered_json(95.0));
}
