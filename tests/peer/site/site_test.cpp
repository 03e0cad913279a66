// SPDX-License-Identifier: GPL-3.0-or-later
// teleta-site with a simulated arm, and its consoles, over the loopback interface. Each test has a domain of
// its own.
#include "tests/app/cli/program_run.h"
#include "tests/peer/site/site_process.h"
#include "tests/support/small_disk.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace teleta {
namespace {

using namespace std::chrono_literals;
using site::Mode;
using site::RequestAnswer;
using site::RequestKind;
using test::SiteProcess;
using test::TestConsole;

constexpr const char* kPractice = "[[device]]\nid = \"practice\"\nscene = \":/scenes/teleoperation.toml\"\n";
constexpr double kRate_radPerS = 0.3;
constexpr const char* kPressAnew = "let go of the switch and press it again";

/// The program of the simulated arm ends with the first jog; then the arm rests unless somebody moves it.
void takeOver(TestConsole& console) {
    ASSERT_EQ(console.ask(RequestKind::request), RequestAnswer::done);
    console.press(kRate_radPerS);
    ASSERT_TRUE(console.moves());
    console.letGo();
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().mode == Mode::held; }));
    ASSERT_TRUE(TestConsole::eventually([&] { return console.rests(200ms); }));
}

TEST(Site, nobodyMovesAnArmWithoutControl) {
    SiteProcess site(81, kPractice);
    site.start();
    TestConsole console(site, "a");
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().clock.has_value(); }));
    EXPECT_EQ(console.hindrance(), "nobody controls the site; request control first");
    console.press(kRate_radPerS);
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().refused > 10; }));
    EXPECT_EQ(console.view().lastRefusal, site::CommandRefusal::notController);
    EXPECT_EQ(console.view().accepted, 0U);
    // A press from before the grant moves nothing either.
    EXPECT_EQ(console.ask(RequestKind::request), RequestAnswer::done);
    const std::uint64_t refused = console.view().refused;
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().refused > refused + 10; }));
    EXPECT_EQ(console.view().lastRefusal, site::CommandRefusal::pressAnew);
    EXPECT_EQ(console.view().accepted, 0U);
    EXPECT_TRUE(TestConsole::eventually([&] { return console.hindrance() == kPressAnew; }));
    console.letGo();
    EXPECT_TRUE(TestConsole::eventually([&] { return console.hindrance().empty(); }));
    console.press(kRate_radPerS);
    EXPECT_TRUE(console.moves());
    EXPECT_GT(console.view().accepted, 0U);
    EXPECT_EQ(console.hindrance(), "");
}

TEST(Site, controlIsHandedOverAndTakenOver) {
    SiteProcess site(82, kPractice);
    site.start();
    TestConsole first(site, "a");
    TestConsole second(site, "b");
    TestConsole boss(site, "boss");
    TestConsole viewer(site, "v", true);
    takeOver(first);
    EXPECT_EQ(second.ask(RequestKind::request), RequestAnswer::busy);
    EXPECT_EQ(viewer.ask(RequestKind::request), RequestAnswer::notPermitted);
    EXPECT_EQ(second.hindrance(), "a controls the site");

    const std::uint64_t epoch = first.view().epoch;
    first.request(RequestKind::offer, "b");
    ASSERT_TRUE(TestConsole::eventually([&] { return second.view().offeredTo == "b"; }));
    first.press(kRate_radPerS);
    EXPECT_TRUE(first.rests(300ms));
    EXPECT_EQ(second.ask(RequestKind::accept), RequestAnswer::done);
    ASSERT_TRUE(TestConsole::eventually([&] { return second.controls() && !first.controls(); }));
    EXPECT_EQ(second.view().epoch, epoch + 1);
    // Who gave control away holds the switch still.
    EXPECT_TRUE(first.rests(300ms));
    first.letGo();
    second.press(-kRate_radPerS);
    EXPECT_TRUE(second.moves());
    second.letGo();

    // A supervisor takes over; b agrees.
    boss.request(RequestKind::takeOver);
    ASSERT_TRUE(TestConsole::eventually([&] { return second.view().offeredTo == "boss"; }));
    // Who waits for control asks for something else: control is theirs none the less.
    EXPECT_EQ(boss.ask(RequestKind::withdrawStop, "nobody"), RequestAnswer::noSuchConsole);
    EXPECT_EQ(second.ask(RequestKind::accept), RequestAnswer::done);
    EXPECT_TRUE(TestConsole::eventually([&] { return boss.controls(); }));
    EXPECT_EQ(boss.ask(RequestKind::release), RequestAnswer::done);
    EXPECT_TRUE(TestConsole::eventually([&] { return boss.view().mode == Mode::free; }));
}

