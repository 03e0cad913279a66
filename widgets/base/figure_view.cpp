// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/figure_view.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>

namespace teleta::base {

FigureView::FigureView(QWidget* parent)
    : QWidget(parent)
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
