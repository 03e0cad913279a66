// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/recording/recorded_files.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <limits>
#include <sys/mount.h>
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

TEST_F(RecorderFaults, somebodyWhoReadsAtTheEndDoesNotMakeTheRecordingFail) {
    auto recorder = start(path()).value();
    const auto tap = recorder->addStream(arrayInfo());
    for (int i = 0; i < 100; ++i)
        appendFrame(*tap, m_start_ns + i, static_cast<float>(i));
    while (recorder->status().frames < 100)
        std::this_thread::yield();
    {
        const auto reader = Recording::open(path());
        ASSERT_TRUE(reader);
        const auto stopped = recorder->stop();
        EXPECT_TRUE(stopped) << core::describe(stopped.error());
        EXPECT_EQ(recorder->status().state, RecorderStatus::State::stopped);
    }
    const auto recording = Recording::open(path());
    ASSERT_TRUE(recording) << core::describe(recording.error());
    EXPECT_TRUE(recording->isComplete());
    EXPECT_EQ(readAllFrames(recording->reader(0)).time_ns.size(), 100U);
    EXPECT_EQ(askFile(path(), QStringLiteral("PRAGMA integrity_check")), "ok");
}

TEST_F(RecorderFaults, twoMayStopItAtOnce) {
    auto recorder = start(path()).value();
    appendFrame(*recorder->addStream(arrayInfo()), m_start_ns, 1.0F);
    std::jthread other([&] { EXPECT_TRUE(recorder->stop()); });
    EXPECT_TRUE(recorder->stop());
    other.join();
    recorder->mark("too late");
    EXPECT_TRUE(Recording::open(path())->isComplete());
}