TEST(Site, stopOfAViewerHoldsUntilItIsWithdrawn) {
    SiteProcess site(83, kPractice);
    site.start();
    TestConsole console(site, "a");
    TestConsole boss(site, "boss");
    auto viewer = std::make_unique<TestConsole>(site, "v", true);
    takeOver(console);
    console.press(kRate_radPerS);
    ASSERT_TRUE(console.moves());
    viewer->stop().engage();
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().mode == Mode::stopped; }));
    EXPECT_EQ(console.view().stopHolders, std::vector<std::string>{"v"});
    EXPECT_EQ(console.hindrance(), "STOP is held by v");
    ASSERT_TRUE(TestConsole::eventually([&] { return console.rests(200ms); }));
    // The viewer vanishes: STOP stays, whatever happens to its program.
    viewer.reset();
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().viewers.empty(); }));
    EXPECT_EQ(console.view().mode, Mode::stopped);
    EXPECT_EQ(console.ask(RequestKind::withdrawStop, "v"), RequestAnswer::notPermitted);
    EXPECT_EQ(boss.ask(RequestKind::withdrawStop, "v"), RequestAnswer::done);
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().mode == Mode::held; }));
    EXPECT_TRUE(console.controls());
    // The switch was held through all of it.
    EXPECT_TRUE(console.rests(300ms));
    EXPECT_TRUE(TestConsole::eventually([&] { return console.hindrance() == kPressAnew; }));
    console.letGo();
    // STOP of its own, too: nothing is sent then, and nothing refused.
    console.press(kRate_radPerS);
    ASSERT_TRUE(console.moves());
    console.stop().engage();
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().mode == Mode::stopped; }));
    console.stop().release();
    EXPECT_TRUE(TestConsole::eventually([&] { return console.hindrance() == kPressAnew; }));
    console.letGo();
    EXPECT_TRUE(TestConsole::eventually([&] { return console.hindrance().empty(); }));
    console.press(kRate_radPerS);
    EXPECT_TRUE(console.moves());
}

/// The key of those who stand beside the robot.
TEST(Site, stopAtTheSiteHoldsTheArmsAndItsWithdrawalFreesWhatAGoneConsoleHolds) {
    SiteProcess site(94, kPractice);
    site.start();
    TestConsole console(site, "a");
    takeOver(console);
    console.press(kRate_radPerS);
    ASSERT_TRUE(console.moves());
    site.send(SIGUSR1);
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().mode == Mode::stopped; }));
    EXPECT_EQ(console.view().stopHolders, std::vector<std::string>{"site"});
    ASSERT_TRUE(TestConsole::eventually([&] { return console.rests(200ms); }));
    site.send(SIGUSR2);
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().mode == Mode::held; }));
    EXPECT_TRUE(console.rests(300ms)) << "the switch was held through it";
    console.letGo();

    auto viewer = std::make_unique<TestConsole>(site, "v", true);
    viewer->stop().engage();
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().mode == Mode::stopped; }));
    viewer.reset();
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().viewers.empty(); }));
    EXPECT_EQ(console.view().mode, Mode::stopped);
    site.send(SIGUSR2);
    EXPECT_TRUE(TestConsole::eventually([&] { return console.view().mode == Mode::held; }));
}

