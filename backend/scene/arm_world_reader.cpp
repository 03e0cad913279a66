// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/arm_world_reader.h"

#include <QCoreApplication>
#include <QString>

#include <array>
#include <string_view>

namespace teleta::scene {

namespace {

struct ArmWorldReader {
    Q_DECLARE_TR_FUNCTIONS(SceneReader)
};

constexpr std::array<std::string_view, core::kArmJoints> kJointNames{"roll", "pitch", "yaw", "elbow"};
constexpr double kHighestSkinRate_Hz = 10'000.0;

core::JointArray readJoints(core::TomlTable& table, std::string_view key, const core::NumberRange& range) {
    core::JointArray values{};
    core::TomlTable joints = table.table(key);
    for (std::size_t j = 0; j < core::kArmJoints; ++j)
        values[j] = joints.number(kJointNames[j], range);
    joints.finish();
    return values;
}

core::JointArray readJoints(core::TomlTable& table, std::string_view key, const core::NumberRange& range,
                            const core::JointArray& fallback) {
    return table.has(key) ? readJoints(table, key, range) : fallback;
}

JointControl readControl(core::TomlTable table) {
    JointControl control;
    if (table.choice("kind", {"position", "admittance"}) == 0) {
        control = PositionControl{.bandwidth_radPerS =
                                      table.number("bandwidth_rad_per_s", core::NumberRange::positive())};
    } else {
        control = AdmittanceControl{
            .inertia_kgm2 = table.number("inertia_kgm2", core::NumberRange::notNegative()),
            .damping_NmsPerRad = table.number("damping_Nms_per_rad", core::NumberRange::notNegative()),
            .stiffness_NmPerRad = table.number("stiffness_Nm_per_rad", core::NumberRange::positive())};
    }
    table.finish();
    return control;
}

ArmBody readBody(core::TomlTable& table) {
    ArmBody body;
    const auto size = [&table](std::string_view key, double& value) {
        value = table.number(key, core::NumberRange::positive(), value);
    };
    size("upper_arm_m", body.upperArmLength_m);
    size("forearm_m", body.forearmLength_m);
    size("half_thickness_m", body.halfThickness_m);
    size("upper_arm_kg", body.upperArmMass_kg);
    size("forearm_kg", body.forearmMass_kg);
    size("joint_inertia_kgm2", body.jointInertia_kgm2);
    size("highest_torque_Nm", body.highestTorque_Nm);
    body.jointDampingTime_s =
        table.number("joint_damping_time_s", core::NumberRange::notNegative(), body.jointDampingTime_s);
    body.jointStiffness_NmPerRad = readJoints(table, "joint_stiffness_Nm_per_rad", core::NumberRange::positive(),
                                              body.jointStiffness_NmPerRad);
    body.lowest_rad = readJoints(table, "lowest_rad", core::NumberRange::any(), body.lowest_rad);
    body.highest_rad = readJoints(table, "highest_rad", core::NumberRange::any(), body.highest_rad);
    body.fastest_radPerS =
        readJoints(table, "fastest_rad_per_s", core::NumberRange::positive(), body.fastest_radPerS);
    body.start_rad = readJoints(table, "start_rad", core::NumberRange::any());
    for (std::size_t j = 0; j < core::kArmJoints; ++j) {
        if (body.start_rad[j] < body.lowest_rad[j] || body.start_rad[j] > body.highest_rad[j])
            table.fail("start_rad",
                       ArmWorldReader::tr("the arm starts outside the range of its joints").toStdString(),
                       ArmWorldReader::tr("%1 from %2 to %3")
                           .arg(QString::fromUtf8(kJointNames[j].data()))
                           .arg(body.lowest_rad[j])
                           .arg(body.highest_rad[j])
                           .toStdString());
    }
    return body;
}

ArmSkin readSkin(core::TomlTable table) {
    ArmSkin skin;
    skin.layout.rows = static_cast<int>(table.integer("rows", 1, core::ArrayLayout::kMaximumSide));
    skin.layout.columns = static_cast<int>(table.integer("columns", 1, core::ArrayLayout::kMaximumSide));
    skin.layout.pitch_m = table.number("pitch_m", core::NumberRange::positive());
    skin.rate_Hz = table.number("rate_Hz", {.low = 0.0, .high = kHighestSkinRate_Hz, .lowOpen = true});
    skin.centreDistance_m = table.number("centre_distance_m", core::NumberRange::any());
    skin.centreSide_rad = table.number("centre_side_rad", core::NumberRange::any(), 0.0);
    skin.fullScale_N = table.number("full_scale_N", core::NumberRange::positive());
    skin.firingThreshold_N = table.number("firing_threshold_N", core::NumberRange::notNegative(), 0.0);
    table.finish();
    return skin;
}

Outline readOutline(core::TomlTable& table) {
    const auto size = [&table](std::string_view key) { return table.number(key, core::NumberRange::positive()); };
    switch (table.choice("shape", {"round", "rectangle", "triangle", "wall"})) {
    case 1:
        return RectangleOutline{.length_m = size("length_m"), .width_m = size("width_m")};
    case 2:
        return TriangleOutline{.side_m = size("side_m")};
    case 3:
        return WallOutline{};
    default:
        return RoundOutline{.radius_m = size("radius_m")};
    }
}

ArmObject readObject(core::TomlTable table) {
    ArmObject object;
    object.name = table.text("name");
    object.outline = readOutline(table);
    object.x_m = table.number("x_m", core::NumberRange::any());
    object.y_m = table.number("y_m", core::NumberRange::any());
    object.z_m = table.number("z_m", core::NumberRange::any());
    object.angle_rad = table.number("angle_rad", core::NumberRange::any(), 0.0);
    object.stiffness_NPerM = table.number("stiffness_N_per_m", core::NumberRange::positive());
    table.finish();
    return object;
}

TouchProgram readTouch(core::TomlTable& table) {
    TouchProgram program;
    program.approach_radPerS = table.number("approach_rad_per_s", core::NumberRange::positive());
    program.travel_radPerS = table.number("travel_rad_per_s", core::NumberRange::positive());
    program.clearance_rad = table.number("clearance_rad", core::NumberRange::positive());
    program.retract_rad = table.number("retract_rad", core::NumberRange::positive());
    program.torqueLimit_Nm = table.number("torque_limit_Nm", core::NumberRange::positive());
    program.hold_s = table.number("hold_s", core::NumberRange::notNegative());
    return program;
}

ContourProgram readContour(core::TomlTable& table) {
    ContourProgram program;
    program.directions = static_cast<int>(table.integer("directions", 3, 360));
    program.startAngle_rad = table.number("start_angle_rad", core::NumberRange::any(), 0.0);
    program.approach_mPerS = table.number("approach_m_per_s", core::NumberRange::positive());
    program.travel_mPerS = table.number("travel_m_per_s", core::NumberRange::positive());
    program.clearance_m = table.number("clearance_m", core::NumberRange::positive());
    program.retract_m = table.number("retract_m", core::NumberRange::positive());
    program.torqueLimit_Nm = table.number("torque_limit_Nm", core::NumberRange::positive());
    program.hold_s = table.number("hold_s", core::NumberRange::notNegative());
    return program;
}

YieldProgram readYield(core::TomlTable& table) {
    YieldProgram program;
    for (core::TomlTable& entry : table.tables("waypoints", 0)) {
        Waypoint waypoint;
        waypoint.time_s = entry.number("time_s", core::NumberRange::notNegative());
        waypoint.reference_rad = readJoints(entry, "reference_rad", core::NumberRange::any());
        entry.finish();
        if (!program.waypoints.empty() && waypoint.time_s <= program.waypoints.back().time_s)
            entry.fail(
                "time_s", ArmWorldReader::tr("the waypoints are not in the order of time").toStdString(),
                ArmWorldReader::tr("a time after %1 s").arg(program.waypoints.back().time_s).toStdString());
        program.waypoints.push_back(waypoint);
    }
    for (core::TomlTable& entry : table.tables("pushes", 0)) {
        Push push;
        push.time_s = entry.number("time_s", core::NumberRange::notNegative());
        push.duration_s = entry.number("duration_s", core::NumberRange::positive());
        push.distance_m = entry.number("distance_m", core::NumberRange::notNegative());
        push.forceX_N = entry.number("force_x_N", core::NumberRange::any(), 0.0);
        push.forceY_N = entry.number("force_y_N", core::NumberRange::any(), 0.0);
        push.forceZ_N = entry.number("force_z_N", core::NumberRange::any(), 0.0);
        entry.finish();
        program.pushes.push_back(push);
    }
    return program;
}

OperatorProgram readOperator(core::TomlTable& table) {
    OperatorProgram program;
    program.travel_mPerS = table.number("travel_m_per_s", core::NumberRange::positive());
    program.approach_mPerS = table.number("approach_m_per_s", core::NumberRange::positive());
    program.clearance_m = table.number("clearance_m", core::NumberRange::positive());
    program.feltTorque_Nm = table.number("felt_torque_Nm", core::NumberRange::positive());
    program.reaction_s = table.number("reaction_s", core::NumberRange::notNegative());
    program.hold_s = table.number("hold_s", core::NumberRange::notNegative());
    for (core::TomlTable& entry : table.tables("explore", 1)) {
        Exploration exploration;
        exploration.x_m = entry.number("x_m", core::NumberRange::any());
        exploration.y_m = entry.number("y_m", core::NumberRange::any());
        exploration.radius_m = entry.number("radius_m", core::NumberRange::positive());
        exploration.touches = static_cast<int>(entry.integer("touches", 1, 360));
        exploration.startAngle_rad = entry.number("start_angle_rad", core::NumberRange::any(), 0.0);
        entry.finish();
        program.explorations.push_back(exploration);
    }
    return program;
}

ArmProgram readProgram(core::TomlTable table, std::size_t objects) {
    ArmProgram program;
    switch (table.choice("kind", {"touch", "contour", "yield", "operator"})) {
    case 1:
        program = readContour(table);
        break;
    case 2:
        program = readYield(table);
        break;
    case 3:
        program = readOperator(table);
        break;
    default:
        program = readTouch(table);
    }
    const bool needsObject =
        std::holds_alternative<TouchProgram>(program) || std::holds_alternative<ContourProgram>(program);
    if (needsObject && objects == 0)
        table.fail("kind", ArmWorldReader::tr("the program has no object to touch").toStdString(),
                   ArmWorldReader::tr("at least one [[object]]").toStdString());
    table.finish();
    return program;
}

UnknownPlaces readUnknown(core::TomlTable table) {
    UnknownPlaces unknown;
    unknown.swap = table.boolean("swap", unknown.swap);
    unknown.spread_m = table.number("spread_m", core::NumberRange::notNegative(), unknown.spread_m);
    unknown.turn_rad = table.number("turn_rad", core::NumberRange::notNegative(), unknown.turn_rad);
    table.finish();
    return unknown;
}

} // namespace

ArmWorld readArmWorld(core::TomlTable arm, core::TomlTable skin, core::TomlTable program, const std::vector<core::TomlTable>& objects,
                      const std::optional<core::TomlTable>& unknown) {
    ArmWorld world;
    core::TomlTable control = arm.table("control");
    world.body = readBody(arm);
    arm.finish();
    world.control = readControl(control);
    world.skin = readSkin(skin);
    for (const core::TomlTable& object : objects)
        world.objects.push_back(readObject(object));
    if (unknown)
        world.unknown = readUnknown(*unknown);
    world.program = readProgram(program, objects.size());
    return world;
}

} // namespace teleta::scene
