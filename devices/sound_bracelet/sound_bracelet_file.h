// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/tactors.h"
#include "backend/core/error.h"
#include "backend/core/keys/keys.h"
#include "devices/sound_bracelet/tone_voice.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace teleta::sound {

/// Through what the samples reach the card.
enum class SoundApi {
    pipeWire, ///< PipeWire's own JACK library
    jack,     ///< the JACK library of the system
    alsa,
};

/// Which outputs, as a person writes it: pipewire, pipewire:NODE, jack, jack:CLIENT or alsa:PCM.
struct SoundAddress {
    SoundApi api = SoundApi::pipeWire;
    std::string name; ///< node, client or PCM; empty: the only card that there is

    bool operator==(const SoundAddress&) const = default;
};

/// Voice coils on the outputs of a sound card, as their TOML file describes them.
struct SoundBraceletFile {
    std::string name;
    std::string device; ///< what `address` was read from
    SoundAddress address;
    std::uint32_t sampleRate_Hz = 48'000; ///< 44100, 48000 or 96000
    std::uint32_t period_frames = 128;    ///< a power of two
    /// Output of each tactor, counted from 1; all different.
    std::array<std::uint32_t, core::kTactors> channels{1, 2, 3, 4, 5, 6};
    std::array<ToneSettings, core::kTactors> tones{};
    bool shared = false; ///< other programs may play on the card as well
    /// From a frame to what it moves, as it was measured, and how much it varies; nothing: nobody did.
    std::optional<double> latency_ms{};
    std::optional<double> latencySpread_ms{};

    bool operator==(const SoundBraceletFile&) const = default;

    void describeKeys(core::Keys& keys);

    [[nodiscard]] double period_s() const {
        return static_cast<double>(period_frames) / static_cast<double>(sampleRate_Hz);
    }
};

/// Error: notFound, ioFailed, badInput with file, line and column. Thread: any.
[[nodiscard]] core::Expected<SoundBraceletFile> readSoundBracelet(const std::string& path);
/// The same of a text; file: named in errors.
[[nodiscard]] core::Expected<SoundBraceletFile> parseSoundBracelet(std::string_view text,
                                                                   const std::string& file);

} // namespace teleta::sound
