// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/arguments.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

TEST(Arguments, withPasswordsAreOverwrittenFromEndToEnd) {
    std::string program = "teleta";
    std::string store = "postgresql://anna:averylongpassword@host/db";
    std::string shortOne = "x://a:b@h";
    const std::string before = store;
    std::array<char*, 4> argv{program.data(), store.data(), shortOne.data(), nullptr};
    teleta::app::hidePasswords(3, argv.data());
    EXPECT_STREQ(argv[0], "teleta");
    EXPECT_STREQ(argv[1], "postgresql://anna:***@host/db");
    EXPECT_EQ(std::string(argv[1], before.size()).find("password"), std::string::npos);
    // There is no room for the three stars, and nothing beyond the end is touched.
    EXPECT_EQ(shortOne.substr(0, 9), "x://a:***");
    EXPECT_EQ(shortOne.c_str()[9], '\0');
}
