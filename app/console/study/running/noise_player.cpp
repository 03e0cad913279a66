// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/running/noise_player.h"

#include "backend/study/session/pink_noise.h"
#include "widgets/base/background.h"

#include <QAudioDevice>
#include <QAudioFormat>
#include <QAudioSink>
#include <QMediaDevices>

#include <algorithm>
#include <cstring>
#include <utility>

namespace teleta::console {

namespace {

constexpr int kRate_Hz = 48'000;

} // namespace

LoopedSound::LoopedSound(std::vector<float> samples, QObject* parent)
    : QIODevice(parent)
    , m_samples(std::move(samples)) {
}

qint64 LoopedSound::bytesAvailable() const {
    return static_cast<qint64>(m_samples.size() * sizeof(float)) + QIODevice::bytesAvailable();
}

qint64 LoopedSound::readData(char* data, qint64 most_B) {
    const auto period_B = static_cast<qint64>(m_samples.size() * sizeof(float));
    const char* samples = reinterpret_cast<const char*>(m_samples.data());
    for (qint64 done_B = 0; done_B < most_B;) {
        const qint64 part_B = std::min(most_B - done_B, period_B - m_position_B);
        std::memcpy(data + done_B, samples + m_position_B, static_cast<std::size_t>(part_B));
        done_B += part_B;
        m_position_B = (m_position_B + part_B) % period_B;
    }
    return most_B;
}

qint64 LoopedSound::writeData(const char* /*data*/, qint64 /*size_B*/) {
    return -1;
}

NoisePlayer::NoisePlayer(QObject* parent)
    : QObject(parent) {
}

NoisePlayer::~NoisePlayer() = default;

void NoisePlayer::setPlaying(bool playing) {
    m_wanted = playing;
    if (!playing) {
        m_sink.reset();
        m_sound.reset();
        emit changed();
        return;
    }
    if (m_sink)
        return;
    study::PinkNoiseSettings settings;
    settings.rate_Hz = kRate_Hz;
    base::runInBackground(
        this, [settings] { return study::pinkNoise(settings); },
        [this](core::Expected<std::vector<float>> samples) {
            if (!m_wanted || m_sink)
                return;
            if (samples)
                play(std::move(*samples));
            else
                emit failed(samples.error());
        });
}

void NoisePlayer::play(std::vector<float> samples) {
    QAudioFormat format;
    format.setSampleRate(kRate_Hz);
    format.setChannelCount(1);
    format.setSampleFormat(QAudioFormat::Float);
    const QAudioDevice device = QMediaDevices::defaultAudioOutput();
    if (device.isNull() || !device.isFormatSupported(format)) {
        m_wanted = false;
        emit failed(core::Error{
            core::ErrorKind::unavailable,
            (device.isNull() ? tr("this computer has no sound output")
                             : tr("%1 cannot play 48 kHz", "a sound output").arg(device.description()))
                .toStdString(),
            tr("headphones, plugged in, or the noise from another device").toStdString(),
            {}});
        emit changed();
        return;
    }
    m_sound = std::make_unique<LoopedSound>(std::move(samples));
    m_sound->open(QIODevice::ReadOnly);
    m_sink = std::make_unique<QAudioSink>(device, format);
    connect(m_sink.get(), &QAudioSink::stateChanged, this, [this](QAudio::State state) {
        if (state != QAudio::StoppedState || !m_sink || m_sink->error() == QAudio::NoError)
            return;
        // Queued: not from within the sink's own signal.
        QMetaObject::invokeMethod(
            this,
            [this] {
                setPlaying(false);
                emit failed(core::Error{core::ErrorKind::unavailable,
                                        tr("the sound output stopped").toStdString(),
                                        tr("headphones that stay plugged in").toStdString(),
                                        {}});
            },
            Qt::QueuedConnection);
    });
    m_sink->start(m_sound.get());
    emit changed();
}

} // namespace teleta::console
