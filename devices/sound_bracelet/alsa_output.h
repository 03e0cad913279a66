// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/sound_bracelet/alsa_stream.h"
#include "devices/sound_bracelet/sound_output.h"

#include <memory>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace teleta::sound {

/// Plays on a card of ALSA directly, where no sound server runs, from a thread that asks for real time.
/// Thread: as SoundOutput.
class AlsaOutput : public SoundOutput {
public:
    /// Error: as openSoundOutput.
    [[nodiscard]] static core::Expected<std::unique_ptr<AlsaOutput>> open(const SoundBraceletFile& file,
                                                                          ToneEngine& engine);

    [[nodiscard]] std::string where() const override { return m_where; }
    [[nodiscard]] double statedLatency_s() const override { return m_statedLatency_s; }

private:
    AlsaOutput(const SoundBraceletFile& file, ToneEngine& engine, AlsaStream stream);
    void run(const std::stop_token& stop);

    ToneEngine& m_engine;
    AlsaStream m_stream;
    std::string m_where;
    double m_statedLatency_s;
    std::vector<float> m_samples; ///< of all tactors, one after the other
    ToneEngine::Outputs m_tactors{};
    std::jthread m_thread; ///< last, so that it ends first
};

} // namespace teleta::sound
