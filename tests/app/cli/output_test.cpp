// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <clocale>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

using teleta::test::ProgramResult;
using teleta::test::ProgramSettings;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::RunningProgram;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

class Output : public testing::Test {
protected:
    Output()
        : m_frames(m_folder.write("frames.csv", "time_s,t0,t1\n0,0,0\n0.5,1,3\n1.5,1,0\n")) {}

    ProgramResult start(const std::string& command, std::vector<std::string> options = {},
                        const ProgramSettings& settings = {}) {
        options.insert(options.begin(),
                       {command, m_frames, "--rows", "1", "--columns", "2", "--pitch-mm", "10"});
        return run(options, settings);
    }

    TemporaryFolder m_folder;
    std::string m_frames;
};

} // namespace

TEST_F(Output, asJsonIsOneDocumentWithTheSameKeysAndNullForNA) {
    for (const std::string command : {"features", "contacts"}) {
        const auto csv = splitCsv(start(command).out);
        const ProgramResult result = start(command, {"--json"});
        EXPECT_EQ(result.exitCode, 0);
        const auto document = nlohmann::ordered_json::parse(result.out);
        ASSERT_TRUE(document.is_array());
        ASSERT_EQ(document.size() + 1, csv.size());
        for (std::size_t i = 0; i < document.size(); ++i) {
            std::size_t column = 0;
            for (const auto& [key, value] : document[i].items()) {
                ASSERT_EQ(key, csv[0][column]);
                const std::string& field = csv[i + 1][column++];
                if (field == "NA")
                    EXPECT_TRUE(value.is_null());
                else if (value.is_string())
                    EXPECT_EQ(value.get<std::string>(), field);
                else
                    EXPECT_EQ(value.get<double>(), std::stod(field));
            }
            EXPECT_EQ(column, csv[0].size());
        }
    }
}

TEST_F(Output, asJsonOfNoRowsIsAnEmptyArray) {
    const ProgramResult result = start("contacts", {"--json", "--threshold", "100"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(nlohmann::json::parse(result.out), nlohmann::json::array());
}

TEST_F(Output, intoAFileIsTheSameCsvAndLeavesStandardOutputEmpty) {
    const std::string path = m_folder.path("out.csv");
    const ProgramResult result = start("features", {"--out", path});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(readAll(path), start("features").out);
    EXPECT_EQ(m_folder.entries(), 2U) << "no temporary file is left";
}

TEST_F(Output, jsonAndAFileCanBeHadTogether) {
    const std::string path = m_folder.path("out.csv");
    const ProgramResult result = start("features", {"--out", path, "--json"});
    EXPECT_EQ(nlohmann::json::parse(result.out).size(), 3U);
    EXPECT_EQ(readAll(path), start("features").out);
}

TEST_F(Output, ofWorkThatFailedLeavesAnOlderFileAsItWas) {
    const std::string path = m_folder.write("out.csv", "old");
    m_frames = m_folder.write("frames.csv", "time_s,t0,t1\n0,1,1\n1,1,x\n");
    EXPECT_EQ(start("features", {"--out", path}).exitCode, 3);
    EXPECT_EQ(readAll(path), "old");
    EXPECT_EQ(m_folder.entries(), 2U);
}

TEST_F(Output, thatCannotBeWrittenEndsWith1) {
    const ProgramResult folder = start("features", {"--out", m_folder.path("missing/out.csv")});
    EXPECT_EQ(folder.exitCode, 1);
    EXPECT_NE(folder.err.find("missing/out.csv"), std::string::npos) << folder.err;
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{}, std::vector<std::string>{"--json"}}) {
        const ProgramResult full = start("features", options, {.environment = {}, .outPath = "/dev/full"});
        EXPECT_EQ(full.exitCode, 1);
        EXPECT_NE(full.err.find("standard output: cannot write"), std::string::npos) << full.err;
    }
}

