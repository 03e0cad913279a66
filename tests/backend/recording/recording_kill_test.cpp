// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/recording/recorded_files.h"

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace teleta;
using namespace teleta::recording;
using namespace teleta::test;

namespace {

/// What the killed process says last, in memory that outlives it.
struct LastWords {
    std::atomic<std::uint64_t> committed{0};
    std::atomic<std::int64_t> appended_ns{0};
};

/// Records an array at 200 Hz and joints at 1 kHz until it is killed.
[[noreturn]] void recordForever(const std::string& path, LastWords& words) {
    makeApplication();
    const std::int64_t start_ns = core::steadyNow_ns();
    auto recorder = Recorder::start(path, headAt(start_ns));
    if (!recorder)
        _exit(1);
    const auto array = (*recorder)->addStream(arrayInfo());
    StreamInfo joints;
    joints.name = "joints";
    joints.kind = StreamKind::joints;
    joints.type = ValueType::float64;
    joints.shape = {12};
    const auto arm = (*recorder)->addStream(joints);
    const std::array<double, 12> angles{};
    for (std::int64_t i = 0;; ++i) {
        const std::int64_t due_ns = start_ns + i * 1'000'000;
        std::this_thread::sleep_until(core::toTimePoint(due_ns));
        arm->append(due_ns, static_cast<double>(i) * 1e-3, std::span<const double>(angles));
        if (i % 5 == 0)
            appendFrame(*array, due_ns, static_cast<float>(i / 5));
        words.appended_ns.store(due_ns);
        words.committed.store((*recorder)->status().frames);
    }
}

/// Between two processes, in memory of both.
struct Turns {
    std::atomic<bool> isWritten{false};
    std::atomic<bool> wasRead{false};
};

constexpr int kBeforeAndAfter = 100;

/// Records so many frames, and as many again after somebody has read them.
[[noreturn]] void recordInTwoParts(const std::string& path, Turns& turns) {
    makeApplication();
    const std::int64_t start_ns = core::steadyNow_ns();
    auto recorder = Recorder::start(path, headAt(start_ns));
    if (!recorder)
        _exit(1);
    const auto tap = (*recorder)->addStream(arrayInfo());
    for (int i = 0; i < 2 * kBeforeAndAfter; ++i) {
        if (i == kBeforeAndAfter) {
            while ((*recorder)->status().frames < kBeforeAndAfter)
                std::this_thread::yield();
            turns.isWritten = true;
            while (!turns.wasRead)
                std::this_thread::yield();
        }
        appendFrame(*tap, start_ns + i, static_cast<float>(i));
    }
    _exit((*recorder)->stop() ? 0 : 1);
}

} // namespace

// It might be taken for one that was cut off.
TEST(RecordingKill, aRecordingOfAnotherProcessIsReadWithoutDisturbingIt) {
    const TemporaryFolder folder;
    const std::string path = folder.path("run.teleta");
    void* memory = mmap(nullptr, sizeof(Turns), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    ASSERT_NE(memory, MAP_FAILED);
    auto* turns = new (memory) Turns;
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0)
        recordInTwoParts(path, *turns);
    int status = 0;
    while (!turns->isWritten)
        ASSERT_EQ(waitpid(child, &status, WNOHANG), 0) << "it ended by itself";
    makeApplication();
    for (int look = 0; look < 3; ++look) {
        const auto recording = Recording::open(path);
        EXPECT_TRUE(recording);
        if (recording) {
            EXPECT_EQ(readAllFrames(recording->reader(0)).time_ns.size(), std::size_t{kBeforeAndAfter});
        }
    }
    EXPECT_TRUE(std::filesystem::exists(path + "-wal"));
    turns->wasRead = true;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    EXPECT_FALSE(std::filesystem::exists(path + "-wal"));
    const auto recording = Recording::open(path);
    ASSERT_TRUE(recording) << core::describe(recording.error());
    EXPECT_TRUE(recording->isComplete());
    EXPECT_EQ(readAllFrames(recording->reader(0)).time_ns.size(), std::size_t{2 * kBeforeAndAfter});
    munmap(memory, sizeof(Turns));
}

// Killed at random instants, a recording always opens, is intact, and has all frames up to its last
// transaction. That lies less than half a second back, but where the disk itself held the writer up.
TEST(RecordingKill, aRecordingKilledAtRandomInstantsOpensWithAllButItsLastMoment) {
    constexpr int kKills = 20;
    const TemporaryFolder folder;
    void* memory =
        mmap(nullptr, sizeof(LastWords), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    ASSERT_NE(memory, MAP_FAILED);
    auto* words = new (memory) LastWords;
    std::uint32_t random = 7;
    double longest_s = 0.0;
    int late = 0;
    int withFrames = 0;
    for (int kill = 0; kill < kKills; ++kill) {
        const std::string path = folder.path("killed" + std::to_string(kill) + ".teleta");
        words->committed = 0;
        words->appended_ns = 0;
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0)
            recordForever(path, *words);
        random = random * 1664525U + 1013904223U;
        poll(nullptr, 0, 20 + static_cast<int>(random >> 22U)); // up to 1 s
        ::kill(child, SIGKILL);
        int status = 0;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself";

        if (words->committed.load() == 0 && !std::filesystem::exists(path))
            continue; // it had not come so far
        const auto recording = Recording::open(path);
        if (words->committed.load() == 0 && !recording) {
            // Killed while the file was made: that is told, nothing more.
            EXPECT_EQ(recording.error().kind, core::ErrorKind::badInput) << core::describe(recording.error());
            continue;
        }
        ASSERT_TRUE(recording) << core::describe(recording.error());
        EXPECT_FALSE(recording->isComplete());
        EXPECT_FALSE(std::filesystem::exists(path + "-wal")) << "the file alone is not the recording";
        EXPECT_EQ(askFile(path, QStringLiteral("PRAGMA integrity_check")), "ok");
        std::uint64_t frames = 0;
        std::int64_t newest_ns = 0;
        for (std::size_t stream = 0; stream < recording->streams().size(); ++stream) {
            const auto extent = recording->extent(stream).value();
            frames += extent ? extent->frames : 0;
            newest_ns = std::max(newest_ns, extent ? extent->last_ns : 0);
        }
        EXPECT_GE(frames, words->committed.load());
        if (frames == 0)
            continue;
        ++withFrames;
        const ReadFrames array = readAllFrames(recording->reader(0));
        for (std::size_t i = 0; i < array.time_ns.size(); ++i)
            ASSERT_EQ(array.values[i * kTaxels], static_cast<float>(i)) << "a frame is missing in between";
        const double missing_s = static_cast<double>(words->appended_ns.load() - newest_ns) * 1e-9;
        longest_s = std::max(longest_s, missing_s);
        late += missing_s > 0.5 ? 1 : 0;
    }
    std::printf("%d killed recordings with frames, at most %.3f s missing\n", withFrames, longest_s);
    EXPECT_LE(late, withFrames / 4) << "more than the last half second is missing";
    EXPECT_GT(withFrames, kKills / 3) << "it was hardly ever killed at work";
    munmap(memory, sizeof(LastWords));
}
