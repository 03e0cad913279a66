// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/simulated_arm_worker.h"

#include "backend/core/device_state.h"
#include "devices/simulated/simulated_times.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace teleta::simulated {

namespace {

constexpr std::size_t kStepsAtOnce = 64;
constexpr std::int64_t kSilentLook_ns = 10'000'000;

std::size_t samplesIn(double duration_s, double rate_Hz) {
    const double samples = duration_s * rate_Hz;
    return samples >= 1.0 && samples < 1e6 ? static_cast<std::size_t>(std::llround(samples)) : 1;
}

} // namespace

SimulatedArmWorker::SimulatedArmWorker(std::unique_ptr<core::ArmGenerator> generator,
                                       const core::StopSwitch& stopSwitch, SimulatedArmConfig config)
    : m_generator(std::move(generator))
    , m_stopSwitch(stopSwitch)
    , m_config(std::move(config))
    , m_description(m_generator->description())
    , m_skinDescription(m_generator->skinDescription())
    , m_drive(m_description)
    , m_joints(m_config.queueSamples, samplesIn(m_config.batch_s, m_description.nominalRate_Hz))
    , m_skin(m_config.queueBlocks)
    , m_faults(m_config.faults)
    , m_dropRandom(m_config.faultSeed)
    , m_values(m_skinDescription.layout.taxels()) {
}

void SimulatedArmWorker::open(core::Wakeup& consumer) {
    m_drive.begin(m_config.startProgram);
    m_joints.open(consumer, m_config.clock->now_ns());
    m_skin.open(consumer, m_config.clock->now_ns());
}

void SimulatedArmWorker::run(const std::stop_token& stop) {
    const auto staleAfter = [&](double rate_Hz) {
        return m_config.staleAfter_s ? toNs(*m_config.staleAfter_s) : core::staleAfter_ns(rate_Hz);
    };
    const std::int64_t jointsStaleAfter_ns = staleAfter(m_description.nominalRate_Hz);
    const std::int64_t skinStaleAfter_ns = staleAfter(m_skinDescription.nominalRate_Hz);

    Lock lock(m_mutex);
    connect();
    bool silent = false;
    while (!stop.stop_requested()) {
        const SimulatedFaults faults = m_faults;
        if (faults.unplugged) {
            waitForPlug(lock, stop);
            continue;
        }
        const std::int64_t now_ns = m_config.clock->now_ns();
        if (std::exchange(silent, faults.silent) != faults.silent) {
            m_joints.flush();
            m_epoch_ns = now_ns;
            m_sinceEpoch = 0;
        }
        if (faults.silent)
            obeyStop(now_ns);
        const std::int64_t next_ns = faults.silent ? core::PacingClock::kNever_ns : due_ns(faults.lag_s);
        if (next_ns <= now_ns) {
            lock.unlock();
            stepDue(faults, now_ns);
            lock.lock();
            continue;
        }
        std::int64_t deadline_ns = faults.silent ? now_ns + kSilentLook_ns : next_ns;
        const auto watchAge = [&](auto& outlet, std::int64_t staleAfter_ns) {
            if (outlet.state() != core::DeviceState::live)
                return;
            const std::int64_t stale_ns = outlet.lastData_ns() + staleAfter_ns;
            if (now_ns >= stale_ns)
                outlet.setState(core::DeviceState::stale, now_ns);
            else
                deadline_ns = std::min(deadline_ns, stale_ns);
        };
        watchAge(m_joints, jointsStaleAfter_ns);
        watchAge(m_skin, skinStaleAfter_ns);
        m_config.clock->waitUntil(m_condition, lock, deadline_ns);
    }
    m_drive.begin(false);
    setState(core::DeviceState::closed);
    m_jointDiscontinuity = m_skinDiscontinuity = true;
}

/// An arm that tells nothing still stops, and does not go on by itself when it tells again.
void SimulatedArmWorker::obeyStop(std::int64_t now_ns) {
    if (m_stopSwitch.engaged())
        (void)m_drive.decide(true, m_generator->programDone(), now_ns, m_reference_rad);
    else if (m_drive.drive() == core::ArmDrive::stopped)
        m_drive.begin(false);
}

void SimulatedArmWorker::wake() {
    const std::scoped_lock lock(m_mutex);
    m_condition.notify_all();
}

