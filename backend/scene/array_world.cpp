// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/array_world.h"

#include <QCoreApplication>

#include <cmath>
#include <numbers>

namespace teleta::scene {

namespace {

struct ArrayText {
    Q_DECLARE_TR_FUNCTIONS(SceneReader)
};

constexpr std::string_view kLength = "Length, along x at angle 0";

void describeKeyframe(Keys& keys, std::vector<Keyframe>& frames, std::size_t i) {
    describeTime(keys, frames, i);
    keys.number("x_m", frames[i].x_m, kAny, "Place along the columns", Need::optional);
    keys.number("y_m", frames[i].y_m, kAny, "Place along the rows", Need::optional);
    keys.number("depth_m", frames[i].depth_m, kAny,
                "Depth of the lowest point under the free surface; negative: above it");
    keys.number("angle_rad", frames[i].angle_rad, kAny, "Turn about the normal", Need::optional);
}

} // namespace

void describeLayout(Keys& keys, core::ArrayLayout& layout) {
    const core::WholeRange side{1, core::ArrayLayout::kMaximumSide};
    keys.whole("rows", layout.rows, side, "Rows of taxels");
    keys.whole("columns", layout.columns, side, "Taxels in a row");
    double pitch_m = layout.pitchX_m;
    keys.number("pitch_m", pitch_m, kPositive, "Distance between neighbouring taxels");
    layout.setPitch_m(pitch_m);
}

void describeReadings(Keys& keys, double& fullScale_N, double& firingThreshold_N) {
    keys.number("full_scale_N", fullScale_N, kPositive,
                "Load at which a taxel saturates, if the scene lists that effect");
    keys.number("firing_threshold_N", firingThreshold_N, kNotNegative, "A taxel with less load reads 0",
                Need::optional);
}

void refuseUnordered(Keys& keys, double before_s) {
    keys.refuse("time_s", ArrayText::tr("the times of the keyframes do not increase").toStdString(),
                ArrayText::tr("a time after %1 s").arg(before_s).toStdString());
}

void ArraySensor::describeKeys(Keys& keys) {
    describeLayout(keys, layout);
    keys.number("stiffness_N_per_m", stiffness_NPerM, kPositive, "Stiffness of one taxel");
    describeReadings(keys, fullScale_N, firingThreshold_N);
}

void Cylinder::describeKeys(Keys& keys) {
    keys.number("radius_m", radius_m, kPositive, "Radius");
    keys.number("length_m", length_m, kPositive, kLength);
}

void BoxEdge::describeKeys(Keys& keys) {
    keys.number("length_m", length_m, kPositive, kLength);
}

void FlatPunch::describeKeys(Keys& keys) {
    keys.number("length_m", length_m, kPositive, kLength);
    keys.number("width_m", width_m, kPositive, "Width");
}

void Indenter::describeKeys(Keys& keys) {
    keys.text("name", name, "Name in tables and files");
    keys.variant("shape", shape,
                 {{"sphere", "A rigid ball"},
                  {"cylinder", "A rigid round bar that lies on the surface"},
                  {"box_edge", "The edge of a rigid box, its faces at 45 degrees to the surface"},
                  {"flat_punch", "A rigid rectangular face, parallel to the surface"}},
                 "Shape of the body");
    keys.flag("loop", loop, "The motion repeats; it must end where it starts");
    keys.tables("keyframes", keyframes, 1, "Where the body is at given times; it moves smoothly in between",
                describeKeyframe);
    if (!loop || keyframes.empty())
        return;
    const Keyframe& first = keyframes.front();
    const Keyframe& last = keyframes.back();
    // All shapes look the same after half a turn.
    const double turn_rad = std::remainder(last.angle_rad - first.angle_rad, std::numbers::pi);
    if (first.x_m != last.x_m || first.y_m != last.y_m || first.depth_m != last.depth_m ||
        std::abs(turn_rad) > 1e-3)
        keys.refuse("loop", ArrayText::tr("the motion does not end where it starts").toStdString(),
                    ArrayText::tr("a last keyframe like the first one").toStdString());
}

void ArrayWorld::describeKeys(Keys& keys) {
    keys.table("sensor", "The tactile array", Need::required, [this](Keys& table) {
        table.word("kind", "array", "What the sensor is");
        sensor.describeKeys(table);
    });
    keys.tables("indenter", indenters, 1, "Rigid bodies that press on the array");
}

} // namespace teleta::scene
