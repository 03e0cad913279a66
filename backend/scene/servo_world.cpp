// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/servo_world.h"

#include <QCoreApplication>

#include <numbers>
#include <string_view>

namespace teleta::scene {

namespace {

struct ServoText {
    Q_DECLARE_TR_FUNCTIONS(SceneReader)
};

constexpr double kSteepest_rad = 1.2;
// What the servo's controller accepts.
constexpr double kHighestForce_N = 30.0;
constexpr double kHighestSpeed_mPerS = 0.1;
constexpr double kFarthestPlace_m = 0.05;
constexpr double kShortestRoll_s = 1.0;
constexpr double kHighestSensorRate_Hz = 10'000.0;
constexpr std::array<std::string_view, kServoJoints> kServoJointNames{"a1", "a2", "a3", "a4",
                                                                      "a5", "a6", "a7"};
/// The limits of the KUKA LWR 4+, in degrees.
constexpr std::array<double, kServoJoints> kFarthest_deg{170.0, 120.0, 170.0, 120.0, 170.0, 120.0, 170.0};

constexpr NumberRange kSteepness = NumberRange::between(-kSteepest_rad, kSteepest_rad);

void describeMotion(Keys& keys, std::vector<MassKeyframe>& frames, std::size_t i) {
    describeTime(keys, frames, i);
    keys.number("x_m", frames[i].x_m, kAny, "Place along the tray, from the hinge");
}

} // namespace

void ServoArm::describeKeys(Keys& keys) {
    keys.table("start_rad", "Joint angles at the start", Need::required, [this](Keys& table) {
        for (std::size_t j = 0; j < kServoJoints; ++j) {
            const double farthest_rad = kFarthest_deg[j] * std::numbers::pi / 180.0;
            table.number(kServoJointNames[j], start_rad[j], NumberRange::between(-farthest_rad, farthest_rad),
                         "Angle of the joint");
        }
    });
    keys.word("kind", "lwr", "A KUKA LWR 4+ with seven joints");
    keys.number("stiffness_N_per_m", stiffness_NPerM, kPositive, "Stiffness of the tool's position");
    keys.number("rotational_stiffness_Nm_per_rad", rotationalStiffness_NmPerRad, kPositive,
                "Stiffness of the tool's orientation");
    keys.number("damping_ratio", dampingRatio, kNotNegative, "Damping of every mode of the free arm");
    keys.number("mount_length_m", mountLength_m, kNotNegative, "From the flange to the array's surface",
                Need::optional);
}

void ServoSensor::describeKeys(Keys& keys) {
    const NumberRange rate = NumberRange::positiveUpTo(kHighestSensorRate_Hz);
    array.describeKeys(keys);
    keys.number("acquisition_Hz", acquisition_Hz, rate, "How often the array is read", Need::optional);
    keys.number("images_Hz", images_Hz, rate, "How often features are computed", Need::optional);
    keys.number("servo_Hz", servo_Hz, rate, "How often the servo corrects the arm", Need::optional);
}

void BarShape::describeKeys(Keys& keys) {
    keys.number("radius_m", radius_m, kPositive, "Radius");
    keys.number("behind_m", behind_m, kNotNegative, "How far the bar reaches to -x");
    keys.number("ahead_m", ahead_m, kPositive, "How far it reaches to +x");
    keys.number("straight_m", straight_m, kAny, "Where the bend begins", Need::optional);
    keys.number("bend_m", bend_m, kNotNegative, "Length of the bend; 0: straight throughout", Need::optional);
    keys.number("bend_behind_m", bendBehind_m, kNotNegative, "Length of a bend on the other side",
                Need::optional);
    keys.number("fall_rad", fall_rad, kSteepness, "Slope behind the bend, away from the array",
                Need::optional);
    keys.number("turn_rad", turn_rad, kSteepness, "Slope behind the bend, to the side", Need::optional);
}

void TrayHinge::describeKeys(Keys& keys) {
    keys.number("height_m", height_m, kAny, "Distance of the hinge behind the line of contact");
    keys.number("inertia_kgm2", inertia_kgm2, kPositive, "Inertia about the hinge, without the mass");
    keys.number("damping_Nms_per_rad", damping_NmsPerRad, kNotNegative, "Damping of the hinge",
                Need::optional);
    keys.number("mass_kg", mass_kg, kNotNegative, "Mass that is moved on the tray");
    keys.tables("motion", motion, 1, "Where the mass is at given times; it moves smoothly in between",
                describeMotion);
}

void PoseSpread::describeKeys(Keys& keys) {
    keys.number("y_m", y_m, kNotNegative, "Largest displacement along y", Need::optional);
    keys.number("gap_m", gap_m, kNotNegative, "Largest change of the gap", Need::optional);
    keys.number("yaw_rad", yaw_rad, kNotNegative, "Largest turn about z", Need::optional);
    keys.number("pitch_rad", pitch_rad, kNotNegative, "Largest turn about y", Need::optional);
}

void ServoObject::describeKeys(Keys& keys) {
    keys.text("name", name, "Name in tables and files");
    keys.variant("shape", shape,
                 {{"bar", "A round bar, straight or bent"},
                  {"box_edge", "The edge of a box, its faces at 45 degrees to the array"},
                  {"sphere", "A ball"},
                  {"wall", "A flat face without end"}},
                 "Shape of the object");
    keys.number("stiffness_N_per_m", stiffness_NPerM, NumberRange::between(10.0, 1e9),
                "Stiffness of a patch as large as a taxel");
    keys.number("x_m", x_m, kAny, "Place, in the frame that the array has at the start", Need::optional);
    keys.number("y_m", y_m, kAny, "The same along y", Need::optional);
    keys.number("gap_m", gap_m, kAny, "Gap to the array; negative: pressed in");
    keys.number("yaw_rad", yaw_rad, kAny, "Turn about z, after the pitch", Need::optional);
    keys.number("pitch_rad", pitch_rad, kSteepness, "Turn about y", Need::optional);
    keys.table("spread", spread, "How far the pose may differ; each seed has its own", Need::optional);
    keys.table("hinge", hinge, "The object turns about a hinge across its line of contact");
}

void ServoTaskSettings::describeKeys(Keys& keys) {
    keys.choose("kind", static_cast<std::size_t>(kind),
                {{"explore_edge", "Approaches an edge, aligns with it and slides along it"},
                 {"point", "Keeps the force and the place of a point contact"},
                 {"roll", "Rolls about the contact"},
                 {"comanipulate", "Keeps a tray level by moving under its load"}},
                "What the servo does", Need::required, [this](Keys& table, std::size_t chosen) {
                    kind = static_cast<ServoTaskKind>(chosen);
                    if (kind == ServoTaskKind::exploreEdge) {
                        table.number("slide_m_per_s", slide_mPerS,
                                     NumberRange::between(0.0, kHighestSpeed_mPerS), "Speed along the edge");
                        table.flag("dzmp", moment, "Follow the slope by the moment that the array feels");
                    } else if (kind == ServoTaskKind::roll) {
                        table.number("roll_angle_rad", rollAngle_rad,
                                     NumberRange::between(0.0, kSteepest_rad), "Amplitude of rolling");
                        table.number("roll_period_s", rollPeriod_s, {.low = kShortestRoll_s},
                                     "Period of rolling");
                    }
                });
    keys.number("force_N", force_N, NumberRange::positiveUpTo(kHighestForce_N), "Force of the contact");
    keys.number("cop_y_m", copY_m, NumberRange::between(-kFarthestPlace_m, kFarthestPlace_m),
                "Where on the array the contact is kept", Need::optional);
    keys.number("approach_m_per_s", approach_mPerS, NumberRange::positiveUpTo(kHighestSpeed_mPerS),
                "Speed toward the object");
    keys.choice("expect", expect,
                {{"completed", "The servo does its task; otherwise teleta simulate ends with exit code 1"},
                 {"not_completed", "The servo may fail; teleta simulate ends with exit code 0"}},
                "How a run should end", Need::optional);
}

void ServoWorld::describeKeys(Keys& keys) {
    keys.table("robot", arm, "The arm, under Cartesian impedance control");
    keys.table("sensor", sensor, "The tactile array in its hand");
    keys.table("object", object, "What the array touches");
    keys.table("task", "What the servo does", Need::required, [this](Keys& table) {
        task.describeKeys(table);
        if (task.kind == ServoTaskKind::comanipulate && !object.hinge)
            table.refuse("kind", ServoText::tr("there is no tray to keep level").toStdString(),
                         ServoText::tr("an [object.hinge]").toStdString());
    });
}

} // namespace teleta::scene
