// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <cstdint>

class QToolButton;

namespace teleta::chrome {

/// State of a recording.
struct RecordingReading {
    enum class State { idle, starting, recording, stopping };

    State state = State::idle;
    double duration_s = 0.0;
    std::uint64_t bytes = 0; ///< of the file
    std::uint64_t lost = 0;  ///< frames that could not be written in time
};

/// Starts and ends a recording, and shows its state: a red dot and a word, time, size, losses; with a button
/// for marks. Thread: GUI.
class RecordingIndicator : public QWidget {
    Q_OBJECT

public:
    explicit RecordingIndicator(QWidget* parent = nullptr);

    void setReading(const RecordingReading& reading);
    [[nodiscard]] QString text() const;

signals:
    void toggleRequested();
    void markRequested();

private:
    void describe();
    void restyle();

    QToolButton* m_record;
    QToolButton* m_mark;
    RecordingReading m_reading;
};

} // namespace teleta::chrome
