// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/recording/mark_changes.h"
#include "backend/recording/recording_database.h"
#include "tests/backend/recording/recorded_files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <span>
#include <sys/stat.h>

using namespace teleta;
using namespace teleta::recording;
using namespace teleta::test;

namespace {

constexpr std::int64_t kPeriod_ns = 5'000'000;

class RecordingTest : public testing::Test {
protected:
    RecordingTest() { makeApplication(); }

    /// 3000 frames from 1 s on, in blocks that a jump ends after each hundred.
    std::string write() {
        auto recorder = Recorder::start(path(), headAt(0), {.simulatedTime = true});
        EXPECT_TRUE(recorder);
        const auto tap = (*recorder)->addStream(arrayInfo());
        for (int i = 0; i < 3000; ++i) {
            const std::array<float, kTaxels> values{static_cast<float>(i)};
            tap->append(1'000'000'000 + i * kPeriod_ns, i * 0.005, std::span<const float>(values),
                        i % 100 == 0);
        }
        EXPECT_TRUE((*recorder)->stop());
        return path();
    }
    [[nodiscard]] std::string path() const { return m_folder.path("run.teleta"); }

    TemporaryFolder m_folder;
};

core::Error openError(const std::string& path) {
    const auto recording = Recording::open(path);
    EXPECT_FALSE(recording);
    return recording ? core::Error{} : recording.error();
}

} // namespace

