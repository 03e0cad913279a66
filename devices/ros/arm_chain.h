// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/serial_chain.h"
#include "backend/core/device/required_devices.h"
#include "backend/core/error.h"
#include "devices/dds/participant.h"
#include "devices/ros/files/ros_arm_file.h"

#include <QStringList>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace teleta::ros_arm {

/// The chain that the file names, from its URDF file or from /robot_description, for which it waits up to
/// kDescriptionWait_ns. cancelled: looked at meanwhile. Error: those of arm_model::parseUrdf() and
/// SerialChain::create(); unavailable, nobody told a description; cancelled. Thread: any; it waits.
[[nodiscard]] core::Expected<std::shared_ptr<const arm_model::SerialChain>>
findChain(const std::shared_ptr<const dds::Participant>& participant, const RosArmFile& file,
          const std::function<bool()>& cancelled);

inline constexpr long long kDescriptionWait_ns = 5'000'000'000;

/// The joints of the chain as messages name them. Error: badInput, two have one name.
[[nodiscard]] core::Expected<std::vector<std::string>> wireNames(const RosArmFile& file,
                                                                 const arm_model::SerialChain& chain);

/// Why the arm of this file may not be moved from here, as translated sentences without a full stop; empty
/// when it may. What the file demands is kept, or nothing moves. required: the devices of the site that
/// moves the arm; null: the arm is moved without a site.
[[nodiscard]] QStringList obstacles(const RosArmFile& file, const arm_model::SerialChain& chain,
                                    const core::RequiredDevices* required = nullptr);

} // namespace teleta::ros_arm
