// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/part.h"

#include <gtest/gtest.h>

namespace teleta::core {
namespace {

TEST(PartTest, aPartThatIsNotThereIsNamed) {
    const auto missing = loadPart("teleta_no_such_part");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, ErrorKind::unavailable);
    EXPECT_NE(missing.error().message.find("teleta_no_such_part.so"), std::string::npos)
        << missing.error().message;
    EXPECT_NE(missing.error().expected, "");
}

TEST(PartTest, aFileThatIsNoPartIsRefused) {
    // It loads, since it is a library, but it does not export its name.
    const auto foreign = loadPart("libz");
    ASSERT_FALSE(foreign);
    EXPECT_EQ(foreign.error().kind, ErrorKind::unavailable);
    EXPECT_NE(foreign.error().message.find("libz"), std::string::npos) << foreign.error().message;
}

} // namespace
} // namespace teleta::core
