// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/compose.h"

#include <QToolButton>
#include <QWidget>

#include <cstdint>

namespace teleta::chrome {

/// State of a recording.
struct RecordingReading {
    enum class State { idle, starting, recording, stopping };

    State state = State::idle;
    double duration_s = 0.0;
    std::uint64_t bytes = 0; ///< of the file
    std::uint64_t lost = 0;  ///< frames that could not be written in time
    QString problem;         ///< while idle: why the last recording ended by itself, or did not begin
};

/// Starts, marks and ends a recording; shows a red dot and a word, time, size and losses, and whether the
/// last recording failed. Thread: GUI.
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

    QToolButton* m_record = base::named<QToolButton>("record", this);
    QToolButton* m_mark = base::named<QToolButton>("mark", this);
    RecordingReading m_reading;
};

} // namespace teleta::chrome
