// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/serial_chain.h"
#include "backend/core/error.h"
#include "backend/ros/joint_state_joiner.h"
#include "backend/ros/qos_profile.h"
#include "devices/dds/discovery.h"
#include "devices/ros/arm_fault.h"
#include "devices/ros/check/frame_check.h"
#include "devices/ros/files/ros_arm_file.h"

#include <QString>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace teleta::ros_arm {

/// What was told of the force at an arm's wrist.
struct WrenchObservation {
    std::uint64_t messages = 0;
    double longestGap_s = 0.0; ///< without a message; the whole time when there was none
    double strongest_N = 0.0;  ///< NaN: some force was no number
    std::string unknownFrame;  ///< that is not known; empty: none
};

/// What was seen of an arm and its controller for some time.
struct ArmObservation {
    double time_s = 0.0;       ///< > 0
    std::uint64_t samples = 0; ///< in which all joints were told
    double longestGap_s = 0.0; ///< without a sample; time_s when there was none
    bool effortTold = false;   ///< in the newest sample
    ros::JointCounters counters;
    std::uint64_t zeroStamps = 0;
    std::optional<double> clockDifference_s; ///< median of our wall clock less the stamps
    std::vector<std::string> missing;        ///< joints, as messages name them, at the last message
    std::vector<std::string> unknown;        ///< names in messages that are not the arm's
    std::optional<ArmFault> fault;           ///< the first one
    std::optional<ros::QosMismatch> jointMismatch;
    std::optional<WrenchObservation> wrench; ///< nothing: the file names no force sensor
    FrameObservation frames;
    std::vector<dds::FoundEnd> ends; ///< of other programs, of all topics
};

enum class FindingLevel {
    good,
    note,    ///< worth knowing
    problem, ///< the arm cannot be moved
};

struct ArmFinding {
    const char* check; ///< "joints", "rate", "effort", "force", "frames", "clock", "controller", "writers",
                       ///< "file", "pad"
    FindingLevel level;
    QString text; ///< translated, without a full stop
};

struct WatchedArm {
    std::shared_ptr<const arm_model::SerialChain> chain;
    ArmObservation observation;
};

/// Watches the arm for this time, without a writer: it moves nothing and does not disturb who does.
/// cancelled: looked at meanwhile. Error: as findChain(). Thread: any; it waits.
[[nodiscard]] core::Expected<WatchedArm> watchArm(const RosArmFile& file, double time_s,
                                                  const std::function<bool()>& cancelled);

/// What it means for moving the arm. Thread: any (pure).
[[nodiscard]] std::vector<ArmFinding> findingsOf(const RosArmFile& file, const arm_model::SerialChain& chain,
                                                 const ArmObservation& seen);

} // namespace teleta::ros_arm
