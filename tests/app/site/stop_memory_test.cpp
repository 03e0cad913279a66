// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/site/stop_memory.h"
#include "tests/support/small_disk.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

namespace teleta::site_program {
namespace {

using site::StopHolders;

site::BootName boot(std::uint8_t value) {
    site::BootName name{};
    name[0] = value;
    name[15] = 0xAB;
    return name;
}

const StopHolders kSome{true, {{"a", boot(1)}, {"a", boot(2)}, {"viewer_1", boot(3)}}};
const StopHolders kSite{true, {}};

class StopMemoryTest : public ::testing::Test {
protected:
    [[nodiscard]] std::string folder() const { return m_folder.filePath("below/state").toStdString(); }
    [[nodiscard]] std::string path() const { return folder() + "/lab-stop.json"; }
    void put(const std::string& text) const {
        std::filesystem::create_directories(folder());
        std::ofstream(path()) << text;
    }
    [[nodiscard]] std::string text() const {
        std::ifstream file(path());
        return {std::istreambuf_iterator<char>(file), {}};
    }
    /// Waits at most 10 s until it holds.
    template <typename Holds>
    [[nodiscard]] static bool eventually(const Holds& holds) {
        for (int i = 0; i < 2000; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(5)))
            if (holds())
                return true;
        return false;
    }

    QTemporaryDir m_folder;
};

TEST_F(StopMemoryTest, nobodyHoldsASiteThatNeverRan) {
    const StopMemory memory(folder(), "lab");
    EXPECT_EQ(memory.atStart(), StopHolders());
    EXPECT_EQ(memory.problem(), "");
    EXPECT_EQ(parseStop(text(), path()).value(), StopHolders()) << "it can be written";
}

TEST_F(StopMemoryTest, whatWasToldLastIsThereAtTheNextStart) {
    {
        StopMemory memory(folder(), "lab");
        memory.keep(kSome);
        // While the program runs, too: it may be killed.
        EXPECT_TRUE(eventually([&] { return text() == stopText(kSome); }));
        memory.keep(kSite);
        memory.keep(kSome);
    }
    EXPECT_EQ(StopMemory(folder(), "lab").atStart(), kSome);
    EXPECT_EQ(StopMemory(folder(), "other").atStart(), StopHolders());
    {
        StopMemory memory(folder(), "lab");
        memory.keep({});
    }
    EXPECT_EQ(StopMemory(folder(), "lab").atStart(), StopHolders());
}

TEST_F(StopMemoryTest, anythingButAWholeFileIsStop) {
    const std::string whole = stopText({false, {{"a", boot(1)}}});
    std::vector<std::string> damaged{"[]",
                                     "null",
                                     whole + "x",
                                     std::string(2U << 20U, ' '),
                                     R"({"version": 2, "site": false, "consoles": []})",
                                     R"({"version": 1, "site": 0, "consoles": []})",
                                     R"({"version": 1, "site": false})",
                                     R"({"version": 1, "site": false, "consoles": [{"console": "a"}]})",
                                     R"({"version": 1, "site": false, "consoles": [{"console": "A", "program":
                                         "00112233445566778899aabbccddeeff"}]})",
                                     R"({"version": 1, "site": false, "consoles": [{"console": "a", "program":
                                         "0011223344556677"}]})"};
    // The last character is the end of the line.
    for (std::size_t length = 0; length + 1 < whole.size(); ++length)
        damaged.push_back(whole.substr(0, length));
    for (const std::string& each : damaged) {
        put(each);
        const StopMemory memory(folder(), "lab");
        EXPECT_EQ(memory.atStart(), kSite) << each.substr(0, 200);
        EXPECT_NE(memory.problem().find(path()), std::string::npos) << memory.problem();
        EXPECT_EQ(memory.trouble(), "");
    }
    // It stays so until somebody withdraws it.
    EXPECT_EQ(StopMemory(folder(), "lab").atStart(), kSite);
    put(whole);
    EXPECT_EQ(StopMemory(folder(), "lab").atStart(), (StopHolders{false, {{"a", boot(1)}}}));
}

TEST_F(StopMemoryTest, whatCannotBeWrittenIsStopAndIsTriedAgain) {
    std::filesystem::create_directories(path()); // a folder of the file's name
    {
        StopMemory memory(folder(), "lab");
        EXPECT_EQ(memory.atStart(), kSite);
        EXPECT_NE(memory.problem(), "");
        EXPECT_NE(memory.trouble(), "");
        memory.keep({});
        std::filesystem::remove(path());
        EXPECT_TRUE(eventually([&] { return memory.trouble().empty(); }));
    }
    EXPECT_EQ(StopMemory(folder(), "lab").atStart(), StopHolders());
}

TEST_F(StopMemoryTest, aFullDiskKeepsWhatItHad) {
    const test::SmallDisk disk(folder(), 1);
    if (!disk.exists())
        GTEST_SKIP() << "needs the right to mount a disk";
    {
        StopMemory memory(folder(), "lab");
        ASSERT_EQ(memory.problem(), "");
        ASSERT_TRUE(disk.fill());
        memory.keep(kSite);
        EXPECT_TRUE(eventually([&] { return !memory.trouble().empty(); }));
        EXPECT_EQ(text(), stopText({}));
        std::filesystem::remove(disk.path("ballast"));
        EXPECT_TRUE(eventually([&] { return text() == stopText(kSite); }));
    }
    ASSERT_TRUE(disk.fill());
    const StopMemory memory(folder(), "lab");
    EXPECT_EQ(memory.atStart(), kSite);
}

TEST_F(StopMemoryTest, isWhereSystemdSays) {
    qputenv("STATE_DIRECTORY", "/var/lib/teleta-site:/var/lib/other");
    EXPECT_EQ(StopMemory::usualFolder(), "/var/lib/teleta-site");
    qunsetenv("STATE_DIRECTORY");
    qputenv("XDG_STATE_HOME", "/home/x/.state");
    EXPECT_EQ(StopMemory::usualFolder(), "/home/x/.state/teleta-site");
    qputenv("XDG_STATE_HOME", "relative");
    qputenv("HOME", "/home/x");
    EXPECT_EQ(StopMemory::usualFolder(), "/home/x/.local/state/teleta-site");
}

} // namespace
} // namespace teleta::site_program
