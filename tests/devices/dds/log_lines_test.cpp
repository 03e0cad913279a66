// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/dds/log_lines.h"

#include <gtest/gtest.h>

namespace teleta::dds {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

TEST(DdsLog, letsOneLineASecondThroughAndCountsTheOthers) {
    LogLimit limit;
    std::int64_t passed = 0;
    // A failed send each millisecond for 3 s.
    for (std::int64_t i = 0; i < 3000; ++i)
        passed += limit.pass("send failed", i * kSecond_ns / 1000) ? 1 : 0;
    EXPECT_EQ(passed, 3);
    EXPECT_EQ(limit.pass("later", 10 * kSecond_ns), "later (+999)");
    EXPECT_EQ(limit.pass("quiet", 12 * kSecond_ns), "quiet");
}

} // namespace
} // namespace teleta::dds
