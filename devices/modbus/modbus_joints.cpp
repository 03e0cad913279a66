// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/modbus/modbus_joints.h"

#include "backend/core/failure.h"
#include "devices/modbus/libmodbus_link.h"

#include <QCoreApplication>

#include <utility>

namespace teleta::modbus {

namespace {

core::ArmDescription describeArm(const RegisterMap& map, core::ArmDescription arm) {
    arm.name = map.name;
    arm.nominalRate_Hz = map.inputRate_Hz;
    arm.simulated = false;
    arm.recorded = false;
    // Nobody has told the ranges of an arm that is described by its joints alone.
    if (arm.joints() != map.joints.size())
        arm.lowest_rad = arm.highest_rad = core::JointVector::zeros(map.joints.size());
    arm.fastest_radPerS = core::JointVector::zeros(map.joints.size());
    arm.hasProgram = false;
    return arm;
}

} // namespace

ModbusJoints::ModbusJoints(const RegisterMap& map, LinkOpener opener, const core::ArmDescription& arm,
                           ModbusJointsConfig config)
    : m_description(describeArm(map, arm))
    , m_worker(map, std::move(opener), std::move(config)) {
}

core::Expected<std::unique_ptr<core::ArmSource>>
makeModbusJoints(const RegisterMap& map, const core::ArmDescription& arm, ModbusJointsConfig config) {
    if (map.joints.empty())
        return core::failed(core::ErrorKind::refused,
                            QCoreApplication::translate("Modbus", "The device reports no joints."),
                            QCoreApplication::translate("Modbus", "tables [[joint]] in its file"));
    return std::make_unique<ModbusJoints>(map, libmodbusOpener(map), arm, std::move(config));
}

} // namespace teleta::modbus