/// What is on disk of a site's STOP, as the next start reads it.
bool isKept(SiteProcess& site, bool stopOfSite, std::size_t consoles) {
    std::ifstream file(site.folder().filePath("lab-stop.json").toStdString());
    const auto kept = nlohmann::json::parse(file, nullptr, false);
    return kept.is_object() && kept["site"] == stopOfSite && kept["consoles"].size() == consoles;
}

TEST(Site, oneThatIsKilledWhileItIsStoppedStartsStopped) {
    SiteProcess site(152, kPractice);
    site.start();
    TestConsole console(site, "a");
    takeOver(console);
    console.press(kRate_radPerS);
    ASSERT_TRUE(console.moves());
    site.send(SIGUSR1);
    ASSERT_TRUE(TestConsole::eventually([&] { return isKept(site, true, 0); }));
    // The second start finds what the first one found.
    for (int starts = 0; starts < 2; ++starts) {
        site.kill();
        ASSERT_TRUE(TestConsole::eventually([&] { return !console.view().reached; }));
        site.start();
        ASSERT_TRUE(TestConsole::eventually([&] { return console.view().reached; }));
        EXPECT_EQ(console.view().mode, Mode::stopped);
        EXPECT_EQ(console.view().stopHolders, std::vector<std::string>{"site"});
        EXPECT_EQ(console.ask(RequestKind::request), RequestAnswer::stopped);
        // The switch is held all the time, and the program of the simulated arm would move it, too.
        EXPECT_TRUE(console.rests(300ms));
    }
    console.letGo();
    site.send(SIGUSR2);
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().mode == Mode::free; }));
    ASSERT_TRUE(TestConsole::eventually([&] { return isKept(site, false, 0); }));
    site.kill();
    ASSERT_TRUE(TestConsole::eventually([&] { return !console.view().reached; }));
    site.start();
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().reached; }));
    EXPECT_EQ(console.view().mode, Mode::free);
    takeOver(console);
}

TEST(Site, aSwitchThatIsHeldThroughARestartMovesNothingWhoeverIsGivenControl) {
    SiteProcess site(155, kPractice);
    site.start();
    TestConsole console(site, "a");
    takeOver(console);
    for (int restarts = 0; restarts < 3; ++restarts) {
        console.press(kRate_radPerS);
        ASSERT_TRUE(console.moves());
        site.kill();
        ASSERT_TRUE(TestConsole::eventually([&] { return !console.view().reached; }));
        // Asked for while nobody is there to answer, with the switch held.
        (void)console.request(RequestKind::request);
        site.start();
        ASSERT_TRUE(TestConsole::eventually([&] { return console.controls(); }));
        // The program of the simulated arm moves it until somebody else does.
        EXPECT_TRUE(TestConsole::eventually([&] { return console.hindrance() == kPressAnew; }));
        EXPECT_EQ(console.view().accepted, 0U);
        console.letGo();
        ASSERT_TRUE(TestConsole::eventually([&] { return console.hindrance().empty(); }));
    }
    console.press(kRate_radPerS);
    EXPECT_TRUE(console.moves());
}

