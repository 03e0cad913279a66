// SPDX-License-Identifier: GPL-3.0-or-later
// teleta-site with a robot of Fast DDS and MuJoCo, and consoles at it. The robot's log says where the arm was
// and when; its clock is the steady one of this computer.
#include "backend/pipeline/recorded/recorded_sources.h"
#include "backend/recording/recording.h"
#include "robot_fixture.h"
#include "tests/peer/site/site_process.h"

#include <csignal>
#include <sstream>
#include <string>
#include <vector>

namespace teleta {
namespace {

using namespace std::chrono_literals;
using site::Mode;
using site::RequestAnswer;
using site::RequestKind;
using test::SiteProcess;
using test::TestConsole;

constexpr double kBraking_s = kRate_radPerS / kDeceleration_radPerS2;
/// Cycles of site and arm, and a busy machine.
constexpr double kSlack_s = 0.2;

class SiteRobot : public RosArmPeer {
protected:
    /// The robot in a domain, the site and its consoles in the next one.
    void begin(int domain, const QStringList& more = {}) {
        start(domain, more);
        writeFile("", "announce = false\n");
        m_site = std::make_unique<SiteProcess>(domain + 1, "[[device]]\nfile = \"" + path() + "\"\n");
        m_site->start();
    }
    /// A console takes control, and moves the arm as long as it presses.
    static void moveBy(TestConsole& console) {
        ASSERT_EQ(console.ask(RequestKind::request), RequestAnswer::done);
        ASSERT_TRUE(TestConsole::eventually([&] { return console.hindrance().empty(); }))
            << console.hindrance();
        console.press(kRate_radPerS);
        ASSERT_TRUE(console.moves());
    }
    [[nodiscard]] test::RunningProgram jog(double seconds) const {
        return test::RunningProgram({"arm", "jog", m_site->fileOf("a"), "--joint", "joint_3", "--rate", "0.3",
                                     "--seconds", std::to_string(seconds), "--yes", "--json"});
    }
    bool runsAtFullSpeed() {
        return eventually([this] {
            const std::vector<json> states = logOf("state");
            return !states.empty() && states.back()["velocity"][kJoint].get<double>() > 0.9 * kRate_radPerS;
        });
    }
    void expectRest() {
        std::this_thread::sleep_for(700ms);
        EXPECT_NEAR(logOf("state").back()["velocity"][kJoint].get<double>(), 0.0, 1e-3);
    }

