// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/camera_world.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <cmath>

namespace teleta::scene {

namespace {

struct CameraWorldText {
    Q_DECLARE_TR_FUNCTIONS(SceneReader)
};

void describeDepth(Keys& keys, double& depth_m, const NumberRange& range, const CameraSkin& skin,
                   std::string_view about) {
    keys.number("depth_m", depth_m, range, about);
    const double deepest_m = 0.5 * skin.radius_m;
    if (depth_m >= deepest_m)
        keys.refuse("depth_m", CameraWorldText::tr("this is deeper than the skin can yield").toStdString(),
                    CameraWorldText::tr("less than %1 m").arg(deepest_m).toStdString());
}

} // namespace

void CameraSkin::describeKeys(Keys& keys) {
    keys.number("radius_m", radius_m, kPositive, "Radius of the tube", Need::optional);
    keys.number("begin_m", begin_m, kAny, "Where the skin begins, along the axis", Need::optional);
    keys.number("length_m", length_m, kPositive, "Length of the skin", Need::optional);
    keys.number("dot_pitch_m", dotPitch_m, kPositive, "Distance between neighbouring dots", Need::optional);
    keys.number("dot_diameter_m", dotDiameter_m, kPositive, "Diameter of a dot", Need::optional);
    keys.number("reach_m", reach_m, kPositive, "How far the skin yields beside a contact", Need::optional);
    keys.number("drag_per_depth", dragPerDepth, kNotNegative,
                "How far a sliding finger drags the skin along, as a share of its depth", Need::optional);
    if (dotDiameter_m >= dotPitch_m)
        keys.refuse("dot_diameter_m", CameraWorldText::tr("the dots touch each other").toStdString(),
                    CameraWorldText::tr("less than the pitch of %1 m").arg(dotPitch_m).toStdString());
    const double least_m = length_m / kMostDotRings;
    if (dotPitch_m >= radius_m || dotPitch_m <= least_m)
        keys.refuse("dot_pitch_m",
                    CameraWorldText::tr("there would be too few or too many dots").toStdString(),
                    CameraWorldText::tr("more than %1 m and less than the radius of %2 m")
                        .arg(least_m)
                        .arg(radius_m)
                        .toStdString());
}

void TubeCamera::describeKeys(Keys& keys, const CameraSkin& skin) {
    keys.whole("width_px", width_px, {1, kLargestImageSide_px}, "Width of the image", Need::optional);
    keys.whole("height_px", height_px, {1, kLargestImageSide_px}, "Height of the image", Need::optional);
    keys.number("focal_length_px", focalLength_px, kPositive, "Focal length in the middle of the image",
                Need::optional);
    keys.number("behind_m", behind_m, kPositive,
                "How far the lens lies behind the origin of the sensor's frame", Need::optional);
    keys.number("offset_x_m", offsetX_m, kAny, "Distance of the lens from the axis, along x", Need::optional);
    keys.number("offset_y_m", offsetY_m, kAny, "The same along y", Need::optional);
    const double farthest_m = 0.5 * skin.radius_m;
    if (std::hypot(offsetX_m, offsetY_m) >= farthest_m)
        keys.refuse(std::abs(offsetX_m) > std::abs(offsetY_m) ? "offset_x_m" : "offset_y_m",
                    CameraWorldText::tr("the camera is too far from the tube's axis").toStdString(),
                    CameraWorldText::tr("less than %1 m").arg(farthest_m).toStdString());
}

void Finger::describeKeys(Keys& keys, const CameraSkin& skin) {
    keys.text("name", name, "Name in tables and files");
    keys.number("radius_m", radius_m, kPositive, "Radius of the ball that the fingertip is");
    keys.tables("keyframes", keyframes, 1, "Where the finger is at given times; it moves smoothly in between",
                [&skin](Keys& table, std::vector<FingerKeyframe>& frames, std::size_t i) {
                    describeTime(table, frames, i);
                    table.number("angle_rad", frames[i].angle_rad, kAny, "Angle about the axis of the tube");
                    table.number("z_m", frames[i].z_m, kAny, "Place along the axis");
                    describeDepth(table, frames[i].depth_m, kAny, skin,
                                  "Depth of its tip under the free skin, less than half the tube's radius; "
                                  "negative: away from it");
                });
}

void Probing::describeKeys(Keys& keys, const CameraSkin& skin) {
    keys.whole("holes_around", around, {1, kMostHoles}, "Holes in a ring of the shell", Need::optional);
    keys.whole("holes_along", along, {1, kMostHoles / std::max(1, around), "10000 / holes_around"},
               "Rings of holes", Need::optional);
    keys.number("first_z_m", first_z_m, kAny, "Place of the first ring, along the axis");
    keys.number("last_z_m", last_z_m, kAny, "Place of the last ring");
    keys.number("stick_radius_m", stickRadius_m, kPositive, "Radius of the stick", Need::optional);
    describeDepth(keys, depth_m, kPositive, skin, "Depth of the presses, less than half the tube's radius");
    keys.number("hole_s", hole_s, kPositive, "Time from hole to hole", Need::optional);
    keys.number("play_m", play_m, kNotNegative, "Play of the stick in its hole, as a standard deviation",
                Need::optional);
    keys.number("wrong_share", wrongShare, kShare, "Share of the holes that are mistaken for another one",
                Need::optional);
}

void BumpReaction::describeKeys(Keys& keys) {
    keys.number("speed_m_per_s", speed_mPerS, kPositive, "A contact that deepens faster is a bump",
                Need::optional);
    keys.number("depth_m", depth_m, kPositive, "A deeper contact is a bump, too", Need::optional);
    keys.number("retreat_m", retreat_m, kPositive, "How far the arm draws back", Need::optional);
}

void CarrierLimits::describeKeys(Keys& keys) {
    keys.number("speed_m_per_s", speed_mPerS, kPositive, "Highest speed", Need::optional);
    keys.number("acceleration_m_per_s2", acceleration_mPerS2, kPositive, "Highest acceleration",
                Need::optional);
    keys.number("turn_rad_per_s", turn_radPerS, kPositive, "Highest speed of turning", Need::optional);
    keys.number("turn_acceleration_rad_per_s2", turnAcceleration_radPerS2, kPositive,
                "Highest acceleration of turning", Need::optional);
}

void CameraWorld::describeKeys(Keys& keys) {
    keys.table("skin", skin, "The soft tube and the dots that are printed on it");
    keys.table("camera", "The camera inside the tube, which looks along its axis", Need::required,
               [this](Keys& table) { camera.describeKeys(table, skin); });
    keys.tables(
        "finger", fingers, 0, "Balls that touch the skin",
        [this](Keys& table, std::vector<Finger>& all, std::size_t i) { all[i].describeKeys(table, skin); });
    keys.table("probing", probing, "A person who probes the skin with a stick, hole by hole",
               [this](Keys& table, Probing& known) { known.describeKeys(table, skin); });
    keys.table("reaction", "What the arm that carries the tube does when it is touched", Need::optional,
               [this](Keys& table) {
                   table.variant("kind", reaction,
                                 {{"none", "It stays where it is"},
                                  {"bump", "It stops and draws back from a bump"},
                                  {"follow", "It moves along with what touches it"}},
                                 "Kind of reaction");
               });
    keys.table("limits", limits, "Limits of the arm that carries the tube", Need::optional);
}

} // namespace teleta::scene
