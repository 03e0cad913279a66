// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QLabel>
#include <QWidget>

namespace teleta::chrome {

/// What engaged STOP.
enum class StopCause {
    button,
    keys,    ///< Ctrl and the full stop
    escape,  ///< Esc, twice
    program, ///< not a person at this window
};

/// A red line across every page while STOP is engaged: since when, by what, and how to go on. Thread: GUI.
class StopBanner : public QWidget {
    Q_OBJECT

public:
    explicit StopBanner(QWidget* parent = nullptr);

    /// Shows it with this cause and time.
    void engage(StopCause cause, const QDateTime& since);
    void release();

    /// What engaged STOP, as a sentence, for the log too.
    [[nodiscard]] static QString sentence(StopCause cause);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();
    void restyle();

    QLabel* m_what = new QLabel(this);
    QLabel* m_next = new QLabel(this);
    StopCause m_cause = StopCause::program;
    QDateTime m_since;
};

} // namespace teleta::chrome
