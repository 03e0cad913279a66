// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/camera_world_reader.h"

#include <QCoreApplication>
#include <QString>

#include <array>
#include <cmath>
#include <string_view>

namespace teleta::scene {

namespace {

struct CameraWorldReader {
    Q_DECLARE_TR_FUNCTIONS(SceneReader)
};

std::optional<core::TomlTable> tableIfThere(core::TomlTable& root, std::string_view key) {
    if (!root.has(key))
        return std::nullopt;
    return root.table(key);
}

void readSize(core::TomlTable& table, std::string_view key, double& value) {
    value = table.number(key, core::NumberRange::positive(), value);
}

TubeCamera readCamera(core::TomlTable& table, const CameraSkin& skin) {
    TubeCamera camera;
    camera.width_px = static_cast<int>(table.integer("width_px", 1, kLargestImageSide_px, camera.width_px));
    camera.height_px =
        static_cast<int>(table.integer("height_px", 1, kLargestImageSide_px, camera.height_px));
    readSize(table, "focal_length_px", camera.focalLength_px);
    readSize(table, "behind_m", camera.behind_m);
    camera.offsetX_m = table.number("offset_x_m", core::NumberRange::any(), 0.0);
    camera.offsetY_m = table.number("offset_y_m", core::NumberRange::any(), 0.0);
    const double farthest_m = 0.5 * skin.radius_m;
    if (std::hypot(camera.offsetX_m, camera.offsetY_m) >= farthest_m)
        table.fail(std::abs(camera.offsetX_m) > std::abs(camera.offsetY_m) ? "offset_x_m" : "offset_y_m",
                   CameraWorldReader::tr("the camera is too far from the tube's axis").toStdString(),
                   CameraWorldReader::tr("less than %1 m").arg(farthest_m).toStdString());
    table.finish();
    return camera;
}

CameraSkin readCameraSkin(core::TomlTable& table) {
    CameraSkin skin;
    readSize(table, "radius_m", skin.radius_m);
    skin.begin_m = table.number("begin_m", core::NumberRange::any(), skin.begin_m);
    readSize(table, "length_m", skin.length_m);
    readSize(table, "dot_pitch_m", skin.dotPitch_m);
    readSize(table, "dot_diameter_m", skin.dotDiameter_m);
    readSize(table, "reach_m", skin.reach_m);
    skin.dragPerDepth = table.number("drag_per_depth", core::NumberRange::notNegative(), 0.0);
    if (skin.dotDiameter_m >= skin.dotPitch_m)
        table.fail("dot_diameter_m", CameraWorldReader::tr("the dots touch each other").toStdString(),
                   CameraWorldReader::tr("less than the pitch of %1 m").arg(skin.dotPitch_m).toStdString());
    const double least_m = skin.length_m / kMostDotRings;
    if (skin.dotPitch_m >= skin.radius_m || skin.dotPitch_m <= least_m)
        table.fail("dot_pitch_m",
                   CameraWorldReader::tr("there would be too few or too many dots").toStdString(),
                   CameraWorldReader::tr("more than %1 m and less than the radius of %2 m")
                       .arg(least_m)
                       .arg(skin.radius_m)
                       .toStdString());
    table.finish();
    return skin;
}

double readPressDepth(core::TomlTable& table, const core::NumberRange& range, const CameraSkin& skin) {
    const double depth_m = table.number("depth_m", range);
    const double deepest_m = 0.5 * skin.radius_m;
    if (depth_m >= deepest_m)
        table.fail("depth_m", CameraWorldReader::tr("this is deeper than the skin gives way").toStdString(),
                   CameraWorldReader::tr("less than %1 m").arg(deepest_m).toStdString());
    return depth_m;
}

Finger readFinger(core::TomlTable& table, const CameraSkin& skin) {
    Finger finger;
    finger.name = table.text("name");
    finger.radius_m = table.number("radius_m", core::NumberRange::positive());
    for (core::TomlTable& entry : table.tables("keyframes", 1)) {
        FingerKeyframe frame;
        frame.time_s = entry.number("time_s", core::NumberRange::notNegative());
        frame.angle_rad = entry.number("angle_rad", core::NumberRange::any());
        frame.z_m = entry.number("z_m", core::NumberRange::any());
        frame.depth_m = readPressDepth(entry, core::NumberRange::any(), skin);
        entry.finish();
        if (!finger.keyframes.empty() && frame.time_s <= finger.keyframes.back().time_s)
            entry.fail(
                "time_s", CameraWorldReader::tr("the keyframes are not in the order of time").toStdString(),
                CameraWorldReader::tr("a time after %1 s").arg(finger.keyframes.back().time_s).toStdString());
        finger.keyframes.push_back(frame);
    }
    table.finish();
    return finger;
}

Probing readProbing(core::TomlTable& table, const CameraSkin& skin) {
    Probing probing;
    probing.around = static_cast<int>(table.integer("holes_around", 1, kMostHoles, probing.around));
    probing.along =
        static_cast<int>(table.integer("holes_along", 1, kMostHoles / probing.around, probing.along));
    probing.first_z_m = table.number("first_z_m", core::NumberRange::any());
    probing.last_z_m = table.number("last_z_m", core::NumberRange::any());
    readSize(table, "stick_radius_m", probing.stickRadius_m);
    probing.depth_m = readPressDepth(table, core::NumberRange::positive(), skin);
    readSize(table, "hole_s", probing.hole_s);
    probing.play_m = table.number("play_m", core::NumberRange::notNegative(), 0.0);
    probing.wrongShare = table.number("wrong_share", core::NumberRange::between(0.0, 1.0), 0.0);
    table.finish();
    return probing;
}

Reaction readReaction(core::TomlTable& table) {
    Reaction reaction;
    switch (table.choice("kind", {"none", "bump", "follow"})) {
    case 1: {
        BumpReaction bump;
        readSize(table, "speed_m_per_s", bump.speed_mPerS);
        readSize(table, "depth_m", bump.depth_m);
        readSize(table, "retreat_m", bump.retreat_m);
        reaction = bump;
        break;
    }
    case 2: {
        FollowReaction follow;
        readSize(table, "gain_per_s", follow.gain_perS);
        reaction = follow;
        break;
    }
    default:
        break;
    }
    table.finish();
    return reaction;
}

CarrierLimits readLimits(core::TomlTable& table) {
    CarrierLimits limits;
    readSize(table, "speed_m_per_s", limits.speed_mPerS);
    readSize(table, "acceleration_m_per_s2", limits.acceleration_mPerS2);
    readSize(table, "turn_rad_per_s", limits.turn_radPerS);
    readSize(table, "turn_acceleration_rad_per_s2", limits.turnAcceleration_radPerS2);
    table.finish();
    return limits;
}

} // namespace

CameraTables::CameraTables(core::TomlTable& root)
    : camera(root.table("camera"))
    , skin(root.table("skin"))
    , fingers(root.tables("finger", 0))
    , probing(tableIfThere(root, "probing"))
    , reaction(tableIfThere(root, "reaction"))
    , limits(tableIfThere(root, "limits")) {
}

CameraWorld readCameraWorld(CameraTables& tables) {
    CameraWorld world;
    world.skin = readCameraSkin(tables.skin);
    world.camera = readCamera(tables.camera, world.skin);
    for (core::TomlTable& finger : tables.fingers)
        world.fingers.push_back(readFinger(finger, world.skin));
    if (tables.probing)
        world.probing = readProbing(*tables.probing, world.skin);
    if (tables.reaction)
        world.reaction = readReaction(*tables.reaction);
    if (tables.limits)
        world.limits = readLimits(*tables.limits);
    return world;
}

Effect readCameraEffect(core::TomlTable& table, std::set<std::size_t>& listed) {
    Effect effect;
    const std::size_t kind = table.choice("name", {"lens_distortion", "uneven_light", "sensor_noise",
                                                   "motion_blur", "marker_print_error", "vignetting"});
    if (!listed.insert(kind).second)
        table.fail("name", CameraWorldReader::tr("the effect is listed twice").toStdString(),
                   CameraWorldReader::tr("each effect at most once").toStdString());
    effect.why = table.text("why");
    switch (kind) {
    case 1:
        effect.parameters =
            UnevenLightSpec{.lamps = static_cast<int>(table.integer("lamps", 1, 100)),
                            .ripple = table.number("ripple", core::NumberRange::between(0.0, 1.0)),
                            .fallPerMetre = table.number("fall_per_m", core::NumberRange::notNegative())};
        break;
    case 2:
        effect.parameters = SensorNoiseSpec{.read = table.number("read", core::NumberRange::notNegative()),
                                            .shot = table.number("shot", core::NumberRange::notNegative())};
        break;
    case 3:
        effect.parameters = MotionBlurSpec{.exposure_s = table.number("exposure_s", core::NumberRange::positive()),
                                           .samples = static_cast<int>(table.integer("samples", 2, 32, 4))};
        break;
    case 4:
        effect.parameters =
            MarkerPrintErrorSpec{.sd_m = table.number("sd_m", core::NumberRange::notNegative()),
                                 .sizeShare = table.number("size_share", core::NumberRange::notNegative())};
        break;
    case 5:
        effect.parameters = VignettingSpec{.share = table.number("share", core::NumberRange::between(0.0, 1.0))};
        break;
    default: {
        LensDistortionSpec spec;
        constexpr std::array<std::string_view, 6> kRadial{"k1", "k2", "k3", "k4", "k5", "k6"};
        for (std::size_t i = 0; i < kRadial.size(); ++i)
            spec.radial[i] = table.number(kRadial[i], core::NumberRange::any(), 0.0);
        spec.tangential[0] = table.number("p1", core::NumberRange::any(), 0.0);
        spec.tangential[1] = table.number("p2", core::NumberRange::any(), 0.0);
        effect.parameters = spec;
    }
    }
    table.finish();
    return effect;
}

} // namespace teleta::scene
