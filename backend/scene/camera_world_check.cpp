// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/camera_world_check.h"

#include "backend/core/data/range_check.h"

#include <algorithm>
#include <cmath>

namespace teleta::scene {

namespace {

bool isShare(double value) {
    return value >= 0.0 && value <= 1.0;
}

bool isCamera(const TubeCamera& camera, const CameraSkin& skin) {
    const auto side = [](int pixels) { return pixels >= 1 && pixels <= kLargestImageSide_px; };
    return side(camera.width_px) && side(camera.height_px) && core::isPositive(camera.focalLength_px) &&
           core::isPositive(camera.behind_m) &&
           std::hypot(camera.offsetX_m, camera.offsetY_m) < 0.5 * skin.radius_m;
}

bool isSkin(const CameraSkin& skin) {
    return core::isPositive(skin.radius_m) && std::isfinite(skin.begin_m) && core::isPositive(skin.length_m) &&
           core::isPositive(skin.dotPitch_m) && core::isPositive(skin.dotDiameter_m) &&
           skin.dotDiameter_m < skin.dotPitch_m && skin.dotPitch_m < skin.radius_m &&
           skin.length_m / skin.dotPitch_m < kMostDotRings && core::isPositive(skin.reach_m) &&
           core::isNotNegative(skin.dragPerDepth);
}

bool isFinger(const Finger& finger, const CameraSkin& skin) {
    const auto fits = [&](const FingerKeyframe& frame) {
        return std::isfinite(frame.time_s) && std::isfinite(frame.angle_rad) && std::isfinite(frame.z_m) &&
               std::isfinite(frame.depth_m) && frame.depth_m < 0.5 * skin.radius_m;
    };
    return core::isPositive(finger.radius_m) && !finger.keyframes.empty() &&
           std::ranges::all_of(finger.keyframes, fits) &&
           std::ranges::adjacent_find(finger.keyframes, std::ranges::greater_equal{},
                                      &FingerKeyframe::time_s) == finger.keyframes.end();
}

bool isProbing(const Probing& probing, const CameraSkin& skin) {
    return probing.around >= 1 && probing.along >= 1 && probing.around <= kMostHoles &&
           probing.along <= kMostHoles / probing.around && std::isfinite(probing.first_z_m) &&
           std::isfinite(probing.last_z_m) && core::isPositive(probing.stickRadius_m) &&
           core::isPositive(probing.depth_m) && probing.depth_m < 0.5 * skin.radius_m &&
           core::isPositive(probing.hole_s) && core::isNotNegative(probing.play_m) && isShare(probing.wrongShare);
}

struct ReactionIsValid {
    bool operator()(const NoReaction&) const { return true; }
    bool operator()(const BumpReaction& bump) const {
        return core::isPositive(bump.speed_mPerS) && core::isPositive(bump.depth_m) && core::isPositive(bump.retreat_m);
    }
    bool operator()(const FollowReaction& follow) const { return core::isPositive(follow.gain_perS); }
};

} // namespace

CameraWorldFault checkCameraWorld(const CameraWorld& world) {
    if (!isSkin(world.skin))
        return CameraWorldFault::skin;
    if (!isCamera(world.camera, world.skin))
        return CameraWorldFault::camera;
    if (!std::ranges::all_of(world.fingers,
                             [&](const Finger& finger) { return isFinger(finger, world.skin); }))
        return CameraWorldFault::finger;
    if (world.probing && !isProbing(*world.probing, world.skin))
        return CameraWorldFault::probing;
    const CarrierLimits& limits = world.limits;
    if (!std::visit(ReactionIsValid(), world.reaction) || !core::isPositive(limits.speed_mPerS) ||
        !core::isPositive(limits.acceleration_mPerS2) || !core::isPositive(limits.turn_radPerS) ||
        !core::isPositive(limits.turnAcceleration_radPerS2))
        return CameraWorldFault::arm;
    return CameraWorldFault::none;
}

bool isCameraEffect(const LensDistortionSpec& spec) {
    const auto finite = [](double value) { return std::isfinite(value); };
    return std::ranges::all_of(spec.radial, finite) && std::ranges::all_of(spec.tangential, finite);
}

bool isCameraEffect(const UnevenLightSpec& spec) {
    return spec.lamps >= 1 && spec.lamps <= 100 && isShare(spec.ripple) && core::isNotNegative(spec.fallPerMetre);
}

bool isCameraEffect(const SensorNoiseSpec& spec) {
    return core::isNotNegative(spec.read) && core::isNotNegative(spec.shot);
}

bool isCameraEffect(const MotionBlurSpec& spec) {
    return core::isPositive(spec.exposure_s) && spec.samples >= 2 && spec.samples <= 32;
}

bool isCameraEffect(const MarkerPrintErrorSpec& spec) {
    return core::isNotNegative(spec.sd_m) && core::isNotNegative(spec.sizeShare);
}

bool isCameraEffect(const VignettingSpec& spec) {
    return isShare(spec.share);
}

} // namespace teleta::scene
