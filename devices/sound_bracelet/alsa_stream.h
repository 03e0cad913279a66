// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/sound_bracelet/sound_bracelet_file.h"
#include "devices/sound_bracelet/tone_engine.h"

#include <alsa/asoundlib.h>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace teleta::sound {

/// Writes one sample, -1 .. 1, in a format that the stream knows (FLOAT, S32 or S16, of this machine's byte
/// order), to the place of the sample with that number.
void putSample(snd_pcm_format_t format, float sample, std::size_t number, std::vector<std::byte>& samples);

/// A PCM of ALSA, opened with exactly the rate and the period of the file, without resampling. Outputs that
/// belong to no tactor get zeros. A buffer that runs empty stops the card, and what was not written is
/// silence, so that a program that was killed leaves nothing playing. Thread: one at a time.
class AlsaStream {
public:
    enum class Written {
        period,
        late, ///< the card had run empty; it is ready for the next period
        gone,
    };

    /// Error: as openSoundOutput.
    [[nodiscard]] static core::Expected<AlsaStream> open(const SoundBraceletFile& file);

    /// Plays one period of the six tactors; waits until the card has room.
    [[nodiscard]] Written write(const ToneEngine::Outputs& tactors);
    /// Silent at once.
    void drop();

    /// Periods that the card holds.
    [[nodiscard]] unsigned periods() const { return m_periods; }
    /// Outputs that the card has.
    [[nodiscard]] unsigned channels() const { return m_channels; }

private:
    struct Close {
        void operator()(snd_pcm_t* pcm) const { snd_pcm_close(pcm); }
    };
    AlsaStream() = default;
    [[nodiscard]] core::Expected<void> choose(const SoundBraceletFile& file);
    [[nodiscard]] bool setSilence();

    std::unique_ptr<snd_pcm_t, Close> m_pcm;
    std::array<std::uint32_t, core::kTactors> m_outputs{}; ///< of the tactors, from 0
    unsigned m_channels = 0;
    unsigned m_periods = 0;
    snd_pcm_uframes_t m_period_frames = 0;
    snd_pcm_format_t m_format = SND_PCM_FORMAT_FLOAT;
    std::vector<std::byte> m_period; ///< interleaved
};

} // namespace teleta::sound
