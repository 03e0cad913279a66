// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/gel_world.h"

#include <QCoreApplication>
#include <QString>

namespace teleta::scene {

namespace {

struct GelWorldText {
    Q_DECLARE_TR_FUNCTIONS(SceneReader)
};

} // namespace

void GelSensor::describeKeys(Keys& keys) {
    keys.whole("width_px", width_px, {32, kLargestGelSide_px}, "Width of the picture", Need::optional);
    keys.whole("height_px", height_px, {32, kLargestGelSide_px}, "Height of the picture", Need::optional);
    keys.number("pixel_m", pixel_m, kPositive, "Size of a pixel on the gel's surface", Need::optional);
    keys.whole("rows", rows, {2, 200}, "Rows of markers", Need::optional);
    keys.whole("columns", columns, {2, 200}, "Markers in a row", Need::optional);
    keys.number("pitch_m", pitch_m, kPositive, "Distance between neighbouring markers", Need::optional);
    keys.number("marker_diameter_m", markerDiameter_m, kPositive, "Diameter of a marker", Need::optional);
    keys.flag("bright", bright, "The markers are brighter than the gel");
    keys.number("blur_px", blur_px, NumberRange::between(0.0, 20.0),
                "Blur of the lens, as a standard deviation", Need::optional);
    keys.number("noise", noise, NumberRange::between(0.0, 100.0),
                "Noise of a pixel in grey levels, as a standard deviation", Need::optional);
    keys.number("unevenness", unevenness, kShare,
                "Share by which the light falls to one corner and rises to the opposite one", Need::optional);
    keys.number("print_error_m", printError_m, kNotNegative,
                "Error of a marker's place, as a standard deviation", Need::optional);
    if (markerDiameter_m >= pitch_m)
        keys.refuse("marker_diameter_m", GelWorldText::tr("the markers touch each other").toStdString(),
                    GelWorldText::tr("less than the pitch of %1 m").arg(pitch_m).toStdString());
    const double across_m = (columns - 1) * pitch_m + markerDiameter_m;
    const double down_m = (rows - 1) * pitch_m + markerDiameter_m;
    if (across_m >= width_px * pixel_m || down_m >= height_px * pixel_m)
        keys.refuse("pitch_m", GelWorldText::tr("the markers do not fit into the picture").toStdString(),
                    GelWorldText::tr("a grid smaller than %1 m x %2 m")
                        .arg(width_px * pixel_m)
                        .arg(height_px * pixel_m)
                        .toStdString());
}

void GelBall::describeKeys(Keys& keys) {
    keys.text("name", name, "Name in tables and files");
    keys.number("x_m", x_m, kAny, "Where it meets the gel, from the left edge of the picture");
    keys.number("y_m", y_m, kAny, "The same from the upper edge");
    keys.number("radius_m", radius_m, kPositive, "Radius of the ball");
    keys.number("friction", friction, kPositive, "Coefficient of friction", Need::optional);
    keys.number("spread_per_depth", spreadPerDepth, kNotNegative,
                "How far the skin at the rim of the contact is pressed outwards, as a share of the depth",
                Need::optional);
    keys.tables("keyframes", keyframes, 1, "Where the ball is at given times; it moves smoothly in between",
                [this](Keys& table, std::vector<GelKeyframe>& frames, std::size_t i) {
                    describeTime(table, frames, i);
                    GelKeyframe& frame = frames[i];
                    table.number("depth_m", frame.depth_m, kAny,
                                 "Depth of its tip under the free gel, less than its radius; negative: away "
                                 "from it");
                    table.number("drag_x_m", frame.dragX_m, kAny,
                                 "How far it has been dragged along x since it met the gel", Need::optional);
                    table.number("drag_y_m", frame.dragY_m, kAny, "The same along y", Need::optional);
                    table.number("turn_rad", frame.turn_rad, kAny,
                                 "How far it has turned about the normal, from x to y", Need::optional);
                    if (frame.depth_m >= radius_m)
                        table.refuse("depth_m",
                                     GelWorldText::tr("this is deeper than the ball is round").toStdString(),
                                     GelWorldText::tr("less than %1 m").arg(radius_m).toStdString());
                });
}

void GelBumpReaction::describeKeys(Keys& keys) {
    keys.number("spread_m_per_s", spread_mPerS, kPositive, "A contact that spreads the skin faster is a bump",
                Need::optional);
    keys.number("spread_m", spread_m, kPositive, "A contact that has spread it further is a bump, too",
                Need::optional);
    keys.number("retreat_m", retreat_m, kPositive, "How far the arm draws back", Need::optional);
}

void GelWorld::describeKeys(Keys& keys) {
    keys.table("gel", sensor, "The gel, its markers and its camera");
    keys.tables("ball", balls, 1, "Rigid balls that are pressed onto the gel",
                [](Keys& table, std::vector<GelBall>& all, std::size_t i) { all[i].describeKeys(table); });
    keys.table("reaction", "What the arm that carries the gel does when it is touched", Need::optional,
               [this](Keys& table) {
                   table.variant("kind", reaction,
                                 {{"none", "It stays where it is"},
                                  {"bump", "It draws back from a bump"},
                                  {"follow", "It moves along with what touches it, in the plane of the gel"}},
                                 "Kind of reaction");
               });
    keys.table("limits", limits, "Limits of the arm that carries the gel", Need::optional);
}

} // namespace teleta::scene
