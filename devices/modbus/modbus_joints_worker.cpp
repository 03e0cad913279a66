// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/modbus/modbus_joints_worker.h"

#include "backend/core/device/device_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::modbus {

namespace {

constexpr std::size_t kJoints = core::kArmJoints;

std::vector<InputRegister> jointInputs(const RegisterMap& map) {
    std::vector<InputRegister> inputs;
    for (const JointRegisters& joint : *map.joints)
        inputs.push_back(map.inputs[joint.angle]);
    for (const JointRegisters& joint : *map.joints)
        inputs.push_back(map.inputs[joint.torque]);
    return inputs;
}

} // namespace

ModbusJointsWorker::ModbusJointsWorker(const RegisterMap& map, LinkOpener opener, ModbusJointsConfig config)
    : m_opener(std::move(opener))
    , m_config(std::move(config))
    , m_rate_Hz(map.inputRate_Hz)
    , m_reader(jointInputs(map))
    , m_staleAfter_ns(core::staleAfter_ns(m_rate_Hz))
    , m_joints(m_config.queueSamples)
    , m_values(2 * kJoints) {
}

void ModbusJointsWorker::open(core::Wakeup& consumer) {
    m_consumer = &consumer;
    m_opened_ns = now_ns();
    m_lost = 0;
    m_overflowAtOpen = m_joints.overflow();
    m_rate.reset();
    m_status = {};
    setState(core::DeviceState::connecting);
}

void ModbusJointsWorker::run(const std::stop_token& stop) {
    Lock lock(m_mutex);
    while (connect(lock, stop)) {
        while (!stop.stop_requested()) {
            if (!waitUntil(lock, stop, due_ns()))
                break;
            lock.unlock();
            const bool connected = readOnce();
            lock.lock();
            if (!connected)
                break;
        }
        m_link.reset();
    }
    setState(core::DeviceState::closed);
    m_discontinuity = true;
}

void ModbusJointsWorker::wake() {
    const std::scoped_lock lock(m_mutex);
    m_condition.notify_all();
}

/// Tries until there is a connection, less and less often. False: stopped.
bool ModbusJointsWorker::connect(Lock& lock, const std::stop_token& stop) {
    std::int64_t retry_ns = m_config.firstRetry_ns;
    while (!stop.stop_requested()) {
        if (m_status.state == core::DeviceState::lost) {
            if (!waitUntil(lock, stop, now_ns() + retry_ns))
                return false;
            retry_ns = std::min(2 * retry_ns, m_config.longestRetry_ns);
            setState(core::DeviceState::reconnecting, m_status.message);
        }
        lock.unlock();
        auto link = m_opener();
        lock.lock();
        if (link) {
            m_link = std::move(*link);
            m_failures = 0;
            m_epoch_ns = now_ns();
            m_sinceEpoch = 0;
            setState(core::DeviceState::connecting);
            return !stop.stop_requested();
        }
        setState(core::DeviceState::lost, link.error().message);
    }
    return false;
}

/// False: stopped.
bool ModbusJointsWorker::waitUntil(Lock& lock, const std::stop_token& stop, std::int64_t deadline_ns) {
    while (!stop.stop_requested() && now_ns() < deadline_ns)
        m_config.clock->waitUntil(m_condition, lock, deadline_ns);
    return !stop.stop_requested();
}

std::int64_t ModbusJointsWorker::due_ns() const {
    return m_epoch_ns + std::llround(static_cast<double>(m_sinceEpoch) / m_rate_Hz * 1e9);
}

bool ModbusJointsWorker::readOnce() {
    countSkipped();
    ++m_sinceEpoch;
    const Answer answer = m_reader.read(*m_link, m_values);
    if (answer.done()) {
        m_failures = 0;
        deliver();
        return true;
    }
    ++m_lost;
    ++m_failures;
    if (answer.kind != Answer::Kind::lost && m_failures < m_config.failuresUntilLost) {
        setState(core::observedState(m_status.state, m_status.lastData_ns, now_ns(), m_staleAfter_ns),
                 describe(answer));
        return true;
    }
    m_discontinuity = true;
    setState(core::DeviceState::lost, describe(answer));
    return false;
}

void ModbusJointsWorker::countSkipped() {
    const double late_s = static_cast<double>(now_ns() - due_ns()) * 1e-9;
    const double periods = std::floor(late_s * m_rate_Hz);
    if (periods >= 1.0) {
        m_lost += static_cast<std::uint64_t>(periods);
        m_sinceEpoch += static_cast<std::uint64_t>(periods);
    }
}

void ModbusJointsWorker::deliver() {
    core::JointSample sample;
    sample.time_ns = now_ns();
    sample.sourceTime_s = static_cast<double>(sample.time_ns - m_opened_ns) * 1e-9;
    std::copy_n(m_values.begin(), kJoints, sample.angle_rad.begin());
    std::copy_n(m_values.begin() + kJoints, kJoints, sample.torque_Nm.begin());
    sample.reference_rad = sample.angle_rad;
    sample.discontinuity = std::exchange(m_discontinuity, false);
    m_rate.add(sample.time_ns);
    m_status.lastData_ns = sample.time_ns;
    ++m_status.framesRead;
    (void)m_joints.push(std::move(sample));
    if (m_status.state != core::DeviceState::live || !m_status.message.empty())
        setState(core::DeviceState::live);
    else
        publish();
}

void ModbusJointsWorker::setState(core::DeviceState state, std::string message) {
    if (m_status.state != state)
        m_status.since_ns = now_ns();
    m_status.state = state;
    m_status.message = std::move(message);
    publish();
}

void ModbusJointsWorker::publish() {
    m_status.rate_Hz = m_rate.rate_Hz(now_ns());
    m_status.framesLost = m_lost + (m_joints.overflow() - m_overflowAtOpen);
    m_published.set(m_status);
    m_consumer->notify();
}

} // namespace teleta::modbus
