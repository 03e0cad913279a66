// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/shared_keys.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace teleta::scene {

inline constexpr int kLargestImageSide_px = 8192;
inline constexpr double kMostDotRings = 1000.0;

/// The soft skin of the tube and the dots that are printed on it.
struct CameraSkin {
    double radius_m = 0.025;
    double begin_m = 0.0; ///< z
    double length_m = 0.100;
    double dotPitch_m = 0.004;
    double dotDiameter_m = 0.0015;
    double reach_m = 0.0015;   ///< how far the skin yields beside a contact
    double dragPerDepth = 0.0; ///< a finger that slides drags the skin by up to so much of its depth
    void describeKeys(Keys& keys);
};

/// The camera that looks along the axis of the tube; its optical axis is z, its lens lies before z = 0.
struct TubeCamera {
    int width_px = 1640;
    int height_px = 1232;
    double focalLength_px = 587.0; ///< > 0; at the middle of the image
    double behind_m = 0.020;       ///< of the sensor frame's origin, where its lens is
    double offsetX_m = 0.0;        ///< of the lens from the axis
    double offsetY_m = 0.0;
    void describeKeys(Keys& keys, const CameraSkin& skin);
};

/// Where a finger is at a time, in the base: the sensor's frame as it was at the start.
struct FingerKeyframe {
    double time_s = 0.0;
    double angle_rad = 0.0; ///< about the tube's axis
    double z_m = 0.0;       ///< along it
    double depth_m = 0.0;   ///< of its tip under the free skin; negative: away from it
};

/// A ball that touches the skin. Between keyframes it moves along monotone cubics.
struct Finger {
    std::string name;
    double radius_m = 0.010;
    std::vector<FingerKeyframe> keyframes;
    void describeKeys(Keys& keys, const CameraSkin& skin);
};

/// A person who probes the skin with a stick, through the holes of a shell one after the other: a grid, ring
/// by ring.
struct Probing {
    int around = 25; ///< holes a ring, 1 .. kMostHoles in all
    int along = 10;
    double first_z_m = 0.0; ///< of the first ring
    double last_z_m = 0.0;
    double stickRadius_m = 0.0019;
    double depth_m = 0.0;
    double hole_s = 1.0;     ///< from hole to hole
    double play_m = 0.0;     ///< of the stick in its hole: standard deviation in either direction
    double wrongShare = 0.0; ///< of the holes that are mistaken for another one, 0 .. 1
    void describeKeys(Keys& keys, const CameraSkin& skin);
};
inline constexpr int kMostHoles = 10000;

/// The arm stays where it is, whatever touches it.
struct NoReaction {
    void describeKeys(Keys&) {}
};

/// The arm stops and draws back when it is bumped.
struct BumpReaction {
    double speed_mPerS = 0.02; ///< a contact that deepens faster is a bump
    double depth_m = 0.0015;   ///< or one that is deeper
    double retreat_m = 0.03;   ///< how far it draws back
    void describeKeys(Keys& keys);
};

/// The arm follows what touches it: turns about the tube's axis and moves along it.
struct FollowReaction {
    double gain_perS = 8.0;
    void describeKeys(Keys& keys) {
        keys.number("gain_per_s", gain_perS, kPositive, "Speed over the distance that the contact has moved",
                    Need::optional);
    }
};

using Reaction = std::variant<NoReaction, BumpReaction, FollowReaction>;

/// Limits of the arm that carries the tube.
struct CarrierLimits {
    double speed_mPerS = 0.25;
    double acceleration_mPerS2 = 5.0;
    double turn_radPerS = 2.0;
    double turnAcceleration_radPerS2 = 40.0;
    void describeKeys(Keys& keys);
};

/// A soft tube that is watched from inside by a camera.
struct CameraWorld {
    TubeCamera camera;
    CameraSkin skin;
    std::vector<Finger> fingers;
    std::optional<Probing> probing; ///< a stick that comes besides the fingers
    Reaction reaction;
    CarrierLimits limits;
    void describeKeys(Keys& keys);
};

} // namespace teleta::scene
