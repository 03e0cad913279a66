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

/// The largest place in room that leaves taken free, at most wanted and at least least large; null: there is
/// none. Thread: any (pure).
[[nodiscard]] QRect placeBeside(const QRect& room, const QRect& taken, const QSize& wanted,
                                const QSize& least);

/// Puts the participant's window on a screen of its own, as large as it is. Where there is no other screen,
/// or that screen goes away, the window stands beside the console; where there is no room, over the parts of
/// it that are not needed while a session runs: it must never cover the experimenter's controls. Thread: GUI.
class ParticipantPlacement : public QObject {
    Q_OBJECT

public:
    /// controls: the part of the console that has to be seen and reached. All must outlive it.
    ParticipantPlacement(QWidget& window, QWidget& console, QWidget& controls);

    void show();

signals:
    /// The participant's screen was lost while the window was on it.
    void screenLost();
    /// There is no place in which the window leaves the controls free.
    void consoleCovered();

private:
    void onScreenRemoved(QScreen* screen);
    void showBeside();

    QWidget& m_window;
    QWidget& m_console;
    QWidget& m_controls;
    QPointer<QScreen> m_screen; ///< null: the window is beside the console
};

} // namespace teleta::console
