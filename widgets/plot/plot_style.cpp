// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/plot_style.h"

#include "widgets/base/theme.h"

#include <qcustomplot.h>

#include <algorithm>

namespace teleta::plot {

namespace {

constexpr int kMostTicks = 5;          ///< about as many; QCustomPlot takes up to half as many again
constexpr double kLine_em = 2.0;       ///< of an axis, for a tick
constexpr double kNumber_em = 4.0;     ///< likewise
constexpr double kBesideAxes_em = 4.0; ///< labels, titles and margins

} // namespace

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

void keepTicksApart(QCustomPlot& plot) {
    QObject::connect(&plot, &QCustomPlot::beforeReplot, &plot, [&plot] {
        const double em = QFontMetricsF(plot.yAxis->tickLabelFont()).height();
        const auto count = [em](int length_px, double each_em) {
            return std::clamp(static_cast<int>((length_px / em - kBesideAxes_em) / each_em), 1, kMostTicks);
        };
        plot.yAxis->ticker()->setTickCount(count(plot.viewport().height(), kLine_em));
        plot.xAxis->ticker()->setTickCount(count(plot.viewport().width(), kNumber_em));
    });
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
