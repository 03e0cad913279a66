// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/sound_bracelet/jack_library.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace teleta::peer {

/// A client with an input and an output, "delay:in" and "delay:out": what comes goes out so many samples
/// later. Thread: one; the library calls back from its own.
class SampleDelay {
public:
    explicit SampleDelay(std::size_t samples)
        : m_ring(samples) {}
    ~SampleDelay() {
        if (m_client != nullptr)
            m_jack.clientClose(m_client);
    }
    SampleDelay(const SampleDelay&) = delete;
    SampleDelay& operator=(const SampleDelay&) = delete;

    /// source: the port that is delayed. False: it cannot.
    [[nodiscard]] bool start(const std::string& library, const std::string& source,
                             std::uint32_t period_frames) {
        auto jack = sound::loadJack(library);
        if (!jack)
            return false;
        m_jack = *jack;
        m_client = m_jack.clientOpen("delay", sound::kJackNoStartServer, nullptr);
        if (m_client == nullptr)
            return false;
        m_in = m_jack.portRegister(m_client, "in", sound::kJackAudio, sound::kJackPortIsInput, 0);
        m_out = m_jack.portRegister(m_client, "out", sound::kJackAudio, sound::kJackPortIsOutput, 0);
        m_jack.setProcess(m_client, process, this);
        (void)m_jack.setBufferSize(m_client, period_frames);
        return m_in != nullptr && m_out != nullptr && m_jack.activate(m_client) == 0 &&
               m_jack.connect(m_client, source.c_str(), m_jack.portName(m_in)) == 0;
    }

private:
    static int process(std::uint32_t frames, void* self) {
        auto& line = *static_cast<SampleDelay*>(self);
        const auto* const in = static_cast<const float*>(line.m_jack.portBuffer(line.m_in, frames));
        auto* const out = static_cast<float*>(line.m_jack.portBuffer(line.m_out, frames));
        for (std::uint32_t i = 0; i < frames; ++i) {
            float& place = line.m_ring[line.m_next];
            const float now = in != nullptr ? in[i] : 0.0F;
            if (out != nullptr)
                out[i] = place;
            place = now;
            line.m_next = (line.m_next + 1) % line.m_ring.size();
        }
        return 0;
    }

    sound::JackLibrary m_jack{};
    sound::JackClient* m_client = nullptr;
    sound::JackPort* m_in = nullptr;
    sound::JackPort* m_out = nullptr;
    std::vector<float> m_ring;
    std::size_t m_next = 0;
};

} // namespace teleta::peer
