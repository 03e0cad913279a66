// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/error.h"
#include "backend/scene/scene.h"
#include "backend/servo/servo_link.h"

#include <cstdint>
#include <memory>

namespace teleta::simulation {

/// The tactile array of a servo scene with the closed loop behind it: each frame runs the world, the image
/// processing and the servo up to the next reading of the array. STOP (motionHeld) holds the commanded pose;
/// the arm rests against its springs there. The link says what the servo does and takes what the operator
/// asks for; what the controller refuses changes nothing. Deterministic as the loop is, as long as nobody
/// asks for anything. link: not null. Error: badInput when the scene is not valid or not of a servo.
[[nodiscard]] core::Expected<std::unique_ptr<core::FrameGenerator>>
makeServoArray(const scene::Scene& scene, std::uint64_t seed, std::shared_ptr<servo::ServoLink> link);

} // namespace teleta::simulation
