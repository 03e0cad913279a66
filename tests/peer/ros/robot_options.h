// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arm_physics.h"

#include <cstdint>
#include <string>
#include <vector>

namespace teleta::peer {

/// Something that goes wrong from `start_s` on, for `duration_s` (infinite: to the end). Its time counts from
/// the start.
struct Fault {
    std::string kind;
    double start_s = 0;
    double duration_s = 0;
};

/// The faults that --help tells.
[[nodiscard]] const std::vector<std::string>& faultKinds();

/// The command line of ros_robot.
struct RobotOptions {
    int domain = 0;
    std::string urdf;
    std::string tip;
    double rate_Hz = 500;
    std::string distribution = "jazzy";
    std::string startFrom = "measured";
    std::string controller = "trajectory";
    std::string jointQos = "reliable";
    std::string commandQos = "reliable";
    std::vector<double> position_rad;
    bool effortWithGravity = false;
    bool torqueSensors = false;
    bool pad = false;
    bool frames = false; ///< on /tf
    double padRate_Hz = 100;
    std::vector<SoftObject> objects;
    double effortNoise_Nm = 0;
    double positionNoise_rad = 0;
    std::uint64_t seed = 1; ///< of the noise
    std::vector<Fault> faults;
    std::string log;
    double seconds = 60;
    bool commands = false;
};

/// Reads the command line; ends the program with a message on bad ones and after --help.
[[nodiscard]] RobotOptions readOptions(int argc, char** argv);

/// "KIND@START" or "KIND@START+DURATION" in seconds. Throws std::invalid_argument.
[[nodiscard]] Fault readFault(const std::string& text);

/// "X,Y,Z,STIFFNESS" in m and N/m. Throws std::invalid_argument.
[[nodiscard]] SoftObject readObject(const std::string& text);

} // namespace teleta::peer