TEST(Site, stopsOfConsolesOutliveItsProgram) {
    SiteProcess site(153, kPractice);
    site.start();
    TestConsole boss(site, "boss");
    TestConsole console(site, "a");
    auto viewer = std::make_unique<TestConsole>(site, "v", true);
    viewer->stop().engage();
    console.stop().engage();
    ASSERT_TRUE(TestConsole::eventually([&] { return isKept(site, false, 2); }));
    viewer.reset();
    site.kill();
    ASSERT_TRUE(TestConsole::eventually([&] { return !boss.view().reached; }));
    // Withdrawn while nobody listens: its presence tells it later.
    console.stop().release();
    site.start();
    ASSERT_TRUE(TestConsole::eventually([&] { return boss.view().reached; }));
    EXPECT_TRUE(
        TestConsole::eventually([&] { return boss.view().stopHolders == std::vector<std::string>{"v"}; }));
    EXPECT_EQ(boss.view().mode, Mode::stopped);
    EXPECT_EQ(boss.ask(RequestKind::withdrawStop, "v"), RequestAnswer::done);
    EXPECT_TRUE(TestConsole::eventually([&] { return boss.view().mode == Mode::free; }));
    EXPECT_TRUE(TestConsole::eventually([&] { return isKept(site, false, 0); }));
}

TEST(Site, aDamagedFileOfItsStopIsStopAndIsSaid) {
    SiteProcess site(154, kPractice);
    std::ofstream(site.folder().filePath("lab-stop.json").toStdString()) << R"({"version": 1, "site": fal)";
    site.start();
    TestConsole console(site, "a");
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().reached; }));
    EXPECT_EQ(console.view().stopHolders, std::vector<std::string>{"site"});
    EXPECT_TRUE(site.said("stop_unknown"));
    site.send(SIGUSR2);
    EXPECT_TRUE(TestConsole::eventually([&] { return console.view().mode == Mode::free; }));
    takeOver(console);
}

/// The arms go on, and the consoles are told.
TEST(Site, aFullDiskEndsTheRecordingAndNothingElse) {
    SiteProcess site(95, kPractice);
    const test::SmallDisk disk(site.folder().filePath("disk").toStdString(), 4);
    if (!disk.exists())
        GTEST_SKIP() << "needs the right to mount a disk";
    site.recordInto(QString::fromStdString(disk.path("")));
    site.setDevices(kPractice);
    site.start();
    TestConsole console(site, "a");
    takeOver(console);
    ASSERT_TRUE(disk.fill());
    bool isTold = false;
    EXPECT_TRUE(TestConsole::eventually([&] {
        for (const site_link::RemoteEvent& event : console.client().takeEvents())
            isTold = isTold || event.code == "recording_failed";
        return isTold;
    }));
    console.press(kRate_radPerS);
    EXPECT_TRUE(console.moves());
}

TEST(Site, aConsoleThatEndsGivesControlUpAndStopsNobody) {
    SiteProcess site(89, kPractice);
    site.start();
    TestConsole console(site, "a");
    TestConsole viewer(site, "v", true);
    takeOver(console);
    console.press(kRate_radPerS);
    ASSERT_TRUE(console.moves());
    // As the console does when its window is closed.
    console.client().leave();
    console.stop().engage();
    ASSERT_TRUE(TestConsole::eventually([&] { return viewer.view().mode == Mode::free; }));
    EXPECT_TRUE(TestConsole::eventually([&] { return viewer.rests(300ms); }));
    EXPECT_TRUE(viewer.view().stopHolders.empty());
    // A STOP that a person has engaged before stays.
    viewer.stop().engage();
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().mode == Mode::stopped; }));
    viewer.client().leave();
    viewer.stop().release();
    std::this_thread::sleep_for(300ms);
    EXPECT_EQ(console.view().stopHolders, std::vector<std::string>{"v"});
}

TEST(Site, anArmComesToRestWhenItsOperatorIsKilled) {
    SiteProcess site(84, kPractice);
    site.start();
    TestConsole viewer(site, "v", true);
    test::RunningProgram jog(
        {"arm", "jog", site.fileOf("a"), "--joint", "joint_2", "--rate", "0.3", "--seconds", "2", "--yes"});
    ASSERT_TRUE(TestConsole::eventually([&] { return viewer.view().mode == Mode::moving; }));
    ASSERT_TRUE(viewer.moves(0.05));
    jog.send(SIGKILL);
    const std::int64_t killed_ns = core::steadyNow_ns();
    EXPECT_EQ(jog.wait().exitCode, -SIGKILL);
    ASSERT_TRUE(TestConsole::eventually([&] { return viewer.rests(300ms); }));
    // Motion lease of 100 ms, braking, a cycle of the site: 0.3 s; the rest is for a busy machine.
    const double rest_s = core::elapsed_s(killed_ns, viewer.lastAway_ns(1e-3));
    EXPECT_LT(rest_s, 1.0);
    ::testing::Test::RecordProperty("rest_ms", static_cast<int>(rest_s * 1e3));
    EXPECT_TRUE(TestConsole::eventually([&] { return viewer.view().mode == Mode::free; }));
}

