// SPDX-License-Identifier: GPL-3.0-or-later
// The program against a robot of Fast DDS and MuJoCo, over the loopback interface. Each test has a domain of
// its own. The robot's log says where the arm was and when; its clock is the steady one of this computer.
#include "backend/core/steady_time.h"
#include "backend/core/threads/wakeup.h"
#include "dds_node.h"
#include "devices/ros/array/ros_array.h"
#include "messagesPubSubTypes.h"
#include "robot_fixture.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

namespace teleta {
namespace {

TEST_F(RosArmPeer, aCheckFindsAnArmThatCanBeMoved) {
    start(72);
    const ProgramResult result = check();
    EXPECT_EQ(result.exitCode, 0) << result.out << result.err;
    const json rows = json::parse(result.out);
    for (const char* name : {"joints", "rate", "effort", "clock", "controller"})
        EXPECT_TRUE(std::ranges::any_of(
            rows, [&](const json& row) { return row["check"] == name && row["result"] == "ok"; }))
            << name << result.out;
    // It moved nothing, and did not look like someone who would.
    EXPECT_TRUE(logOf("trajectory").empty());
    for (const json& matched : logOf("matched"))
        EXPECT_EQ(matched["commanders"], 0);
}

/// MuJoCo's own poses of the links, by its own reading of the URDF.
TEST_F(RosArmPeer, aCheckComparesTheDescriptionWithTheRobotsOwnFrames) {
    start(113, {"--tf", "--position", "0.1,0.2,0.3,0.4,0.5,0.6,0.7"});
    const auto frames = [](const ProgramResult& result) {
        for (const json& row : json::parse(result.out)) {
            if (row["check"] == "frames")
                return row["result"].get<std::string>() + ": " + row["detail"].get<std::string>();
        }
        return std::string();
    };
    const ProgramResult same = check();
    EXPECT_EQ(same.exitCode, 0) << same.out << same.err;
    EXPECT_TRUE(frames(same).starts_with("ok: ")) << frames(same);
    // The file of an arm with a longer forearm.
    std::ifstream own(kUrdf);
    std::string longer((std::istreambuf_iterator<char>(own)), {});
    const std::string forearm = "<parent link=\"link_4\"/>";
    const std::size_t joint = longer.find(forearm);
    ASSERT_NE(joint, std::string::npos);
    const std::size_t origin = longer.find("<origin xyz=\"", joint);
    ASSERT_NE(origin, std::string::npos);
    const std::size_t begin = origin + std::string("<origin xyz=\"").size();
    longer.replace(begin, longer.find('"', begin) - begin, "0 0 0.5");
    writeBeside("longer.urdf", longer);
    writeFile("description = \"longer.urdf\"\n");
    const ProgramResult other = check();
    EXPECT_NE(other.exitCode, 0);
    EXPECT_TRUE(frames(other).starts_with("problem: the tip is not where /tf has it")) << other.out;
}

TEST_F(RosArmPeer, anEchoReadsWhatTheOtherMiddlewareSends) {
    start(79, {"--position", "0.1,0.2,0.3,0.4,0.5,0.6,0.7"});
    const auto echo = [](const char* topic) {
        return test::run(
            {"ros", "echo", topic, "--count", "2", "--json", "--interface", "lo", "--domain", "79"});
    };
    const ProgramResult states = echo("/joint_states");
    ASSERT_EQ(states.exitCode, 0) << states.err;
    const json messages = json::parse(states.out);
    ASSERT_EQ(messages.size(), 2U);
    EXPECT_EQ(messages[0]["name"].size(), 7U);
    EXPECT_EQ(messages[0]["name"][6], "joint_7");
    EXPECT_NEAR(messages[0]["position"][6].get<double>(), 0.7, 0.01);
    EXPECT_EQ(messages[0]["effort"].size(), 7U);
    const ProgramResult wrench = echo("/ft/wrench");
    ASSERT_EQ(wrench.exitCode, 0) << wrench.err;
    EXPECT_EQ(json::parse(wrench.out)[0]["header"]["frame_id"], "tool0");
}

TEST_F(RosArmPeer, aCertificateWatchesTheArmOnItsOwnTopic) {
    start(110);
    const std::vector<std::string> certify{"certify", "--arm",
                                           path(),    "--joint",
                                           "joint_3", "--yes",
                                           "--kinds", "kill,sleep,stop",
                                           "--out",   m_folder.filePath("report").toStdString(),
                                           "--json"};
    const auto run = [&certify](std::vector<std::string> more) {
        more.insert(more.begin(), certify.begin(), certify.end());
        return test::run(more);
    };
    const ProgramResult passed = run({"--faults", "3", "--bound", "1"});
    EXPECT_EQ(passed.exitCode, 0) << passed.err << passed.out;
    const json report = json::parse(passed.out, nullptr, false);
    ASSERT_TRUE(report.is_object()) << passed.out;
    EXPECT_EQ(report["system"]["actuator"], "arm");
    EXPECT_EQ(report["system"]["driver"], "Robot");
    EXPECT_EQ(report["system"]["simulated"], false);
    EXPECT_EQ(report["total"]["faults"], 3);
    EXPECT_EQ(report["total"]["restarted"], 0);
    EXPECT_NEAR(logOf("state").back()["velocity"][kJoint].get<double>(), 0.0, 1e-3);
    // T1 alone, in which the arm goes on at full speed, is longer than that.
    const ProgramResult late = run({"--faults", "1", "--bound", "0.02"});
    EXPECT_EQ(late.exitCode, 1) << late.out;
    EXPECT_EQ(json::parse(late.out, nullptr, false)["total"]["over_bound"], 1);
}

TEST_F(RosArmPeer, whoMovesAnArmIsANodeOfItsOwn) {
    start(80);
    const auto nodesDuringAJog = [this] {
        const std::size_t before = logOf("trajectory").size();
        test::RunningProgram jog(jogArguments(2.0));
        EXPECT_TRUE(eventually([&] { return logOf("trajectory").size() > before; }));
        const ProgramResult nodes =
            test::run({"ros", "nodes", "--json", "--interface", "lo", "--domain", "80"});
        EXPECT_EQ(jog.wait().exitCode, 0);
        return json::parse(nodes.out);
    };
    for (const char* distribution : {"jazzy", "humble"}) {
        writeFile("", std::string("distribution = \"") + distribution + "\"\n");
        EXPECT_EQ(nodesDuringAJog(),
                  json::parse(R"([{"node": "/teleta", "publishers": 1, "subscribers": 1}])"))
            << distribution;
    }
    writeFile("", "announce = false\n");
    EXPECT_EQ(nodesDuringAJog(), json::array());
}

TEST_F(RosArmPeer, aCheckSaysWhatIsInTheWay) {
    start(73, {"--fault", "missing@0", "--command-qos", "transient-local"});
    writeFile("required = [\"pad\"]\n");
    const peer::EndQos reliable{};
    peer::DdsNode other(73);
    (void)other.write(
        "/arm_controller/joint_trajectory",
        eprosima::fastdds::dds::TypeSupport(new trajectory_msgs::msg::JointTrajectoryPubSubType), reliable);
    const ProgramResult result = check();
    EXPECT_EQ(result.exitCode, 1) << result.out;
    const json rows = json::parse(result.out);
    EXPECT_EQ(resultOf(rows, "joints"), "/joint_states does not report: joint_7") << result.out;
    EXPECT_NE(resultOf(rows, "controller").find("asks for transient local"), std::string::npos) << result.out;
    EXPECT_EQ(resultOf(rows, "writers"), "someone else commands /arm_controller/joint_trajectory")
        << result.out;
    EXPECT_NE(resultOf(rows, "file").find("pad"), std::string::npos) << result.out;
    EXPECT_NE(result.err.find("the arm cannot be moved: 4 problem"), std::string::npos) << result.err;
    // The same, from who would move it.
    const ProgramResult jog = test::run(jogArguments(0.1));
    EXPECT_EQ(jog.exitCode, 1);
    EXPECT_NE(jog.err.find("the file requires pad"), std::string::npos) << jog.err;
    EXPECT_TRUE(logOf("trajectory").empty());
}

TEST_F(RosArmPeer, aJogMovesAsFarAsItSays) {
    start(74);
    const ProgramResult result = test::run(jogArguments(1.0));
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const json told = json::parse(result.out);
    // 0.3 rad/s for 1 s, less the ramp up (v^2 / 2a), plus the one down and what a cycle adds.
    EXPECT_NEAR(told["way"].get<double>(), 0.3, 0.03) << result.out;
    const std::vector<json> states = logOf("state");
    ASSERT_FALSE(states.empty());
    EXPECT_NEAR(states.back()["position"][kJoint].get<double>(), told["way"].get<double>(), 2e-3);
    for (const std::size_t other : {0U, 1U, 3U, 4U, 5U, 6U})
        EXPECT_NEAR(states.back()["position"][other].get<double>(), 0.0, 1e-2) << other;
    double fastest = 0.0;
    for (const json& state : states)
        fastest = std::max(fastest, std::abs(state["velocity"][kJoint].get<double>()));
    EXPECT_LT(fastest, 1.5 * kRate_radPerS);
    EXPECT_FALSE(told["time_to_rest_s"].is_null());
    for (const json& trajectory : logOf("trajectory"))
        EXPECT_EQ(trajectory["accepted"], true) << trajectory["reason"];
    const ProgramResult unknown =
        test::run({"arm", "jog", path(), "--joint", "elbow", "--rate", "0.1", "--seconds", "0.1", "--yes"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_NE(unknown.err.find("joint_7"), std::string::npos) << unknown.err;
}

TEST_F(RosArmPeer, theArmComesToRestByItselfWhenTheProgramIsKilled) {
    start(75);
    test::RunningProgram jog(jogArguments(2.0));
    ASSERT_TRUE(comesToMove());
    ASSERT_TRUE(eventually([this] {
        const std::vector<json> states = logOf("state");
        return !states.empty() && states.back()["velocity"][kJoint].get<double>() > 0.9 * kRate_radPerS;
    }));
    jog.send(SIGKILL);
    EXPECT_EQ(jog.wait().exitCode, -SIGKILL);
    std::this_thread::sleep_for(std::chrono::seconds(1));
    const double lastCommand_s = steady_s(logOf("trajectory").back());
    const double rest_s = lastAway_s(1e-3) - lastCommand_s;
    const double braking_s = kRate_radPerS / kDeceleration_radPerS2;
    EXPECT_LE(rest_s, kLease_s + kFirstPoint_s + braking_s + 0.02);
    EXPECT_GT(rest_s, 0.0);
    // No command moved it again.
    EXPECT_NEAR(logOf("state").back()["velocity"][kJoint].get<double>(), 0.0, 1e-3);
}

TEST_F(RosArmPeer, anInterruptionHoldsTheArm) {
    start(76);
    test::RunningProgram jog(jogArguments(2.0));
    ASSERT_TRUE(comesToMove());
    jog.send(SIGINT);
    const ProgramResult result = jog.wait();
    EXPECT_EQ(result.exitCode, 1);
    const json told = json::parse(result.out);
    EXPECT_LT(told["held_s"].get<double>(), 1.9);
    EXPECT_FALSE(told["time_to_rest_s"].is_null());
    EXPECT_NEAR(logOf("state").back()["velocity"][kJoint].get<double>(), 0.0, 1e-3);
}

TEST_F(RosArmPeer, aVelocityControllerIsBroughtToRest) {
    start(122, {"--controller", "velocity"});
    const std::string adapter = "adapter = \"velocity\"\ncontroller = \"/velocity_controller\"\n";
    writeFile(adapter);
    const ProgramResult refused = check();
    EXPECT_EQ(refused.exitCode, 3);
    EXPECT_NE(refused.err.find("unguarded = true"), std::string::npos) << refused.err;
    writeFile(adapter + "unguarded = true\n");
    const ProgramResult checked = check();
    EXPECT_EQ(checked.exitCode, 0) << checked.out << checked.err;
    EXPECT_NE(checked.out.find("UNGUARDED"), std::string::npos) << checked.out;

    const ProgramResult result = test::run(jogArguments(1.0));
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_GT(json::parse(result.out)["way"].get<double>(), 0.0) << result.out;
    const auto areZero = [](const json& command) {
        return std::ranges::all_of(command["data"], [](const json& value) { return value == 0.0; });
    };
    const std::vector<json> commands = logOf("velocity");
    ASSERT_FALSE(commands.empty());
    for (const json& command : commands) {
        EXPECT_EQ(command["accepted"], true);
        for (const json& value : command["data"])
            EXPECT_LE(std::abs(value.get<double>()), kRate_radPerS + 1e-9);
    }
    EXPECT_TRUE(areZero(commands.back()));
    EXPECT_NEAR(logOf("state").back()["velocity"][kJoint].get<double>(), 0.0, 1e-3);
    // The way is that of the rates, each of which holds until the next one comes.
    double integral = 0.0;
    for (std::size_t i = 0; i + 1 < commands.size(); ++i)
        integral +=
            commands[i]["data"][kJoint].get<double>() * (steady_s(commands[i + 1]) - steady_s(commands[i]));
    EXPECT_NEAR(commands.back()["position"][kJoint].get<double>(), integral, 0.1 * integral + 1e-3);

    // Ended in the middle, the program sends zeros before it goes.
    const auto isFast = [this] {
        const std::vector<json> states = logOf("state");
        return !states.empty() && states.back()["velocity"][kJoint].get<double>() > 0.9 * kRate_radPerS;
    };
    test::RunningProgram ended(jogArguments(2.0));
    ASSERT_TRUE(eventually(isFast));
    ended.send(SIGTERM);
    (void)ended.wait();
    EXPECT_TRUE(eventually([&] { return areZero(logOf("velocity").back()); }));
    EXPECT_TRUE(
        eventually([&] { return std::abs(logOf("state").back()["velocity"][kJoint].get<double>()) < 1e-3; }));

    // Joints that are told wrongly bring it to rest, too.
    test::RunningProgram blind(jogArguments(2.0));
    ASSERT_TRUE(eventually(isFast));
    ASSERT_TRUE(m_robot.command("fault nan"));
    EXPECT_EQ(blind.wait().exitCode, 1);
    EXPECT_TRUE(eventually([&] { return areZero(logOf("velocity").back()); }));
    ASSERT_TRUE(m_robot.command("fault none"));

    // That is what UNGUARDED means: nothing at the robot stops what a killed program left behind.
    test::RunningProgram killed(jogArguments(2.0));
    ASSERT_TRUE(eventually(isFast));
    killed.send(SIGKILL);
    EXPECT_EQ(killed.wait().exitCode, -SIGKILL);
    const auto goesOn = [this](std::size_t states) {
        const std::size_t before = logOf("state").size();
        return eventually([&] { return logOf("state").size() > before + states; });
    };
    ASSERT_TRUE(goesOn(50)); // what was on its way has come, and is in the log
    const std::size_t left = logOf("velocity").size();
    ASSERT_TRUE(goesOn(50));
    EXPECT_EQ(logOf("velocity").size(), left);
    EXPECT_TRUE(isFast());
}

TEST_F(RosArmPeer, aProgramThatEndsLeavesNoRateBehindHoweverGentlyTheArmBrakes) {
    start(125, {"--controller", "velocity"});
    // Braking from 0.3 rad/s would take 6 s.
    writeFile("adapter = \"velocity\"\ncontroller = \"/velocity_controller\"\nunguarded = true\n", {},
              "deceleration_radPerS2 = 0.05\nstop_deceleration_radPerS2 = 0.05\n");
    test::RunningProgram jog(jogArguments(2.0));
    ASSERT_TRUE(eventually([this] {
        const std::vector<json> states = logOf("state");
        return !states.empty() && states.back()["velocity"][kJoint].get<double>() > 0.9 * kRate_radPerS;
    }));
    jog.send(SIGTERM);
    (void)jog.wait();
    const auto rates = [this] { return logOf("velocity").back()["data"].get<std::vector<double>>(); };
    EXPECT_TRUE(
        eventually([&] { return std::ranges::all_of(rates(), [](double rate) { return rate == 0.0; }); }));
    EXPECT_TRUE(eventually(
        [this] { return std::abs(logOf("state").back()["velocity"][kJoint].get<double>()) < 1e-3; }));
}

TEST_F(RosArmPeer, aPositionControllerStaysWhereItWasLeft) {
    start(123, {"--controller", "position", "--position", "0.1,0.2,0.3,0.4,0.5,0.6,0.7"});
    writeFile("adapter = \"position\"\ncontroller = \"/position_controller\"\nunguarded = true\n");
    const ProgramResult result = test::run(jogArguments(1.0));
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const double way = json::parse(result.out)["way"];
    EXPECT_GT(way, 0.0) << result.out;
    const std::vector<json> commands = logOf("position");
    ASSERT_FALSE(commands.empty());
    constexpr double kLeash_rad = 0.05;
    for (const json& command : commands)
        for (std::size_t i = 0; i < command["data"].size(); ++i)
            EXPECT_NEAR(command["data"][i].get<double>(), command["position"][i].get<double>(),
                        kLeash_rad + 1e-3)
                << i;
    const json last = logOf("state").back();
    EXPECT_NEAR(last["position"][kJoint].get<double>(), 0.3 + way, 5e-3);
    EXPECT_NEAR(last["velocity"][kJoint].get<double>(), 0.0, 1e-3);

    test::RunningProgram killed(jogArguments(2.0));
    ASSERT_TRUE(eventually(
        [this] { return logOf("state").back()["velocity"][kJoint].get<double>() > 0.9 * kRate_radPerS; }));
    killed.send(SIGKILL);
    EXPECT_EQ(killed.wait().exitCode, -SIGKILL);
    EXPECT_TRUE(eventually(
        [this] { return std::abs(logOf("state").back()["velocity"][kJoint].get<double>()) < 1e-3; }));
    EXPECT_NEAR(logOf("state").back()["position"][kJoint].get<double>(),
                logOf("position").back()["data"][kJoint].get<double>(), 5e-3);
}

TEST_F(RosArmPeer, aProbeListensToThePad) {
    start(124, {"--pad"});
    const auto probe = [this](const std::string& rows) {
        writeBeside("pad.toml", "kind = \"ros_tactile\"\nname = \"pad\"\ntopic = \"/pad/tactile\"\n"
                                "format = \"Float64MultiArray\"\nrows = " +
                                    rows +
                                    "\ncols = 6\npitch_mm = 3.4\nrate_Hz = 100\n[ros]\ndomain = 124\n"
                                    "interface = \"lo\"\n");
        return test::run({"devices", "--probe", m_folder.filePath("pad.toml").toStdString(), "--json"});
    };
    const ProgramResult result = probe("14");
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const json pad = json::parse(result.out)["devices"][0];
    EXPECT_EQ(pad["kind"], "ros_tactile");
    EXPECT_EQ(pad["connected"], true) << result.out;
    EXPECT_GT(pad["frame_rate_hz"].get<double>(), 20.0);
    const auto value = [](const json& device, const char* name) {
        for (const json& one : device["values"])
            if (one["name"] == name)
                return one["value"].get<double>();
        return -1.0;
    };
    EXPECT_EQ(value(pad, "rows"), 14.0);
    EXPECT_GT(value(pad, "messages"), 10.0);
    EXPECT_EQ(value(pad, "misfits"), 0.0);
    // A file of another size.
    const ProgramResult other = probe("13");
    EXPECT_EQ(other.exitCode, 1) << other.out;
    const json misfit = json::parse(other.out)["devices"][0];
    EXPECT_EQ(misfit["connected"], false);
    EXPECT_NE(misfit["reason"].get<std::string>().find("84"), std::string::npos) << other.out;
    EXPECT_GT(value(misfit, "misfits"), 10.0);
}

/// The robot tells its force in tool0 and that tool0 hangs on link_7; the file's description has no tool0.
TEST_F(RosArmPeer, aForceIsFoundInAFrameThatOnlyTheRobotKnows) {
    start(130);
    std::ifstream urdf(kUrdf);
    std::string bare;
    for (std::string line; std::getline(urdf, line);)
        if (line.find("tool0") == std::string::npos)
            bare += line + '\n';
    writeBeside("bare.urdf", bare);
    writeBeside("ft.toml", "kind = \"ros_wrench\"\nname = \"wrist\"\ntopic = \"/ft/wrench\"\n");
    writeBeside("arm.toml", "kind = \"ros_arm\"\nname = \"Robot\"\ndescription = \"bare.urdf\"\n"
                            "base_frame = \"base_link\"\ntip_frame = \"link_7\"\neffort_unit = \"Nm\"\n"
                            "controller = \"/arm_controller\"\nwrench = \"ft.toml\"\n"
                            "[ros]\ndomain = 130\ninterface = \"lo\"\n[limits]\nforce_stop_N = 50.0\n");
    const ProgramResult result = check();
    EXPECT_EQ(result.exitCode, 0) << result.out << result.err;
    const json rows = json::parse(result.out);
    EXPECT_TRUE(std::ranges::any_of(rows, [](const json& row) {
        return row["check"] == "force" && row["result"] == "ok";
    })) << result.out;
}

TEST_F(RosArmPeer, aForceAtTheWristHoldsTheArm) {
    start(112);
    writeBeside("ft.toml",
                "kind = \"ros_wrench\"\nname = \"wrist\"\ntopic = \"/ft/wrench\"\ntimeout_s = 0.25\n");
    writeFile("wrench = \"ft.toml\"\n", {}, "force_stop_N = 15.0\n");
    test::RunningProgram jog(jogArguments(2.0));
    ASSERT_TRUE(eventually([this] {
        const std::vector<json> states = logOf("state");
        return !states.empty() && states.back()["velocity"][kJoint].get<double>() > 0.9 * kRate_radPerS;
    }));
    ASSERT_TRUE(m_robot.command("push 0 0 -30"));
    const double pushed_s = 1e-9 * static_cast<double>(core::steadyNow_ns());
    const ProgramResult result = jog.wait();
    EXPECT_EQ(result.exitCode, 0) << result.err;
    // A step of 20 ms, the first point and the way to brake.
    EXPECT_LE(lastAway_s(2e-3) - pushed_s,
              0.02 + kFirstPoint_s + kRate_radPerS / kDeceleration_radPerS2 + 0.1);
    EXPECT_GT(json::parse(result.out)["way"].get<double>(), 0.0);
    EXPECT_LT(json::parse(result.out)["way"].get<double>(), 0.5) << "2 s at 0.3 rad/s are 0.6 rad";
    // Nor does it begin to move, until the force is gone.
    const auto way = [this] { return json::parse(test::run(jogArguments(0.5)).out)["way"].get<double>(); };
    EXPECT_NEAR(way(), 0.0, 1e-3);
    ASSERT_TRUE(m_robot.command("push 0 0 0"));
    EXPECT_GT(way(), 0.05);
    // A sensor that is silent is no sensor without a force.
    ASSERT_TRUE(m_robot.command("fault no-wrench"));
    const ProgramResult blind = test::run(jogArguments(0.2));
    EXPECT_EQ(blind.exitCode, 1);
    EXPECT_NE(blind.err.find("/ft/wrench reports no force"), std::string::npos) << blind.err;
}

TEST_F(RosArmPeer, aPadIsATactileArray) {
    start(116, {"--pad"});
    const auto openPad = [](int rows, int columns) {
        const auto file = ros_array::parseRosArray(
            "kind = \"ros_tactile\"\nname = \"pad\"\ntopic = \"/pad/tactile\"\nformat = "
            "\"Float64MultiArray\"\n"
            "rows = " +
                std::to_string(rows) + "\ncols = " + std::to_string(columns) +
                "\npitch_mm = 3.4\nrate_Hz = 100\n[ros]\ndomain = 116\ninterface = \"lo\"\n",
            "pad.toml");
        EXPECT_TRUE(file) << core::describe(file.error());
        auto opened = ros_array::RosArray::open(*file);
        EXPECT_TRUE(opened) << core::describe(opened.error());
        return std::move(*opened);
    };
    core::Wakeup wakeup;
    const auto pad = openPad(14, 6);
    pad->start(wakeup);
    ASSERT_TRUE(m_robot.command("press 8"));
    double sum_N = 0.0;
    const auto isPressed = [&] {
        for (core::SampleBlock block; pad->blocks().pop(block);) {
            const auto frame = block.frame(block.frames() - 1);
            sum_N = std::accumulate(frame.begin(), frame.end(), 0.0);
        }
        return std::abs(sum_N - 8.0) < 0.4;
    };
    EXPECT_TRUE(eventually(isPressed)) << sum_N;
    EXPECT_EQ(pad->status().state, core::DeviceState::live);
    ASSERT_TRUE(m_robot.command("fault no-pad"));
    EXPECT_TRUE(eventually([&] { return pad->status().state == core::DeviceState::stale; }));
    EXPECT_NE(pad->status().message.find("/pad/tactile"), std::string::npos) << pad->status().message;
    ASSERT_TRUE(m_robot.command("fault none"));
    EXPECT_TRUE(eventually([&] { return pad->status().state == core::DeviceState::live; }));

    const auto turned = openPad(6, 14);
    turned->start(wakeup);
    EXPECT_TRUE(eventually([&] {
        return turned->status().message.find("14 x 6 numbers, the file has 6 x 14") != std::string::npos;
    })) << turned->status().message;
    EXPECT_EQ(turned->status().state, core::DeviceState::connecting);
    EXPECT_GT(turned->counters().misfits, 0U);
}

TEST_F(RosArmPeer, anotherWriterEndsTheMotion) {
    start(77);
    test::RunningProgram jog(jogArguments(2.0));
    ASSERT_TRUE(comesToMove());
    const peer::EndQos reliable{};
    peer::DdsNode other(77);
    (void)other.write(
        "/arm_controller/joint_trajectory",
        eprosima::fastdds::dds::TypeSupport(new trajectory_msgs::msg::JointTrajectoryPubSubType), reliable);
    const ProgramResult result = jog.wait();
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.err.find("someone else commands /arm_controller/joint_trajectory"), std::string::npos)
        << result.err;
    EXPECT_LT(json::parse(result.out)["held_s"].get<double>(), 1.9);
    // The next one does not even begin.
    const std::size_t commands = logOf("trajectory").size();
    const ProgramResult next = test::run(jogArguments(0.2));
    EXPECT_EQ(next.exitCode, 1);
    EXPECT_NE(next.err.find("someone else commands"), std::string::npos) << next.err;
    EXPECT_EQ(logOf("trajectory").size(), commands);
}

TEST_F(RosArmPeer, jointStatesThatCannotBeBelievedEndTheMotion) {
    start(78);
    const std::vector<std::pair<const char*, const char*>> faults{
        {"nan", "/joint_states reports a position that is not a number"},
        {"backward", "the stamps of /joint_states went back"},
        {"missing", "/joint_states does not report: joint_7"}};
    for (const auto& [fault, text] : faults) {
        const std::size_t before = logOf("trajectory").size();
        test::RunningProgram jog(jogArguments(2.0));
        ASSERT_TRUE(eventually([&] { return logOf("trajectory").size() > before + 5; })) << fault;
        ASSERT_TRUE(m_robot.command(std::string("fault ") + fault));
        const ProgramResult result = jog.wait();
        EXPECT_EQ(result.exitCode, 1) << fault;
        EXPECT_NE(result.err.find(text), std::string::npos) << fault << ": " << result.err;
        ASSERT_TRUE(m_robot.command("fault none"));
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        EXPECT_NEAR(logOf("state").back()["velocity"][kJoint].get<double>(), 0.0, 1e-3) << fault;
    }
    // The order of the joints is no fault.
    ASSERT_TRUE(m_robot.command("fault swapped"));
    EXPECT_EQ(test::run(jogArguments(0.2)).exitCode, 0);
}

} // namespace
} // namespace teleta
