// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/recording/recorded_files.h"

#include <csignal>
#include <filesystem>
#include <sys/resource.h>
#include <unistd.h>

using namespace teleta;
using namespace teleta::recording;
using namespace teleta::test;

namespace {

class RecorderFaults : public testing::Test {
protected:
    RecorderFaults() { makeApplication(); }

    [[nodiscard]] std::string path() const { return m_folder.path("run.teleta"); }
    [[nodiscard]] core::Expected<std::unique_ptr<Recorder>> start(const std::string& path) const {
        return Recorder::start(path, headAt(m_start_ns));
    }

    TemporaryFolder m_folder;
    std::int64_t m_start_ns = core::steadyNow_ns();
};

} // namespace

TEST_F(RecorderFaults, nobodysFileIsWrittenOver) {
    const std::string there = m_folder.write("run.teleta", "somebody's");
    const auto recorder = start(there);
    ASSERT_FALSE(recorder);
    EXPECT_EQ(recorder.error().kind, core::ErrorKind::refused);
    EXPECT_EQ(readAll(there), "somebody's");
}

TEST_F(RecorderFaults, aFolderThatIsNotThereIsAnError) {
    const auto recorder = start(m_folder.path("none/run.teleta"));
    ASSERT_FALSE(recorder);
    EXPECT_EQ(recorder.error().kind, core::ErrorKind::ioFailed);
    EXPECT_NE(recorder.error().expected, "");
}

// Root may write anywhere, so that another user has to try.
TEST_F(RecorderFaults, aReadOnlyFolderIsAnErrorAndARecordingInItCanBeRead) {
    {
        auto recorder = start(path()).value();
        appendFrame(*recorder->addStream(arrayInfo()), m_start_ns, 1.0F);
        ASSERT_TRUE(recorder->stop());
    }
    namespace fs = std::filesystem;
    fs::permissions(path(), fs::perms(0444));
    fs::permissions(m_folder.path("."), fs::perms(0555));
    constexpr uid_t kNobody = 65'534;
    const uid_t user = geteuid();
    if (user == 0) {
        ASSERT_EQ(seteuid(kNobody), 0);
    }
    const auto refused = start(m_folder.path("other.teleta"));
    std::size_t frames = 0;
    if (const auto recording = Recording::open(path()))
        frames = readAllFrames(recording->reader(0)).time_ns.size();
    if (user == 0) {
        ASSERT_EQ(seteuid(user), 0);
    }
    fs::permissions(m_folder.path("."), fs::perms(0755));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, core::ErrorKind::ioFailed);
    EXPECT_EQ(frames, 1U);
    EXPECT_FALSE(fs::exists(m_folder.path("other.teleta")));
}

TEST_F(RecorderFaults, aDiskThatIsFullAtTheStartIsAnErrorAndLeavesNoFile) {
    const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    rlimit full = before;
    full.rlim_cur = 0;
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &full), 0);
    const auto recorder = start(path());
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, ignored);
    ASSERT_FALSE(recorder);
    EXPECT_EQ(recorder.error().kind, core::ErrorKind::ioFailed);
    EXPECT_EQ(m_folder.entries(), 0U);
}

// A limit on the size of files stands for a disk that is full: the write-ahead log cannot grow.
TEST_F(RecorderFaults, aFullDiskEndsTheRecordingWithAMessageAndLeavesWhatWasWritten) {
    auto recorder = start(path()).value();
    const auto tap = recorder->addStream(arrayInfo());
    std::int64_t time_ns = m_start_ns;
    for (int i = 0; i < 500; ++i)
        appendFrame(*tap, ++time_ns, static_cast<float>(i));
    while (recorder->status().frames < 500)
        std::this_thread::yield();

    const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    rlimit full = before;
    full.rlim_cur = std::filesystem::file_size(path() + "-wal");
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &full), 0);
    for (int i = 500; recorder->status().state == RecorderStatus::State::recording; ++i) {
        if (i < 4000)
            appendFrame(*tap, ++time_ns, static_cast<float>(i));
        std::this_thread::yield();
    }
    const auto stopped = recorder->stop();
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, ignored);

    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().kind, core::ErrorKind::ioFailed);
    EXPECT_NE(stopped.error().message, "");
    EXPECT_EQ(stopped.error().where.file, path());
    EXPECT_TRUE(tap->isClosed()) << "the data thread is to go on without it";
    const std::uint64_t written = recorder->status().frames;
    recorder.reset();

    const auto recording = Recording::open(path());
    ASSERT_TRUE(recording) << core::describe(recording.error());
    EXPECT_FALSE(recording->isComplete());
    const ReadFrames all = readAllFrames(recording->reader(0));
    EXPECT_EQ(all.time_ns.size(), written);
    ASSERT_GE(all.time_ns.size(), 500U);
    for (std::size_t i = 0; i < all.time_ns.size(); ++i)
        ASSERT_EQ(all.values[i * kTaxels], static_cast<float>(i));
    EXPECT_EQ(askFile(path(), QStringLiteral("PRAGMA integrity_check")), "ok");
}