TEST(Site, aConsoleThatWasFrozenMovesNothingWhenItGoesOn) {
    SiteProcess site(85, kPractice);
    site.start();
    TestConsole viewer(site, "v", true);
    test::RunningProgram jog(
        {"arm", "jog", site.fileOf("a"), "--joint", "joint_2", "--rate", "0.3", "--seconds", "2", "--yes"});
    ASSERT_TRUE(TestConsole::eventually([&] { return viewer.view().mode == Mode::moving; }));
    jog.send(SIGSTOP);
    ASSERT_TRUE(TestConsole::eventually([&] { return viewer.view().mode == Mode::held; }));
    ASSERT_TRUE(TestConsole::eventually([&] { return viewer.rests(600ms); }));
    const std::uint64_t accepted = viewer.view().accepted;
    jog.send(SIGCONT);
    (void)jog.wait();
    EXPECT_TRUE(viewer.rests(300ms));
    // What it sent was a hold, or was refused.
    EXPECT_LE(viewer.view().accepted, accepted + site::OperatorHand::kHolds);
}

TEST(Site, aSiteThatWasFrozenOrRestartedMovesNothing) {
    SiteProcess site(86, kPractice);
    site.start();
    TestConsole console(site, "a");
    takeOver(console);
    console.press(kRate_radPerS);
    ASSERT_TRUE(console.moves());
    site.send(SIGSTOP);
    ASSERT_TRUE(TestConsole::eventually([&] { return !console.view().reached; }));
    EXPECT_EQ(console.hindrance(), "the site does not answer");
    // Longer than any lease.
    std::this_thread::sleep_for(2500ms);
    site.send(SIGCONT);
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().reached; }));
    // The world of a simulated arm stood still meanwhile: it brakes first.
    ASSERT_TRUE(TestConsole::eventually([&] { return console.rests(200ms); }));
    EXPECT_TRUE(console.rests(500ms));
    EXPECT_EQ(console.view().mode, Mode::free);
    console.letGo();

    site.kill();
    ASSERT_TRUE(TestConsole::eventually([&] { return !console.view().reached; }));
    site.start();
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().reached; }));
    EXPECT_EQ(console.view().boots, 1U);
    EXPECT_TRUE(TestConsole::eventually([&] { return console.view().mode == Mode::free; }));
}

TEST(Site, theCommandLineSeesItAndRecordsIt) {
    SiteProcess site(87, kPractice);
    site.start();
    const auto list = test::run({"site", "list", site.fileOf("a"), "--json"});
    ASSERT_EQ(list.exitCode, 0) << list.err;
    const auto sites = nlohmann::json::parse(list.out);
    ASSERT_EQ(sites.size(), 1U);
    EXPECT_EQ(sites[0]["site"], "lab");
    EXPECT_EQ(sites[0]["state"], "free");
    EXPECT_EQ(sites[0]["arms"], 1);
    EXPECT_EQ(sites[0]["streams"], 2);

    const auto clock = test::run({"site", "clock", site.fileOf("c"), "--seconds", "2.5", "--json"});
    ASSERT_EQ(clock.exitCode, 0) << clock.err;
    const auto rows = nlohmann::json::parse(clock.out);
    ASSERT_EQ(rows.size(), 2U);
    // Both programs have one clock: the true offset is 0.
    for (const auto& row : rows)
        EXPECT_LE(std::abs(row["offset_s"].get<double>()), row["bound_s"].get<double>()) << row;

    const std::string path = site.folder().filePath("site.teleta").toStdString();
    const auto record = test::run({"site", "record", site.fileOf("r"), "--seconds", "2", "--out", path});
    ASSERT_EQ(record.exitCode, 0) << record.err;
    const auto replay = test::run({"replay", path, "--json"});
    ASSERT_EQ(replay.exitCode, 0) << replay.err;
    // 200 frames a second for 2 s; the first ones come when the stream is found.
    EXPECT_GT(nlohmann::json::parse(replay.out).size(), 300U);
}

