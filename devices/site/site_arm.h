// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace teleta::arm_model {
class SerialChain;
}

namespace teleta::site_link {

/// What an arm says of itself besides core::ArmSource.
struct ArmHealth {
    std::string fault; ///< why it is not commanded any more, a sentence without a full stop; empty: none
    std::uint32_t flags = 0; ///< limits that act, arm_model::MotionFlag
    /// It was held while it was commanded, and moves only when the switch was let go and pressed again.
    bool wantsNewPress = false;
};

/// Where the joints of an arm were.
struct ArmReading {
    core::JointVector angle_rad; ///< rad or m; empty: not known yet
    std::int64_t time_ns = 0;    ///< when, by the steady clock
};

/// An arm of a site, for those who command it and those who are told of it.
struct SiteArm {
    std::string name;                  ///< isSiteName()
    core::ArmSource* source = nullptr; ///< not null; outlives this
    std::function<ArmHealth()> health; ///< empty: it has no faults
    /// The newest angles. Any thread. Empty: nobody tells them.
    std::function<ArmReading()> angles;
    /// Older ones are not where the joints are.
    std::int64_t oldestAngles_ns = 100'000'000;
    std::shared_ptr<const arm_model::SerialChain> chain; ///< null: not known
    std::string adapter = "simulated";                   ///< "none": it is read-only
    bool guarded = true; ///< something at the robot ends a motion when nothing more comes
    std::string effortUnit = "Nm";
    double tipSpeed_mPerS = 0.0; ///< limits of the tip; 0: not known
    double tipTurn_radPerS = 0.0;
};

} // namespace teleta::site_link
