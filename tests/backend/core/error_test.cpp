// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/error.h"

#include <gtest/gtest.h>

using teleta::core::describe;
using teleta::core::Error;
using teleta::core::ErrorKind;

TEST(Error, namesThePlaceAsFarAsItIsKnown) {
    Error error{ErrorKind::badInput, "not a number: \"abc\"", "a number", {"frames.csv", 12, 7}};
    EXPECT_EQ(describe(error), "frames.csv:12:7: not a number: \"abc\" (expected a number)");
    error.where.column = 0;
    EXPECT_EQ(describe(error), "frames.csv:12: not a number: \"abc\" (expected a number)");
    error.where.line = 0;
    error.expected.clear();
    EXPECT_EQ(describe(error), "frames.csv: not a number: \"abc\"");
    error.where.file.clear();
    EXPECT_EQ(describe(error), "not a number: \"abc\"");
}
