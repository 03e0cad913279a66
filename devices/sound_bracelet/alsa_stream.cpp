// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/sound_bracelet/alsa_stream.h"

#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>

namespace teleta::sound {

namespace {

struct AlsaText {
    Q_DECLARE_TR_FUNCTIONS(AlsaText)
};

constexpr unsigned kCardPeriods = 2;
constexpr int kLongestWait_ms = 500;
constexpr std::array<snd_pcm_format_t, 3> kFormats{SND_PCM_FORMAT_FLOAT, SND_PCM_FORMAT_S32,
                                                   SND_PCM_FORMAT_S16};

/// ALSA's own texts would go to the terminal, in the middle of a table.
void ignoreAlsaText(const char*, int, const char*, int, const char*, ...) {
}

core::Unexpected notOpened(const SoundBraceletFile& file, int error) {
    const QString name = QString::fromStdString(file.address.name);
    if (error == -EBUSY)
        return core::refused(AlsaText::tr("Another program plays on %1.").arg(name),
                             AlsaText::tr("it to be closed there first"));
    return core::failed(core::ErrorKind::unavailable,
                        AlsaText::tr("The sound card %1 cannot be opened: %2")
                            .arg(name, QString::fromLocal8Bit(snd_strerror(error))));
}

/// Whether others can play on it as well: plugins that mix, and those that lead to a sound server.
bool mixes(snd_pcm_t* pcm) {
    const snd_pcm_type_t type = snd_pcm_type(pcm);
    return type == SND_PCM_TYPE_DMIX || type == SND_PCM_TYPE_SHARE || type == SND_PCM_TYPE_IOPLUG;
}

template <typename Integer>
Integer scaled(float sample) {
    constexpr double kLargest = std::numeric_limits<Integer>::max();
    return static_cast<Integer>(std::lround(std::clamp(static_cast<double>(sample), -1.0, 1.0) * kLargest));
}

} // namespace

void putSample(snd_pcm_format_t format, float sample, std::size_t number, std::vector<std::byte>& samples) {
    const auto store = [&](auto value) {
        std::memcpy(&samples[number * sizeof value], &value, sizeof value);
    };
    if (format == SND_PCM_FORMAT_FLOAT)
        store(sample);
    else if (format == SND_PCM_FORMAT_S32)
        store(scaled<std::int32_t>(sample));
    else
        store(scaled<std::int16_t>(sample));
}

core::Expected<AlsaStream> AlsaStream::open(const SoundBraceletFile& file) {
    snd_lib_error_set_handler(ignoreAlsaText);
    AlsaStream stream;
    snd_pcm_t* pcm = nullptr;
    // A busy card would keep the opening waiting.
    if (const int error =
            snd_pcm_open(&pcm, file.address.name.c_str(), SND_PCM_STREAM_PLAYBACK, SND_PCM_NONBLOCK);
        error < 0)
        return notOpened(file, error);
    stream.m_pcm.reset(pcm);
    if (!file.shared && mixes(pcm))
        return core::refused(AlsaText::tr("Other programs can play on %1 as well.")
                                 .arg(QString::fromStdString(file.address.name)),
                             AlsaText::tr("the card itself, as alsa:hw:CARD=NAME, or shared = true in the "
                                          "device file"));
    TELETA_CHECK(stream.choose(file));
    if (!stream.setSilence() || snd_pcm_nonblock(pcm, 0) < 0 || snd_pcm_prepare(pcm) < 0)
        return notOpened(file, -EIO);
    return stream;
}

core::Expected<void> AlsaStream::choose(const SoundBraceletFile& file) {
    snd_pcm_t* pcm = m_pcm.get();
    snd_pcm_hw_params_t* hardware = nullptr;
    snd_pcm_hw_params_alloca(&hardware);
    if (const int error = snd_pcm_hw_params_any(pcm, hardware); error < 0)
        return notOpened(file, error);
    (void)snd_pcm_hw_params_set_rate_resample(pcm, hardware, 0);
    const auto format = std::ranges::find_if(kFormats, [&](snd_pcm_format_t one) {
        return snd_pcm_hw_params_test_format(pcm, hardware, one) == 0;
    });
    if (format == kFormats.end() ||
        snd_pcm_hw_params_set_access(pcm, hardware, SND_PCM_ACCESS_RW_INTERLEAVED) < 0 ||
        snd_pcm_hw_params_set_format(pcm, hardware, *format) < 0)
        return core::refused(AlsaText::tr("The sound card takes none of the known formats."),
                             QStringLiteral("FLOAT, S32, S16"));
    m_format = *format;
    if (snd_pcm_hw_params_set_rate(pcm, hardware, file.sampleRate_Hz, 0) < 0)
        return core::refused(
            AlsaText::tr("The sound card does not play %1 samples a second.").arg(file.sampleRate_Hz),
            AlsaText::tr("another sample_rate_Hz in the device file"));
    unsigned most = 0;
    (void)snd_pcm_hw_params_get_channels_max(hardware, &most);
    // A card may have fixed numbers of channels, and all of them count.
    m_channels = *std::ranges::max_element(file.channels);
    if (snd_pcm_hw_params_set_channels_min(pcm, hardware, &m_channels) < 0 ||
        snd_pcm_hw_params_set_channels_first(pcm, hardware, &m_channels) < 0)
        return core::refused(
            AlsaText::tr("The sound card has %n output(s).", nullptr, static_cast<int>(most)),
            AlsaText::tr("an output %1, as channels says").arg(*std::ranges::max_element(file.channels)));
    int direction = 0;
    m_period_frames = file.period_frames;
    m_periods = kCardPeriods;
    if (snd_pcm_hw_params_set_period_size(pcm, hardware, m_period_frames, direction) < 0 ||
        snd_pcm_hw_params_set_periods_near(pcm, hardware, &m_periods, &direction) < 0 ||
        snd_pcm_hw_params(pcm, hardware) < 0)
        return core::refused(
            AlsaText::tr("The sound card does not take %1 samples at a time.").arg(file.period_frames),
            AlsaText::tr("another period_frames in the device file"));
    std::ranges::transform(file.channels, m_outputs.begin(), [](std::uint32_t output) { return output - 1; });
    m_period.resize(static_cast<std::size_t>(
        snd_pcm_frames_to_bytes(pcm, static_cast<snd_pcm_sframes_t>(m_period_frames))));
    return {};
}

bool AlsaStream::setSilence() {
    snd_pcm_t* pcm = m_pcm.get();
    snd_pcm_sw_params_t* software = nullptr;
    snd_pcm_sw_params_alloca(&software);
    snd_pcm_uframes_t buffer_frames = 0;
    snd_pcm_uframes_t period_frames = 0;
    snd_pcm_uframes_t boundary_frames = 0;
    return snd_pcm_get_params(pcm, &buffer_frames, &period_frames) == 0 &&
           snd_pcm_sw_params_current(pcm, software) == 0 &&
           snd_pcm_sw_params_get_boundary(software, &boundary_frames) == 0 &&
           // Starts full; stops empty, so that nothing is played twice.
           snd_pcm_sw_params_set_start_threshold(pcm, software, buffer_frames) == 0 &&
           snd_pcm_sw_params_set_stop_threshold(pcm, software, buffer_frames) == 0 &&
           // All of the buffer that was not written, which ALSA calls a size of the boundary.
           snd_pcm_sw_params_set_silence_threshold(pcm, software, 0) == 0 &&
           snd_pcm_sw_params_set_silence_size(pcm, software, boundary_frames) == 0 &&
           snd_pcm_sw_params_set_avail_min(pcm, software, m_period_frames) == 0 &&
           snd_pcm_sw_params(pcm, software) == 0;
}

AlsaStream::Written AlsaStream::write(const ToneEngine::Outputs& tactors) {
    for (std::size_t frame = 0; frame < m_period_frames; ++frame)
        for (std::size_t i = 0; i < core::kTactors; ++i)
            putSample(m_format, tactors[i][frame], frame * m_channels + m_outputs[i], m_period);
    const std::size_t frameBytes = m_period.size() / m_period_frames;
    snd_pcm_uframes_t done = 0;
    while (done < m_period_frames) {
        // With room for a period, what follows does not wait. A card that has none for so long is stuck.
        if (snd_pcm_wait(m_pcm.get(), kLongestWait_ms) == 0)
            return Written::gone;
        const snd_pcm_sframes_t written =
            snd_pcm_writei(m_pcm.get(), m_period.data() + done * frameBytes, m_period_frames - done);
        if (written == -EPIPE)
            return snd_pcm_prepare(m_pcm.get()) < 0 ? Written::gone : Written::late;
        if (written < 0 && written != -EINTR && written != -EAGAIN)
            return Written::gone;
        done += static_cast<snd_pcm_uframes_t>(std::max<snd_pcm_sframes_t>(written, 0));
    }
    return Written::period;
}

void AlsaStream::drop() {
    (void)snd_pcm_drop(m_pcm.get());
}

} // namespace teleta::sound
