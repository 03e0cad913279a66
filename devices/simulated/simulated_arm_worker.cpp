// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/simulated_arm_worker.h"

#include "backend/core/device/device_state.h"

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

std::int64_t staleAfter(const SimulatedArmConfig& config, double rate_Hz) {
    return config.staleAfter_s ? toNs(*config.staleAfter_s) : core::staleAfter_ns(rate_Hz);
}

} // namespace

SimulatedArmWorker::SimulatedArmWorker(std::unique_ptr<core::ArmGenerator> generator,
                                       const core::StopSwitch& stopSwitch, SimulatedArmConfig config)
    : SimulatedWorker(config.clock, generator->description().nominalRate_Hz, config.faults, config.faultSeed)
    , m_generator(std::move(generator))
    , m_stopSwitch(stopSwitch)
    , m_config(std::move(config))
    , m_description(m_generator->description())
    , m_skinDescription(m_generator->skinDescription())
    , m_drive(m_description)
    , m_joints(m_config.queueSamples, samplesIn(m_config.batch_s, m_description.nominalRate_Hz))
    , m_skin(m_config.queueBlocks)
    , m_jointsStaleAfter_ns(staleAfter(m_config, m_description.nominalRate_Hz))
    , m_skinStaleAfter_ns(staleAfter(m_config, m_skinDescription.nominalRate_Hz))
    , m_values(m_skinDescription.layout.taxels()) {
}

void SimulatedArmWorker::open(core::Wakeup& consumer) {
    m_drive.begin(m_config.startProgram);
    m_present.store(m_generator->presentObjects(), std::memory_order_relaxed);
    m_joints.open(consumer, now_ns());
    m_skin.open(consumer, now_ns());
}

void SimulatedArmWorker::disconnected() {
    m_drive.begin(false);
    m_jointDiscontinuity = m_skinDiscontinuity = true;
}

std::string SimulatedArmWorker::unpluggedMessage() const {
    return QCoreApplication::translate("SimulatedArmDevice", "The arm was unplugged.").toStdString();
}

std::int64_t SimulatedArmWorker::idle(const SimulatedFaults& faults, std::int64_t now_ns) {
    if (faults.silent)
        obeyStop(now_ns);
    return std::min({faults.silent ? now_ns + kSilentLook_ns : core::PacingClock::kNever_ns,
                     watchAge(m_joints, m_jointsStaleAfter_ns, now_ns),
                     watchAge(m_skin, m_skinStaleAfter_ns, now_ns)});
}

/// An arm that sends nothing still stops, and does not resume by itself when it sends again.
void SimulatedArmWorker::obeyStop(std::int64_t now_ns) {
    if (m_stopSwitch.engaged())
        (void)m_drive.decide(true, m_generator->programDone(), now_ns, m_reference_rad);
    else if (m_drive.drive() == core::ArmDrive::stopped)
        m_drive.begin(false);
}

void SimulatedArmWorker::setState(core::DeviceState state, const std::string& message) {
    const std::int64_t now = now_ns();
    m_joints.setState(state, now, message);
    m_skin.setState(state, now, message);
}

void SimulatedArmWorker::makeDue(const SimulatedFaults& faults, std::int64_t now_ns) {
    const std::int64_t late_ns = now_ns - due_ns(faults.lag_s);
    if (late_ns > toNs(m_config.longestCatchUp_s))
        standStill(late_ns);
    for (std::size_t i = 0; i < kStepsAtOnce && due_ns(faults.lag_s) <= now_ns; ++i)
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
        m_drive.decide(stopped, m_generator->programDone(), now_ns(), m_reference_rad);

    core::JointSample sample;
    m_generator->next(demand, sample);
    m_present.store(m_generator->presentObjects(), std::memory_order_relaxed);
    if (m_generator->isRemote()) {
        count();
        deliverArrivals(faults);
        return;
    }
    const bool hasFrame = m_generator->skinFrame(m_values);
    count();
    m_reference_rad = sample.reference_rad;
    sample.time_ns = now_ns();

    // The skin first: whoever has the sample can then get the frame that was read with it.
    if (hasFrame && happens(faults.dropShare))
        m_skin.lose(1);
    else if (hasFrame)
        deliverFrame(sample.time_ns, m_generator->time_s());
    if (happens(faults.dropShare)) {
        m_joints.lose(1);
        return;
    }
    sample.discontinuity = std::exchange(m_jointDiscontinuity, false);
    m_joints.deliver(std::move(sample));
}

void SimulatedArmWorker::deliverArrivals(const SimulatedFaults& faults) {
    const std::int64_t now = now_ns();
    while (m_generator->takeArrival(m_arrival)) {
        core::JointSample& sample = m_arrival.sample;
        // Steps that catch up share a time: stamps must not run back.
        m_newestRead_ns = std::max(m_newestRead_ns, now - toNs(m_generator->time_s() - sample.sourceTime_s));
        sample.time_ns = m_newestRead_ns;
        m_reference_rad = sample.reference_rad;
        if (m_arrival.hasFrame && happens(faults.dropShare)) {
            m_skin.lose(1);
        } else if (m_arrival.hasFrame) {
            m_values = m_arrival.frame;
            deliverFrame(sample.time_ns, sample.sourceTime_s, now);
        }
        if (happens(faults.dropShare)) {
            m_joints.lose(1);
            continue;
        }
        sample.discontinuity = std::exchange(m_jointDiscontinuity, false);
        m_joints.deliver(std::move(sample), now);
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
