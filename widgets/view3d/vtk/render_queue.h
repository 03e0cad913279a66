// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/vtk/render_turns.h"

#include <QObject>
#include <QTimer>

namespace teleta::view3d {

/// Queue in which all OpenGL views of the program wait to draw, in the order of RenderTurns. Thread: GUI.
class RenderQueue : public QObject {
public:
    class View {
    public:
        /// Called from the event loop.
        virtual void turnHasCome() = 0;

    protected:
        ~View() = default;
    };

    /// The program's queue, created by the first call.
    static RenderQueue& instance();

    /// Calls view.turnHasCome() when it is the view's turn: soon if little is drawn.
    void ask(View& view);
    void leave(View& view);
    void drawn(View& view, std::int64_t begun_ns, std::int64_t ended_ns);

private:
    explicit RenderQueue(QObject* parent);
    void serve();
    void schedule();

    RenderTurns m_turns;
    QTimer m_timer;
};

} // namespace teleta::view3d
