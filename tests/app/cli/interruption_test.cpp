// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <atomic>
#include <csignal>
#include <fcntl.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::RunningProgram;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

/// The program reads frames of two taxels from a pipe; this test holds the other end.
class Interruption : public testing::Test {
protected:
    void SetUp() override {
        std::signal(SIGPIPE, SIG_IGN);
        ASSERT_EQ(mkfifo(m_pipe.c_str(), 0600), 0);
        // Open for both, so that opening does not wait for the program.
        m_writer = ::open(m_pipe.c_str(), O_RDWR | O_CLOEXEC);
        ASSERT_GE(m_writer, 0);
    }
    void TearDown() override { ::close(m_writer); }

    void feed(const std::string& text) const {
        ASSERT_EQ(::write(m_writer, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    }

    /// Waits until the program has written the text; false when it ended before.
    static bool waitForOutput(RunningProgram& program, const std::string& text) {
        while (!program.ended()) {
            if (program.hasWritten(text))
                return true;
            std::this_thread::yield();
        }
        return false;
    }

    std::vector<std::string> arguments(const std::string& command,
                                       const std::vector<std::string>& more) const {
        std::vector<std::string> all{command, m_pipe, "--rows", "1", "--columns", "2"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }

    TemporaryFolder m_folder;
    std::string m_pipe = m_folder.path("pipe");
    int m_writer = -1;
};

/// Time and force of the rows that were written, as the frames below have them: i/8 s and 1 + i N.
void expectRowsInOrder(const std::vector<std::vector<std::string>>& rows) {
    ASSERT_GE(rows.size(), 2U) << "a header and a row";
    for (std::size_t i = 1; i < rows.size(); ++i) {
        ASSERT_EQ(rows[i].size(), 13U);
        EXPECT_EQ(std::stod(rows[i][0]), static_cast<double>(i - 1) / 8.0);
        EXPECT_EQ(std::stod(rows[i][2]), static_cast<double>(i));
    }
}

std::string frame(int index) {
    return std::to_string(index / 8.0) + ',' + std::to_string(1 + index) + ",0\n";
}

} // namespace

TEST_F(Interruption, whileWaitingForInputCompletesTheFile) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        const std::string path = m_folder.path("out.csv");
        RunningProgram program(arguments("features", {"--out", path}));
        feed("time_s,t0,t1\n" + frame(0) + frame(1) + frame(2));
        ASSERT_TRUE(waitForOutput(program, "\n0,"));
        EXPECT_FALSE(std::filesystem::exists(path)) << "it appears when it is complete";
        program.send(signal);
        const ProgramResult result = program.wait();
        EXPECT_EQ(result.exitCode, 1);
        EXPECT_NE(result.err.find("interrupted"), std::string::npos) << result.err;
        expectRowsInOrder(splitCsv(readAll(path)));
        std::filesystem::remove(path);
        EXPECT_EQ(m_folder.entries(), 1U) << "only the pipe is left";
    }
}

TEST_F(Interruption, whileInputPoursInCompletesTheFileAndTheJsonDocument) {
    const std::string path = m_folder.path("out.csv");
    const std::string json = m_folder.path("out.json");
    RunningProgram program(arguments("features", {"--out", path, "--json"}),
                           {.environment = {}, .outPath = json});
    feed("time_s,t0,t1\n");
    // Not blocking, so that the end does not hang when nobody reads any more.
    fcntl(m_writer, F_SETFL, O_NONBLOCK);
    std::atomic<bool> done = false;
    std::thread writer([&] {
        std::string text;
        for (int i = 0; !done; ++i) {
            text = frame(i);
            while (!done && ::write(m_writer, text.data(), text.size()) < 0)
                std::this_thread::yield();
        }
    });
    const bool started = waitForOutput(program, "\n0,");
    program.send(SIGINT);
    const ProgramResult result = program.wait();
    done = true;
    writer.join();
    EXPECT_TRUE(started);
    EXPECT_EQ(result.exitCode, 1);
    const auto rows = splitCsv(readAll(path));
    expectRowsInOrder(rows);
    EXPECT_EQ(nlohmann::json::parse(readAll(json)).size(), rows.size() - 1);
}

TEST_F(Interruption, beforeThereIsAnyInputLeavesNoFile) {
    // Nothing is written to the pipe, so the program waits for the header.
    RunningProgram program(arguments("contacts", {"--out", m_folder.path("out.csv")}));
    // The program may not have installed its handlers yet; then the default action ends it.
    while (!program.ended()) {
        program.send(SIGTERM);
        std::this_thread::yield();
    }
    const ProgramResult result = program.wait();
    EXPECT_TRUE(result.exitCode == 1 || result.exitCode == -SIGTERM) << result.exitCode;
    EXPECT_EQ(m_folder.entries(), 1U);
}

TEST_F(Interruption, leavesNoProgressBarOnTheTerminal) {
    const std::string path = m_folder.path("out.csv");
    RunningProgram program(arguments("features", {"--out", path}),
                           {.environment = {}, .outPath = {}, .terminal = true});
    feed("time_s,t0,t1\n");
    // Not blocking, so that the end does not hang when nobody reads any more.
    fcntl(m_writer, F_SETFL, O_NONBLOCK);
    std::atomic<bool> done = false;
    std::thread writer([&] {
        for (const std::string text = frame(0); !done;) {
            if (::write(m_writer, text.data(), text.size()) < 0)
                std::this_thread::yield();
        }
    });
    // The source has no known size, so amount and rate are shown.
    std::string seen;
    while (seen.find("MB/s") == std::string::npos && !program.ended())
        seen = program.readTerminal();
    program.send(SIGINT);
    const std::string all = program.wait().out;
    done = true;
    writer.join();
    EXPECT_NE(seen.find(" MB  "), std::string::npos) << seen;
    const std::size_t erased = all.rfind("\r\x1b[K");
    ASSERT_NE(erased, std::string::npos);
    EXPECT_EQ(all.find("MB/s", erased), std::string::npos) << "the message stands on a clean line";
    EXPECT_NE(all.find("teleta: interrupted", erased), std::string::npos) << all;
}

/// One of its files is a pipe, so that the export cannot come to its end by itself.
TEST(ExportInterruption, finishesTheFilesOfAnExport) {
    const TemporaryFolder folder;
    ASSERT_EQ(teleta::test::run({"simulate", "teleta-touch", "--duration", "3", "--out", folder.path("run")})
                  .exitCode,
              0);
    std::filesystem::create_directory(folder.path("csv"));
    const std::string pipe = folder.path("csv/frames.csv");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int reader = ::open(pipe.c_str(), O_RDWR | O_CLOEXEC);
    ASSERT_GE(reader, 0);
    RunningProgram program(
        {"export", folder.path("run/recording.teleta"), "--csv", folder.path("csv"), "--force"});
    std::array<char, 4096> text{};
    ASSERT_GT(::read(reader, text.data(), text.size()), 0) << "it is in the middle of the frames";
    program.send(SIGINT);
    fcntl(reader, F_SETFL, O_NONBLOCK);
    while (!program.ended())
        if (::read(reader, text.data(), text.size()) < 0)
            std::this_thread::yield();
    ::close(reader);
    const ProgramResult result = program.wait();
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.err.find("interrupted"), std::string::npos) << result.err;
    EXPECT_TRUE(std::filesystem::exists(folder.path("csv/events.csv")));
    EXPECT_FALSE(std::filesystem::exists(folder.path("csv/joints.csv"))) << "of a stream after it";
}
