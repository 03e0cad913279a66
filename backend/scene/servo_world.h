// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/array_world.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace teleta::scene {

inline constexpr std::size_t kServoJoints = 7;

/// The seven-joint arm that carries a tactile array at its flange, under Cartesian impedance control (paper,
/// eq. 11). The array looks along the flange's z axis.
struct ServoArm {
    std::array<double, kServoJoints> start_rad{};
    double stiffness_NPerM = 1000.0;             ///< of the tool's position
    double rotationalStiffness_NmPerRad = 200.0; ///< of its orientation
    double dampingRatio = 0.7;                   ///< of every mode of the free arm
    double mountLength_m = 0.03;                 ///< flange to the array's surface
    void describeKeys(Keys& keys);
};

/// The tactile array in the arm's hand and the rates of what happens to its frames (paper, Table 2).
struct ServoSensor {
    ArraySensor array;
    double acquisition_Hz = 200.0; ///< > 0; what is faster than the scene's rate happens at that rate
    double images_Hz = 140.0;
    double servo_Hz = 100.0;
    void describeKeys(Keys& keys);
};

/// A round bar. Its line of contact runs along x; from straight_m on its slope grows evenly over bend_m to
/// the given angles and stays there: it falls away from the array and turns aside. Behind straight_m it bends
/// in the same way over bendBehind_m, as an arch does.
struct BarShape {
    double radius_m = 0.0;
    double behind_m = 0.0; ///< how far it reaches to -x
    double ahead_m = 0.0;  ///< and to +x
    double straight_m = 0.0;
    double bend_m = 0.0; ///< 0: straight throughout
    double bendBehind_m = 0.0;
    double fall_rad = 0.0; ///< (-1.2, 1.2)
    double turn_rad = 0.0; ///< (-1.2, 1.2)
    void describeKeys(Keys& keys);
};

/// The sharp edge of a box between two faces at 45 degrees to the array, along x and without end.
struct EdgeShape {
    void describeKeys(Keys&) {}
};

/// A ball; its topmost point is the object's origin.
struct BallShape {
    double radius_m = 0.0;
    void describeKeys(Keys& keys) { keys.number("radius_m", radius_m, kPositive, "Radius"); }
};

/// A flat face without end.
struct WallShape {
    void describeKeys(Keys&) {}
};

using ServoShape = std::variant<BarShape, EdgeShape, BallShape, WallShape>;

/// Where a mass lies on a tray at a time; it moves smoothly in between and rests at both ends.
struct MassKeyframe {
    double time_s = 0.0;
    double x_m = 0.0; ///< along the tray's edge bar, from the hinge
};

/// The object turns about a hinge across its line of contact, and a mass is moved on it.
struct TrayHinge {
    double height_m = 0.0;     ///< of the hinge behind the line of contact; any
    double inertia_kgm2 = 0.0; ///< about the hinge, without the mass
    double damping_NmsPerRad = 0.0;
    double mass_kg = 0.0;
    std::vector<MassKeyframe> motion{}; ///< at least one, times strictly increasing
    void describeKeys(Keys& keys);
};

/// How far the object may lie from where the scene says: every value is drawn evenly from within its bounds,
/// for each seed anew. All >= 0.
struct PoseSpread {
    double y_m = 0.0;
    double gap_m = 0.0;
    double yaw_rad = 0.0;
    double pitch_rad = 0.0;
    void describeKeys(Keys& keys);
};

/// What the array touches. Its pose is given in the frame {s} of the array at the start: x_m and y_m of its
/// origin, gap_m between the surfaces (negative: pressed in), pitch about y and then yaw about z.
struct ServoObject {
    std::string name;
    ServoShape shape;
    double stiffness_NPerM = 1e9; ///< of a patch of one taxel's area; 10 .. 1e9
    double x_m = 0.0;
    double y_m = 0.0;
    double gap_m = 0.0;
    double yaw_rad = 0.0;
    double pitch_rad = 0.0;
    PoseSpread spread;
    std::optional<TrayHinge> hinge;
    void describeKeys(Keys& keys);
};

/// What the servo is to do; each is built from the tasks of servo/servo_task.h.
enum class ServoTaskKind {
    exploreEdge,  ///< phases I to IV: approach, align, edge control, slide along the edge
    point,        ///< approach, then keep force and place of a point contact
    roll,         ///< approach, then roll about the contact
    comanipulate, ///< approach, then keep a tray level by moving under its load
};

/// How a run should end: whether one that does not do its task is an error of teleta simulate.
enum class ServoExpectation { completed, notCompleted };

struct ServoTaskSettings {
    ServoTaskKind kind = ServoTaskKind::exploreEdge;
    double force_N = 5.0;
    double copY_m = 0.0; ///< where the array keeps the contact
    double approach_mPerS = 0.01;
    double slide_mPerS = 0.005;
    double rollAngle_rad = 0.0; ///< amplitude of rolling
    double rollPeriod_s = 0.0;
    bool moment = true;                                    ///< false: without the DZMP, as the baseline
    ServoExpectation expect = ServoExpectation::completed; ///< how a run should end
    void describeKeys(Keys& keys);
};

/// An arm that servoes on what its tactile array feels.
struct ServoWorld {
    ServoArm arm;
    ServoSensor sensor;
    ServoObject object;
    ServoTaskSettings task;
    void describeKeys(Keys& keys);
};

} // namespace teleta::scene
