// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/controls/badge.h"

#include "widgets/base/theme.h"

#include <QFontMetricsF>
#include <QPainter>

namespace teleta::base {

namespace {

QFont badgeFont(const QFont& font) {
    return bold(sized(font, kSmallText));
}

} // namespace

QString provenanceText(Provenance provenance) {
    return provenance == Provenance::simulated   ? QCoreApplication::translate("Provenance", "SIMULATED")
           : provenance == Provenance::recorded  ? QCoreApplication::translate("Provenance", "RECORDED")
           : provenance == Provenance::unguarded ? QCoreApplication::translate("Provenance", "UNGUARDED")
           : provenance == Provenance::recordedSimulation
               ? QCoreApplication::translate("Provenance", "RECORDED SIMULATION")
               : QString();
}

QColor provenanceColour(Provenance provenance, const QPalette& palette) {
    const StatusColours& colours = statusColours(palette);
    return provenance == Provenance::recorded    ? colours.recorded
           : provenance == Provenance::live      ? colours.neutral
           : provenance == Provenance::unguarded ? colours.lost
                                                 : colours.simulated;
}

bool paintsScreen(const QPainter& painter) {
    // Charts are painted into a pixmap first.
    const int kind = painter.device()->devType();
    return kind == QInternal::Widget || kind == QInternal::Pixmap;
}

QSizeF badgeSize(const QFont& font, const QString& text) {
    const QFontMetricsF metrics(badgeFont(font));
    return {metrics.horizontalAdvance(text) + metrics.height(), metrics.height() * 1.25};
}

void paintBadge(QPainter& painter, const QRectF& rect, const QString& text, const QColor& colour) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    const double radius = 0.2 * rect.height();
    painter.drawRoundedRect(rect, radius, radius);
    painter.setFont(badgeFont(painter.font()));
    painter.setPen(readableOn(colour));
    painter.drawText(rect, Qt::AlignCenter, text);
    painter.restore();
}

QRectF paintProvenance(QPainter& painter, const QRectF& line, Provenance provenance, const QPalette& palette,
                       double gap) {
    const QString text = provenanceText(provenance);
    if (text.isEmpty() || paintsScreen(painter))
        return line;
    const QSizeF size = badgeSize(painter.font(), text);
    const QPointF corner(line.right() - size.width(), line.center().y() - 0.5 * size.height());
    paintBadge(painter, QRectF(corner, size), text, provenanceColour(provenance, palette));
    return line.adjusted(0.0, 0.0, -size.width() - gap, 0.0);
}

} // namespace teleta::base
