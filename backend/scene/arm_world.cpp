// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/arm_world.h"

#include <QCoreApplication>
#include <QString>

#include <array>
#include <string_view>

namespace teleta::scene {

namespace {

struct ArmText {
    Q_DECLARE_TR_FUNCTIONS(SceneReader)
};

constexpr std::array<std::string_view, ArmBody::kJoints> kArmJointNames{"roll", "pitch", "yaw", "elbow"};
constexpr double kHighestSkinRate_Hz = 10'000.0;

void describeWaypoint(Keys& keys, std::vector<Waypoint>& waypoints, std::size_t i) {
    describeTime(keys, waypoints, i);
    keys.numbers("reference_rad", kArmJointNames, waypoints[i].reference_rad, kAny,
                 "Where the references of the joints are");
}

} // namespace

void AdmittanceControl::describeKeys(Keys& keys) {
    keys.number("inertia_kgm2", inertia_kgm2, kNotNegative, "Inertia that a push feels");
    keys.number("damping_Nms_per_rad", damping_NmsPerRad, kNotNegative, "Damping that a push feels");
    keys.number("stiffness_Nm_per_rad", stiffness_NmPerRad, kPositive, "Stiffness that a push feels");
}

void ArmBody::describeKeys(Keys& keys) {
    keys.number("upper_arm_m", upperArmLength_m, kPositive, "Length of the upper arm", Need::optional);
    keys.number("forearm_m", forearmLength_m, kPositive, "Length of the forearm", Need::optional);
    keys.number("half_thickness_m", halfThickness_m, kPositive, "Half the thickness of the links",
                Need::optional);
    keys.number("upper_arm_kg", upperArmMass_kg, kPositive, "Mass of the upper arm", Need::optional);
    keys.number("forearm_kg", forearmMass_kg, kPositive, "Mass of the forearm", Need::optional);
    keys.number("joint_inertia_kgm2", jointInertia_kgm2, kPositive,
                "Inertia at each joint, on the link's side", Need::optional);
    keys.number("highest_torque_Nm", highestTorque_Nm, kPositive,
                "Torque at which no joint goes on against its load", Need::optional);
    keys.number("joint_damping_time_s", jointDampingTime_s, kNotNegative,
                "Damping of a joint's twist over its stiffness", Need::optional);
    keys.numbers("joint_stiffness_Nm_per_rad", kArmJointNames, jointStiffness_NmPerRad, kPositive,
                 "Stiffness between motor and link", Need::optional);
    keys.number("elbow_stiffness_se_Nm_per_rad", elbowStiffnessSe_NmPerRad, kNotNegative,
                "Standard error of the elbow's stiffness, told to the estimates of stiffness",
                Need::optional);
    keys.numbers("lowest_rad", kArmJointNames, lowest_rad, kAny, "Lowest joint angles", Need::optional);
    keys.numbers("highest_rad", kArmJointNames, highest_rad, kAny, "Highest joint angles", Need::optional);
    keys.numbers("fastest_rad_per_s", kArmJointNames, fastest_radPerS, kPositive, "Highest joint speeds",
                 Need::optional);
    keys.numbers("start_rad", kArmJointNames, start_rad, kAny, "Joint angles at the start");
    for (std::size_t j = 0; j < ArmBody::kJoints; ++j) {
        if (start_rad[j] < lowest_rad[j] || start_rad[j] > highest_rad[j])
            keys.refuse("start_rad",
                        ArmText::tr("the arm starts outside the range of its joints").toStdString(),
                        ArmText::tr("%1 from %2 to %3")
                            .arg(QString::fromUtf8(kArmJointNames[j].data()))
                            .arg(lowest_rad[j])
                            .arg(highest_rad[j])
                            .toStdString());
    }
}

void ArmSkin::describeKeys(Keys& keys) {
    describeLayout(keys, layout);
    keys.number("rate_Hz", rate_Hz, NumberRange::positiveUpTo(kHighestSkinRate_Hz), "Frames a second");
    keys.number("centre_distance_m", centreDistance_m, kAny,
                "Distance of the middle of the skin from the elbow, along the forearm");
    keys.number("centre_side_rad", centreSide_rad, kAny, "Side of the forearm on which the middle lies",
                Need::optional);
    keys.number("centre_se_m", centreSe_m, kNotNegative,
                "Standard error of a contact's centre, from a calibration run of the skin; what its "
                "threshold hides comes on top",
                Need::optional);
    describeReadings(keys, fullScale_N, firingThreshold_N);
}

void RectangleOutline::describeKeys(Keys& keys) {
    keys.number("length_m", length_m, kPositive, "Length, along x at angle 0");
    keys.number("width_m", width_m, kPositive, "Width");
}

void ArmObject::describeKeys(Keys& keys) {
    keys.text("name", name, "Name in tables and files");
    keys.variant("shape", outline,
                 {{"round", "A round object"},
                  {"rectangle", "A box"},
                  {"triangle", "An equilateral triangle; one corner is on the x axis at angle 0"},
                  {"wall", "A wall without end that faces x at angle 0"}},
                 "Outline of the upright object");
    keys.number("x_m", x_m, kAny, "Centre of the outline or a point of the wall, in the arm's base");
    keys.number("y_m", y_m, kAny, "The same along y");
    keys.number("z_m", z_m, kAny, "Height of the rim that the forearm touches");
    keys.number("angle_rad", angle_rad, kAny, "Turn about z", Need::optional);
    keys.number("stiffness_N_per_m", stiffness_NPerM, kPositive, "Stiffness, normal to the surface");
}

void TouchProgram::describeKeys(Keys& keys) {
    keys.number("approach_rad_per_s", approach_radPerS, kPositive, "Speed of the elbow toward the object");
    keys.number("travel_rad_per_s", travel_radPerS, kPositive, "Speed of the elbow elsewhere");
    keys.number("clearance_rad", clearance_rad, kPositive,
                "Where the approach begins, before the first contact");
    keys.number("retract_rad", retract_rad, kPositive,
                "How far the elbow goes back before the next object takes its place");
    keys.number("torque_limit_Nm", torqueLimit_Nm, kPositive, "Torque at which the press ends");
    keys.number("hold_s", hold_s, kNotNegative, "How long the press is held");
}

void ContourProgram::describeKeys(Keys& keys) {
    keys.whole("directions", directions, {3, 360},
               "Directions from which the object is touched, evenly spaced");
    keys.number("start_angle_rad", startAngle_rad, kAny, "Direction of the first touch, about z",
                Need::optional);
    keys.number("approach_m_per_s", approach_mPerS, kPositive, "Speed toward the object");
    keys.number("travel_m_per_s", travel_mPerS, kPositive, "Speed elsewhere");
    keys.number("clearance_m", clearance_m, kPositive,
                "Distance of the surface at which the approach begins");
    keys.number("retract_m", retract_m, kPositive, "Distance of the surface on the way around");
    keys.number("torque_limit_Nm", torqueLimit_Nm, kPositive, "Torque at which the press ends");
    keys.number("hold_s", hold_s, kNotNegative, "How long the press is held");
}

void Push::describeKeys(Keys& keys) {
    keys.number("time_s", time_s, kNotNegative, "When the push begins");
    keys.number("duration_s", duration_s, kPositive, "How long it lasts");
    keys.number("distance_m", distance_m, kNotNegative, "Where it acts: from the elbow along the forearm");
    keys.number("force_x_N", forceX_N, kAny, "Largest force along x of the base", Need::optional);
    keys.number("force_y_N", forceY_N, kAny, "The same along y", Need::optional);
    keys.number("force_z_N", forceZ_N, kAny, "The same along z", Need::optional);
}

void YieldProgram::describeKeys(Keys& keys) {
    keys.tables("waypoints", waypoints, 0,
                "Where the arm is to be at given times; without any, it stays at its start",
                describeWaypoint);
    keys.tables("pushes", pushes, 0, "Forces on the forearm, each half a sine over its duration");
}

void Exploration::describeKeys(Keys& keys) {
    keys.number("x_m", x_m, kAny, "The place, in the arm's base");
    keys.number("y_m", y_m, kAny, "The same along y");
    keys.number("radius_m", radius_m, kPositive,
                "Distance of the elbow from the place before and after each touch");
    keys.whole("touches", touches, {1, 360}, "Touches, evenly spaced around the place");
    keys.number("start_angle_rad", startAngle_rad, kAny, "Direction of the first touch, about z",
                Need::optional);
}

void OperatorProgram::describeKeys(Keys& keys) {
    keys.number("travel_m_per_s", travel_mPerS, kPositive, "Speed of the elbow between touches");
    keys.number("approach_m_per_s", approach_mPerS, kPositive, "Speed toward the object");
    keys.number("clearance_m", clearance_m, kPositive,
                "Distance from the last contact at which the operator slows down");
    keys.number("felt_torque_Nm", feltTorque_Nm, kPositive,
                "Joint torque above which the operator feels a contact");
    keys.number("reaction_s", reaction_s, kNotNegative, "From feeling a contact to stopping");
    keys.number("hold_s", hold_s, kNotNegative, "How long a contact is held");
    keys.tables("explore", explorations, 1, "Places around which the operator feels his way");
}

void UnknownPlaces::describeKeys(Keys& keys) {
    keys.flag("swap", swap, "Any object may stand at the place of any other");
    keys.number("spread_m", spread_m, kNotNegative, "Each object is displaced by up to so much in x and in y",
                Need::optional);
    keys.number("turn_rad", turn_rad, kNotNegative, "Each object is turned by up to so much", Need::optional);
}

void ArmWorld::describeKeys(Keys& keys) {
    keys.table("arm", "The arm", Need::required, [this](Keys& arm) {
        body.describeKeys(arm);
        arm.table("control", "The controllers of the joints", Need::required, [this](Keys& table) {
            table.variant("kind", control,
                          {{"position", "The motors follow the reference, whatever the load"},
                           {"admittance", "The motors yield to the load like a mass on a damped spring"}},
                          "What the controllers do");
        });
    });
    keys.table("skin", skin, "The tactile skin around the forearm");
    keys.tables("object", objects, 0, "Upright objects that the forearm can touch");
    keys.table("unknown", unknown, "What the arm does not know of the objects; each seed has its own places",
               Need::optional);
    keys.table("program", "What the arm does", Need::required, [this](Keys& table) {
        table.variant("kind", program,
                      {{"touch", "Touches one object after the other with the elbow, from below"},
                       {"contour", "Touches the first object from all sides with the hanging forearm"},
                       {"yield", "Follows waypoints while it is pushed"},
                       {"operator", "An operator drives the arm by what comes back from it"}},
                      "Kind of program");
        const bool needsObject =
            std::holds_alternative<TouchProgram>(program) || std::holds_alternative<ContourProgram>(program);
        if (needsObject && objects.empty())
            table.refuse("kind", ArmText::tr("the program has no object to touch").toStdString(),
                         ArmText::tr("at least one [[object]]").toStdString());
    });
}

} // namespace teleta::scene
