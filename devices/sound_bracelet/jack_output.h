// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/sound_bracelet/jack_library.h"
#include "devices/sound_bracelet/sound_output.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace teleta::sound {

/// Six mono ports of a JACK client, connected to the outputs of the file, under PipeWire or JACK. Ports, not
/// a stream: a stream of six channels would be taken for 5.1 and mixed.
/// Thread: as SoundOutput; the library calls back from threads of its own.
class JackOutput : public SoundOutput {
public:
    /// Opens with the first library behind which a server answers. Error: as openSoundOutput.
    [[nodiscard]] static core::Expected<std::unique_ptr<JackOutput>> open(const SoundBraceletFile& file,
                                                                          ToneEngine& engine);
    /// Closes the client; its ports go silent.
    ~JackOutput() override;

    void check() override;
    [[nodiscard]] std::string where() const override {
        return (m_file.address.api == SoundApi::pipeWire ? "PipeWire, " : "JACK, ") + m_card;
    }
    [[nodiscard]] double statedLatency_s() const override { return m_statedLatency_s; }

private:
    JackOutput(const SoundBraceletFile& file, ToneEngine& engine, JackLibrary jack, JackClient* client);

    [[nodiscard]] core::Expected<void> start();
    [[nodiscard]] core::Expected<void> findOutputs();
    [[nodiscard]] core::Expected<void> registerPorts();
    void setCallbacks();
    [[nodiscard]] core::Expected<void> connectPorts();
    [[nodiscard]] core::Expected<void> awaitPeriod();
    void readLatency();
    [[nodiscard]] bool isConnected() const;
    [[nodiscard]] bool isShared() const;
    [[nodiscard]] std::vector<std::string> namesOf(const std::string& port) const;

    void countMissedPeriods(std::uint32_t frames);

    static int process(std::uint32_t frames, void* self);
    static int rateChanged(std::uint32_t rate_Hz, void* self);
    static int missedPeriod(void* self);
    static void connectionsChanged(std::uint32_t, std::uint32_t, int, void* self);
    static void ended(void* self);

    SoundBraceletFile m_file;
    ToneEngine& m_engine;
    JackLibrary m_jack;
    JackClient* m_client;
    bool m_active = false;
    std::vector<std::string> m_cardPorts; ///< all outputs of the card, in its order
    std::array<std::string, core::kTactors> m_targets{};
    std::array<std::string, core::kTactors> m_portNames{};
    std::array<JackPort*, core::kTactors> m_ports{};
    std::vector<float> m_unheard; ///< of ports without a buffer
    std::string m_card;
    double m_statedLatency_s = 0.0;
    std::atomic<bool> m_playing{false};       ///< opened: from now on a change is a fault
    std::atomic<bool> m_changed{false};       ///< connections, since the last look
    std::atomic<bool> m_told{false};          ///< of a missed period, since the last callback
    std::optional<std::uint32_t> m_nextFrame; ///< the callback's own: when the next period should begin
};

} // namespace teleta::sound
