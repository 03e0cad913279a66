// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"
#include "tests/backend/recording/recorded_files.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <string>
#include <thread>

using teleta::test::askFile;
using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::RunningProgram;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

class ReplayCommand : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_EQ(
            run({"simulate", "tactile-indenter", "--duration", "3", "--out", m_folder.path("run")}).exitCode,
            0);
    }
    [[nodiscard]] std::string recording() const { return m_folder.path("run/recording.teleta"); }

    TemporaryFolder m_folder;
};

} // namespace

TEST_F(ReplayCommand, theFeaturesAreThoseOfTheFramesThatWereRecorded) {
    const ProgramResult replayed = run({"replay", recording(), "--threshold", "0.1"});
    ASSERT_EQ(replayed.exitCode, 0) << replayed.err;
    const ProgramResult computed = run({"features", m_folder.path("run/frames.csv"), "--threshold", "0.1"});
    ASSERT_EQ(computed.exitCode, 0) << computed.err;
    const auto rows = splitCsv(replayed.out);
    const auto expected = splitCsv(computed.out);
    ASSERT_EQ(rows.size(), expected.size());
    ASSERT_GT(rows.size(), 300U);
    EXPECT_EQ(rows[0], expected[0]);
    std::size_t touching = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        ASSERT_NEAR(std::stod(rows[i][0]), std::stod(expected[i][0]), 1e-9);
        ASSERT_TRUE(std::equal(rows[i].begin() + 1, rows[i].end(), expected[i].begin() + 1)) << "row " << i;
        touching += rows[i][1] != "none" ? 1 : 0;
    }
    EXPECT_GT(touching, 10U);
}

// Large frames take longer to compute than to read, so that the reader is always ahead.
TEST(ReplayCommandOnLongRecordings, noRowIsMissing) {
    const TemporaryFolder folder;
    ASSERT_EQ(run({"simulate", "tactile-mat", "--duration", "50", "--out", folder.path("run")}).exitCode, 0);
    const ProgramResult replayed =
        run({"replay", folder.path("run/recording.teleta"), "--out", folder.path("f.csv")});
    ASSERT_EQ(replayed.exitCode, 0) << replayed.err;
    EXPECT_EQ(replayed.err, "");
    EXPECT_EQ(splitCsv(readAll(folder.path("f.csv"))).size(), 1U + 5000U) << "100 frames a second";
}

TEST_F(ReplayCommand, aSpeedPacesItAndAnInterruptionCompletesTheFile) {
    // So slow that all of the recording would take five minutes.
    RunningProgram program({"replay", recording(), "--speed", "0.01", "--out", m_folder.path("f.csv")});
    // The first row; not just any text: the recording itself is among the open files.
    while (!program.hasWritten("active\n0") && !program.ended())
        std::this_thread::yield();
    program.send(SIGINT);
    const ProgramResult result = program.wait();
    EXPECT_EQ(result.exitCode, 1) << result.err;
    const auto rows = splitCsv(readAll(m_folder.path("f.csv")));
    EXPECT_GE(rows.size(), 2U);
    EXPECT_LT(rows.size(), 300U) << "it was not paced";
}

TEST_F(ReplayCommand, framesThatAreMissingAreTold) {
    // The writer makes a block of 512 frames at most.
    askFile(recording(), QStringLiteral("UPDATE block SET data = x'00' WHERE key = 1"));
    const std::string blocks = askFile(recording(), QStringLiteral("SELECT COUNT(*) FROM block"));
    const std::string whole =
        askFile(recording(), QStringLiteral("SELECT SUM(frames) FROM block WHERE key > 1"));
    ASSERT_GT(std::stoi(blocks), 1);
    const ProgramResult replayed = run({"replay", recording(), "--out", m_folder.path("f.csv")});
    EXPECT_EQ(replayed.exitCode, 0);
    EXPECT_EQ(replayed.err, "teleta: 1 damaged block left out, 0 frames lost at this speed\n");
    EXPECT_EQ(splitCsv(readAll(m_folder.path("f.csv"))).size(), 1U + std::stoul(whole));
}

TEST_F(ReplayCommand, settingsThatChangedDuringTheRecordingAreTold) {
    for (const char* text : {"nonsense", "[]", R"({"stream":"other","settings":{}})"})
        askFile(recording(), QStringLiteral("INSERT INTO event (time_ns, kind, text, value) "
                                            "VALUES (0, 'settings', '%1', 0)")
                                 .arg(QLatin1String(text)));
    EXPECT_EQ(run({"replay", recording(), "--out", m_folder.path("f.csv")}).err, "");
    askFile(recording(), QStringLiteral("UPDATE event SET text = '{\"stream\":\"frames\",\"settings\":{}}' "
                                        "WHERE text = 'nonsense'"));
    const ProgramResult replayed = run({"replay", recording(), "--out", m_folder.path("g.csv")});
    EXPECT_EQ(replayed.exitCode, 0) << replayed.err;
    EXPECT_NE(replayed.err.find("settings changed"), std::string::npos) << replayed.err;
    EXPECT_EQ(readAll(m_folder.path("f.csv")), readAll(m_folder.path("g.csv")));
}

