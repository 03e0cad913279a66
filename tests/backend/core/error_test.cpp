// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/error.h"
#include "backend/core/passwords.h"

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

TEST(Error, showsNoPasswords) {
    using teleta::core::withoutPasswords;
    EXPECT_EQ(withoutPasswords("postgresql://anna:s3cret@host:5432/db?study=s"),
              "postgresql://anna:***@host:5432/db?study=s");
    EXPECT_EQ(withoutPasswords("postgrsql://anna:s3@cr:et@host/db and ftp://b:x@h"),
              "postgrsql://anna:***@host/db and ftp://b:***@h");
    EXPECT_EQ(withoutPasswords("postgresql:///db?password=s3cret&study=s"),
              "postgresql:///db?password=***&study=s");
    for (const char* text : {"tcp://[::1]:502", "tcp://host:502", "tcp://anna@host:502/x", "a: b@c", "://",
                             "://@", "https://example.org/a:b@c", ""})
        EXPECT_EQ(withoutPasswords(text), text);
    EXPECT_EQ(describe({ErrorKind::notFound, "there is no \"x://u:pw@h\"", "", {"x://u:pw@h/f", 0, 0}}),
              "x://u:***@h/f: there is no \"x://u:***@h\"");
}
