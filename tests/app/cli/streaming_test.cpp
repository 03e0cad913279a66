// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

using teleta::test::ProgramResult;
using teleta::test::RunningProgram;
using teleta::test::TemporaryFolder;

namespace {

constexpr int kTaxels = 84; // the default array, 6 x 14

/// Frames as recorded ones look: 84 taxels with three decimals, some of them under load.
std::string framesText(int first, int count) {
    std::string text;
    char field[32];
    for (int i = first; i < first + count; ++i) {
        text.append(field, static_cast<std::size_t>(std::snprintf(field, sizeof field, "%.3f", i * 0.001)));
        for (int taxel = 0; taxel < kTaxels; ++taxel) {
            const double load_N =
                (taxel % 14 == i / 500 % 14 ? 1.0 : 0.0) + ((i * 31 + taxel * 17) % 100) * 0.001;
            text.append(field, static_cast<std::size_t>(std::snprintf(field, sizeof field, ",%.3f", load_N)));
        }
        text += '\n';
    }
    return text;
}

bool writeAll(int file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t count = ::write(file, text.data(), text.size());
        if (count <= 0)
            return false;
        text.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

/// Waits until nothing is left in a pipe.
bool isRead(int file) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    for (int left = 1; std::chrono::steady_clock::now() < end;) {
        if (::ioctl(file, FIONREAD, &left) == 0 && left == 0)
            return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

struct Streamed {
    long memory_kB = 0;
    std::uint64_t bytes = 0;
    double wall_s = 0.0;
};

/// Feeds so many bytes through a pipe. The memory is read when all of them have left it.
Streamed stream(std::uint64_t bytes, const std::vector<std::string>& arguments) {
    const TemporaryFolder folder;
    const std::string pipe = folder.path("pipe");
    EXPECT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::vector<std::string> all = arguments;
    all.push_back(pipe);
    std::string header = "time_s";
    for (int taxel = 0; taxel < kTaxels; ++taxel)
        header += ",t" + std::to_string(taxel);
    // The rows of one chunk are repeated with the time standing still; only the first chunk moves it on.
    const std::string chunk = framesText(0, 4000);
    std::string same = chunk;
    for (std::size_t begin = 0; begin < same.size();) {
        const std::size_t comma = same.find(',', begin);
        same.replace(begin, comma - begin, "4.000");
        begin = same.find('\n', begin) + 1;
    }

    const auto start = std::chrono::steady_clock::now();
    RunningProgram program(all, {.environment = {}, .outPath = "/dev/null"});
    const int writer = ::open(pipe.c_str(), O_WRONLY | O_CLOEXEC);
    fcntl(writer, F_SETPIPE_SZ, 1 << 20);
    Streamed result;
    EXPECT_TRUE(writeAll(writer, header + '\n' + chunk));
    for (result.bytes = header.size() + 1 + chunk.size(); result.bytes < bytes; result.bytes += same.size()) {
        if (!writeAll(writer, same))
            break;
    }
    EXPECT_TRUE(isRead(writer));
    result.memory_kB = program.peakMemory_kB();
    ::close(writer);
    const ProgramResult ended = program.wait();
    result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_GE(result.bytes, bytes);
    return result;
}

std::uint64_t longStreamBytes() {
    const char* megabytes = std::getenv("TELETA_STREAM_MB");
    return (megabytes != nullptr ? std::strtoull(megabytes, nullptr, 10) : 300) * 1'000'000;
}

class Streaming : public testing::TestWithParam<std::vector<std::string>> {};

} // namespace

TEST_P(Streaming, needsTheSameMemoryForALongRecordingAsForAShortOne) {
    std::signal(SIGPIPE, SIG_IGN);
    const Streamed small = stream(3'000'000, GetParam());
    const Streamed large = stream(longStreamBytes(), GetParam());
    const double size_MB = static_cast<double>(large.bytes) * 1e-6;
    std::printf("%.0f MB in %.2f s, %.0f MB/s, peak memory %ld kB; 3 MB: %ld kB\n", size_MB, large.wall_s,
                size_MB / large.wall_s, large.memory_kB, small.memory_kB);
    ASSERT_GT(small.memory_kB, 0);
    // Threads that are late let a few more chunks wait; the recording itself is many times larger.
    EXPECT_LT(1e-3 * static_cast<double>(large.memory_kB - small.memory_kB), 0.03 * size_MB);
}

INSTANTIATE_TEST_SUITE_P(Commands, Streaming,
                         testing::Values(std::vector<std::string>{"features"},
                                         std::vector<std::string>{"features", "--json"},
                                         std::vector<std::string>{"contacts"}));
