// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/render_queue.h"

#include "backend/core/steady_time.h"

#include <QCoreApplication>
#include <QPointer>
#include <QWidget>

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
    connect(&m_timer, &QTimer::timeout, this, &RenderQueue::serve);
}

void RenderQueue::ask(QWidget& view) {
    m_turns.ask(&view);
    serve();
}

void RenderQueue::leave(QWidget& view) {
    m_turns.leave(&view);
}

void RenderQueue::drawn(QWidget& view, std::int64_t begun_ns, std::int64_t ended_ns) {
    m_turns.drawn(&view, begun_ns, ended_ns);
    serve();
}

void RenderQueue::serve() {
    const std::int64_t now_ns = core::steadyNow_ns();
    while (auto* view = static_cast<QWidget*>(m_turns.next(now_ns)))
        view->update();
    if (const auto turn_ns = m_turns.nextTurn_ns())
        m_timer.start(static_cast<int>(std::max<std::int64_t>(*turn_ns - now_ns, 0) / 1'000'000 + 1));
}

} // namespace teleta::view3d
