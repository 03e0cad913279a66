// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/camera_world.h"

namespace teleta::scene {

/// What is wrong with the world of a camera.
enum class CameraWorldFault { none, camera, skin, finger, probing, arm };

/// Sizes, signs, motions and limits of a camera's world. Thread: any (pure).
[[nodiscard]] CameraWorldFault checkCameraWorld(const CameraWorld& world);

/// Whether the parameters of an effect are within their ranges.
[[nodiscard]] bool isCameraEffect(const LensDistortionSpec& spec);
[[nodiscard]] bool isCameraEffect(const UnevenLightSpec& spec);
[[nodiscard]] bool isCameraEffect(const SensorNoiseSpec& spec);
[[nodiscard]] bool isCameraEffect(const MotionBlurSpec& spec);
[[nodiscard]] bool isCameraEffect(const MarkerPrintErrorSpec& spec);
[[nodiscard]] bool isCameraEffect(const VignettingSpec& spec);

} // namespace teleta::scene
