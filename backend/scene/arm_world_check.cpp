// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/arm_world_check.h"

#include "backend/core/data/range_check.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace teleta::scene {

namespace {

bool isFinite(const core::JointArray& values) {
    return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

bool isValid(const ArmBody& body) {
    for (std::size_t j = 0; j < core::kArmJoints; ++j) {
        if (!core::arePositive({body.jointStiffness_NmPerRad[j], body.fastest_radPerS[j]}) ||
            !core::areFinite({body.lowest_rad[j], body.highest_rad[j]}) ||
            !(body.start_rad[j] >= body.lowest_rad[j] && body.start_rad[j] <= body.highest_rad[j]))
            return false;
    }
    return core::arePositive({body.upperArmLength_m, body.forearmLength_m, body.halfThickness_m,
                        body.upperArmMass_kg, body.forearmMass_kg, body.jointInertia_kgm2,
                        body.highestTorque_Nm}) &&
           core::areNotNegative({body.jointDampingTime_s});
}

struct ControlIsValid {
    bool operator()(const PositionControl& control) const { return core::arePositive({control.bandwidth_radPerS}); }
    bool operator()(const AdmittanceControl& control) const {
        return core::areNotNegative({control.inertia_kgm2, control.damping_NmsPerRad}) &&
               core::arePositive({control.stiffness_NmPerRad});
    }
};

bool isValid(const ArmSkin& skin) {
    const auto side = [](int taxels) { return taxels >= 1 && taxels <= core::ArrayLayout::kMaximumSide; };
    return side(skin.layout.rows) && side(skin.layout.columns) &&
           core::arePositive({skin.layout.pitch_m, skin.rate_Hz, skin.fullScale_N}) &&
           core::areFinite({skin.centreDistance_m, skin.centreSide_rad}) &&
           core::areNotNegative({skin.firingThreshold_N});
}

struct OutlineIsValid {
    bool operator()(const RoundOutline& outline) const { return core::arePositive({outline.radius_m}); }
    bool operator()(const RectangleOutline& outline) const {
        return core::arePositive({outline.length_m, outline.width_m});
    }
    bool operator()(const TriangleOutline& outline) const { return core::arePositive({outline.side_m}); }
    bool operator()(const WallOutline&) const { return true; }
};

bool isValid(const ArmObject& object) {
    return std::visit(OutlineIsValid(), object.outline) &&
           core::areFinite({object.x_m, object.y_m, object.z_m, object.angle_rad}) &&
           core::arePositive({object.stiffness_NPerM});
}

struct ProgramIsValid {
    std::size_t objects;

    bool operator()(const TouchProgram& program) const {
        return objects > 0 &&
               core::arePositive({program.approach_radPerS, program.travel_radPerS, program.clearance_rad,
                            program.retract_rad, program.torqueLimit_Nm}) &&
               core::areNotNegative({program.hold_s});
    }
    bool operator()(const ContourProgram& program) const {
        return objects > 0 && program.directions >= 3 && program.directions <= 360 &&
               std::isfinite(program.startAngle_rad) &&
               core::arePositive({program.approach_mPerS, program.travel_mPerS, program.clearance_m,
                            program.retract_m, program.torqueLimit_Nm}) &&
               core::areNotNegative({program.hold_s});
    }
    bool operator()(const OperatorProgram& program) const {
        const auto isValidExploration = [](const Exploration& exploration) {
            return core::areFinite({exploration.x_m, exploration.y_m, exploration.startAngle_rad}) &&
                   core::arePositive({exploration.radius_m}) && exploration.touches >= 1 &&
                   exploration.touches <= 360;
        };
        return !program.explorations.empty() &&
               core::arePositive({program.travel_mPerS, program.approach_mPerS, program.clearance_m,
                            program.feltTorque_Nm}) &&
               core::areNotNegative({program.reaction_s, program.hold_s}) &&
               std::ranges::all_of(program.explorations, isValidExploration);
    }
    bool operator()(const YieldProgram& program) const {
        const bool waypoints =
            std::ranges::all_of(program.waypoints,
                                [](const Waypoint& waypoint) {
                                    return std::isfinite(waypoint.time_s) && isFinite(waypoint.reference_rad);
                                }) &&
            std::ranges::adjacent_find(program.waypoints, std::ranges::greater_equal{}, &Waypoint::time_s) ==
                program.waypoints.end();
        return waypoints && std::ranges::all_of(program.pushes, [](const Push& push) {
                   return core::arePositive({push.duration_s}) && core::areNotNegative({push.time_s, push.distance_m}) &&
                          core::areFinite({push.forceX_N, push.forceY_N, push.forceZ_N});
               });
    }
};

} // namespace

ArmWorldCheck checkArmWorld(const ArmWorld& world) {
    if (!isValid(world.body))
        return {ArmWorldFault::body};
    if (!std::visit(ControlIsValid(), world.control))
        return {ArmWorldFault::control};
    if (!isValid(world.skin))
        return {ArmWorldFault::skin};
    for (std::size_t i = 0; i < world.objects.size(); ++i) {
        if (!isValid(world.objects[i]))
            return {ArmWorldFault::object, i};
    }
    if (!core::areNotNegative({world.unknown.spread_m, world.unknown.turn_rad}))
        return {ArmWorldFault::unknown};
    if (!std::visit(ProgramIsValid{world.objects.size()}, world.program))
        return {ArmWorldFault::program};
    return {};
}

} // namespace teleta::scene
