// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/figure_view.h"

#include "widgets/base/theme.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QToolTip>

namespace teleta::base {

FigureView::FigureView(QWidget* parent, QSizeF usual_em, QSizeF smallest_em)
    : SizedView(parent, usual_em, smallest_em)
    , m_export(this, [this] { return figure(); }) {
    setFocusPolicy(Qt::StrongFocus);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    connect(&m_export, &FigureExport::saved, this, &FigureView::exported);
    connect(&m_export, &FigureExport::failed, this, &FigureView::exportFailed);
}

void FigureView::populateMenu(QMenu& menu, const QPoint& position) {
    addOwnActions(menu, position);
    if (!menu.isEmpty())
        menu.addSeparator();
    m_export.addActions(menu);
}

void FigureView::addOwnActions(QMenu& /*menu*/, const QPoint& /*position*/) {
}

void FigureView::setSizes_em(const QSizeF& preferred, const QSizeF& smallest) {
    m_preferred_em = preferred;
    m_smallest_em = smallest;
}

QSize FigureView::sizeHint() const {
    return m_preferred_em ? QSize(em(this, m_preferred_em->width()), em(this, m_preferred_em->height()))
                          : QWidget::sizeHint();
}

QSize FigureView::minimumSizeHint() const {
    return m_smallest_em ? QSize(em(this, m_smallest_em->width()), em(this, m_smallest_em->height()))
                         : QWidget::minimumSizeHint();
}

QString FigureView::toolTipAt(const QPointF& /*point*/) const {
    return toolTip();
}

bool FigureView::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    if (const QString text = toolTipAt(help->pos()); text.isEmpty())
        QToolTip::hideText();
    else
        QToolTip::showText(help->globalPos(), text, this);
    return true;
}

void FigureView::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy))
        copyPicture(figure());
    else
        QWidget::keyPressEvent(event);
}

void FigureView::contextMenuEvent(QContextMenuEvent* event) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    populateMenu(*menu, event->pos());
    menu->popup(event->globalPos());
}

} // namespace teleta::base