TEST_F(RecordingTest, aSeekFindsTheBlockThatHoldsTheTime) {
    const auto recording = Recording::open(write());
    ASSERT_TRUE(recording) << core::describe(recording.error());
    const auto extent = recording->extent(0).value();
    ASSERT_TRUE(extent);
    EXPECT_EQ(extent->first_ns, 1'000'000'000);
    EXPECT_EQ(extent->last_ns, 1'000'000'000 + 2999 * kPeriod_ns);
    EXPECT_EQ(extent->frames, 3000U);
    StreamReader reader = recording->reader(0);
    core::TappedFrames block;
    for (const int frame : {0, 1, 99, 100, 1550, 2999}) {
        const std::int64_t time_ns = 1'000'000'000 + frame * kPeriod_ns;
        ASSERT_TRUE(reader.seek(time_ns));
        ASSERT_TRUE(reader.next(block).value());
        EXPECT_EQ(block.time_ns.front(), time_ns - frame % 100 * kPeriod_ns);
        EXPECT_EQ(valuesOf<float>(block, static_cast<std::size_t>(frame % 100), kTaxels)[0],
                  static_cast<float>(frame));
    }
    ASSERT_TRUE(reader.seek(-1)); // before all
    ASSERT_TRUE(reader.next(block).value());
    EXPECT_EQ(block.time_ns.front(), 1'000'000'000);
    ASSERT_TRUE(reader.seek(std::numeric_limits<std::int64_t>::max())); // behind all
    ASSERT_TRUE(reader.next(block).value());
    EXPECT_EQ(block.time_ns.back(), extent->last_ns);
    EXPECT_FALSE(reader.next(block).value());
}

TEST_F(RecordingTest, aMarkIsChangedWhileTheFileIsPlayed) {
    const std::string path = write();
    askFile(path,
            QStringLiteral(
                "INSERT INTO event (time_ns, kind, text, value) VALUES (2000000000, 'mark', 'slip', 7)"));
    const auto recording = Recording::open(path);
    ASSERT_TRUE(recording) << core::describe(recording.error());
    StreamReader reader = recording->reader(0);
    core::TappedFrames block;
    ASSERT_TRUE(reader.next(block).value());
    const MarkChange change{.number = 7, .note = "it slipped"};
    const auto changed = changeMarks(path, std::span(&change, 1));
    ASSERT_TRUE(changed) << core::describe(changed.error());
    // The reader goes on where it was.
    std::size_t frames = block.frames();
    while (reader.next(block).value())
        frames += block.frames();
    EXPECT_EQ(frames, 3000U);
    EXPECT_FALSE(reader.next(block).value());
    const auto again = Recording::open(path);
    ASSERT_TRUE(again);
    EXPECT_TRUE(std::ranges::any_of(again->events(), [](const RecordingEvent& event) {
        return event.kind == kMark && event.text == "it slipped";
    }));
}

TEST_F(RecordingTest, aFileThatIsNoRecordingIsToldFromOneThatIs) {
    EXPECT_EQ(openError(m_folder.path("none.teleta")).kind, core::ErrorKind::notFound);

    const std::string text = m_folder.write("text.teleta", "time_s,t0\n0,1\n");
    EXPECT_EQ(openError(text).kind, core::ErrorKind::badInput);
    EXPECT_EQ(openError(text).message, "this is not a recording");
    EXPECT_FALSE(Recording::looksLikeOne(text));
    EXPECT_EQ(openError(m_folder.write("empty.teleta", "")).message, "this is not a recording");

    const std::string other = m_folder.path("other.sqlite");
    askFile(other, QStringLiteral("CREATE TABLE study (one INTEGER)"));
    EXPECT_EQ(openError(other).kind, core::ErrorKind::badInput);
    EXPECT_EQ(openError(other).message, "this is an SQLite database, but not a recording");

    EXPECT_TRUE(Recording::looksLikeOne(write()));
}

TEST_F(RecordingTest, aFileOfANewerVersionIsRefusedWithBothNumbers) {
    const std::string path = write();
    askFile(path, QStringLiteral("PRAGMA user_version = 99"));
    const core::Error error = openError(path);
    EXPECT_EQ(error.kind, core::ErrorKind::badInput);
    EXPECT_NE(error.message.find("newer version"), std::string::npos) << error.message;
    EXPECT_NE(error.message.find("99"), std::string::npos) << error.message;
    EXPECT_NE(error.expected.find(std::to_string(RecordingDatabase::currentSchema())), std::string::npos)
        << error.expected;
}

TEST_F(RecordingTest, aBlockThatIsNotWholeIsToldAndTheNextOneIsRead) {
    const std::string path = write();
    askFile(path, QStringLiteral("UPDATE block SET data = x'00' WHERE key = 3"));
    askFile(path, QStringLiteral("UPDATE block SET time_ns = zeroblob(8 * frames - 8) || x'ff00000000000080' "
                                 "WHERE key = 5"));
    askFile(path, QStringLiteral("UPDATE block SET frames = -1 WHERE key = 7"));
    const auto recording = Recording::open(path);
    ASSERT_TRUE(recording);
    StreamReader reader = recording->reader(0);
    core::TappedFrames block;
    int whole = 0;
    std::vector<std::string> told;
    for (;;) {
        const auto any = reader.next(block);
        if (any && !*any)
            break;
        if (any) {
            ++whole;
            continue;
        }
        EXPECT_EQ(any.error().kind, core::ErrorKind::badInput);
        ASSERT_TRUE(reader.canGoOn());
        told.push_back(any.error().message);
    }
    EXPECT_EQ(whole, 27);
    ASSERT_EQ(told.size(), 3U);
    EXPECT_NE(told[0].find("block 3"), std::string::npos) << told[0];
}

// Each page of a file may be in a bad sector of the disk.
TEST_F(RecordingTest, aPageThatCannotBeReadTakesOnlyItsBlock) {
    constexpr int kBlocks = 12;
    const std::vector<std::vector<int>> cases{{0}, {5}, {0, 5, 6}, {11}};
    int number = 0;
    for (const std::vector<int>& lost : cases) {
        const std::string path = m_folder.path("large" + std::to_string(++number) + ".teleta");
        recordLargeBlocks(path, 0, kBlocks);
        for (const int block : lost)
            damageLargeBlock(path, block);
        const auto recording = Recording::open(path);
        ASSERT_TRUE(recording) << core::describe(recording.error());
        EXPECT_EQ(recording->extent(0).value()->frames, static_cast<std::uint64_t>(kBlocks * kLargeFrames));
        StreamReader reader = recording->reader(0);
        core::TappedFrames block;
        const auto blockNumber = [&] {
            return static_cast<int>(valuesOf<float>(block, 0, kLargeTaxels)[0]) / kLargeFrames;
        };
        std::vector<int> read;
        std::size_t damaged = 0;
        for (;;) {
            const auto any = reader.next(block);
            if (any && !*any)
                break;
            if (any) {
                read.push_back(blockNumber());
                continue;
            }
            EXPECT_EQ(any.error().kind, core::ErrorKind::badInput);
            ASSERT_TRUE(reader.canGoOn());
            ASSERT_LE(++damaged, lost.size());
        }
        std::vector<int> whole;
        for (int i = 0; i < kBlocks; ++i) {
            if (!std::ranges::binary_search(lost, i))
                whole.push_back(i);
        }
        EXPECT_EQ(read, whole);
        EXPECT_EQ(damaged, lost.size());

        // The other way.
        ASSERT_TRUE(reader.seek(std::numeric_limits<std::int64_t>::max()));
        if (!std::ranges::binary_search(lost, kBlocks - 1)) {
            ASSERT_TRUE(reader.next(block).value());
            EXPECT_EQ(blockNumber(), kBlocks - 1);
            whole.pop_back();
        }
        for (; !whole.empty(); whole.pop_back()) {
            ASSERT_TRUE(reader.previous(block).value());
            EXPECT_EQ(blockNumber(), whole.back());
        }
        EXPECT_FALSE(reader.previous(block).value());
    }
}

// A page of small blocks has the sizes of whole ones, too.
TEST_F(RecordingTest, aPageOfSmallBlocksThatCannotBeReadTakesOnlyThose) {
    write();
    constexpr std::size_t kBytes = kTaxels * sizeof(float);
    const std::array<float, kTaxels> frame{1550.0F};
    damagePageWith(path(), {reinterpret_cast<const char*>(frame.data()), kBytes});
    const auto recording = Recording::open(path());
    ASSERT_TRUE(recording) << core::describe(recording.error());
    const auto extent = recording->extent(0);
    ASSERT_TRUE(extent) << core::describe(extent.error());
    ASSERT_TRUE(*extent);
    EXPECT_EQ((*extent)->first_ns, 1'000'000'000);
    EXPECT_EQ((*extent)->last_ns, 1'000'000'000 + 2999 * kPeriod_ns);
    StreamReader reader = recording->reader(0);
    core::TappedFrames block;
    std::uint64_t frames = 0;
    int damaged = 0;
    for (;;) {
        const auto any = reader.next(block);
        if (any && !*any)
            break;
        ASSERT_TRUE(any || reader.canGoOn());
        frames += any ? block.frames() : 0;
        damaged += any ? 0 : 1;
    }
    EXPECT_GE(damaged, 1);
    EXPECT_LT(frames, 3000U);
    EXPECT_GT(frames, 2000U);
    EXPECT_EQ((*extent)->frames, frames);
}

// A table that breaks off is not one that ends.
TEST_F(RecordingTest, damageInATableIsNotTakenForItsEnd) {
    {
        auto recorder = Recorder::start(path(), headAt(0), {.simulatedTime = true}).value();
        for (int i = 0; i < 2000; ++i)
            recorder->add({.time_ns = i, .kind = kMark, .text = "note " + std::to_string(i) + " of many"});
        ASSERT_TRUE(recorder->stop());
    }
    std::string content = readAll(path());
    const std::size_t note = content.find("note 1500 of");
    ASSERT_NE(note, std::string::npos);
    constexpr std::size_t kPage = 4096;
    content.replace(note / kPage * kPage, 64, 64, '\xff');
    const core::Error error = openError(m_folder.write("damaged.teleta", content));
    EXPECT_EQ(error.kind, core::ErrorKind::badInput);
    EXPECT_NE(error.message.find("damaged"), std::string::npos) << error.message;
}

TEST_F(RecordingTest, blocksAreReadBackwardsWithoutTheDamagedOnes) {
    const std::string path = write();
    askFile(path, QStringLiteral("UPDATE block SET data = x'00' WHERE key = 3"));
    const auto recording = Recording::open(path);
    StreamReader reader = recording->reader(0);
    core::TappedFrames block;
    EXPECT_FALSE(reader.previous(block).value()) << "nothing was read";
    ASSERT_TRUE(reader.seek(1'000'000'000 + 350 * kPeriod_ns));
    ASSERT_TRUE(reader.next(block).value());
    const auto firstFrame = [&] { return valuesOf<float>(block, 0, kTaxels)[0]; };
    EXPECT_EQ(firstFrame(), 300.0F);
    ASSERT_TRUE(reader.previous(block).value());
    EXPECT_EQ(firstFrame(), 100.0F);
    ASSERT_TRUE(reader.previous(block).value());
    EXPECT_EQ(firstFrame(), 0.0F);
    EXPECT_FALSE(reader.previous(block).value());
    EXPECT_EQ(firstFrame(), 0.0F);
    ASSERT_TRUE(reader.next(block).value());
    EXPECT_EQ(firstFrame(), 100.0F);
}

TEST_F(RecordingTest, aStreamThatIsDescribedByNonsenseIsDamage) {
    const std::string path = write();
    for (const char* change :
         {"UPDATE stream SET shape = '2x'", "UPDATE stream SET shape = '2x3', kind = 'smell'",
          "UPDATE stream SET kind = 'array', shape = '99999999x99999999'",
          "UPDATE stream SET shape = '2x3', type = 'float16'"}) {
        askFile(path, QString::fromLatin1(change));
        EXPECT_EQ(openError(path).kind, core::ErrorKind::badInput) << change;
    }
    askFile(path, QStringLiteral("UPDATE stream SET type = 'float32'"));
    EXPECT_TRUE(Recording::open(path));
}

TEST_F(RecordingTest, bytesOverwrittenAnywhereGiveAnErrorOrFramesButNoCrash) {
    const std::string path = write();
    const std::string content = readAll(path);
    std::uint32_t random = 12345;
    const auto next = [&random] { return random = random * 1664525U + 1013904223U; };
    int errors = 0;
    for (int round = 0; round < 200; ++round) {
        std::string damaged = content;
        for (int i = 0; i < 32; ++i)
            damaged[next() % damaged.size()] = static_cast<char>(next() >> 24U);
        if (round % 3 == 0)
            damaged.resize(next() % damaged.size());
        const std::string file = m_folder.write("damaged.teleta", damaged);
        const auto recording = Recording::open(file);
        if (!recording) {
            ++errors;
            continue;
        }
        for (std::size_t stream = 0; stream < recording->streams().size(); ++stream) {
            StreamReader reader = recording->reader(stream);
            core::TappedFrames block;
            for (int blocks = 0; blocks < 100; ++blocks) {
                const auto any = reader.next(block);
                errors += any ? 0 : 1;
                if ((any && !*any) || !reader.canGoOn())
                    break;
            }
        }
    }
    EXPECT_GT(errors, 0);
}

TEST_F(RecordingTest, isForItsOwnerAloneWhateverTheUmask) {
    const mode_t before = ::umask(0);
    const std::string file = write();
    ::umask(before);
    EXPECT_EQ(std::filesystem::status(file).permissions(),
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
}

TEST_F(RecordingTest, isNeitherAPipeNorADevice) {
    ASSERT_EQ(::mkfifo(path().c_str(), 0600), 0);
    for (const std::string& other : {path(), std::string("/dev/zero")}) {
        EXPECT_EQ(openError(other).kind, core::ErrorKind::badInput) << other;
        EXPECT_FALSE(Recording::looksLikeOne(other)) << other;
    }
}

TEST_F(RecordingTest, refusesASchemaThatRunsCode) {
    (void)write();
    const auto execute = [this](const QString& statement) {
        RecordingDatabase database(path());
        ASSERT_TRUE(database.openForWriting()) << statement.toStdString();
        ASSERT_TRUE(database.run(statement)) << statement.toStdString();
    };
    execute(QStringLiteral("DROP TABLE event"));
    // Whoever reads this view never comes back.
    execute(
        QStringLiteral("CREATE VIEW event AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) "
                       "SELECT i AS key, i AS time_ns, 'mark' AS kind, '' AS text, 0.0 AS value FROM n"));
    const core::Error error = openError(path());
    EXPECT_EQ(error.kind, core::ErrorKind::badInput);
    EXPECT_NE(error.message.find("view, \"event\""), std::string::npos) << error.message;
}
