// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/figure/svg_view.h"

#include "widgets/base/colour_maps.h"
#include "widgets/base/theme.h"

#include <QEvent>
#include <QPainter>
#include <QSvgRenderer>

#include <utility>

namespace teleta::base {

namespace {

figure::SvgColours svgColoursOf(const QPalette& palette) {
    const QColor paper = palette.color(QPalette::Base);
    const QColor ink = palette.color(QPalette::Text);
    figure::SvgColours colours;
    colours.paper = paper.name();
    colours.ink = ink.name();
    colours.soft = mixed(ink, paper, 0.3).name();
    colours.grid = mixed(ink, paper, 0.82).name();
    for (std::size_t i = 0; i < colours.series.size(); ++i)
        colours.series[i] = identityColour(static_cast<int>(i) + 1, isDark(palette)).name();
    return colours;
}

} // namespace

SvgView::SvgView(QWidget* parent)
    : FigureView(parent, {40, 29}, {22, 16}) {
}

SvgView::~SvgView() = default;

void SvgView::setPicture(std::optional<Picture> picture) {
    m_picture = std::move(picture);
    m_renderer.reset();
    setAccessibleName(m_picture ? m_picture->words : QString());
    update();
}

Figure SvgView::figure() {
    Figure figure;
    if (!m_picture)
        return figure;
    figure.name = m_picture->file;
    figure.svg = QByteArray::fromStdString(m_picture->canvas.standalone());
    const auto renderer = std::make_shared<QSvgRenderer>(figure.svg);
    figure.size_px = renderer->defaultSize();
    figure.paint = [renderer, size = figure.size_px](QPainter& painter) {
        renderer->render(&painter, QRectF(QPointF(), size));
    };
    figure.csv = [csv = m_picture->csv] { return csv; };
    return figure;
}

void SvgView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_picture) {
        if (!m_renderer)
            m_renderer = std::make_unique<QSvgRenderer>(
                QByteArray::fromStdString(m_picture->canvas.standalone(svgColoursOf(palette()))));
        const QSizeF size =
            QSizeF(m_renderer->defaultSize()).scaled(QSizeF(this->size()), Qt::KeepAspectRatio);
        QRectF place(QPointF(), size);
        place.moveCenter(QRectF(rect()).center());
        m_renderer->render(&painter, place);
    }
    paintFocusFrame(painter, *this);
}

void SvgView::changeEvent(QEvent* event) {
    FigureView::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        m_renderer.reset();
        update();
    }
}

} // namespace teleta::base
