// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/site/site_log.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>
#include <string>

namespace teleta::site_program {
namespace {

using Severity = site_link::SiteNews::Severity;

std::vector<nlohmann::json> flushed(SiteLog& log) {
    testing::internal::CaptureStdout();
    log.flush();
    std::istringstream lines(testing::internal::GetCapturedStdout());
    std::vector<nlohmann::json> all;
    for (std::string line; std::getline(lines, line);)
        all.push_back(nlohmann::json::parse(line));
    return all;
}

TEST(SiteLog, aLineIsOneJsonDocument) {
    SiteLog log(true);
    log.write({Severity::warning, "console1", "stop", "STOP is held by \"console1\""});
    const auto lines = flushed(log);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0]["severity"], "warning");
    EXPECT_EQ(lines[0]["source"], "console1");
    EXPECT_EQ(lines[0]["code"], "stop");
    EXPECT_EQ(lines[0]["message"], "STOP is held by \"console1\"");
    EXPECT_TRUE(flushed(log).empty());
}

TEST(SiteLog, whatNobodyReadsIsLostAndSaid) {
    SiteLog log(true);
    for (std::size_t i = 0; i < SiteLog::kMostLines + 7; ++i)
        log.write({Severity::note, {}, "n", std::to_string(i)});
    const auto lines = flushed(log);
    ASSERT_EQ(lines.size(), SiteLog::kMostLines + 1);
    EXPECT_EQ(lines[0]["code"], "log_lost");
    EXPECT_EQ(lines[0]["message"], "7 lines of the log were lost");
    EXPECT_EQ(lines[1]["message"], "7");
}

} // namespace
} // namespace teleta::site_program
