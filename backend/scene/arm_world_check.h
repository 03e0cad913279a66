// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/arm_world.h"

namespace teleta::scene {

/// What is out of range in a world that a program made.
enum class ArmWorldFault { none, body, control, skin, object, unknown, program };

/// The first fault, in the order of the enumeration; with object: which one. Thread: any (pure).
struct ArmWorldCheck {
    ArmWorldFault fault = ArmWorldFault::none;
    std::size_t object = 0;
};
[[nodiscard]] ArmWorldCheck checkArmWorld(const ArmWorld& world);

} // namespace teleta::scene
