// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QRect>

class QScreen;
class QWidget;

namespace teleta::console {

/// Which of several screens is the participant's: another one than the console's, the one that lies furthest
/// to the right, then furthest down; -1: there is none. screens: their geometries. Thread: any (pure).
[[nodiscard]] int participantScreen(const QList<QRect>& screens, int console);

/// Puts the participant's window on a screen of its own, as large as it is, and brings it back beside the
/// console when that screen goes away: it must never cover the experimenter's. Thread: GUI.
class ParticipantPlacement : public QObject {
    Q_OBJECT

public:
    /// Both must outlive it.
    ParticipantPlacement(QWidget& window, QWidget& console);

    void show();

signals:
    /// The participant's screen was lost while the window was on it.
    void screenLost();

private:
    void onScreenRemoved(QScreen* screen);
    void showBeside();

    QWidget& m_window;
    QWidget& m_console;
    QPointer<QScreen> m_screen; ///< null: the window is beside the console
};

} // namespace teleta::console
