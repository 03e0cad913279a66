// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/input_file.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

using teleta::core::ErrorKind;
using teleta::core::readFile;
using teleta::core::requireFile;
using teleta::test::TemporaryFolder;

TEST(InputFile, isReadByteForByte) {
    const TemporaryFolder folder;
    const std::string bytes("a\0b\r\n\xFF", 6);
    EXPECT_EQ(readFile(folder.write("f", bytes)).value(), bytes);
    EXPECT_EQ(readFile(folder.write("empty", "")).value(), "");
    EXPECT_EQ(readFile("/proc/self/comm").value().back(), '\n') << "a file whose size says 0";
}

TEST(InputFile, ofTheLargestSizeIsReadAndOneByteMoreIsNot) {
    const TemporaryFolder folder;
    const std::string path = folder.write("f", std::string(100'000, 'x'));
    EXPECT_EQ(readFile(path, 100'000).value().size(), 100'000U);
    const auto more = readFile(path, 99'999);
    ASSERT_FALSE(more);
    EXPECT_EQ(more.error().kind, ErrorKind::badInput);
    EXPECT_EQ(more.error().where.file, path);
    EXPECT_NE(more.error().message.find("too large"), std::string::npos) << more.error().message;
}

TEST(InputFile, isNeitherAPipeNorADeviceNorAFolder) {
    const TemporaryFolder folder;
    const std::string pipe = folder.path("pipe");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    for (const std::string& path :
         {pipe, std::string("/dev/zero"), std::string("/dev/null"), folder.path("")}) {
        const auto read = readFile(path);
        ASSERT_FALSE(read) << path;
        EXPECT_EQ(read.error().kind, ErrorKind::badInput) << path;
        EXPECT_FALSE(requireFile(path)) << path;
    }
}

TEST(InputFile, thatIsNotThereIsNotFound) {
    const TemporaryFolder folder;
    EXPECT_EQ(readFile(folder.path("none")).error().kind, ErrorKind::notFound);
    EXPECT_EQ(requireFile(folder.path("none/below")).error().kind, ErrorKind::notFound);
    EXPECT_EQ(readFile(":/none").error().kind, ErrorKind::notFound);
}
