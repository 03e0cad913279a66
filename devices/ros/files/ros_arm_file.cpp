// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/files/ros_arm_file.h"

#include "backend/core/beside_file.h"
#include "backend/core/device/joint_vector.h"
#include "backend/core/keys/keys.h"
#include "backend/core/keys/toml_table.h"
#include "devices/ros/files/ros_file_keys.h"

#include <QCoreApplication>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>

namespace teleta::ros_arm {

namespace {

using core::NumberRange;
using core::TomlTable;

struct ArmFileText {
    Q_DECLARE_TR_FUNCTIONS(RosArmFile)
};

/// In the order of Adapter.
constexpr std::array<std::string_view, 4> kAdapterNames{"trajectory", "moveit_servo", "velocity", "position"};

/// No arm needs more; larger numbers are slips of the unit.
constexpr NumberRange kRate = NumberRange::positiveUpTo(1000.0);
constexpr double kFarthest_m = 1000.0;
constexpr double kLargestTorque_Nm = 1000.0;
constexpr double kMetrePerMm = 1e-3;

/// The index of one of the names; the fallback when the key is missing.
std::size_t choiceOr(TomlTable& table, std::string_view key, const std::vector<std::string_view>& names,
                     std::size_t fallback) {
    return table.has(key) ? table.choice(key, names) : fallback;
}

void readAdapter(TomlTable& root, RosArmFile& file) {
    file.adapter =
        static_cast<Adapter>(choiceOr(root, "adapter", {kAdapterNames.begin(), kAdapterNames.end()}, 0));
    const bool unguarded = root.boolean("unguarded", false);
    if (unguarded && isGuarded(file.adapter))
        root.fail("unguarded",
                  ArmFileText::tr("with this adapter the robot stops by itself, so it is not unguarded")
                      .toStdString(),
                  "false");
    if (!unguarded && !isGuarded(file.adapter))
        root.fail(
            "adapter",
            ArmFileText::tr("with this adapter nothing stops the robot when this program ends or the network "
                            "fails")
                .toStdString(),
            ArmFileText::tr("another adapter, or unguarded = true").toStdString());
}

void readNode(TomlTable& root, RosArmFile& file) {
    if (!root.has("ros"))
        return;
    TomlTable table = root.table("ros");
    file.domain = readDomain(table);
    file.distribution = static_cast<Distribution>(choiceOr(table, "distribution", {"jazzy", "humble"}, 0));
    file.announce = table.boolean("announce", true);
    table.finish();
}

void readJointNames(TomlTable& root, RosArmFile& file) {
    if (!root.has("joint_names"))
        return;
    TomlTable table = root.table("joint_names");
    std::set<std::string> onTheWire;
    for (const std::string& joint : table.keys()) {
        const std::string name = table.text(joint);
        if (!onTheWire.insert(name).second)
            table.fail(joint,
                       ArmFileText::tr("two joints have the ROS name \"%1\"")
                           .arg(QString::fromStdString(name))
                           .toStdString(),
                       ArmFileText::tr("a unique name for each joint").toStdString());
        file.jointNames.emplace(joint, name);
    }
}

void readBox(TomlTable& table, arm_model::MotionLimits& limits) {
    if (!table.has("box_m"))
        return;
    const auto rows = table.numberRows("box_m", NumberRange::between(-kFarthest_m, kFarthest_m), 3, 2);
    if (rows.size() != 3)
        return;
    Eigen::AlignedBox3d box;
    for (int axis = 0; axis < 3; ++axis) {
        const std::vector<double>& row = rows[static_cast<std::size_t>(axis)];
        if (!(row[0] < row[1]))
            table.fail("box_m", ArmFileText::tr("a side of the box is empty or reversed").toStdString(),
                       ArmFileText::tr("[lowest, highest] for x, y and z").toStdString());
        box.min()(axis) = row[0];
        box.max()(axis) = row[1];
    }
    limits.box_m = box;
}

void readLimits(TomlTable& root, RosArmFile& file) {
    if (!root.has("limits"))
        return;
    TomlTable table = root.table("limits");
    arm_model::MotionLimits& limits = file.limits;
    limits.speedScale = table.number("speed_scale", NumberRange::positiveUpTo(1.0), limits.speedScale);
    for (const auto& [key, value] :
         {std::pair{"acceleration_radPerS2", &limits.acceleration_radPerS2},
          std::pair{"deceleration_radPerS2", &limits.deceleration_radPerS2},
          std::pair{"stop_deceleration_radPerS2", &limits.stopDeceleration_radPerS2},
          std::pair{"tip_speed_mPerS", &limits.tipSpeed_mPerS},
          std::pair{"tip_turn_radPerS", &limits.tipTurn_radPerS}})
        *value = table.number(key, kRate, *value);
    for (const auto& [key, value] :
         {std::pair{"leash_rad", &limits.leash_rad}, std::pair{"joint_margin_rad", &limits.jointMargin_rad}})
        *value = table.number(key, NumberRange::positiveUpTo(1.0), *value);
    if (limits.stopDeceleration_radPerS2 < limits.deceleration_radPerS2)
        table.fail("stop_deceleration_radPerS2",
                   ArmFileText::tr("STOP would brake more gently than letting go").toStdString(),
                   ArmFileText::tr("at least deceleration_radPerS2, %1")
                       .arg(limits.deceleration_radPerS2)
                       .toStdString());
    if (table.has("effort_stop")) {
        const std::vector<double> efforts =
            table.numberList("effort_stop", NumberRange::positive(),
                             {1, static_cast<long long>(core::JointVector::kCapacity)});
        limits.effortStop_Nm = core::JointVector::of(efforts).value_or(core::JointVector());
        if (file.effortUnit != EffortUnit::newtonMetre)
            table.fail("effort_stop", ArmFileText::tr("the efforts of this arm are not in Nm").toStdString(),
                       "effort_unit = \"Nm\"");
    }
    if (table.has("force_stop_N"))
        limits.forceStop_N = table.number("force_stop_N", NumberRange::positive());
    readBox(table, limits);
    table.finish();
}

void readWrench(TomlTable& root, const std::string& path, RosArmFile& file) {
    if (!root.has("wrench"))
        return;
    auto wrench = readRosWrench(core::besideFile(path, root.text("wrench")));
    if (wrench)
        file.wrench = std::move(*wrench);
    else
        root.fail("wrench", core::describe(wrench.error()),
                  ArmFileText::tr("the file of a force sensor, kind = \"ros_wrench\"").toStdString());
}

void readTorques(TomlTable& table, core::TouchTorques& torques) {
    if (table.has("window_Nm")) {
        const std::vector<double> window = table.numberList("window_Nm", NumberRange::positive(), {2, 2});
        if (window.size() == 2 && !(window[0] < window[1]))
            table.fail("window_Nm", ArmFileText::tr("the window is empty or reversed").toStdString(),
                       ArmFileText::tr("[lowest, highest]").toStdString());
        if (window.size() == 2) {
            // The noise floor as far below the window as usual.
            torques.noiseFloor_Nm *= window[0] / torques.windowLow_Nm;
            torques.windowLow_Nm = window[0];
            torques.windowHigh_Nm = torques.threshold_Nm = window[1];
        }
    }
    torques.noiseFloor_Nm = table.number("noise_floor_Nm", NumberRange::positiveUpTo(torques.windowLow_Nm),
                                         torques.noiseFloor_Nm);
    torques.threshold_Nm = table.number(
        "threshold_Nm", NumberRange::between(torques.noiseFloor_Nm, kLargestTorque_Nm), torques.threshold_Nm);
}

void readTouch(TomlTable& root, const std::string& path, RosArmFile& file) {
    if (!root.has("touch"))
        return;
    TomlTable table = root.table("touch");
    // Without torques the pad tells where a touch is, and nothing evaluates it.
    for (const char* key : {"joint_stiffness_NmPerRad", "window_Nm", "threshold_Nm", "noise_floor_Nm"})
        if (file.effortUnit != EffortUnit::newtonMetre && table.has(key))
            table.fail(key, ArmFileText::tr("the efforts of this arm are not in Nm").toStdString(),
                       "effort_unit = \"Nm\"");
    RosTouchFile touch;
    core::PadPlacement& pad = touch.pad;
    pad.joint = table.text("joint", "");
    if (table.has("joint_stiffness_NmPerRad")) {
        const std::vector<double> springs =
            table.numberList("joint_stiffness_NmPerRad", NumberRange::notNegative(),
                             {1, static_cast<long long>(core::JointVector::kCapacity)});
        pad.jointStiffness_NmPerRad = core::JointVector::of(springs).value_or(core::JointVector());
    }
    pad.centreSe_m = kMetrePerMm * table.number("centre_se_mm", NumberRange::notNegative(), 0.0);
    readTorques(table, pad.torques);
    if (table.has("array")) {
        touch.array = core::besideFile(path, table.text("array"));
        pad.link = table.text("frame");
        readPose(table, pad);
    } else {
        for (const char* key : {"frame", "pose"})
            if (table.has(key))
                table.fail(key, ArmFileText::tr("the pad is not named").toStdString(),
                           ArmFileText::tr("array = \"the file of the pad\"").toStdString());
    }
    file.touch = std::move(touch);
    table.finish();
}

core::Expected<RosArmFile> read(const core::TomlDocument& document, const std::string& path) {
    RosArmFile file;
    TomlTable root = document.root();
    (void)root.choice("kind", {"ros_arm"});
    file.name = root.text("name");
    const std::string description = root.text("description", "topic");
    if (description != "topic")
        file.description = core::besideFile(path, description);
    file.baseFrame = root.text("base_frame");
    file.tipFrame = root.text("tip_frame");
    file.prefix = root.text("prefix", "");
    readAdapter(root, file);
    file.controller =
        readTopic(root, "controller",
                  file.adapter == Adapter::moveitServo ? std::optional("/servo_node") : std::nullopt);
    file.jointStates = readTopic(root, "joint_states", "/joint_states");
    file.jointTimeout_s = readTimeout_s(root, "joint_timeout_s", file.jointTimeout_s);
    file.effortUnit = static_cast<EffortUnit>(
        choiceOr(root, "effort_unit", {"Nm", "A", "none"}, static_cast<std::size_t>(EffortUnit::none)));
    file.effortContainsGravity = root.boolean("effort_contains_gravity", false);
    if (file.effortContainsGravity && file.effortUnit != EffortUnit::newtonMetre)
        root.fail("effort_contains_gravity",
                  ArmFileText::tr("the efforts of this arm are not in Nm").toStdString(),
                  "effort_unit = \"Nm\"");
    file.required = root.textList("required");
    if (root.has("mesh_path"))
        file.meshPath = core::besideFile(path, root.text("mesh_path"));
    readNode(root, file);
    readJointNames(root, file);
    readLimits(root, file);
    readWrench(root, path, file);
    readTouch(root, path, file);
    root.finish();
    if (document.firstError())
        return core::Unexpected(*document.firstError());
    return file;
}

} // namespace

std::string_view nameOf(Adapter adapter) {
    return kAdapterNames[static_cast<std::size_t>(adapter)];
}

bool isGuarded(Adapter adapter) {
    return adapter == Adapter::trajectory || adapter == Adapter::moveitServo;
}

std::string RosArmFile::commandTopic() const {
    return controller + (adapter == Adapter::trajectory    ? "/joint_trajectory"
                         : adapter == Adapter::moveitServo ? "/delta_joint_cmds"
                                                           : "/commands");
}

std::string RosArmFile::wireName(std::string_view joint) const {
    const auto mapped = jointNames.find(joint);
    return prefix + (mapped == jointNames.end() ? std::string(joint) : mapped->second);
}

core::Expected<RosArmFile> readRosArm(const std::string& path) {
    TELETA_TRY(const core::TomlDocument document, core::TomlDocument::open(path));
    return read(document, path);
}

core::Expected<RosArmFile> parseRosArm(std::string_view text, const std::string& file) {
    TELETA_TRY(const core::TomlDocument document, core::TomlDocument::parse(text, file));
    return read(document, file);
}

} // namespace teleta::ros_arm
