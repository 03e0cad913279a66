// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/sound_bracelet/sound_bracelet_port.h"

#include "backend/core/steady_time.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace teleta::sound {

namespace {

constexpr double kHighestRate_Hz = 200.0;
constexpr std::int64_t kLeastSilence_ns = 500'000'000;
constexpr double kSilentPeriods = 10.0;
constexpr std::int64_t kLongestRamp_ns = 100'000'000;

/// The same for the same tactors, whatever else the file says.
std::string serialOf(const SoundBraceletFile& file) {
    std::string serial = file.device + '#';
    for (std::size_t i = 0; i < core::kTactors; ++i)
        serial += (i > 0 ? "-" : "") + std::to_string(file.channels[i]);
    return serial;
}

} // namespace

SoundBraceletPort::SoundBraceletPort(std::unique_ptr<ToneEngine> engine, std::unique_ptr<SoundOutput> output,
                                     double period_s)
    : m_engine(std::move(engine))
    , m_output(std::move(output))
    , m_longestSilence_ns(
          std::max(kLeastSilence_ns, static_cast<std::int64_t>(kSilentPeriods * period_s * 1e9))) {
}

SoundBraceletPort::~SoundBraceletPort() {
    const std::int64_t end_ns = core::steadyNow_ns() + kLongestRamp_ns;
    m_engine->set({});
    while (m_engine->isAudible() && !isBroken() && core::steadyNow_ns() < end_ns)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

bool SoundBraceletPort::write(std::uint16_t sequence, const core::Drive& drive, std::uint16_t timeout_ms) {
    if (isBroken())
        return false;
    m_engine->set({.drive = drive,
                   .written_ns = core::steadyNow_ns(),
                   .timeout_ns = std::int64_t{timeout_ms} * 1'000'000,
                   .sequence = sequence});
    return true;
}

core::BraceletPort::Read SoundBraceletPort::read(core::BoardReport& report) {
    if (isBroken())
        return Read::lost;
    PlayedFrame frame;
    if (!m_engine->played(frame))
        return Read::nothing;
    const CallbackCost cost = m_engine->cost();
    report = {.sequence = frame.sequence, .driving = frame.driving, .timedOut = frame.timedOut};
    report.sound = core::SoundReport{.played_ns = frame.played_ns,
                                     .meanShare = cost.meanShare,
                                     .longestShare = cost.longestShare,
                                     .missedPeriods = cost.missedPeriods};
    return Read::report;
}

std::string SoundBraceletPort::failure() const {
    const SoundFault fault = m_engine->fault();
    return fault == SoundFault::none ? std::string() : describe(fault);
}

bool SoundBraceletPort::isBroken() {
    if (m_engine->fault() == SoundFault::none) {
        m_output->check();
        if (core::steadyNow_ns() - m_engine->called_ns() > m_longestSilence_ns)
            m_engine->fail(SoundFault::callbacksStopped);
    }
    return m_engine->fault() != SoundFault::none;
}

core::Expected<core::OpenedBracelet> openSoundBraceletPort(const SoundBraceletFile& file,
                                                           const core::StopSwitch& stopSwitch,
                                                           const OutputOpener& opener) {
    auto engine = std::make_unique<ToneEngine>(file.tones, file.sampleRate_Hz, stopSwitch);
    TELETA_TRY(auto output, opener(file, *engine));
    core::BraceletDescription description;
    description.name = file.name;
    description.model = output->where();
    description.serial = serialOf(file);
    description.maximumRate_Hz = std::min(kHighestRate_Hz, 1.0 / file.period_s());
    description.statedLatency_s = output->statedLatency_s();
    if (file.latency_ms)
        description.measuredLatency_s = 1e-3 * *file.latency_ms;
    if (file.latencySpread_ms)
        description.latencySpread_s = 1e-3 * *file.latencySpread_ms;
    return core::OpenedBracelet{
        std::make_unique<SoundBraceletPort>(std::move(engine), std::move(output), file.period_s()),
        std::move(description)};
}

} // namespace teleta::sound