TEST_F(RecorderFaults, framesThatAReaderWouldRefuseAreDroppedAndCounted) {
    auto recorder = Recorder::start(path(), headAt(1'000), {.simulatedTime = true}).value();
    const auto tap = recorder->addStream(arrayInfo());
    appendFrame(*tap, 2'000, 1.0F);
    const std::array<float, kTaxels - 1> few{};
    tap->append(3'000, 0.0, std::span<const float>(few));
    const std::array<std::int64_t, 2> backwards_ns{5'000, 4'000};
    const std::array<double, 2> times_s{0.0, 0.0};
    const std::array<float, 2 * kTaxels> two{};
    tap->append(std::span(backwards_ns), std::span(times_s), std::span<const float>(two));
    const std::array<float, kTaxels> one{};
    tap->append(6'000, std::numeric_limits<double>::quiet_NaN(), std::span<const float>(one));
    appendFrame(*tap, 7'000, 2.0F);
    ASSERT_TRUE(recorder->stop());
    EXPECT_EQ(recorder->status().frames, 2U);
    EXPECT_EQ(recorder->status().dropped, 4U);
    const auto recording = Recording::open(path());
    EXPECT_EQ(readAllFrames(recording->reader(0)).time_ns, (std::vector<std::int64_t>{2'000, 7'000}));
    const auto& events = recording->events();
    const auto told = std::ranges::find(events, kDropped, &RecordingEvent::kind);
    ASSERT_NE(told, events.end());
    EXPECT_EQ(told->value, 4.0);
    EXPECT_LE(told->time_ns, 7'000) << "the time of the scene, not of the clock";
}

TEST_F(RecorderFaults, framesWhoseTimeWentBackAreKeptAsAJump) {
    auto recorder = start(path()).value();
    const auto tap = recorder->addStream(arrayInfo());
    for (const std::int64_t time_ns : {5'000, 6'000, 3'000, 4'000})
        appendFrame(*tap, time_ns, static_cast<float>(time_ns));
    ASSERT_TRUE(recorder->stop());
    EXPECT_EQ(recorder->status().dropped, 0U);
    const ReadFrames all = readAllFrames(Recording::open(path())->reader(0));
    EXPECT_EQ(all.time_ns, (std::vector<std::int64_t>{3'000, 4'000, 5'000, 6'000}));
    EXPECT_EQ(all.jumps, 1U);
}

TEST_F(RecorderFaults, numbersThatAreNoneDoNotEndTheRecording) {
    auto recorder = start(path()).value();
    StreamInfo info = arrayInfo();
    info.nominalRate_Hz = std::numeric_limits<double>::quiet_NaN();
    appendFrame(*recorder->addStream(info), m_start_ns, 1.0F);
    recorder->add({.time_ns = m_start_ns,
                   .kind = kMark,
                   .text = "a note",
                   .value = std::numeric_limits<double>::quiet_NaN()});
    const auto stopped = recorder->stop();
    ASSERT_TRUE(stopped) << core::describe(stopped.error());
    const auto recording = Recording::open(path());
    EXPECT_EQ(recording->streams().at(0).nominalRate_Hz, 0.0);
    EXPECT_EQ(recorder->status().marks, 1U);
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

// A disk of 256 kB, where this may be made.
TEST_F(RecorderFaults, aDiskThatHasNoRoomLeftIsToldAsThatAndLeavesWhatWasWritten) {
    const std::string disk = m_folder.path("disk");
    std::filesystem::create_directory(disk);
    if (mount("none", disk.c_str(), "tmpfs", 0, "size=256k") != 0)
        GTEST_SKIP() << "no disk can be mounted here";
    const std::string file = disk + "/run.teleta";
    std::uint64_t written = 0;
    core::Error error;
    {
        auto recorder = start(file).value();
        const auto tap = recorder->addStream(arrayInfo());
        for (int i = 0; recorder->status().state == RecorderStatus::State::recording; ++i) {
            appendFrame(*tap, m_start_ns + i, static_cast<float>(i));
            std::this_thread::sleep_for(std::chrono::microseconds(20));
        }
        const auto stopped = recorder->stop();
        EXPECT_FALSE(stopped);
        error = stopped ? core::Error{} : stopped.error();
        written = recorder->status().frames;
    }
    EXPECT_EQ(error.kind, core::ErrorKind::ioFailed);
    EXPECT_EQ(error.message, "the disk is full");
    // Its log takes no room any more where it is read.
    const std::string copy = m_folder.path("copy.teleta");
    for (const char* part : {"", "-wal"})
        std::filesystem::copy_file(file + part, copy + part);
    EXPECT_EQ(umount(disk.c_str()), 0);
    const auto recording = Recording::open(copy);
    ASSERT_TRUE(recording) << core::describe(recording.error());
    EXPECT_FALSE(recording->isComplete());
    EXPECT_GE(readAllFrames(recording->reader(0)).time_ns.size(), written);
    EXPECT_GT(written, 0U);
}

// Who copies it takes the file alone.
TEST_F(RecorderFaults, aRecordingThatWasCutOffIsWholeWithoutItsLogOnceItWasOpened) {
    namespace fs = std::filesystem;
    const std::string cut = m_folder.path("cut.teleta");
    {
        auto recorder = start(path()).value();
        const auto tap = recorder->addStream(arrayInfo());
        for (int i = 0; i < 100; ++i)
            appendFrame(*tap, m_start_ns + i, static_cast<float>(i));
        while (recorder->status().frames < 100)
            std::this_thread::yield();
        // As a killed program leaves it.
        for (const char* part : {"", "-wal"})
            fs::copy_file(path() + part, cut + part);
    }
    {
        const auto recording = Recording::open(cut);
        ASSERT_TRUE(recording) << core::describe(recording.error());
        EXPECT_FALSE(recording->isComplete());
        EXPECT_EQ(readAllFrames(recording->reader(0)).time_ns.size(), 100U);
    }
    EXPECT_FALSE(fs::exists(cut + "-wal"));
    const std::string copy = m_folder.path("copy.teleta");
    fs::copy_file(cut, copy);
    const auto recording = Recording::open(copy);
    ASSERT_TRUE(recording) << core::describe(recording.error());
    EXPECT_EQ(readAllFrames(recording->reader(0)).time_ns.size(), 100U);
    EXPECT_EQ(askFile(copy, QStringLiteral("PRAGMA integrity_check")), "ok");
}

TEST_F(RecorderFaults, aRecordingThatIsRecordedIsReadWithoutDisturbingIt) {
    auto recorder = start(path()).value();
    const auto tap = recorder->addStream(arrayInfo());
    for (const std::uint64_t frames : {100U, 200U}) {
        while (recorder->status().frames < frames - 100)
            std::this_thread::yield();
        for (std::uint64_t i = frames - 100; i < frames; ++i)
            appendFrame(*tap, m_start_ns + static_cast<std::int64_t>(i), static_cast<float>(i));
        while (recorder->status().frames < frames)
            std::this_thread::yield();
        EXPECT_TRUE(Recording::looksLikeOne(path()));
        const auto recording = Recording::open(path());
        ASSERT_TRUE(recording) << core::describe(recording.error());
        EXPECT_EQ(readAllFrames(recording->reader(0)).time_ns.size(), frames);
        EXPECT_TRUE(std::filesystem::exists(path() + "-wal"));
    }
    ASSERT_TRUE(recorder->stop());
    EXPECT_FALSE(std::filesystem::exists(path() + "-wal"));
    EXPECT_EQ(readAllFrames(Recording::open(path())->reader(0)).time_ns.size(), 200U);
}

TEST_F(RecorderFaults, aRecordingThatWasCutOffIsNotReadWhereItCannotBeCompletedAndThatIsTold) {
    namespace fs = std::filesystem;
    const fs::path cut = m_folder.path("cut");
    fs::create_directory(cut);
    {
        auto recorder = start(path()).value();
        appendFrame(*recorder->addStream(arrayInfo()), m_start_ns, 1.0F);
        while (recorder->status().frames < 1)
            std::this_thread::yield();
        // As a killed program leaves it.
        for (const char* part : {"", "-wal"})
            fs::copy_file(path() + part, cut / (std::string("run.teleta") + part));
    }
    for (const auto& entry : fs::directory_iterator(cut))
        fs::permissions(entry.path(), fs::perms(0444));
    fs::permissions(m_folder.path("."), fs::perms(0755));
    fs::permissions(cut, fs::perms(0555));
    constexpr uid_t kNobody = 65'534;
    const uid_t user = geteuid();
    if (user == 0) {
        ASSERT_EQ(setresuid(kNobody, kNobody, user), 0); // also what access() looks at
    }
    const auto opened = Recording::open((cut / "run.teleta").string());
    if (user == 0) {
        ASSERT_EQ(setresuid(user, user, user), 0);
    }
    fs::permissions(cut, fs::perms(0755));
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().kind, core::ErrorKind::ioFailed);
    EXPECT_NE(opened.error().expected.find("has to be completed"), std::string::npos)
        << core::describe(opened.error());
    const auto recording = Recording::open((cut / "run.teleta").string());
    ASSERT_TRUE(recording) << core::describe(recording.error());
    EXPECT_EQ(readAllFrames(recording->reader(0)).time_ns.size(), 1U);
}