TEST(Site, aProgramThatIsStartedAnewAfterAKillGetsControlOfItsOwn) {
    SiteProcess site(108, kPractice);
    site.start();
    TestConsole viewer(site, "v", true);
    const auto jog = [&site] {
        return test::RunningProgram({"arm", "jog", site.fileOf("a"), "--joint", "joint_3", "--rate", "0.1",
                                     "--seconds", "1.5", "--yes", "--json"});
    };
    auto killed = jog();
    ASSERT_TRUE(TestConsole::eventually([&] { return viewer.view().mode == Mode::moving; }));
    killed.send(SIGKILL);
    EXPECT_EQ(killed.wait().exitCode, -SIGKILL);
    // The name still controls the site: that is the program before.
    EXPECT_EQ(viewer.view().controller, "a");
    auto anew = jog();
    const test::ProgramResult result = anew.wait();
    EXPECT_EQ(result.exitCode, 0) << result.err << result.out;
    // Less where this machine was so busy that a command came too late and held the arm.
    EXPECT_GT(nlohmann::json::parse(result.out)["way"].get<double>(), 0.02);
}

TEST(Site, aCertificateOfItsArmPasses) {
    SiteProcess site(109, kPractice);
    site.start();
    TestConsole viewer(site, "v", true);
    const std::string name = site.folder().filePath("report").toStdString();
    // The bound is long: how punctual this machine is stands in the report, not in a test.
    const auto result = test::run({"certify", "--site", site.fileOf("a"), "--joint", "joint_3", "--yes",
                                   "--faults", "7", "--bound", "1", "--out", name, "--json"});
    EXPECT_EQ(result.exitCode, 0) << result.err << result.out;
    const auto report = nlohmann::json::parse(result.out, nullptr, false);
    ASSERT_TRUE(report.is_object()) << result.out;
    EXPECT_EQ(report["passes"], true);
    EXPECT_EQ(report["system"]["actuator"], "arm");
    EXPECT_EQ(report["system"]["driver"], "practice (lab)");
    EXPECT_EQ(report["system"]["simulated"], true);
    EXPECT_EQ(report["total"]["restarted"], 0);
    ASSERT_EQ(report["kinds"].size(), 7U) << "one of each kind";
    for (const auto& fault : report["faults"])
        EXPECT_GT(fault["zero_s"], 0.0) << fault;
    // It leaves nothing behind.
    EXPECT_TRUE(TestConsole::eventually([&] { return viewer.view().mode == Mode::free; }));
    EXPECT_TRUE(viewer.view().stopHolders.empty());
    EXPECT_TRUE(viewer.rests(300ms));
}