    std::unique_ptr<SiteProcess> m_site;
};

TEST_F(SiteRobot, aJogThroughTheSiteMovesAsFarAsItSays) {
    begin(100);
    auto program = jog(1.0);
    const ProgramResult result = program.wait();
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const json told = json::parse(result.out);
    // Less where this machine was so busy that a command came too late and held the arm.
    EXPECT_GT(told["way"].get<double>(), 0.02) << result.out;
    EXPECT_LT(told["way"].get<double>(), 0.34) << result.out;
    EXPECT_NEAR(logOf("state").back()["position"][kJoint].get<double>(), told["way"].get<double>(), 2e-3);
    for (const json& trajectory : logOf("trajectory"))
        EXPECT_EQ(trajectory["accepted"], true) << trajectory["reason"];
}

/// The tip's frame hangs on the wrist of an arm that is stretched upwards; 30 N press it down.
TEST_F(SiteRobot, aConsoleRecordsTheForceAtTheWrist) {
    start(128);
    writeBeside("ft.toml", "kind = \"ros_wrench\"\nname = \"wrist\"\ntopic = \"/ft/wrench\"\n");
    writeFile("wrench = \"ft.toml\"\n", "announce = false\n");
    m_site = std::make_unique<SiteProcess>(129, "[[device]]\nfile = \"" + path() + "\"\n");
    m_site->start();
    ASSERT_TRUE(m_robot.command("push 0 0 -30"));
    const std::string recorded = m_folder.filePath("record.teleta").toStdString();
    const ProgramResult record =
        test::run({"site", "record", m_site->fileOf("r"), "--seconds", "2", "--out", recorded});
    ASSERT_EQ(record.exitCode, 0) << record.err;
    const ProgramResult exported =
        test::run({"export", recorded, "--csv", m_folder.filePath("csv").toStdString()});
    ASSERT_EQ(exported.exitCode, 0) << exported.err;
    std::ifstream table(m_folder.filePath("csv/arm-wrench.csv").toStdString());
    std::string header;
    ASSERT_TRUE(std::getline(table, header)) << record.out << exported.out;
    EXPECT_NE(header.find("force_x_n,force_y_n,force_z_n,torque_x_nm"), std::string::npos) << header;
    std::string last;
    std::size_t rows = 0;
    for (std::string line; std::getline(table, line); ++rows)
        last = line;
    EXPECT_GT(rows, 20U);
    std::vector<double> numbers;
    std::istringstream words(last);
    for (std::string word; std::getline(words, word, ',');)
        numbers.push_back(std::stod(word));
    const auto column = static_cast<std::size_t>(std::count(
        header.begin(), header.begin() + static_cast<std::ptrdiff_t>(header.find("force_x_n")), ','));
    ASSERT_GE(numbers.size(), column + 6);
    EXPECT_NEAR(std::hypot(numbers[column], numbers[column + 1], numbers[column + 2]), 30.0, 3.0) << last;
}

TEST_F(SiteRobot, theArmIsHeldWithoutADeviceThatItRequires) {
    start(114, {"--pad"});
    writeBeside("pad.toml",
                "kind = \"ros_tactile\"\nname = \"pad\"\ntopic = \"/pad/tactile\"\n"
                "format = \"Float64MultiArray\"\nrows = 14\ncols = 6\npitch_mm = 3.4\nrate_Hz = 100\n"
                "[ros]\ndomain = 114\ninterface = \"lo\"\n");
    writeFile("required = [\"pad\"]\n", "announce = false\n");
    m_site = std::make_unique<SiteProcess>(115, "[[device]]\nfile = \"" + path() +
                                                    "\"\n[[device]]\nid = \"pad\"\ntaxels = \"" +
                                                    m_folder.filePath("pad.toml").toStdString() + "\"\n");
    m_site->start();
    TestConsole console(*m_site, "a");
    ASSERT_NO_FATAL_FAILURE(moveBy(console));
    ASSERT_TRUE(m_robot.command("fault no-pad"));
    EXPECT_TRUE(TestConsole::eventually([&] { return console.rests(200ms, 2e-3); }));
    EXPECT_TRUE(TestConsole::eventually([&] {
        return console.hindrance().find("pad, which the arm requires") != std::string::npos;
    })) << console.hindrance();
    // The switch is still held when it comes back.
    ASSERT_TRUE(m_robot.command("fault none"));
    EXPECT_TRUE(TestConsole::eventually([&] {
        return console.hindrance().find("let go of the switch") != std::string::npos;
    })) << console.hindrance();
    EXPECT_TRUE(console.rests(300ms, 2e-3));
    console.letGo();
    ASSERT_TRUE(TestConsole::eventually([&] { return console.hindrance().empty(); })) << console.hindrance();
    console.press(kRate_radPerS);
    EXPECT_TRUE(console.moves());
}

/// An array with a frame is a part of the arm for consoles, and in what they record.
TEST_F(SiteRobot, anArrayWithAFrameIsWornByItsArm) {
    start(140, {"--pad"});
    writeBeside("pad.toml",
                "kind = \"ros_tactile\"\nname = \"pad\"\ntopic = \"/pad/tactile\"\n"
                "format = \"Float64MultiArray\"\nrows = 14\ncols = 6\npitch_mm = 3.4\nrate_Hz = 100\n"
                "[ros]\ndomain = 140\ninterface = \"lo\"\n");
    writeFile("", "announce = false\n", "[touch]\nwindow_Nm = [0.8, 2.0]\n");
    const auto devices = [this](const std::string& link) {
        return "[[device]]\nfile = \"" + path() + "\"\n[[device]]\nid = \"pad\"\ntaxels = \"" +
               m_folder.filePath("pad.toml").toStdString() + "\"\nframe = \"" + link + "\"\n";
    };
    m_site = std::make_unique<SiteProcess>(141, devices("hand"));
    QProcess check;
    check.setProcessChannelMode(QProcess::MergedChannels);
    check.start(QStringLiteral(TELETA_SITE_PROGRAM), {m_site->folder().filePath("site.toml"), "--check"});
    ASSERT_TRUE(check.waitForFinished(20'000));
    EXPECT_EQ(check.exitCode(), 1);
    const std::string told = check.readAll().toStdString();
    EXPECT_NE(told.find("no arm has the link hand"), std::string::npos) << told;
    m_site->setDevices(devices("tool0"));
    m_site->start();
    const std::string recorded = m_folder.filePath("record.teleta").toStdString();
    const ProgramResult record =
        test::run({"site", "record", m_site->fileOf("r"), "--seconds", "2", "--out", recorded});
    ASSERT_EQ(record.exitCode, 0) << record.err;
    const auto opened = recording::Recording::open(recorded);
    ASSERT_TRUE(opened) << core::describe(opened.error());
    const auto sources = pipeline::recordedSources(*opened);
    ASSERT_TRUE(sources) << core::describe(sources.error());
    EXPECT_TRUE(sources->arms.empty());
    ASSERT_EQ(sources->arrays.size(), 1U);
    const pipeline::RecordedSource& arm = sources->arrays.front();
    EXPECT_TRUE(arm.jointStream && arm.chain);
    ASSERT_TRUE(arm.arm.pad);
    EXPECT_EQ(arm.arm.pad->link, "tool0");
    EXPECT_EQ(arm.arm.pad->torques.windowLow_Nm, 0.8);
}

TEST_F(SiteRobot, moveItServoMovesTheArmAndHaltsItWhenTheSiteIsKilled) {
    start(118, {"--controller", "servo"});
    writeFile("adapter = \"moveit_servo\"\n", "announce = false\n");
    // Without a site nobody knows whether the clocks agree.
    const ProgramResult direct = test::run(jogArguments(0.2));
    EXPECT_EQ(direct.exitCode, 1);
    EXPECT_NE(direct.err.find("only teleta-site"), std::string::npos) << direct.err;
    m_site = std::make_unique<SiteProcess>(119, "[[device]]\nfile = \"" + path() + "\"\n");
    m_site->start();
    auto first = jog(1.0);
    const ProgramResult result = first.wait();
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const double way = json::parse(result.out)["way"];
    EXPECT_GT(way, 0.02) << result.out;
    EXPECT_LT(way, 0.36) << result.out;
    for (const json& jogged : logOf("jog")) {
        EXPECT_EQ(jogged["accepted"], true);
        EXPECT_GT(jogged["age_s"].get<double>(), 0.0);
    }
    expectRest();
    EXPECT_NEAR(logOf("state").back()["position"][kJoint].get<double>(), way, 5e-3);

    auto second = jog(2.0);
    ASSERT_TRUE(runsAtFullSpeed());
    m_site->kill();
    expectRest();
    // Servo's time-out; this servo stops within a few steps.
    EXPECT_LE(lastAway_s(1e-3) - steady_s(logOf("jog").back()), 0.1 + 0.1);
    EXPECT_EQ(second.wait().exitCode, 1);
}

TEST_F(SiteRobot, moveItServoIsNotTrustedWithAnotherClock) {
    start(120, {"--controller", "servo", "--fault", "backward@0"});
    writeFile("adapter = \"moveit_servo\"\n", "announce = false\n");
    m_site = std::make_unique<SiteProcess>(121, "[[device]]\nfile = \"" + path() + "\"\n");
    m_site->start();
    TestConsole console(*m_site, "a");
    ASSERT_EQ(console.ask(RequestKind::request), RequestAnswer::done);
    EXPECT_TRUE(TestConsole::eventually([&] {
        return console.hindrance().find("MoveIt Servo takes -0.02 to 0.08") != std::string::npos;
    })) << console.hindrance();
    console.press(kRate_radPerS);
    EXPECT_TRUE(console.rests(500ms, 2e-3));
    EXPECT_TRUE(logOf("jog").empty());
}

/// A clock that jumps back lets the last rate live on, so rest is told and not only silence.
TEST_F(SiteRobot, moveItServoIsToldToRestWhenTheClocksPart) {
    start(160, {"--controller", "servo"});
    writeFile("adapter = \"moveit_servo\"\n", "announce = false\n");
    m_site = std::make_unique<SiteProcess>(161, "[[device]]\nfile = \"" + path() + "\"\n");
    m_site->start();
    TestConsole console(*m_site, "a");
    ASSERT_NO_FATAL_FAILURE(moveBy(console));
    ASSERT_TRUE(m_robot.command("fault backward"));
    EXPECT_TRUE(eventually([this] {
        const std::vector<json> jogs = logOf("jog");
        return std::ranges::all_of(jogs.back()["velocities"],
                                   [](const json& velocity) { return velocity.get<double>() == 0.0; });
    }));
    EXPECT_TRUE(TestConsole::eventually([&] { return console.rests(200ms, 2e-3); }));
    EXPECT_EQ(logOf("jog").back()["accepted"], true);
}

TEST_F(SiteRobot, theArmRestsWhenTheConsoleIsKilled) {
    begin(102);
    auto program = jog(2.0);
    ASSERT_TRUE(runsAtFullSpeed());
    program.send(SIGKILL);
    const double killed_s = 1e-9 * static_cast<double>(core::steadyNow_ns());
    EXPECT_EQ(program.wait().exitCode, -SIGKILL);
    expectRest();
    const double rest_s = lastAway_s(1e-3) - killed_s;
    RecordProperty("rest_ms", static_cast<int>(1e3 * rest_s));
    EXPECT_LE(rest_s, kLease_s + kFirstPoint_s + kBraking_s + kSlack_s);
}

TEST_F(SiteRobot, theArmRestsByItselfWhenTheSiteIsKilled) {
    begin(104);
    auto program = jog(2.0);
    ASSERT_TRUE(runsAtFullSpeed());
    m_site->kill();
    expectRest();
    // Nobody brakes but the controller, at the end of the points that it has.
    const double last_s = steady_s(logOf("trajectory").back());
    const double rest_s = lastAway_s(1e-3) - last_s;
    RecordProperty("rest_ms", static_cast<int>(1e3 * rest_s));
    EXPECT_LE(rest_s, kFirstPoint_s + kBraking_s + 0.03);
    EXPECT_EQ(program.wait().exitCode, 1);
}

TEST_F(SiteRobot, stopOfAViewerBrakesAndAFaultIsClearedByWhoControls) {
    begin(106);
    TestConsole console(*m_site, "a");
    TestConsole viewer(*m_site, "v", true);
    ASSERT_NO_FATAL_FAILURE(moveBy(console));
    viewer.stop().engage();
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().mode == Mode::stopped; }));
    EXPECT_TRUE(TestConsole::eventually([&] { return console.rests(200ms, 2e-3); }));
    viewer.stop().release();
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().mode == Mode::held; }));
    EXPECT_TRUE(console.rests(300ms, 2e-3));
    console.letGo();
    console.press(-kRate_radPerS);
    ASSERT_TRUE(console.moves());

    ASSERT_TRUE(m_robot.command("fault nan"));
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().mode == Mode::fault; }));
    EXPECT_EQ(console.ask(RequestKind::clearFault), RequestAnswer::busy) << "its cause is still there";
    ASSERT_TRUE(m_robot.command("fault none"));
    ASSERT_TRUE(TestConsole::eventually([&] { return console.rests(300ms, 2e-3); }));
    console.letGo();
    ASSERT_TRUE(
        TestConsole::eventually([&] { return console.ask(RequestKind::clearFault) == RequestAnswer::done; }));
    EXPECT_TRUE(TestConsole::eventually([&] { return console.view().mode == Mode::held; }));
    console.press(kRate_radPerS);
    EXPECT_TRUE(console.moves());
}

TEST_F(SiteRobot, jointsThatStaySilentAreAFault) {
    begin(132);
    TestConsole console(*m_site, "a");
    ASSERT_NO_FATAL_FAILURE(moveBy(console));
    ASSERT_TRUE(m_robot.command("fault silent"));
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().mode == Mode::fault; }));
    EXPECT_NE(console.hindrance().find("/joint_states fell silent"), std::string::npos)
        << console.hindrance();
    ASSERT_TRUE(m_robot.command("fault none"));
    EXPECT_TRUE(TestConsole::eventually([&] { return console.rests(300ms, 2e-3); }));
    console.letGo();
    ASSERT_TRUE(
        TestConsole::eventually([&] { return console.ask(RequestKind::clearFault) == RequestAnswer::done; }));
    console.press(kRate_radPerS);
    EXPECT_TRUE(console.moves());
}

} // namespace
} // namespace teleta
