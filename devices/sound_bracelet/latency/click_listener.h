// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/sound_bracelet/jack_library.h"
#include "devices/sound_bracelet/sound_bracelet_file.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace teleta::sound {

/// Hears when something begins on an input of the sound server on which a bracelet plays: an accelerometer at
/// a tactor, a cable from its output, or the monitor of a sink. A sample in a period counts for the time
///   beginning of the period's callback + (place in the period - capture latency that the server states) /
///   rate
/// Thread: one; the library calls back from its own.
class ClickListener {
public:
    /// The inputs that there are, in the order of the server. Error: refused, ALSA directly has none;
    /// unavailable, the server does not answer. It may take 2 s.
    [[nodiscard]] static core::Expected<std::vector<std::string>> inputs(const SoundBraceletFile& file);
    /// port: as the server names it, "CARD:capture_1". Error: refused, ALSA directly has no such inputs;
    /// unavailable, there is no such input, with those that there are.
    [[nodiscard]] static core::Expected<std::unique_ptr<ClickListener>> open(const SoundBraceletFile& file,
                                                                             const std::string& port);
    ~ClickListener();
    ClickListener(const ClickListener&) = delete;
    ClickListener& operator=(const ClickListener&) = delete;

    /// The largest magnitude of a sample since the last call.
    [[nodiscard]] float takePeak() { return m_peak.exchange(0.0F, std::memory_order_acq_rel); }
    /// From now on it waits for a sample above this magnitude.
    void arm(float threshold);
    /// Steady time of the first sample above it since arm(); 0: none yet.
    [[nodiscard]] std::int64_t heard_ns() const { return m_heard_ns.load(std::memory_order_acquire); }

private:
    ClickListener(JackLibrary jack, JackClient* client);
    /// A client that is not connected to any port yet.
    [[nodiscard]] static core::Expected<std::unique_ptr<ClickListener>>
    connectTo(const SoundBraceletFile& file);
    [[nodiscard]] std::vector<std::string> inputs() const;
    [[nodiscard]] core::Expected<void> start(const SoundBraceletFile& file, const std::string& port);
    static int process(std::uint32_t frames, void* self);

    JackLibrary m_jack;
    JackClient* m_client;
    JackPort* m_port = nullptr;
    double m_rate_Hz = 48'000.0;
    std::atomic<std::uint32_t> m_capture_frames{0};
    std::atomic<float> m_threshold{0.0F};
    std::atomic<bool> m_armed{false};
    std::atomic<float> m_peak{0.0F};
    std::atomic<std::int64_t> m_heard_ns{0};
};

} // namespace teleta::sound
