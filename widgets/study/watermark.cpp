// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/watermark.h"

#include "widgets/base/controls/badge.h"
#include "widgets/base/theme.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace teleta::study {

namespace {

struct MarkText {
    Q_DECLARE_TR_FUNCTIONS(StudyWatermark)
};

constexpr double kTilt_deg = -24.0;
constexpr float kOpacity = 0.06F;

} // namespace

QString modeMark(Mode mode) {
    return mode == Mode::run     ? QString()
           : mode == Mode::pilot ? MarkText::tr("PILOT")
                                 : MarkText::tr("SIMULATED");
}

QColor modeColour(Mode mode, const QPalette& palette) {
    const base::StatusColours& colours = base::statusColours(palette);
    return mode == Mode::simulated ? colours.simulated : mode == Mode::pilot ? colours.stale : colours.live;
}

void paintWatermark(QPainter& painter, const QRectF& rect, Mode mode, const QPalette& palette) {
    const QString mark = modeMark(mode);
    if (mark.isEmpty() || rect.isEmpty())
        return;
    if (base::paintsScreen(painter)) {
        const double stripe_px = std::max(2.0, base::kStripe * 0.5 * QFontMetricsF(painter.font()).height());
        painter.fillRect(QRectF(rect.topLeft(), QSizeF(rect.width(), stripe_px)), modeColour(mode, palette));
        return;
    }
    painter.save();
    QFont font = base::bold(painter.font());
    font.setPixelSize(100);
    const double width = QFontMetricsF(font).horizontalAdvance(mark);
    const double size = std::min(0.85 * 100.0 * rect.width() / width, 0.5 * rect.height());
    font.setPixelSize(std::max(8, static_cast<int>(size)));
    painter.setFont(font);
    painter.setPen(base::translucent(modeColour(mode, palette), kOpacity));
    painter.translate(rect.center());
    painter.rotate(kTilt_deg);
    painter.drawText(QRectF(-rect.width(), -rect.height(), 2.0 * rect.width(), 2.0 * rect.height()),
                     Qt::AlignCenter, mark);
    painter.restore();
}

} // namespace teleta::study
