// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <string>
#include <sys/wait.h>

using nlohmann::json;
using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::TemporaryFolder;

namespace {

class StandardStreams : public testing::Test {
protected:
    /// A line of the shell, in which $T is the program, run in the folder.
    ProgramResult shell(const std::string& line) const {
        const int status = std::system(("export T='" TELETA_PROGRAM "' LC_ALL=C.UTF-8; cd '" +
                                        m_folder.path("") + "' && { " + line + "; } >out.txt 2>err.txt")
                                           .c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readAll(m_folder.path("out.txt")),
                readAll(m_folder.path("err.txt"))};
    }
    std::string file(const std::string& name) const { return readAll(m_folder.path(name)); }

    TemporaryFolder m_folder;
};

} // namespace

TEST_F(StandardStreams, framesComeFromAPipeAndFeaturesGoToOne) {
    m_folder.write("frames.csv", "time_s,t0,t1\n0,1,2\n0.1,2,3\n");
    const std::string options = " --rows 1 --columns 2";
    ASSERT_EQ(shell("\"$T\" features frames.csv" + options + " -o features.csv").exitCode, 0);
    const ProgramResult piped = shell("cat frames.csv | \"$T\" features -" + options + " --out -");
    EXPECT_EQ(piped.exitCode, 0) << piped.err;
    EXPECT_EQ(piped.out, file("features.csv"));
    // What is redirected to a file with >> is not replaced.
    ASSERT_EQ(
        shell("echo first >both.csv; \"$T\" features frames.csv" + options + " -o - >>both.csv").exitCode, 0);
    EXPECT_EQ(file("both.csv"), "first\n" + file("features.csv"));
}

TEST_F(StandardStreams, whatIsWrongInAPipeIsToldWithItsPlace) {
    const ProgramResult wrong =
        shell("printf 'time_s,t0,t1\\n0,1,x\\n' | \"$T\" features - --rows 1 --columns 2");
    EXPECT_EQ(wrong.exitCode, 3);
    EXPECT_NE(wrong.err.find("stdin:2:5"), std::string::npos) << wrong.err;
}

TEST_F(StandardStreams, aCameraIsWrittenToAPipeAndReadFromOne) {
    ASSERT_EQ(
        run({"simulate", "vtacarm-calibration", "--duration", "60", "--out", m_folder.path("run")}).exitCode,
        0);
    ASSERT_EQ(shell("\"$T\" calibrate run/pairs.csv -o camera.json").exitCode, 0);
    const ProgramResult written = shell("\"$T\" calibrate - --out - <run/pairs.csv");
    ASSERT_EQ(written.exitCode, 0) << written.err;
    EXPECT_EQ(json::parse(written.out), json::parse(file("camera.json")));
    EXPECT_NE(written.err.find("px"), std::string::npos) << "the table for people: " << written.err;
    ASSERT_EQ(shell("\"$T\" locate camera.json run/pairs.csv -o points.csv").exitCode, 0);
    const ProgramResult located = shell("cat camera.json | \"$T\" locate - run/pairs.csv");
    ASSERT_EQ(located.exitCode, 0) << located.err;
    EXPECT_EQ(located.out, file("points.csv"));
}

TEST_F(StandardStreams, aSceneAPatternAndAProtocolComeFromPipes) {
    const std::string scene = std::string(TELETA_SOURCE_DIR) + "/resources/scenes/tactile-two-contacts.toml";
    const ProgramResult simulated = shell("\"$T\" simulate - -d 0.2 -j -o run <'" + scene + "'");
    EXPECT_EQ(simulated.exitCode, 0) << simulated.err;
    EXPECT_FALSE(file("run/frames.csv").empty());
    ASSERT_EQ(shell("\"$T\" pattern show shape.A.static --json >pattern.json").exitCode, 0);
    ASSERT_EQ(shell("\"$T\" pattern convert shape.A.static pattern.json").exitCode, 0);
    const ProgramResult converted = shell("\"$T\" pattern convert - - --format csv <pattern.json");
    EXPECT_EQ(converted.exitCode, 0) << converted.err;
    ASSERT_EQ(shell("\"$T\" pattern convert shape.A.static expected.csv").exitCode, 0);
    EXPECT_EQ(converted.out, file("expected.csv"));
    EXPECT_EQ(shell("\"$T\" pattern convert shape.A.static -").exitCode, 2) << "of which format?";
    EXPECT_EQ(shell("\"$T\" pattern convert shape.A.static a.csv --format csv").exitCode, 2);
    const ProgramResult curve =
        shell("printf 'x_m,y_m\\n0.05,0\\n0,0.05\\n-0.05,0\\n0,-0.05\\n' | \"$T\" contour - --curve -");
    EXPECT_EQ(curve.exitCode, 0) << curve.err;
    EXPECT_EQ(curve.out.find("t,x_m,y_m,curvature_per_m\n"), 0U) << curve.out;
}

TEST_F(StandardStreams, whatNamesNoSingleFileIsRefused) {
    m_folder.write("frames.csv", "time_s,t0,t1\n0,1,2\n");
    EXPECT_EQ(shell("\"$T\" features - --tare - --rows 1 --columns 2 <frames.csv").exitCode, 2)
        << "read twice";
    EXPECT_EQ(shell("\"$T\" features frames.csv --rows 1 --columns 2 -o - --json").exitCode, 2)
        << "two outputs";
    EXPECT_EQ(shell("\"$T\" simulate tactile-indenter --out -").exitCode, 2) << "a folder";
    const ProgramResult recording = shell("\"$T\" replay - <frames.csv");
    EXPECT_EQ(recording.exitCode, 2);
    EXPECT_NE(recording.err.find("database"), std::string::npos) << recording.err;
}

TEST_F(StandardStreams, shortOptionsAreTheLongOnes) {
    ASSERT_EQ(shell("\"$T\" simulate tactile-indenter -s 3 -d 0.2 -o a -j").exitCode, 0);
    ASSERT_EQ(shell("\"$T\" simulate tactile-indenter --seed 3 --duration 0.2 --out b --json").exitCode, 0);
    EXPECT_EQ(file("a/frames.csv"), file("b/frames.csv"));
    EXPECT_EQ(shell("\"$T\" features a/frames.csv -t 0.5").out,
              shell("\"$T\" features a/frames.csv --threshold 0.5").out);
}