TEST_F(ReplayCommand, aStreamThatIsNotDescribedDoesNotHideTheOthers) {
    const std::string folder = m_folder.path("arm");
    ASSERT_EQ(run({"simulate", "teleta-touch", "--duration", "0.5", "--out", folder}).exitCode, 0);
    const std::string arm = folder + "/recording.teleta";
    askFile(arm, QStringLiteral("UPDATE stream SET details = 'nonsense' WHERE kind = 'joints'"));
    const ProgramResult replayed = run({"replay", arm, "--out", m_folder.path("f.csv")});
    EXPECT_EQ(replayed.exitCode, 0) << replayed.err;
    askFile(arm, QStringLiteral("UPDATE stream SET details = 'nonsense'"));
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{"replay", arm}, {"replay", arm, "--stream", "frames"}}) {
        const ProgramResult refused = run(options);
        EXPECT_EQ(refused.exitCode, 3);
        EXPECT_NE(refused.err.find("frames"), std::string::npos) << refused.err;
    }
}

TEST_F(ReplayCommand, aStreamIsChosenByItsName) {
    EXPECT_EQ(run({"replay", recording(), "--stream", "frames", "--out", m_folder.path("f.csv")}).exitCode,
              0);
    const ProgramResult unknown = run({"replay", recording(), "--stream", "skin"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_NE(unknown.err.find("frames"), std::string::npos) << unknown.err;
}

TEST_F(ReplayCommand, whatIsNoRecordingIsABadInput) {
    EXPECT_EQ(run({"replay", m_folder.path("run/frames.csv")}).exitCode, 3);
    EXPECT_EQ(run({"replay", m_folder.path("none.teleta")}).exitCode, 3);
    EXPECT_EQ(run({"replay", recording(), "--speed", "0"}).exitCode, 2);
}

TEST(ReplayCommandOfACamera, theContactsAreThoseOfTheRun) {
    TemporaryFolder folder;
    ASSERT_EQ(run({"simulate", "vtacarm-bump", "--duration", "0.7", "--out", folder.path("run")}).exitCode,
              0);
    const std::string recording = folder.path("run/recording.teleta");
    const ProgramResult replayed = run({"replay", recording});
    ASSERT_EQ(replayed.exitCode, 0) << replayed.err;
    const auto rows = splitCsv(replayed.out);
    const auto expected = splitCsv(readAll(folder.path("run/contacts.csv")));
    ASSERT_EQ(rows.size(), expected.size());
    ASSERT_GT(rows.size(), 3U) << "the finger comes after 0.45 s, then the arm draws back";
    EXPECT_EQ(rows[0], expected[0]);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i][0], expected[i][0]) << "frame of row " << i;
        EXPECT_NEAR(std::stod(rows[i][1]), std::stod(expected[i][1]), 1e-8);
        for (std::size_t column = 2; column < rows[i].size(); ++column)
            EXPECT_EQ(rows[i][column], expected[i][column]) << "row " << i << ", column " << column;
    }
    EXPECT_EQ(run({"replay", recording, "--threshold", "1"}).exitCode, 2);

    ASSERT_EQ(run({"export", recording, "--csv", folder.path("csv")}).exitCode, 0);
    EXPECT_EQ(splitCsv(readAll(folder.path("csv/camera.csv"))).size(), 1U + 28U) << "0.7 s at 40 Hz";
    EXPECT_EQ(splitCsv(readAll(folder.path("csv/reference.csv"))).size(), 2U);
    EXPECT_EQ(splitCsv(readAll(folder.path("csv/contacts.csv"))).size(), expected.size());
}

namespace {

/// A block of the camera in a recording of teleta simulate: the picture of that frame, counted with the
/// reference, which is 0.
QString pictureBlock(int frame) {
    return QStringLiteral("key = (SELECT key FROM block WHERE stream = (SELECT key FROM stream WHERE name = "
                          "'camera') ORDER BY key LIMIT 1 OFFSET %1)")
        .arg(frame - 1);
}

} // namespace

TEST(ReplayCommandOfACamera, contactsBeforeAndBehindAJumpAreNotTheSame) {
    const TemporaryFolder folder;
    ASSERT_EQ(run({"simulate", "vtacarm-bump", "--duration", "0.7", "--out", folder.path("run")}).exitCode,
              0);
    const std::string recording = folder.path("run/recording.teleta");
    const auto before = splitCsv(run({"replay", recording}).out);
    ASSERT_GT(before.size(), 3U);
    ASSERT_EQ(std::stoi(before[2][0]), std::stoi(before[1][0]) + 1) << "the contact lasts two frames";
    ASSERT_EQ(before[2].back(), "NA");
    askFile(recording, QStringLiteral("UPDATE block SET discontinuity = 1 WHERE ") +
                           pictureBlock(std::stoi(before[2][0])));
    const auto after = splitCsv(run({"replay", recording}).out);
    ASSERT_GT(after.size(), 2U);
    EXPECT_EQ(after[1], before[1]);
    EXPECT_EQ(after[2][0], before[2][0]);
    EXPECT_NE(after[2].back(), "NA") << "a contact begins";
}

