// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/stop_switch.h"

#include <QObject>

#include <functional>

namespace teleta::console {

/// Ends the console when nobody can be asked: the signals TERM, INT and HUP, the end of the desktop's
/// session, and a display that is gone. One object per program; it comes after the QApplication.
///   - A signal engages STOP in its handler, whatever the GUI does just then, and asks it to leave. A GUI
///   that
///     does not leave within 10 s is ended. A signal that was ignored when the program began stays ignored.
///   - The session manager's wish to save engages STOP and calls secure(); its wish to end calls leave().
///   - Qt and Xlib end the program when its display is gone. secure() is called before they do.
/// Thread: GUI.
class SuddenEnd : public QObject {
    Q_OBJECT

public:
    struct Actions {
        /// Ends the program's event loop in good order, without questions.
        std::function<void()> leave;
        /// Brings what moves to rest and completes what is written, and waits for both. It is called at most
        /// twice, may find the display gone, and so must not touch a widget.
        std::function<void()> secure;
    };

    SuddenEnd(core::StopSwitch& stop, Actions actions, QObject* parent = nullptr);
    ~SuddenEnd() override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void leave();
    void secure();
    /// False: there is nothing to secure. On another thread it waits for the GUI to do it.
    static bool whenDisplayIsGone();

    core::StopSwitch& m_stop;
    Actions m_actions;
    bool m_sessionEnds = false;
    bool m_leaves = false;
};

} // namespace teleta::console
