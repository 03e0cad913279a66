// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/vtk/render_queue.h"

#include "backend/core/steady_time.h"

#include <QCoreApplication>
#include <QPointer>

#include <algorithm>

namespace teleta::view3d {

RenderQueue& RenderQueue::instance() {
    static QPointer<RenderQueue> queue;
    if (queue.isNull())
        queue = new RenderQueue(QCoreApplication::instance());
    return *queue;
}

RenderQueue::RenderQueue(QObject* parent)
    : QObject(parent) {
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setObjectName(QStringLiteral("turns"));
    connect(&m_timer, &QTimer::timeout, this, &RenderQueue::serve);
}

void RenderQueue::ask(View& view) {
    m_turns.ask(&view);
    schedule();
}

void RenderQueue::leave(View& view) {
    m_turns.leave(&view);
}

void RenderQueue::drawn(View& view, std::int64_t begun_ns, std::int64_t ended_ns) {
    m_turns.drawn(&view, begun_ns, ended_ns);
    schedule();
}

void RenderQueue::serve() {
    while (auto* view = static_cast<View*>(m_turns.next(core::steadyNow_ns())))
        view->turnHasCome();
    schedule();
}

void RenderQueue::schedule() {
    const auto turn_ns = m_turns.nextTurn_ns();
    if (!turn_ns)
        return;
    // The requesting view is in the middle of a change, so its turn comes through the event loop.
    const std::int64_t wait_ns = std::max<std::int64_t>(*turn_ns - core::steadyNow_ns(), 0);
    const auto wait_ms = static_cast<int>((wait_ns + 999'999) / 1'000'000);
    // Repeated requests do not delay it.
    if (!m_timer.isActive() || m_timer.remainingTime() > wait_ms)
        m_timer.start(wait_ms);
}

} // namespace teleta::view3d
