// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/modbus/modbus_joints.h"

#include "backend/core/device/backoff.h"
#include "backend/core/device/device_state.h"
#include "backend/core/failure.h"
#include "devices/modbus/libmodbus_link.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace teleta::modbus {

namespace {

core::ArmDescription describeArm(const RegisterMap& map, core::ArmDescription arm) {
    arm.name = map.name;
    arm.nominalRate_Hz = map.inputRate_Hz;
    arm.simulated = false;
    arm.recorded = false;
    // Nobody has told the ranges of an arm that is described by its joints alone.
    if (arm.joints() != map.joints.size()) {
        arm.lowest_rad = arm.highest_rad = core::JointVector::zeros(map.joints.size());
        std::ranges::fill(arm.lowest_rad, -std::numeric_limits<double>::infinity());
        std::ranges::fill(arm.highest_rad, std::numeric_limits<double>::infinity());
    }
    arm.fastest_radPerS = core::JointVector::zeros(map.joints.size());
    arm.hasProgram = false;
    return arm;
}

std::vector<InputRegister> jointInputs(const RegisterMap& map) {
    std::vector<InputRegister> inputs;
    for (const JointRegisters& joint : map.joints)
        inputs.push_back(map.inputs[joint.angle]);
    for (const JointRegisters& joint : map.joints)
        inputs.push_back(map.inputs[joint.torque]);
    return inputs;
}

} // namespace

ModbusJoints::ModbusJoints(const RegisterMap& map, LinkOpener opener, const core::ArmDescription& arm,
                           ModbusJointsConfig config)
    : m_description(describeArm(map, arm))
    , m_opener(std::move(opener))
    , m_config(std::move(config))
    , m_rate_Hz(map.inputRate_Hz)
    , m_reader(jointInputs(map))
    , m_staleAfter_ns(core::staleAfter_ns(m_rate_Hz))
    , m_joints(m_config.queueSamples, 1)
    , m_wait(m_config.clock)
    , m_values(2 * map.joints.size()) {
}

std::string ModbusJoints::hindrance() const {
    return QCoreApplication::translate("Modbus",
                                       "this arm is read-only: it reports its joints but cannot be moved")
        .toStdString();
}

void ModbusJoints::open(core::Wakeup& consumer) {
    m_opened_ns = now_ns();
    m_joints.open(consumer, m_opened_ns);
}

void ModbusJoints::run(const std::stop_token& stop) {
    while (connect(stop)) {
        while (m_wait.until(due_ns(), stop) && readOnce()) {
        }
        m_link.reset();
    }
    m_joints.setState(core::DeviceState::closed, now_ns());
    m_discontinuity = true;
}

/// Tries until there is a connection, less and less often. False: stopped.
bool ModbusJoints::connect(const std::stop_token& stop) {
    core::Backoff retry(m_config.firstRetry_ns, m_config.longestRetry_ns);
    while (!stop.stop_requested()) {
        if (m_joints.state() == core::DeviceState::lost) {
            if (!m_wait.until(now_ns() + retry.next_ns(), stop))
                return false;
            m_joints.setState(core::DeviceState::reconnecting, now_ns(), m_joints.status().message);
        }
        auto link = m_opener();
        if (link) {
            m_link = std::move(*link);
            m_failures = 0;
            m_epoch_ns = now_ns();
            m_sinceEpoch = 0;
            m_joints.setState(core::DeviceState::connecting, m_epoch_ns);
            return !stop.stop_requested();
        }
        m_joints.setState(core::DeviceState::lost, now_ns(), link.error().message);
    }
    return false;
}

std::int64_t ModbusJoints::due_ns() const {
    return m_epoch_ns + std::llround(static_cast<double>(m_sinceEpoch) / m_rate_Hz * 1e9);
}

bool ModbusJoints::readOnce() {
    countSkipped();
    ++m_sinceEpoch;
    const Answer answer = m_reader.read(*m_link, m_values);
    if (answer.done()) {
        m_failures = 0;
        deliver();
        return true;
    }
    m_joints.lose(1);
    ++m_failures;
    const bool lost = answer.kind == Answer::Kind::lost || m_failures >= m_config.failuresUntilLost;
    m_discontinuity = m_discontinuity || lost;
    m_joints.setState(
        lost ? core::DeviceState::lost
             : core::observedState(m_joints.state(), m_joints.lastData_ns(), now_ns(), m_staleAfter_ns),
        now_ns(), describe(answer));
    return !lost;
}

void ModbusJoints::countSkipped() {
    const double late_s = static_cast<double>(now_ns() - due_ns()) * 1e-9;
    const double periods = std::floor(late_s * m_rate_Hz);
    if (periods >= 1.0) {
        m_joints.lose(static_cast<std::uint64_t>(periods));
        m_sinceEpoch += static_cast<std::uint64_t>(periods);
    }
}

void ModbusJoints::deliver() {
    core::JointSample sample;
    sample.time_ns = now_ns();
    sample.sourceTime_s = static_cast<double>(sample.time_ns - m_opened_ns) * 1e-9;
    const std::size_t joints = m_values.size() / 2;
    sample.angle_rad = sample.torque_Nm = core::JointVector::zeros(joints);
    std::copy_n(m_values.data(), joints, sample.angle_rad.begin());
    std::copy_n(m_values.data() + joints, joints, sample.torque_Nm.begin());
    sample.reference_rad = sample.angle_rad;
    sample.discontinuity = std::exchange(m_discontinuity, false);
    m_joints.deliver(std::move(sample));
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
