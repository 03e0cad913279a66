// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/numbers/tabular_text.h"

#include <QPainter>

#include <algorithm>

namespace teleta::base {

namespace {

bool isCell(QChar c) {
    return (c >= u'0' && c <= u'9') || c == kFigureSpace;
}

struct Cell {
    double width = 0.0;
    bool evenDigits = true;
};

Cell cellOf(const QFontMetricsF& metrics) {
    Cell cell;
    cell.width = metrics.horizontalAdvance(u'0');
    for (char16_t digit = u'1'; digit <= u'9'; ++digit) {
        const double width = metrics.horizontalAdvance(QChar(digit));
        cell.evenDigits = cell.evenDigits && width == cell.width;
        cell.width = std::max(cell.width, width);
    }
    return cell;
}

/// Calls visit(run, width, isOneCell) for each digit cell and each run of other characters.
template <typename Visit>
void forEachRun(const QFontMetricsF& metrics, const Cell& cell, const QString& text, Visit&& visit) {
    qsizetype i = 0;
    while (i < text.size()) {
        if (isCell(text[i])) {
            visit(text.mid(i, 1), cell.width, true);
            ++i;
            continue;
        }
        qsizetype end = i;
        while (end < text.size() && !isCell(text[end]))
            ++end;
        const QString run = text.mid(i, end - i);
        visit(run, metrics.horizontalAdvance(run), false);
        i = end;
    }
}

} // namespace

double tabularWidth(const QFontMetricsF& metrics, const QString& text) {
    double width = 0.0;
    forEachRun(metrics, cellOf(metrics), text, [&width](const QString&, double run, bool) { width += run; });
    return width;
}

void drawTabularText(QPainter& painter, const QRectF& rect, Qt::Alignment alignment, const QString& text) {
    const QFontMetricsF metrics(painter.font());
    const Cell cell = cellOf(metrics);
    double x = rect.left();
    const double width = tabularWidth(metrics, text);
    if (alignment.testFlag(Qt::AlignRight))
        x = rect.right() - width;
    else if (alignment.testFlag(Qt::AlignHCenter))
        x = rect.center().x() - 0.5 * width;
    double baseline = rect.top() + metrics.ascent();
    if (alignment.testFlag(Qt::AlignVCenter))
        baseline = rect.center().y() + 0.5 * (metrics.ascent() - metrics.descent());
    else if (alignment.testFlag(Qt::AlignBottom))
        baseline = rect.bottom() - metrics.descent();

    // In most fonts all digits have the same width; then the text between figure spaces is drawn in one go.
    QString pending;
    double pendingX = x;
    const auto flush = [&] {
        if (!pending.isEmpty())
            painter.drawText(QPointF(pendingX, baseline), pending);
        pending.clear();
    };
    forEachRun(metrics, cell, text, [&](const QString& run, double runWidth, bool oneCell) {
        const QChar c = run[0];
        if (oneCell && (c == kFigureSpace || !cell.evenDigits)) {
            flush();
            if (c != kFigureSpace)
                painter.drawText(QPointF(x + runWidth - metrics.horizontalAdvance(c), baseline), run);
        } else {
            if (pending.isEmpty())
                pendingX = x;
            pending += run;
        }
        x += runWidth;
    });
    flush();
}

} // namespace teleta::base