TEST_F(Output, whoseReaderWentAwayEndsQuietlyBySigpipe) {
    const std::string in = m_folder.path("in");
    const std::string out = m_folder.path("out");
    ASSERT_EQ(mkfifo(in.c_str(), 0600), 0);
    ASSERT_EQ(mkfifo(out.c_str(), 0600), 0);
    const int writer = ::open(in.c_str(), O_RDWR | O_CLOEXEC);
    const int reader = ::open(out.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    RunningProgram program({"features", in, "--rows", "1", "--columns", "2"},
                           {.environment = {}, .outPath = out});
    ::close(reader);
    const std::string frames = readAll(m_frames);
    ASSERT_EQ(::write(writer, frames.data(), frames.size()), static_cast<ssize_t>(frames.size()));
    const ProgramResult result = program.wait();
    ::close(writer);
    EXPECT_EQ(result.exitCode, -SIGPIPE);
    EXPECT_EQ(result.err, "");
}

// As with `teleta contacts FRAMES --json | head`: the pipe is full when its reader leaves.
TEST_F(Output, whoseReaderHasSeenEnoughEndsQuietly) {
    std::string frames = "time_s,t0,t1\n";
    constexpr int kFrames = 20'000;
    for (int i = 0; i < kFrames; ++i)
        frames += std::to_string(i) + ",1,3\n";
    m_frames = m_folder.write("many.csv", frames);
    const std::string out = m_folder.path("out");
    ASSERT_EQ(mkfifo(out.c_str(), 0600), 0);
    const int reader = ::open(out.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    RunningProgram program({"contacts", m_frames, "--rows", "1", "--columns", "2", "--json"},
                           {.environment = {}, .outPath = out});
    pollfd some{reader, POLLIN, 0};
    ASSERT_EQ(poll(&some, 1, 60'000), 1);
    char first = 0;
    ASSERT_EQ(::read(reader, &first, 1), 1);
    EXPECT_EQ(first, '[');
    ::close(reader);
    const ProgramResult result = program.wait();
    EXPECT_EQ(result.exitCode, -SIGPIPE);
    EXPECT_EQ(result.err, "");
}

TEST_F(Output, onATerminalIsATableForPeople) {
    const ProgramResult result = start("features", {}, {.environment = {}, .outPath = {}, .terminal = true});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.out.find(','), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("contact_type"), std::string::npos);
    EXPECT_NE(result.out.find("edge"), std::string::npos);
    // The columns line up: every line is as long as the header.
    const std::size_t width = result.out.find('\r');
    std::size_t lines = 0;
    for (std::size_t begin = 0; begin < result.out.size(); begin += width + 2, ++lines)
        ASSERT_EQ(result.out.find('\r', begin), begin + width) << result.out;
    EXPECT_EQ(lines, 4U);
    const ProgramResult json =
        start("features", {"--json"}, {.environment = {}, .outPath = {}, .terminal = true});
    EXPECT_EQ(nlohmann::json::parse(json.out).size(), 3U);
}

TEST_F(Output, doesNotDependOnTheLocale) {
    // A German locale made here, since it is not on every machine; it must really be in effect.
    const std::string made = m_folder.path("de_DE.UTF-8");
    if (std::system(("localedef --no-archive -i de_DE -f UTF-8 " + made + " >/dev/null 2>&1").c_str()) != 0 ||
        !std::filesystem::exists(made))
        GTEST_SKIP() << "skipped: localedef cannot make a German locale here";
    setenv("LOCPATH", m_folder.path("").c_str(), 1);
    ASSERT_NE(std::setlocale(LC_NUMERIC, "de_DE.UTF-8"), nullptr);
    EXPECT_STREQ(std::localeconv()->decimal_point, ",");
    std::setlocale(LC_NUMERIC, "C");
    unsetenv("LOCPATH");

    const ProgramSettings german{
        .environment = {{"LOCPATH", m_folder.path("")}, {"LC_ALL", "de_DE.UTF-8"}, {"LANG", "de_DE.UTF-8"}},
        .outPath = {}};
    for (const std::string command : {"features", "contacts"}) {
        const std::vector<std::string> options{"--threshold", "0.5", "--gain", "1.5"};
        const ProgramResult result = start(command, options, german);
        EXPECT_EQ(result.exitCode, 0) << result.err;
        EXPECT_EQ(result.out, start(command, options).out);
        EXPECT_NE(result.out.find("0.5"), std::string::npos);
        EXPECT_EQ(start(command, {"--json"}, german).out, start(command, {"--json"}).out);
    }
    EXPECT_EQ(start("features", {"--threshold", "0,5"}, german).exitCode, 2);
}

TEST_F(Output, inTheCLocaleHasNoWarnings) {
    const ProgramResult result = start("features", {}, {.environment = {{"LC_ALL", "C"}}, .outPath = {}});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.err, "");
}
