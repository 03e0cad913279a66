// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/figure/figure_view.h"

#include "widgets/base/picture_property.h"

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
    setProperty(kPictureProperty, true);
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
