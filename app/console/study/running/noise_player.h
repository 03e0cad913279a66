// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QIODevice>
#include <QObject>
#include <QString>

#include <memory>
#include <vector>

class QAudioSink;

namespace teleta::console {

/// Loops one period of a sound, in 32-bit floats. Thread: the one that reads.
class LoopedSound : public QIODevice {
    Q_OBJECT

public:
    /// samples: not empty.
    explicit LoopedSound(std::vector<float> samples, QObject* parent = nullptr);

    [[nodiscard]] bool isSequential() const override { return true; }
    [[nodiscard]] qint64 bytesAvailable() const override;

protected:
    qint64 readData(char* data, qint64 most_B) override;
    qint64 writeData(const char* data, qint64 size_B) override;

private:
    std::vector<float> m_samples;
    qint64 m_position_B = 0;
};

/// Plays endless pink noise on the system's sound output. The level at the ear has to be measured: the
/// experimenter sets the system's volume and confirms. Thread: GUI; the noise is computed on a pool thread.
class NoisePlayer : public QObject {
    Q_OBJECT

public:
    explicit NoisePlayer(QObject* parent = nullptr);
    ~NoisePlayer() override;

    void setPlaying(bool playing);
    [[nodiscard]] bool isPlaying() const { return m_sink != nullptr; }

signals:
    void changed();
    void failed(const teleta::core::Error& error);

private:
    void play(std::vector<float> samples);

    std::unique_ptr<LoopedSound> m_sound;
    std::unique_ptr<QAudioSink> m_sink;
    bool m_wanted = false;
};

} // namespace teleta::console