TEST(Site, theProgramThatACertificateTestsSaysWhyItDoesNotMove) {
    SiteProcess site(111, kPractice);
    site.start();
    TestConsole viewer(site, "v", true);
    viewer.stop().engage();
    ASSERT_TRUE(TestConsole::eventually([&] { return viewer.view().mode == Mode::stopped; }));
    QProcess chain;
    chain.start(QStringLiteral(TELETA_PROGRAM),
                {"certify", "--site", QString::fromStdString(site.fileOf("a")), "--joint", "joint_3",
                 "--rate", "0.1", "--centre", "0"});
    ASSERT_TRUE(chain.waitForStarted());
    EXPECT_TRUE(TestConsole::eventually([&] {
        chain.write("go\n");
        (void)chain.waitForReadyRead(100);
        bool said = false;
        while (chain.canReadLine())
            said = chain.readLine().trimmed() == "problem STOP is held by v" || said;
        return said;
    }));
    chain.closeWriteChannel();
    EXPECT_TRUE(chain.waitForFinished(10'000));
    EXPECT_EQ(chain.exitCode(), 0);
}

TEST(Site, jointsOfAModbusDeviceAreSeenAndNotMoved) {
    test::PeerProcess server;
    server.start(QStringLiteral("/usr/bin/python3"),
                 {QStringLiteral(TELETA_SOURCE_DIR "/tests/peer/modbus_server.py"), "tcp", "0"});
    const auto ready = server.waitFor("ready");
    ASSERT_TRUE(ready) << server.errors();
    ASSERT_TRUE(server.command("set 100 500 1 250 2"));
    SiteProcess site(142, "[[device]]\nfile = \"bench.toml\"\n");
    std::ofstream file(site.folder().filePath("bench.toml").toStdString());
    file << "kind = 'modbus'\nname = 'bench'\ninput_rate_Hz = 50\n[link]\nkind = 'tcp'\n"
            "host = '127.0.0.1'\nport = "
         << ready->substr(ready->find_last_of(' ') + 1) << '\n';
    for (int i = 0; i < 4; ++i)
        file << "[[input]]\nname = 'i" << i << "'\naddress = " << 100 + i
             << "\ntype = 'int16'\nscale = 0.001\nunit = '" << (i % 2 == 0 ? "rad" : "N m") << "'\n";
    file << "[[joint]]\nangle = 'i0'\ntorque = 'i1'\n[[joint]]\nangle = 'i2'\ntorque = 'i3'\n" << std::flush;
    QProcess check;
    check.start(QStringLiteral(TELETA_SITE_PROGRAM), {site.folder().filePath("site.toml"), "--check"});
    ASSERT_TRUE(check.waitForFinished(20'000));
    EXPECT_EQ(check.exitCode(), 0) << check.readAll().toStdString();
    site.start();
    TestConsole console(site, "a");
    EXPECT_DOUBLE_EQ(console.angle(), 0.25);
    ASSERT_TRUE(server.command("set 102 300"));
    EXPECT_TRUE(TestConsole::eventually([&] { return console.angle() == 0.3; }));
    EXPECT_EQ(console.ask(RequestKind::request), RequestAnswer::done);
    EXPECT_TRUE(TestConsole::eventually([&] {
        return console.hindrance() == "this arm is read-only: it reports its joints but cannot be moved";
    })) << console.hindrance();
    console.press(kRate_radPerS);
    EXPECT_TRUE(console.rests(300ms));
    console.letGo();
    for (const std::string& line : server.takeLines())
        EXPECT_FALSE(line.starts_with("write")) << line;
}

TEST(Site, aCheckMovesNothingAndSaysWhatIsMissing) {
    SiteProcess site(88, std::string(kPractice) +
                             "[[device]]\nid = \"pad\"\nwts = \"/dev/there-is-no-such-line\"\n");
    QProcess check;
    check.start(QStringLiteral(TELETA_SITE_PROGRAM),
                {site.folder().filePath("site.toml"), "--check", "--json"});
    ASSERT_TRUE(check.waitForFinished(20'000));
    EXPECT_EQ(check.exitCode(), 1);
    const auto found = nlohmann::json::parse(check.readAllStandardOutput().toStdString());
    EXPECT_EQ(found["usable"], false);
    ASSERT_EQ(found["problems"].size(), 1U);
    EXPECT_EQ(found["problems"][0].get<std::string>().find("pad: "), 0U) << found;
}

} // namespace
} // namespace teleta
