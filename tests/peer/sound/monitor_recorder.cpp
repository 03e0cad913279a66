// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/peer/sound/monitor_recorder.h"

#include "backend/core/steady_time.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace teleta::peer {

MonitorRecorder::MonitorRecorder(std::size_t capacity) {
    for (std::vector<float>& samples : m_samples)
        samples.resize(capacity);
}

MonitorRecorder::~MonitorRecorder() {
    stop();
}

void MonitorRecorder::stop() {
    if (m_client != nullptr)
        m_jack.clientClose(m_client);
    m_client = nullptr;
}

bool MonitorRecorder::start(const std::string& library, const std::array<std::string, kChannels>& ports,
                            std::uint32_t period_frames) {
    auto jack = sound::loadJack(library);
    if (!jack)
        return false;
    m_jack = *jack;
    m_client = m_jack.clientOpen("recorder", sound::kJackNoStartServer, nullptr);
    if (m_client == nullptr)
        return false;
    for (std::size_t i = 0; i < kChannels; ++i) {
        m_ports[i] = m_jack.portRegister(m_client, ("in_" + std::to_string(i + 1)).c_str(), sound::kJackAudio,
                                         sound::kJackPortIsInput, 0);
        if (m_ports[i] == nullptr)
            return false;
    }
    m_jack.setProcess(m_client, process, this);
    m_jack.setXrunCallback(m_client, missed, this);
    m_period_frames = period_frames;
    if (m_jack.bufferSize(m_client) != period_frames)
        m_jack.setBufferSize(m_client, period_frames);
    if (m_jack.activate(m_client) != 0)
        return false;
    for (std::size_t i = 0; i < kChannels; ++i)
        if (m_jack.connect(m_client, ports[i].c_str(), m_jack.portName(m_ports[i])) != 0)
            return false;
    // Until it is called as often as it asked for.
    for (int i = 0; i < 1000 && m_steady.load() < 4; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return m_steady.load() >= 4;
}

std::vector<float> MonitorRecorder::samples(std::size_t channel) const {
    const std::size_t count = m_count.load(std::memory_order_acquire);
    return {m_samples[channel].begin(), m_samples[channel].begin() + static_cast<std::ptrdiff_t>(count)};
}

int MonitorRecorder::process(std::uint32_t frames, void* self) {
    auto& recorder = *static_cast<MonitorRecorder*>(self);
    const std::int64_t now_ns = core::steadyNow_ns();
    const std::size_t at = recorder.m_count.load(std::memory_order_relaxed);
    const std::size_t kept = std::min<std::size_t>(frames, recorder.m_samples[0].size() - at);
    const std::uint32_t begin = recorder.m_jack.frameTime(recorder.m_client);
    if (recorder.m_steady.load() > 0 && begin != recorder.m_nextFrame)
        recorder.m_missed.fetch_add(1);
    recorder.m_nextFrame = begin + frames;
    recorder.m_steady.store(frames == recorder.m_period_frames ? recorder.m_steady.load() + 1 : 0);
    std::size_t silent = frames;
    std::array<const float*, kChannels> inputs{};
    for (std::size_t i = 0; i < kChannels; ++i)
        inputs[i] = static_cast<const float*>(recorder.m_jack.portBuffer(recorder.m_ports[i], frames));
    // A server that ends may give none.
    if (std::ranges::find(inputs, nullptr) != inputs.end())
        return 0;
    for (std::size_t i = 0; i < kChannels; ++i) {
        const float* const samples = inputs[i];
        std::copy_n(samples, kept, recorder.m_samples[i].begin() + static_cast<std::ptrdiff_t>(at));
        for (std::size_t k = frames; k > 0 && frames - k < silent; --k)
            if (samples[k - 1] != 0.0F)
                silent = frames - k;
    }
    recorder.m_count.store(at + kept, std::memory_order_release);
    std::int64_t never = 0;
    if (silent < frames) {
        recorder.m_heardAny.store(true);
        recorder.m_heard_ns.compare_exchange_strong(never, now_ns, std::memory_order_acq_rel);
    }
    recorder.m_silent.store(silent < frames ? silent : recorder.m_silent.load() + frames,
                            std::memory_order_release);
    return 0;
}

int MonitorRecorder::missed(void* self) {
    static_cast<MonitorRecorder*>(self)->m_missed.fetch_add(1);
    return 0;
}

} // namespace teleta::peer
