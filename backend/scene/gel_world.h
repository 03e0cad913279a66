// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/camera_world.h"
#include "backend/scene/shared_keys.h"

#include <string>
#include <variant>
#include <vector>

namespace teleta::scene {

inline constexpr int kLargestGelSide_px = 2048;

/// A flat gel with a grid of printed markers, and the camera that looks straight at it. The origin of the
/// gel's surface is the centre of the upper left pixel; x points right, y down.
struct GelSensor {
    int width_px = 320;
    int height_px = 240;
    double pixel_m = 1e-4; ///< size of a pixel on the gel's surface
    int rows = 8;
    int columns = 10;
    double pitch_m = 0.0028;          ///< of the markers
    double markerDiameter_m = 0.0008; ///< of a marker
    bool bright = false;              ///< the markers; otherwise they are darker than the gel
    double blur_px = 0.6;             ///< of the lens, standard deviation
    double noise = 0.0;               ///< of a pixel, in grey levels, standard deviation
    double unevenness = 0.0;          ///< the light falls by this share to a corner, and rises to the other
    double printError_m = 0.0;        ///< of a marker's place, standard deviation
    void describeKeys(Keys& keys);
};

/// Where a ball is at a time.
struct GelKeyframe {
    double time_s = 0.0;
    double depth_m = 0.0; ///< of its tip under the free gel; negative: away from it
    double dragX_m = 0.0; ///< how far it has been dragged along the gel
    double dragY_m = 0.0;
    double turn_rad = 0.0; ///< about the normal, from x to y
};

/// A rigid ball that is pressed onto the gel, dragged and turned. Between keyframes it moves along monotone
/// cubics.
struct GelBall {
    std::string name;
    double x_m = 0.0; ///< where it meets the gel
    double y_m = 0.0;
    double radius_m = 0.004;
    double friction = 1.0;       ///< coefficient of Coulomb's friction
    double spreadPerDepth = 0.3; ///< how far the skin at the rim is pressed outwards
    std::vector<GelKeyframe> keyframes;
    void describeKeys(Keys& keys);
};

/// The arm that carries the gel draws back when it is bumped. A flat gel does not show how deep a contact is,
/// but how far it spreads the skin, see vision::spreadOf_m().
struct GelBumpReaction {
    double spread_mPerS = 0.002; ///< a contact that spreads the skin faster is a bump
    double spread_m = 0.00015;   ///< or one that has spread it further
    double retreat_m = 0.01;     ///< how far it draws back
    void describeKeys(Keys& keys);
};

/// What the arm that carries the gel does: it follows in the plane of the gel.
using GelReaction = std::variant<NoReaction, GelBumpReaction, FollowReaction>;

/// A flat gel with markers under balls, and the arm that carries it.
struct GelWorld {
    GelSensor sensor;
    std::vector<GelBall> balls;
    GelReaction reaction;
    CarrierLimits limits;
    void describeKeys(Keys& keys);
};

} // namespace teleta::scene
