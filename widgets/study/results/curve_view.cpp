// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/results/curve_view.h"

#include "widgets/base/theme.h"

#include <QPainter>

#include <utility>

namespace teleta::study {

CurveView::CurveView(QWidget* parent)
    : FigureView(parent, {30, 18}, {18, 13}) {
    setFocusPolicy(Qt::NoFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void CurveView::setContent(CurveContent content) {
    m_content = std::move(content);
    setAccessibleName(m_content.title);
    update();
}

base::Figure CurveView::figure() {
    base::Figure figure;
    figure.name = m_content.name;
    figure.size_px = QSizeF(720.0, 420.0);
    figure.paint = [content = m_content, size = figure.size_px, font = font()](QPainter& painter) {
        painter.setFont(font);
        paintCurves(painter, QRectF(QPointF(), size), content, base::designedPalette(false));
    };
    figure.csv = [content = m_content] { return curvesCsv(content); };
    return figure;
}

void CurveView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    paintCurves(painter, rect(), m_content, palette());
}

} // namespace teleta::study
