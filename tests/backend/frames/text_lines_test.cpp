// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/text_lines.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

namespace {

using teleta::frames::TextLines;

std::string writtenFile(const std::string& content) {
    const std::string path = testing::TempDir() + "text_lines_test.txt";
    std::ofstream(path, std::ios::binary) << content;
    return path;
}

/// Lines as long as the room that is there at first and after it has grown, and one and two bytes around.
TEST(TextLines, keepsLinesOfAnyLengthWhole) {
    std::vector<std::string> lines;
    std::string content;
    for (const std::size_t about :
         {std::size_t{1}, std::size_t{4096}, std::size_t{8192}, std::size_t{1} << 20}) {
        for (const std::size_t length : {about - 1, about, about + 1, about + 2}) {
            lines.push_back(std::string(length, static_cast<char>('a' + lines.size() % 26)));
            content += lines.back() + (lines.size() % 2 == 0 ? "\n" : "\r\n");
        }
    }
    content += "the last one has no end";
    lines.emplace_back("the last one has no end");
    TextLines text(writtenFile(content));
    ASSERT_TRUE(text.open());
    for (const std::string& expected : lines) {
        const auto line = text.next();
        ASSERT_TRUE(line && *line) << text.number();
        EXPECT_TRUE(**line == expected) << text.number();
    }
    const auto end = text.next();
    EXPECT_TRUE(end && !*end);
    EXPECT_EQ(text.number(), static_cast<long long>(lines.size()));
}

TEST(TextLines, refusesALineOver16MiB) {
    const std::size_t most = std::size_t{16} << 20;
    TextLines fits(writtenFile(std::string(most - 1, '1') + '\n'));
    ASSERT_TRUE(fits.open());
    EXPECT_TRUE(fits.next());
    TextLines tooLong(writtenFile("1\n" + std::string(most + 1, '1')));
    ASSERT_TRUE(tooLong.open());
    EXPECT_TRUE(tooLong.next());
    const auto refused = tooLong.next();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().where.line, 2);
}

} // namespace
