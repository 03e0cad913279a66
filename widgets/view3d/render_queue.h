// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/render_turns.h"

#include <QObject>
#include <QTimer>

class QWidget;

namespace teleta::view3d {

/// The line in which all OpenGL views of the program wait for their repaint, in the turns of RenderTurns.
/// Thread: GUI.
class RenderQueue : public QObject {
public:
    /// The one of the program; made with the first call.
    static RenderQueue& instance();

    /// Calls view.update() when it is the view's turn: at once when nobody draws much.
    void ask(QWidget& view);
    void leave(QWidget& view);
    void drawn(QWidget& view, std::int64_t begun_ns, std::int64_t ended_ns);

private:
    explicit RenderQueue(QObject* parent);
    void serve();

    RenderTurns m_turns;
    QTimer m_timer;
};

} // namespace teleta::view3d