TEST(ReplayCommandOfACamera, picturesAreComparedWithTheReferenceOfTheirTime) {
    const TemporaryFolder folder;
    ASSERT_EQ(run({"simulate", "vtacarm-bump", "--duration", "0.7", "--out", folder.path("run")}).exitCode,
              0);
    const std::string recording = folder.path("run/recording.teleta");
    const auto before = splitCsv(run({"replay", recording}).out);
    ASSERT_GT(before.size(), 3U);
    // As if somebody had renewed it with the first picture that shows a contact.
    const std::string touched = before[1][0];
    askFile(recording, QStringLiteral("INSERT INTO block (stream, first_ns, last_ns, frames, width, height, "
                                      "discontinuity, time_ns, source_time_s, data) "
                                      "SELECT (SELECT key FROM stream WHERE name = 'reference'), first_ns, "
                                      "last_ns, frames, width, height, 0, time_ns, source_time_s, data "
                                      "FROM block WHERE ") +
                           pictureBlock(std::stoi(touched)));
    const ProgramResult replayed = run({"replay", recording});
    EXPECT_EQ(replayed.exitCode, 0) << replayed.err;
    for (const auto& row : splitCsv(replayed.out))
        EXPECT_NE(row[0], touched) << "a picture differs from itself";
}

TEST(ReplayCommandOfACamera, aReferenceThatIsDamagedIsPassedOver) {
    const TemporaryFolder folder;
    ASSERT_EQ(run({"simulate", "vtacarm-bump", "--duration", "0.7", "--out", folder.path("run")}).exitCode,
              0);
    const std::string recording = folder.path("run/recording.teleta");
    askFile(recording, QStringLiteral("UPDATE block SET data = x'00' WHERE stream = (SELECT key FROM stream "
                                      "WHERE name = 'reference')"));
    // The first picture, which nothing touches either, takes its place.
    const ProgramResult replayed = run({"replay", recording});
    EXPECT_EQ(replayed.exitCode, 0) << replayed.err;
    EXPECT_GT(splitCsv(replayed.out).size(), 3U);
}

TEST(ReplayCommandOfACamera, picturesThatCannotBeUsedAreTold) {
    const TemporaryFolder folder;
    ASSERT_EQ(run({"simulate", "vtacarm-bump", "--duration", "0.2", "--out", folder.path("run")}).exitCode,
              0);
    const std::string recording = folder.path("run/recording.teleta");
    // As many pixels, but of another shape.
    askFile(recording,
            QStringLiteral("UPDATE block SET width = height, height = width WHERE ") + pictureBlock(3));
    const ProgramResult replayed = run({"replay", recording});
    EXPECT_EQ(replayed.exitCode, 0) << replayed.err;
    EXPECT_NE(replayed.err.find("1 of 9 frames could not be used"), std::string::npos) << replayed.err;
}

TEST(ReplayCommandOfAGel, theContactsAreThoseOfTheRun) {
    const TemporaryFolder folder;
    ASSERT_EQ(run({"simulate", "gel-slip", "--duration", "2.6", "--out", folder.path("run")}).exitCode, 0);
    const std::string recording = folder.path("run/recording.teleta");
    const ProgramResult replayed = run({"replay", recording});
    ASSERT_EQ(replayed.exitCode, 0) << replayed.err;
    const auto rows = splitCsv(replayed.out);
    const auto expected = splitCsv(readAll(folder.path("run/contacts.csv")));
    ASSERT_EQ(rows.size(), expected.size());
    ASSERT_GT(rows.size(), 20U) << "the ball comes after a second";
    EXPECT_EQ(rows[0], expected[0]);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i][0], expected[i][0]) << "frame of row " << i;
        EXPECT_EQ(rows[i][2], expected[i][2]) << "contact of row " << i;
        for (std::size_t column = 3; column + 1 < rows[i].size(); ++column)
            EXPECT_NEAR(std::stod(rows[i][column]), std::stod(expected[i][column]), 1e-9)
                << "row " << i << ", column " << column;
    }
    EXPECT_EQ(run({"replay", recording, "--threshold", "1"}).exitCode, 2);
    ASSERT_EQ(run({"export", recording, "--csv", folder.path("csv")}).exitCode, 0);
    EXPECT_EQ(splitCsv(readAll(folder.path("csv/camera.csv"))).size(), 1U + 65U) << "2.6 s at 25 Hz";
    EXPECT_EQ(splitCsv(readAll(folder.path("csv/reference.csv"))).size(), 2U);
    EXPECT_EQ(splitCsv(readAll(folder.path("csv/contacts.csv"))).size(), expected.size());
}
