// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/camera_world_check.h"

#include "backend/scene/range_check.h"

#include <algorithm>
#include <cmath>

namespace teleta::scene {

namespace {

bool isShare(double value) {
    return value >= 0.0 && value <= 1.0;
}

bool isCamera(const TubeCamera& camera, const CameraSkin& skin) {
    const auto side = [](int pixels) { return pixels >= 1 && pixels <= kLargestImageSide_px; };
    return side(camera.width_px) && side(camera.height_px) && isPositive(camera.focalLength_px) &&
           isPositive(camera.behind_m) &&
           std::hypot(camera.offsetX_m, camera.offsetY_m) < 0.5 * skin.radius_m;
}

bool isSkin(const CameraSkin& skin) {
    return isPositive(skin.radius_m) && std::isfinite(skin.begin_m) && isPositive(skin.length_m) &&
           isPositive(skin.dotPitch_m) && isPositive(skin.dotDiameter_m) &&
           skin.dotDiameter_m < skin.dotPitch_m && skin.dotPitch_m < skin.radius_m &&
           skin.length_m / skin.dotPitch_m < kMostDotRings && isPositive(skin.reach_m) &&
           isNotNegative(skin.dragPerDepth);
}

bool isFinger(const Finger& finger, const CameraSkin& skin) {
    const auto fits = [&](const FingerKeyframe& frame) {
        return std::isfinite(frame.time_s) && std::isfinite(frame.angle_rad) && std::isfinite(frame.z_m) &&
               std::isfinite(frame.depth_m) && frame.depth_m < 0.5 * skin.radius_m;
    };
    return isPositive(finger.radius_m) && !finger.keyframes.empty() &&
           std::ranges::all_of(finger.keyframes, fits) &&
           std::ranges::adjacent_find(finger.keyframes, std::ranges::greater_equal{},
                                      &FingerKeyframe::time_s) == finger.keyframes.end();
}

bool isProbing(const Probing& probing, const CameraSkin& skin) {
    return probing.around >= 1 && probing.along >= 1 && probing.around <= kMostHoles &&
           probing.along <= kMostHoles / probing.around && std::isfinite(probing.first_z_m) &&
           std::isfinite(probing.last_z_m) && isPositive(probing.stickRadius_m) &&
           isPositive(probing.depth_m) && probing.depth_m < 0.5 * skin.radius_m &&
           isPositive(probing.hole_s) && isNotNegative(probing.play_m) && isShare(probing.wrongShare);
}

struct ReactionIsValid {
    bool operator()(const NoReaction&) const { return true; }
    bool operator()(const BumpReaction& bump) const {
        return isPositive(bump.speed_mPerS) && isPositive(bump.depth_m) && isPositive(bump.retreat_m);
    }
    bool operator()(const FollowReaction& follow) const { return isPositive(follow.gain_perS); }
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
    if (!std::visit(ReactionIsValid(), world.reaction) || !isPositive(limits.speed_mPerS) ||
        !isPositive(limits.acceleration_mPerS2) || !isPositive(limits.turn_radPerS) ||
        !isPositive(limits.turnAcceleration_radPerS2))
        return CameraWorldFault::arm;
    return CameraWorldFault::none;
}

bool isCameraEffect(const LensDistortionSpec& spec) {
    const auto finite = [](double value) { return std::isfinite(value); };
    return std::ranges::all_of(spec.radial, finite) && std::ranges::all_of(spec.tangential, finite);
}

bool isCameraEffect(const UnevenLightSpec& spec) {
    return spec.lamps >= 1 && spec.lamps <= 100 && isShare(spec.ripple) && isNotNegative(spec.fallPerMetre);
}

bool isCameraEffect(const SensorNoiseSpec& spec) {
    return isNotNegative(spec.read) && isNotNegative(spec.shot);
}

bool isCameraEffect(const MotionBlurSpec& spec) {
    return isPositive(spec.exposure_s) && spec.samples >= 2 && spec.samples <= 32;
}

bool isCameraEffect(const MarkerPrintErrorSpec& spec) {
    return isNotNegative(spec.sd_m) && isNotNegative(spec.sizeShare);
}

bool isCameraEffect(const VignettingSpec& spec) {
    return isShare(spec.share);
}

} // namespace teleta::scene
