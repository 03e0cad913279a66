// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/scene/shared_keys.h"

#include <string>
#include <variant>
#include <vector>

namespace teleta::scene {

/// The motors follow the reference like a critically damped filter, whatever the load: the controller adds
/// the measured torque to the motor's (torque feedback).
struct PositionControl {
    double bandwidth_radPerS = 60.0;
    void describeKeys(Keys& keys) {
        keys.number("bandwidth_rad_per_s", bandwidth_radPerS, kPositive, "How fast the motors follow");
    }
};

/// The motors yield to the joint torque like a mass on a damped spring, see arm::JointAdmittance.
struct AdmittanceControl {
    double inertia_kgm2 = 0.1;
    double damping_NmsPerRad = 2.0;
    double stiffness_NmPerRad = 10.0;
    void describeKeys(Keys& keys);
};

using JointControl = std::variant<PositionControl, AdmittanceControl>;

/// The arm of arm::Arm4Kinematics: two links, uniform round bars, behind joints that twist.
struct ArmBody {
    static constexpr std::size_t kJoints = 4;

    double upperArmLength_m = 0.30;
    double forearmLength_m = 0.27;
    double halfThickness_m = 0.030;
    double upperArmMass_kg = 1.0;
    double forearmMass_kg = 0.5;
    double jointInertia_kgm2 = 0.002; ///< on the link's side of each joint
    double jointDampingTime_s = 0.03; ///< damping of the twist over its stiffness; takes the ringing away
    /// Between motor and link. The elbow's follows from the paper's k_ri and P_C: k_ri P_C^2.
    core::JointVector jointStiffness_NmPerRad{2000.0, 2000.0, 2000.0, 3468.6 * 0.175 * 0.175};
    double elbowStiffnessSe_NmPerRad = 0.0; ///< that the estimates are told; the arm has no such error
    core::JointVector start_rad = core::JointVector::zeros(kJoints);
    core::JointVector lowest_rad{-2.0, -1.6, -2.0, -0.2};
    core::JointVector highest_rad{2.0, 1.6, 2.0, 2.6};
    core::JointVector fastest_radPerS{1.0, 1.0, 1.0, 1.0};
    double highestTorque_Nm = 10.0; ///< at which the controller lets no joint go on against its load
    void describeKeys(Keys& keys);
};

/// The tactile skin around the forearm. A sheet that is longer than the forearm's circumference overlaps;
/// what presses on the overlap is felt by both layers.
struct ArmSkin {
    core::ArrayLayout layout{20, 24, 0.0094};
    double rate_Hz = 200.0; ///< frames are read at the joint sample that follows
    double centreDistance_m = 0.14;
    double centreSide_rad = 0.0;
    double centreSe_m = 0.0;        ///< core::SkinPlacement::centreSe_m
    double fullScale_N = 2.0;       ///< load at which a taxel saturates, when the scene lists that effect
    double firingThreshold_N = 0.0; ///< a taxel whose load is below this reads 0
    void describeKeys(Keys& keys);
};

/// A round object.
struct RoundOutline {
    double radius_m = 0.0;
    void describeKeys(Keys& keys) { keys.number("radius_m", radius_m, kPositive, "Radius"); }
};

/// A box; its length is along x at angle 0.
struct RectangleOutline {
    double length_m = 0.0;
    double width_m = 0.0;
    void describeKeys(Keys& keys);
};

/// An equilateral triangle; one corner is on the x axis at angle 0.
struct TriangleOutline {
    double side_m = 0.0;
    void describeKeys(Keys& keys) { keys.number("side_m", side_m, kPositive, "Length of a side"); }
};

/// A wall without end; its surface faces x at angle 0.
struct WallOutline {
    void describeKeys(Keys&) {}
};

using Outline = std::variant<RoundOutline, RectangleOutline, TriangleOutline, WallOutline>;

/// Something upright that the forearm can touch along its rim, an outline in a plane z = z_m of the base. It
/// yields like a spring, normal to the surface.
struct ArmObject {
    std::string name;
    Outline outline;
    double x_m = 0.0; ///< centre of the outline, a point of the surface of a wall; in the base
    double y_m = 0.0;
    double z_m = 0.0;
    double angle_rad = 0.0; ///< about z
    double stiffness_NPerM = 0.0;
    void describeKeys(Keys& keys);
};

/// One object after the other is touched with the elbow, from below; only the object whose turn it is exists.
///   to the clearance -> slowly until the torque limit -> hold -> back
struct TouchProgram {
    double approach_radPerS = 0.003;
    double travel_radPerS = 0.12;
    double clearance_rad = 0.004; ///< before the first contact, where the slow approach begins
    double retract_rad = 0.1;     ///< before the first contact, where the next object takes its place
    double torqueLimit_Nm = 0.08;
    double hold_s = 0.2;
    void describeKeys(Keys& keys);
};

/// The forearm hangs down beside the first object and touches it from directions all around.
struct ContourProgram {
    int directions = 24;         ///< 3 .. 360, evenly spaced
    double startAngle_rad = 0.0; ///< of the first direction, about z
    double approach_mPerS = 0.001;
    double travel_mPerS = 0.015;
    double clearance_m = 0.001; ///< of the surface, where the slow approach begins
    double retract_m = 0.01;    ///< of the surface, on the way around
    double torqueLimit_Nm = 0.08;
    double hold_s = 0.1;
    void describeKeys(Keys& keys);
};

/// Somebody pushes the forearm: half a sine of force over the duration.
struct Push {
    double time_s = 0.0;
    double duration_s = 0.0;
    double distance_m = 0.0; ///< from the elbow along the forearm
    double forceX_N = 0.0;   ///< in the base
    double forceY_N = 0.0;
    double forceZ_N = 0.0;
    void describeKeys(Keys& keys);
};

/// Where the references are at a time; between two waypoints they move smoothly and rest at both.
struct Waypoint {
    double time_s = 0.0;
    core::JointVector reference_rad = core::JointVector::zeros(ArmBody::kJoints);
};

/// The arm follows waypoints while it is pushed.
struct YieldProgram {
    std::vector<Waypoint> waypoints{}; ///< times strictly increasing; empty: the arm stays
    std::vector<Push> pushes{};
    void describeKeys(Keys& keys);
};

/// Somebody feels his way around something that he sees roughly: touches towards a place, evenly spaced
/// around it.
struct Exploration {
    double x_m = 0.0; ///< the place, in the base
    double y_m = 0.0;
    double radius_m = 0.0;       ///< distance of the elbow from the place before and after each touch
    int touches = 0;             ///< 1 .. 360
    double startAngle_rad = 0.0; ///< of the first touch, about z
    void describeKeys(Keys& keys);
};

/// An operator at another place drives the arm by velocity, his forearm hanging down, from what comes back to
/// him: he goes to each place, feels his way around it and turns back when he has felt enough.
struct OperatorProgram {
    double travel_mPerS = 0.05; ///< of the elbow, between touches
    double approach_mPerS = 0.0035;
    double clearance_m = 0.015;  ///< before where he met the object last, from which he goes slowly
    double feltTorque_Nm = 0.15; ///< of any joint, above which he feels that he touches
    double reaction_s = 0.15;    ///< from feeling it until he stops
    double hold_s = 0.1;
    std::vector<Exploration> explorations; ///< at least one
    void describeKeys(Keys& keys);
};

using ArmProgram = std::variant<TouchProgram, ContourProgram, YieldProgram, OperatorProgram>;

/// How little is known of where the objects are: each seed has its own places.
struct UnknownPlaces {
    bool swap = false;     ///< any object may stand at any of their places
    double spread_m = 0.0; ///< each object is displaced by up to so much in x and in y, evenly
    double turn_rad = 0.0; ///< and turned by up to so much
    void describeKeys(Keys& keys);
};

/// A remote arm among objects.
struct ArmWorld {
    ArmBody body;
    JointControl control;
    ArmSkin skin;
    std::vector<ArmObject> objects;
    UnknownPlaces unknown;
    ArmProgram program;
    void describeKeys(Keys& keys);
};

} // namespace teleta::scene
