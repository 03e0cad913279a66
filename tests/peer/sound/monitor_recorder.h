// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/sound_bracelet/jack_library.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace teleta::peer {

/// A second client that records what six outputs play. Thread: one; the library calls back from its own.
class MonitorRecorder {
public:
    static constexpr std::size_t kChannels = 6;

    /// For so many samples a channel; later ones are counted as silent or not, but not kept.
    explicit MonitorRecorder(std::size_t capacity);
    ~MonitorRecorder();
    MonitorRecorder(const MonitorRecorder&) = delete;
    MonitorRecorder& operator=(const MonitorRecorder&) = delete;

    /// library: path. ports: monitor ports that are connected, by name. False: it cannot.
    [[nodiscard]] bool start(const std::string& library, const std::array<std::string, kChannels>& ports,
                             std::uint32_t period_frames);
    void stop();

    /// Of one channel until now.
    [[nodiscard]] std::vector<float> samples(std::size_t channel) const;
    /// Samples since the newest one, on any channel, that was not 0; all when none was.
    [[nodiscard]] std::size_t silentFor() const { return m_silent.load(std::memory_order_acquire); }
    /// Whether there was sound within the newest 1024 samples.
    [[nodiscard]] bool hears() const { return m_heardAny.load() && silentFor() < 1024; }
    /// Steady time of the first callback since arm() with a sample other than 0; 0: none yet.
    void arm() { m_heard_ns.store(0, std::memory_order_release); }
    [[nodiscard]] std::int64_t heard_ns() const { return m_heard_ns.load(std::memory_order_acquire); }
    [[nodiscard]] std::uint64_t missedPeriods() const { return m_missed.load(); }

private:
    static int process(std::uint32_t frames, void* self);
    static int missed(void* self);

    sound::JackLibrary m_jack{};
    sound::JackClient* m_client = nullptr;
    std::array<sound::JackPort*, kChannels> m_ports{};
    std::array<std::vector<float>, kChannels> m_samples;
    std::uint32_t m_period_frames = 0;
    std::uint32_t m_nextFrame = 0;        ///< the callback's own
    std::atomic<std::size_t> m_steady{0}; ///< callbacks with this period in a row
    std::atomic<std::size_t> m_count{0};
    std::atomic<std::size_t> m_silent{0};
    std::atomic<bool> m_heardAny{false};
    std::atomic<std::int64_t> m_heard_ns{0};
    std::atomic<std::uint64_t> m_missed{0};
};

} // namespace teleta::peer
