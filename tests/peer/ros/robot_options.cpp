// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot_options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace teleta::peer {

namespace {

constexpr const char* kFaults =
    R"(Faults, as --fault KIND@START or KIND@START+DURATION (seconds from the start):
  silent     no joint states
  no-pad     no frames of the pad
  no-wrench  no wrenches
  nan        the position of the first joint is not a number
  infinite   its velocity is infinite
  missing    the last joint is left out
  swapped    the order of the joints is turned round, values still with their names
  jump       the position of the first joint is told 0.5 rad too large
  backward   stamps go back by 2 s
  zero-stamp stamps are zero
  best-effort  joint states come from a new writer that is best effort
  deaf       commands are not taken

Lines on standard input with --commands, each answered by "done" or "error WHY":
  fault KIND | fault none      from now on
  push FX FY FZ                force on the tip in N, axes of the world
  press F                      force of the ball on the pad in N
  counts                       the answer is "done" and what the log's "end" has, so far
  end                          as the end of the input: the program ends

The log has one JSON object a line, with the steady clock in steady_ns: "ready", "state" (100 a second: position,
velocity and desired position; with objects: the force on the pad and how far each is pressed down), "trajectory", "velocity", "position" and "jog" (each that came, whether accepted, why not, where the arm
stood), "matched" (writers on the command topic, readers of joint states), "fault", "end" (counts).)";

double number(const std::string& text) {
    std::size_t used = 0;
    const double value = std::stod(text, &used);
    if (used != text.size() || !(value >= 0))
        throw std::invalid_argument(text);
    return value;
}

} // namespace

const std::vector<std::string>& faultKinds() {
    static const std::vector<std::string> kinds = {"silent",   "no-pad",     "no-wrench",   "nan",
                                                   "infinite", "missing",    "swapped",     "jump",
                                                   "backward", "zero-stamp", "best-effort", "deaf"};
    return kinds;
}

Fault readFault(const std::string& text) {
    const std::size_t at = text.find('@');
    const std::size_t plus = text.find('+', at == std::string::npos ? 0 : at);
    Fault fault;
    fault.kind = text.substr(0, at);
    const auto& kinds = faultKinds();
    try {
        if (at == std::string::npos || std::find(kinds.begin(), kinds.end(), fault.kind) == kinds.end())
            throw std::invalid_argument(text);
        fault.start_s = number(text.substr(at + 1, plus == std::string::npos ? plus : plus - at - 1));
        fault.duration_s = plus == std::string::npos ? std::numeric_limits<double>::infinity()
                                                     : number(text.substr(plus + 1));
    } catch (const std::exception&) {
        throw std::invalid_argument("'" + text +
                                    "' is no fault (KIND@START or KIND@START+DURATION, see --help)");
    }
    return fault;
}

SoftObject readObject(const std::string& text) {
    std::istringstream words(text);
    words.imbue(std::locale::classic());
    SoftObject object;
    char comma[3] = "";
    words >> object.position_m[0] >> comma[0] >> object.position_m[1] >> comma[1] >> object.position_m[2] >>
        comma[2] >> object.stiffness_NPerM;
    if (!words || !words.eof() || comma[0] != ',' || comma[1] != ',' || comma[2] != ',' ||
        !(object.stiffness_NPerM > 0))
        throw std::invalid_argument("'" + text + "' is no object (X,Y,Z,STIFFNESS)");
    return object;
}

