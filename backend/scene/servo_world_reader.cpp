// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/servo_world_reader.h"

#include "backend/core/data/range_check.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string_view>

namespace teleta::scene {

namespace {

struct ServoWorldReader {
    Q_DECLARE_TR_FUNCTIONS(SceneReader)
};

constexpr double kSteepest_rad = 1.2;
// What the servo's controller accepts.
constexpr double kHighestForce_N = 30.0;
constexpr double kHighestSpeed_mPerS = 0.1;
constexpr double kFarthestPlace_m = 0.05;
constexpr double kShortestRoll_s = 1.0;
constexpr double kLeastStiffness_NPerM = 10.0;
constexpr double kMostStiffness_NPerM = 1e9;
constexpr double kHighestSensorRate_Hz = 10'000.0;
constexpr std::array<std::string_view, kServoJoints> kJointNames{"a1", "a2", "a3", "a4", "a5", "a6", "a7"};
/// The limits of the KUKA LWR 4+, in degrees.
constexpr std::array<double, kServoJoints> kFarthest_deg{170.0, 120.0, 170.0, 120.0, 170.0, 120.0, 170.0};

double farthest_rad(std::size_t joint) {
    return kFarthest_deg[joint] * std::numbers::pi / 180.0;
}

core::NumberRange steepness() {
    return core::NumberRange::between(-kSteepest_rad, kSteepest_rad);
}

ServoArm readArm(core::TomlTable table) {
    ServoArm arm;
    core::TomlTable start = table.table("start_rad");
    for (std::size_t j = 0; j < kServoJoints; ++j)
        arm.start_rad[j] =
            start.number(kJointNames[j], core::NumberRange::between(-farthest_rad(j), farthest_rad(j)));
    start.finish();
    (void)table.choice("kind", {"lwr"});
    arm.stiffness_NPerM = table.number("stiffness_N_per_m", core::NumberRange::positive());
    arm.rotationalStiffness_NmPerRad =
        table.number("rotational_stiffness_Nm_per_rad", core::NumberRange::positive());
    arm.dampingRatio = table.number("damping_ratio", core::NumberRange::notNegative());
    arm.mountLength_m = table.number("mount_length_m", core::NumberRange::notNegative(), arm.mountLength_m);
    table.finish();
    return arm;
}

ServoSensor readSensor(core::TomlTable table) {
    const auto side = [&table](std::string_view key) {
        return static_cast<int>(table.integer(key, 1, core::ArrayLayout::kMaximumSide));
    };
    const auto rate = [&table](std::string_view key, double& value) {
        value = table.number(key, {.low = 0.0, .high = kHighestSensorRate_Hz, .lowOpen = true}, value);
    };
    ServoSensor sensor;
    sensor.array.layout.rows = side("rows");
    sensor.array.layout.columns = side("columns");
    sensor.array.layout.pitch_m = table.number("pitch_m", core::NumberRange::positive());
    sensor.array.stiffness_NPerM = table.number("stiffness_N_per_m", core::NumberRange::positive());
    sensor.array.fullScale_N = table.number("full_scale_N", core::NumberRange::positive());
    sensor.array.firingThreshold_N = table.number("firing_threshold_N", core::NumberRange::notNegative(), 0.0);
    rate("acquisition_Hz", sensor.acquisition_Hz);
    rate("images_Hz", sensor.images_Hz);
    rate("servo_Hz", sensor.servo_Hz);
    table.finish();
    return sensor;
}

ServoShape readShape(core::TomlTable& table) {
    switch (table.choice("shape", {"bar", "box_edge", "sphere", "wall"})) {
    case 1:
        return EdgeShape{};
    case 2:
        return BallShape{.radius_m = table.number("radius_m", core::NumberRange::positive())};
    case 3:
        return WallShape{};
    default:
        break;
    }
    BarShape bar;
    bar.radius_m = table.number("radius_m", core::NumberRange::positive());
    bar.behind_m = table.number("behind_m", core::NumberRange::notNegative());
    bar.ahead_m = table.number("ahead_m", core::NumberRange::positive());
    bar.straight_m = table.number("straight_m", core::NumberRange::any(), 0.0);
    bar.bend_m = table.number("bend_m", core::NumberRange::notNegative(), 0.0);
    bar.bendBehind_m = table.number("bend_behind_m", core::NumberRange::notNegative(), 0.0);
    bar.fall_rad = table.number("fall_rad", steepness(), 0.0);
    bar.turn_rad = table.number("turn_rad", steepness(), 0.0);
    return bar;
}

TrayHinge readHinge(core::TomlTable table) {
    TrayHinge hinge;
    hinge.height_m = table.number("height_m", core::NumberRange::any());
    hinge.inertia_kgm2 = table.number("inertia_kgm2", core::NumberRange::positive());
    hinge.damping_NmsPerRad = table.number("damping_Nms_per_rad", core::NumberRange::notNegative(), 0.0);
    hinge.mass_kg = table.number("mass_kg", core::NumberRange::notNegative());
    for (core::TomlTable& entry : table.tables("motion", 1)) {
        MassKeyframe frame;
        frame.time_s = entry.number("time_s", core::NumberRange::notNegative());
        frame.x_m = entry.number("x_m", core::NumberRange::any());
        entry.finish();
        if (!hinge.motion.empty() && frame.time_s <= hinge.motion.back().time_s)
            entry.fail(
                "time_s", ServoWorldReader::tr("the keyframes are not in the order of time").toStdString(),
                ServoWorldReader::tr("a time after %1 s").arg(hinge.motion.back().time_s).toStdString());
        hinge.motion.push_back(frame);
    }
    table.finish();
    return hinge;
}

ServoObject readObject(core::TomlTable table) {
    ServoObject object;
    object.name = table.text("name");
    object.shape = readShape(table);
    object.stiffness_NPerM =
        table.number("stiffness_N_per_m", core::NumberRange::between(kLeastStiffness_NPerM, kMostStiffness_NPerM));
    object.x_m = table.number("x_m", core::NumberRange::any(), 0.0);
    object.y_m = table.number("y_m", core::NumberRange::any(), 0.0);
    object.gap_m = table.number("gap_m", core::NumberRange::any());
    object.yaw_rad = table.number("yaw_rad", core::NumberRange::any(), 0.0);
    object.pitch_rad = table.number("pitch_rad", steepness(), 0.0);
    if (table.has("spread")) {
        core::TomlTable spread = table.table("spread");
        object.spread.y_m = spread.number("y_m", core::NumberRange::notNegative(), 0.0);
        object.spread.gap_m = spread.number("gap_m", core::NumberRange::notNegative(), 0.0);
        object.spread.yaw_rad = spread.number("yaw_rad", core::NumberRange::notNegative(), 0.0);
        object.spread.pitch_rad = spread.number("pitch_rad", core::NumberRange::notNegative(), 0.0);
        spread.finish();
    }
    if (table.has("hinge"))
        object.hinge = readHinge(table.table("hinge"));
    table.finish();
    return object;
}

ServoTaskSettings readTask(core::TomlTable table) {
    ServoTaskSettings task;
    task.kind =
        static_cast<ServoTaskKind>(table.choice("kind", {"explore_edge", "point", "roll", "comanipulate"}));
    task.force_N = table.number("force_N", {.low = 0.0, .high = kHighestForce_N, .lowOpen = true});
    task.copY_m = table.number("cop_y_m", core::NumberRange::between(-kFarthestPlace_m, kFarthestPlace_m), 0.0);
    task.approach_mPerS =
        table.number("approach_m_per_s", {.low = 0.0, .high = kHighestSpeed_mPerS, .lowOpen = true});
    if (task.kind == ServoTaskKind::exploreEdge) {
        task.slide_mPerS = table.number("slide_m_per_s", core::NumberRange::between(0.0, kHighestSpeed_mPerS));
        task.moment = table.boolean("dzmp", true);
    }
    if (task.kind == ServoTaskKind::roll) {
        task.rollAngle_rad = table.number("roll_angle_rad", core::NumberRange::between(0.0, kSteepest_rad));
        task.rollPeriod_s = table.number("roll_period_s", core::NumberRange{.low = kShortestRoll_s});
    }
    table.finish();
    return task;
}

struct ShapeIsValid {
    bool operator()(const BarShape& bar) const {
        return core::arePositive({bar.radius_m, bar.ahead_m}) &&
               core::areNotNegative({bar.behind_m, bar.bend_m, bar.bendBehind_m}) &&
               std::isfinite(bar.straight_m) && std::abs(bar.fall_rad) <= kSteepest_rad &&
               std::abs(bar.turn_rad) <= kSteepest_rad;
    }
    bool operator()(const BallShape& ball) const { return core::arePositive({ball.radius_m}); }
    bool operator()(const EdgeShape&) const { return true; }
    bool operator()(const WallShape&) const { return true; }
};

bool isValid(const TrayHinge& hinge) {
    return core::arePositive({hinge.inertia_kgm2}) && core::areNotNegative({hinge.damping_NmsPerRad, hinge.mass_kg}) &&
           std::isfinite(hinge.height_m) && !hinge.motion.empty() &&
           std::ranges::all_of(hinge.motion,
                               [](const MassKeyframe& frame) {
                                   return core::areFinite({frame.time_s, frame.x_m});
                               }) &&
           std::ranges::adjacent_find(hinge.motion, std::ranges::greater_equal{}, &MassKeyframe::time_s) ==
               hinge.motion.end();
}

} // namespace

ServoWorld readServoWorld(core::TomlTable robot, core::TomlTable sensor, core::TomlTable object, core::TomlTable task) {
    ServoWorld world;
    world.arm = readArm(robot);
    world.sensor = readSensor(sensor);
    world.object = readObject(object);
    world.task = readTask(task);
    if (world.task.kind == ServoTaskKind::comanipulate && !world.object.hinge)
        task.fail("kind", ServoWorldReader::tr("there is no tray to keep level").toStdString(),
                  ServoWorldReader::tr("an [object.hinge]").toStdString());
    return world;
}

bool isValidServoWorld(const ServoWorld& world) {
    for (std::size_t j = 0; j < kServoJoints; ++j) {
        if (!(std::abs(world.arm.start_rad[j]) <= farthest_rad(j)))
            return false;
    }
    const ArraySensor& array = world.sensor.array;
    const auto side = [](int taxels) { return taxels >= 1 && taxels <= core::ArrayLayout::kMaximumSide; };
    const ServoObject& object = world.object;
    const ServoTaskSettings& task = world.task;
    return core::arePositive({world.arm.stiffness_NPerM, world.arm.rotationalStiffness_NmPerRad}) &&
           core::areNotNegative({world.arm.dampingRatio, world.arm.mountLength_m}) && side(array.layout.rows) &&
           side(array.layout.columns) &&
           core::arePositive({array.layout.pitch_m, array.stiffness_NPerM, array.fullScale_N,
                        world.sensor.acquisition_Hz, world.sensor.images_Hz, world.sensor.servo_Hz}) &&
           core::areNotNegative({array.firingThreshold_N}) && std::visit(ShapeIsValid(), object.shape) &&
           object.stiffness_NPerM >= kLeastStiffness_NPerM &&
           object.stiffness_NPerM <= kMostStiffness_NPerM &&
           core::areFinite({object.x_m, object.y_m, object.gap_m, object.yaw_rad, object.pitch_rad, task.copY_m}) &&
           core::areNotNegative({object.spread.y_m, object.spread.gap_m, object.spread.yaw_rad,
                           object.spread.pitch_rad, task.slide_mPerS, task.rollAngle_rad,
                           task.rollPeriod_s}) &&
           (!object.hinge || isValid(*object.hinge)) && core::arePositive({task.force_N, task.approach_mPerS}) &&
           task.force_N <= kHighestForce_N && task.approach_mPerS <= kHighestSpeed_mPerS &&
           task.slide_mPerS <= kHighestSpeed_mPerS && std::abs(task.copY_m) <= kFarthestPlace_m &&
           task.rollAngle_rad <= kSteepest_rad &&
           (task.kind != ServoTaskKind::roll || task.rollPeriod_s >= kShortestRoll_s) &&
           (task.kind != ServoTaskKind::comanipulate || object.hinge);
}

} // namespace teleta::scene
