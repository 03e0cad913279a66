// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/plot_style.h"

#include "widgets/base/theme.h"

#include <qcustomplot.h>

namespace teleta::plot {

QColor gridColour(const QPalette& colours) {
    return base::mixed(colours.color(QPalette::Base), colours.color(QPalette::Text), 0.15);
}

void styleAxis(QCPAxis& axis, const QPalette& colours, const QFont& font) {
    const QColor text = colours.color(QPalette::Text);
    const QPen grid(gridColour(colours));
    axis.setBasePen(QPen(text));
    axis.setTickPen(QPen(text));
    axis.setTickLabelColor(text);
    axis.setLabelColor(text);
    axis.setLabelFont(font);
    axis.setTickLabelFont(font);
    axis.grid()->setPen(grid);
    axis.grid()->setZeroLinePen(grid);
}

void stylePlot(QCustomPlot& plot, const QPalette& colours, const QFont& font) {
    plot.setBackground(colours.color(QPalette::Base));
    for (QCPAxis* axis : {plot.xAxis, plot.yAxis})
        styleAxis(*axis, colours, font);
}

QPicture pictureOf(QCustomPlot& plot) {
    QPicture picture;
    QCPPainter painter;
    painter.begin(&picture);
    painter.setMode(QCPPainter::pmVectorized);
    plot.toPainter(&painter, plot.width(), plot.height());
    return picture;
}

QString libraryVersion() {
    return QStringLiteral(QCUSTOMPLOT_VERSION_STR);
}

} // namespace teleta::plot
