// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/simulated_arm_worker.h"

#include "backend/core/device/device_state.h"
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
    , m_link(m_config.clock, m_description.nominalRate_Hz, m_config.faults, m_config.faultSeed)
    , m_values(m_skinDescription.layout.taxels()) {
}

void SimulatedArmWorker::open(core::Wakeup& consumer) {
    m_drive.begin(m_config.startProgram);
    m_joints.open(consumer, m_link.now_ns());
    m_skin.open(consumer, m_link.now_ns());
}

void SimulatedArmWorker::run(const std::stop_token& stop) {
    const auto staleAfter = [&](double rate_Hz) {
        return m_config.staleAfter_s ? toNs(*m_config.staleAfter_s) : core::staleAfter_ns(rate_Hz);
    };
    const std::int64_t jointsStaleAfter_ns = staleAfter(m_description.nominalRate_Hz);
    const std::int64_t skinStaleAfter_ns = staleAfter(m_skinDescription.nominalRate_Hz);

    SimulatedLink::Lock lock = m_link.lock();
    connect();
    bool silent = false;
    while (!stop.stop_requested()) {
        const SimulatedFaults faults = m_link.faults(lock);
        if (faults.unplugged) {
            waitForPlug(lock, stop);
            continue;
        }
        const std::int64_t now_ns = m_link.now_ns();
        if (std::exchange(silent, faults.silent) != faults.silent) {
            m_joints.flush();
            m_link.restart();
        }
        if (faults.silent)
            obeyStop(now_ns);
        const std::int64_t next_ns =
            faults.silent ? core::PacingClock::kNever_ns : m_link.due_ns(faults.lag_s);
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
        m_link.waitUntil(lock, deadline_ns);
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

void SimulatedArmWorker::setState(core::DeviceState state, const std::string& message) {
    const std::int64_t now_ns = m_link.now_ns();
    m_joints.setState(state, now_ns, message);
    m_skin.setState(state, now_ns, message);
}

void SimulatedArmWorker::connect() {
    m_link.restart();
    setState(core::DeviceState::connecting);
}

/// The arm is held when it is back: what it was told before is too old to move it.
void SimulatedArmWorker::waitForPlug(SimulatedLink::Lock& lock, const std::stop_token& stop) {
    const std::string message =
        QCoreApplication::translate("SimulatedArmDevice", "The arm was unplugged.").toStdString();
    m_drive.begin(false);
    if (!m_link.waitForPlug(lock, stop, [&](core::DeviceState state) { setState(state, message); }))
        return;
    m_drive.begin(false);
    m_jointDiscontinuity = m_skinDiscontinuity = true;
    connect();
}

void SimulatedArmWorker::stepDue(const SimulatedFaults& faults, std::int64_t now_ns) {
    const std::int64_t late_ns = now_ns - m_link.due_ns(faults.lag_s);
    if (late_ns > toNs(m_config.longestCatchUp_s))
        m_link.standStill(late_ns);
    for (std::size_t i = 0; i < kStepsAtOnce && m_link.due_ns(faults.lag_s) <= now_ns; ++i)
        step(faults);
}

void SimulatedArmWorker::step(const SimulatedFaults& faults) {
    const bool stopped = m_stopSwitch.engaged();
    if (m_drive.takeRestart(stopped)) {
        m_generator->restart();
        m_reference_rad.reset();
        m_linkCounted = {};
        m_jointDiscontinuity = m_skinDiscontinuity = true;
    }
    const core::ArmDemand demand =
        m_drive.decide(stopped, m_generator->programDone(), m_link.now_ns(), m_reference_rad);

    core::JointSample sample;
    m_generator->next(demand, sample);
    if (m_generator->isRemote()) {
        m_link.count();
        deliverArrivals(faults);
        return;
    }
    const bool hasFrame = m_generator->skinFrame(m_values);
    m_link.count();
    m_reference_rad = sample.reference_rad;
    sample.time_ns = m_link.now_ns();

    // The skin first: who has the sample can have the frame that was read with it.
    if (hasFrame && m_link.happens(faults.dropShare))
        m_skin.lose(1);
    else if (hasFrame)
        deliverFrame(sample.time_ns, m_generator->time_s());
    if (m_link.happens(faults.dropShare)) {
        m_joints.lose(1);
        return;
    }
    sample.discontinuity = std::exchange(m_jointDiscontinuity, false);
    m_joints.deliver(std::move(sample));
}

void SimulatedArmWorker::deliverArrivals(const SimulatedFaults& faults) {
    const std::int64_t now_ns = m_link.now_ns();
    while (m_generator->takeArrival(m_arrival)) {
        core::JointSample& sample = m_arrival.sample;
        // Steps that catch up share a time: stamps must not run back.
        m_newestRead_ns =
            std::max(m_newestRead_ns, now_ns - toNs(m_generator->time_s() - sample.sourceTime_s));
        sample.time_ns = m_newestRead_ns;
        m_reference_rad = sample.reference_rad;
        if (m_arrival.hasFrame && m_link.happens(faults.dropShare)) {
            m_skin.lose(1);
        } else if (m_arrival.hasFrame) {
            m_values = m_arrival.frame;
            deliverFrame(sample.time_ns, sample.sourceTime_s, now_ns);
        }
        if (m_link.happens(faults.dropShare)) {
            m_joints.lose(1);
            continue;
        }
        sample.discontinuity = std::exchange(m_jointDiscontinuity, false);
        m_joints.deliver(std::move(sample), now_ns);
    }
    const core::ArmLinkCounters counters = m_generator->linkCounters();
    if (counters.samplesLost != m_linkCounted.samplesLost)
        m_joints.lose(counters.samplesLost - m_linkCounted.samplesLost);
    if (counters.framesLost != m_linkCounted.framesLost)
        m_skin.lose(counters.framesLost - m_linkCounted.framesLost);
    m_linkCounted = counters;
}

void SimulatedArmWorker::deliverFrame(std::int64_t time_ns, double sourceTime_s,
                                      std::optional<std::int64_t> arrived_ns) {
    core::SampleBlock block;
    block.channels = m_values.size();
    block.time_ns = {time_ns};
    block.sourceTime_s = {sourceTime_s};
    block.values = m_values;
    block.discontinuity = std::exchange(m_skinDiscontinuity, false);
    m_skin.deliver(std::move(block), core::DeviceState::live, arrived_ns);
}

} // namespace teleta::simulated
