// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/signal/signal_drop_area.h"

#include "widgets/signal/signals_mime.h"

#include <QDragEnterEvent>
#include <QPainter>

namespace teleta::signal {

namespace {

constexpr int kFrame_px = 2;

} // namespace

SignalDropArea::SignalDropArea(QWidget* parent)
    : QWidget(parent) {
    setAcceptDrops(true);
    setContentsMargins(kFrame_px, kFrame_px, kFrame_px, kFrame_px);
}

void SignalDropArea::setTarget(bool isTarget) {
    m_isTarget = isTarget;
    update();
}

void SignalDropArea::dragEnterEvent(QDragEnterEvent* event) {
    // Files go to the window.
    if (signalsOf(*event->mimeData()).empty())
        return;
    event->acceptProposedAction();
    setTarget(true);
}

void SignalDropArea::dragLeaveEvent(QDragLeaveEvent* /*event*/) {
    setTarget(false);
}

void SignalDropArea::dropEvent(QDropEvent* event) {
    setTarget(false);
    const std::vector<SignalId> ids = signalsOf(*event->mimeData());
    if (ids.empty())
        return;
    event->acceptProposedAction();
    emit dropped(ids);
}

void SignalDropArea::paintEvent(QPaintEvent* /*event*/) {
    if (!m_isTarget)
        return;
    QPainter painter(this);
    painter.setPen(QPen(palette().color(QPalette::Highlight), kFrame_px));
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

} // namespace teleta::signal