RobotOptions readOptions(int argc, char** argv) {
    RobotOptions options;
    std::vector<std::string> faults;
    std::vector<std::string> objects;
    CLI::App app(
        "A robot on ROS 2 topics for tests: Fast DDS and MuJoCo, on 127.0.0.1 only. It ends by itself.");
    app.footer(kFaults);
    app.add_option("--domain", options.domain, "ROS_DOMAIN_ID")
        ->check(CLI::Range(0, 232))
        ->capture_default_str();
    app.add_option("--urdf", options.urdf, "Published on /robot_description and stepped at 1 kHz")
        ->required()
        ->check(CLI::ExistingFile);
    app.add_option("--tip", options.tip,
                   "Link of the force sensor and the pad; default: the last of the file");
    app.add_option("--rate", options.rate_Hz, "Joint states and wrenches a second; a divisor of 1000")
        ->check(CLI::Range(1.0, 1000.0))
        ->capture_default_str();
    app.add_option("--distribution", options.distribution,
                   "Whose checks of a trajectory: jazzy refuses ends that move and points without positions")
        ->check(CLI::IsMember({"humble", "jazzy"}))
        ->capture_default_str();
    app.add_option(
           "--start-from", options.startFrom,
           "Where a new trajectory starts: where the arm is measured, or from the controller's setpoint")
        ->check(CLI::IsMember({"measured", "desired"}))
        ->capture_default_str();
    app.add_option(
           "--controller", options.controller,
           "trajectory: /arm_controller/joint_trajectory; velocity: /velocity_controller/commands and "
           "position: /position_controller/commands, which keep "
           "the last values for ever; servo: /servo_node/delta_joint_cmds, which halts 0.1 s after the "
           "stamp of the last command")
        ->check(CLI::IsMember({"trajectory", "velocity", "position", "servo"}))
        ->capture_default_str();
    app.add_option("--joint-qos", options.jointQos, "Of the writer of /joint_states")
        ->check(CLI::IsMember({"reliable", "best-effort"}))
        ->capture_default_str();
    app.add_option("--command-qos", options.commandQos,
                   "Of the reader of commands; volatile writers do not match the last")
        ->check(CLI::IsMember({"reliable", "best-effort", "transient-local"}))
        ->capture_default_str();
    app.add_option("--position", options.position_rad,
                   "Where the joints start, separated by commas; default: 0")
        ->delimiter(',');
    app.add_flag("--effort-with-gravity", options.effortWithGravity,
                 "Tell effort with the torque that carries the arm");
    app.add_flag(
           "--torque-sensors", options.torqueSensors,
           "Tell effort as sensors behind the gears feel it, without friction and inertia of the motors")
        ->excludes("--effort-with-gravity");
    app.add_flag("--tf", options.frames, "Tell where the moving links are on /tf, with each joint state");
    app.add_flag("--pad", options.pad, "A pad of 14 x 6 touch sensors on /pad/tactile");
    app.add_option("--pad-rate", options.padRate_Hz, "Frames of the pad a second; a divisor of 1000")
        ->check(CLI::Range(1.0, 1000.0))
        ->capture_default_str();
    app.add_option(
        "--object", objects,
        "X,Y,Z,STIFFNESS: a ball of 12 mm in m of the world, on a vertical spring in N/m; with --pad, "
        "which is a hard plate then; can be repeated");
    app.add_option("--effort-noise", options.effortNoise_Nm, "Standard deviation of the efforts told")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--position-noise", options.positionNoise_rad, "Standard deviation of the positions told")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--seed", options.seed, "Of the noise")->capture_default_str();
    app.add_option("--fault", faults, "Something that goes wrong, see below; can be repeated");
    app.add_option("--json", options.log, "File of the log");
    app.add_option("--seconds", options.seconds, "It ends after this time")
        ->check(CLI::Range(0.01, 7200.0))
        ->capture_default_str();
    app.add_flag("--commands", options.commands, "Take lines from standard input, see below");
    try {
        app.parse(argc, argv);
        for (const std::string& text : faults)
            options.faults.push_back(readFault(text));
        for (const std::string& text : objects)
            options.objects.push_back(readObject(text));
    } catch (const CLI::ParseError& error) {
        std::exit(app.exit(error));
    } catch (const std::invalid_argument& error) {
        std::cerr << "ros_robot: " << error.what() << '\n';
        std::exit(2);
    }
    return options;
}

} // namespace teleta::peer
