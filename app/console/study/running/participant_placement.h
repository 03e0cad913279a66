// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QRect>

class QScreen;
class QWidget;

namespace teleta::console {

/// Index of the participant's screen: not the console's; of the others the rightmost, then the lowest; -1:
/// none. screens: their geometries. Thread: any (pure).
[[nodiscard]] int participantScreen(const QList<QRect>& screens, int console);

/// The largest rectangle in `room` outside `taken`, at most `wanted` and at least `least`; null: none.
/// Thread: any (pure).
[[nodiscard]] QRect placeBeside(const QRect& room, const QRect& taken, const QSize& wanted,
                                const QSize& least);

/// Shows the participant's window full-size on a second screen. Without one, or when it is disconnected, the
/// window goes next to the console, or, without room there, over parts of the console that a running session
/// does not need: it must never cover the experimenter's controls. Thread: GUI.
class ParticipantPlacement : public QObject {
    Q_OBJECT

public:
    /// controls: the part of the console that must stay visible. All must outlive it.
    ParticipantPlacement(QWidget& window, QWidget& console, QWidget& controls);

    void show();

signals:
    /// The participant's screen was disconnected while the window was on it.
    void screenLost();
    /// There is no place that leaves the controls free.
    void consoleCovered();

private:
    void onScreenRemoved(QScreen* screen);
    void showBeside();
    void stayAbove(bool above);

    QWidget& m_window;
    QWidget& m_console;
    QWidget& m_controls;
    QPointer<QScreen> m_screen; ///< null: the window is next to the console
};

} // namespace teleta::console