void SimulatedArmWorker::setFaults(const SimulatedFaults& faults) {
    const std::scoped_lock lock(m_mutex);
    m_faults = faults;
    m_condition.notify_all();
}

SimulatedFaults SimulatedArmWorker::faults() const {
    const std::scoped_lock lock(m_mutex);
    return m_faults;
}

void SimulatedArmWorker::setState(core::DeviceState state, const std::string& message) {
    const std::int64_t now_ns = m_config.clock->now_ns();
    m_joints.setState(state, now_ns, message);
    m_skin.setState(state, now_ns, message);
}

void SimulatedArmWorker::connect() {
    m_epoch_ns = m_config.clock->now_ns();
    m_sinceEpoch = 0;
    setState(core::DeviceState::connecting);
}

/// Behaves as a driver does whose device is gone: says so, then tries again less and less often. The arm is
/// held when it is back: what it was told before is too old to move it.
void SimulatedArmWorker::waitForPlug(Lock& lock, const std::stop_token& stop) {
    core::PacingClock& clock = *m_config.clock;
    const std::string message =
        QCoreApplication::translate("SimulatedArmDevice", "The arm was unplugged.").toStdString();
    m_drive.begin(false);
    setState(core::DeviceState::lost, message);
    for (std::int64_t retry_ns = kFirstRetry_ns;; retry_ns = std::min(2 * retry_ns, kLongestRetry_ns)) {
        const std::int64_t deadline_ns = clock.now_ns() + retry_ns;
        while (clock.now_ns() < deadline_ns) {
            if (stop.stop_requested())
                return;
            clock.waitUntil(m_condition, lock, deadline_ns);
        }
        setState(core::DeviceState::reconnecting, message);
        if (!m_faults.unplugged)
            break;
    }
    m_drive.begin(false);
    m_jointDiscontinuity = m_skinDiscontinuity = true;
    connect();
}

std::int64_t SimulatedArmWorker::due_ns(double lag_s) const {
    const double since_s = static_cast<double>(m_sinceEpoch + 1) / m_description.nominalRate_Hz;
    return m_epoch_ns + toNs(since_s + (lag_s > 0.0 ? std::min(lag_s, kLongestLag_s) : 0.0));
}

void SimulatedArmWorker::stepDue(const SimulatedFaults& faults, std::int64_t now_ns) {
    const std::int64_t late_ns = now_ns - due_ns(faults.lag_s);
    if (late_ns > toNs(m_config.longestCatchUp_s))
        m_epoch_ns += late_ns;
    for (std::size_t i = 0; i < kStepsAtOnce && due_ns(faults.lag_s) <= now_ns; ++i)
        step(faults);
}

void SimulatedArmWorker::step(const SimulatedFaults& faults) {
    const bool stopped = m_stopSwitch.engaged();
    if (m_drive.takeRestart(stopped)) {
        m_generator->restart();
        m_reference_rad.reset();
        m_jointDiscontinuity = m_skinDiscontinuity = true;
    }
    const core::ArmDemand demand =
        m_drive.decide(stopped, m_generator->programDone(), m_config.clock->now_ns(), m_reference_rad);

    core::JointSample sample;
    m_generator->next(demand, sample);
    const bool hasFrame = m_generator->skinFrame(m_values);
    ++m_sinceEpoch;
    m_reference_rad = sample.reference_rad;
    sample.time_ns = m_config.clock->now_ns();

    // The skin first: who has the sample can have the frame that was read with it.
    if (hasFrame && drops(faults))
        m_skin.lose(1);
    else if (hasFrame)
        deliverFrame(sample.time_ns);
    if (drops(faults)) {
        m_joints.lose(1);
        return;
    }
    sample.discontinuity = std::exchange(m_jointDiscontinuity, false);
    m_joints.deliver(std::move(sample));
}

bool SimulatedArmWorker::drops(const SimulatedFaults& faults) {
    return static_cast<double>(m_dropRandom() >> 11) * 0x1.0p-53 < faults.dropShare;
}

void SimulatedArmWorker::deliverFrame(std::int64_t now_ns) {
    core::SampleBlock block;
    block.channels = m_values.size();
    block.time_ns = {now_ns};
    block.sourceTime_s = {m_generator->time_s()};
    block.values = m_values;
    block.discontinuity = std::exchange(m_skinDiscontinuity, false);
    m_skin.deliver(std::move(block), core::DeviceState::live);
}

} // namespace teleta::simulated
