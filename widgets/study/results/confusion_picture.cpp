// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/results/confusion_picture.h"

#include "widgets/base/numbers/tabular_text.h"
#include "widgets/base/theme.h"
#include "widgets/study/watermark.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>

#include <algorithm>

namespace teleta::study {

namespace {

struct PictureText {
    Q_DECLARE_TR_FUNCTIONS(ConfusionPicture)
};

constexpr double kLeft_em = 3.4;
constexpr double kTop_em = 4.6;
constexpr double kRight_em = 2.6;
constexpr double kBottom_em = 0.6;

QString name(const ConfusionContent& content, std::size_t column) {
    return column == content.matrix.noneColumn() ? QStringLiteral("NONE")
                                                 : content.letters.value(static_cast<qsizetype>(column));
}

QString cellText(const ConfusionContent& content, std::size_t row, std::size_t column) {
    if (!content.percent)
        return content.matrix.rowTotal(row) == 0
                   ? QStringLiteral("\u2013")
                   : QLocale().toString(qlonglong(content.matrix.count(row, column)));
    const std::optional<double> percent = content.matrix.rowPercent(row, column);
    if (!percent)
        return QStringLiteral("\u2013");
    return *percent == 0.0 ? QStringLiteral("0") : QLocale().toString(*percent, 'f', 1);
}

} // namespace

ConfusionLayout::ConfusionLayout(const QRectF& rect, double emOfFont, std::size_t rowCount,
                                 std::size_t columnCount)
    : em(emOfFont)
    , rows(std::max<std::size_t>(rowCount, 1))
    , columns(std::max<std::size_t>(columnCount, 1)) {
    const QRectF room = rect.adjusted(kLeft_em * em, kTop_em * em, -kRight_em * em, -kBottom_em * em);
    const double side = std::max(1.0, std::min({room.width() / static_cast<double>(columns),
                                                room.height() / static_cast<double>(rows), 5.5 * em}));
    const QSizeF size(side * static_cast<double>(columns), side * static_cast<double>(rows));
    grid = QRectF(QPointF(room.left() + 0.5 * std::max(0.0, room.width() - size.width()), room.top()), size);
}

QRectF ConfusionLayout::cell(std::size_t row, std::size_t column) const {
    const double width = grid.width() / static_cast<double>(columns);
    const double height = grid.height() / static_cast<double>(rows);
    return {grid.left() + static_cast<double>(column) * width, grid.top() + static_cast<double>(row) * height,
            width, height};
}

std::optional<std::pair<std::size_t, std::size_t>> ConfusionLayout::cellAt(const QPointF& at) const {
    if (!grid.contains(at))
        return std::nullopt;
    const auto column =
        static_cast<std::size_t>((at.x() - grid.left()) / grid.width() * static_cast<double>(columns));
    const auto row =
        static_cast<std::size_t>((at.y() - grid.top()) / grid.height() * static_cast<double>(rows));
    return std::pair(std::min(row, rows - 1), std::min(column, columns - 1));
}

void paintConfusion(QPainter& painter, const QRectF& rect, const ConfusionContent& content,
                    const QPalette& palette) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QFont normal = painter.font();
    const double em = QFontMetricsF(normal).height();
    const ConfusionMatrix& matrix = content.matrix;
    const ConfusionLayout layout(rect, em, matrix.patterns(), matrix.columns());
    const QColor ground = palette.color(QPalette::Base);
    const QColor text = palette.color(QPalette::Text);
    const QColor faint = palette.color(QPalette::PlaceholderText);
    const QRectF& grid = layout.grid;
    const double side = layout.cell(0, 0).width();
    const QFont bold = base::bold(normal);
    const QFont small = base::sized(normal, base::kSmallText);

    painter.setFont(bold);
    painter.setPen(text);
    painter.drawText(QRectF(rect.left(), rect.top() + 0.3 * em, rect.width(), 1.2 * em), Qt::AlignCenter,
                     content.title);
    if (content.letters.isEmpty()) {
        painter.restore();
        return;
    }
    painter.setFont(small);
    painter.setPen(faint);
    painter.drawText(QRectF(rect.left(), rect.top() + 1.7 * em, rect.width(), 1.2 * em), Qt::AlignCenter,
                     content.percent ? PictureText::tr("answered, % of the row")
                                     : PictureText::tr("answered"));
    painter.save();
    painter.translate(grid.left() - 2.4 * em, grid.center().y());
    painter.rotate(-90.0);
    painter.drawText(QRectF(-0.5 * grid.height(), -0.6 * em, grid.height(), 1.2 * em), Qt::AlignCenter,
                     PictureText::tr("presented"));
    painter.restore();
    painter.drawText(QRectF(grid.right(), grid.top() - 1.4 * em, kRight_em * em, 1.2 * em), Qt::AlignCenter,
                     QStringLiteral("n"));

    const bool wide = side >= 2.9 * em;
    for (std::size_t column = 0; column < matrix.columns(); ++column) {
        const QRectF at = layout.cell(0, column);
        painter.setFont(column == matrix.noneColumn() || !wide ? small : bold);
        painter.setPen(column == matrix.noneColumn() ? faint : text);
        painter.drawText(QRectF(at.left() - em, grid.top() - 1.4 * em, at.width() + 2.0 * em, 1.2 * em),
                         Qt::AlignCenter, name(content, column));
    }
    painter.setFont(wide ? normal : small);
    for (std::size_t row = 0; row < matrix.patterns(); ++row) {
        const QRectF first = layout.cell(row, 0);
        painter.setFont(bold);
        painter.setPen(text);
        painter.drawText(QRectF(grid.left() - 1.8 * em, first.top(), 1.5 * em, first.height()),
                         Qt::AlignCenter, content.letters.value(static_cast<qsizetype>(row)));
        painter.setFont(small);
        painter.setPen(faint);
        painter.drawText(QRectF(grid.right(), first.top(), kRight_em * em, first.height()), Qt::AlignCenter,
                         QLocale().toString(qlonglong(matrix.rowTotal(row))));
        painter.setFont(wide ? normal : small);
        for (std::size_t column = 0; column < matrix.columns(); ++column) {
            const QRectF at = layout.cell(row, column);
            const double share = matrix.rowPercent(row, column).value_or(0.0) / 100.0;
            const QColor fill = base::mixed(ground, palette.color(QPalette::Highlight), share);
            painter.fillRect(at, fill);
            painter.setPen(QPen(base::mixed(ground, text, 0.25), 1.0));
            painter.drawRect(at);
            const bool nothing = matrix.count(row, column) == 0;
            painter.setPen(nothing ? faint : base::readableOn(fill));
            base::drawTabularText(painter, at, Qt::AlignCenter, cellText(content, row, column));
        }
    }
    // Right answers are framed, to be visible without colour.
    painter.setPen(QPen(text, 1.6));
    painter.setBrush(Qt::NoBrush);
    for (std::size_t i = 0; i < matrix.patterns(); ++i)
        painter.drawRect(layout.cell(i, i));
    if (content.last) {
        painter.setPen(QPen(base::statusColours(palette).stale, 3.0));
        painter.drawRect(layout.cell(content.last->first, content.last->second).adjusted(2, 2, -2, -2));
    }
    paintWatermark(painter, rect, content.mode, palette);
    painter.restore();
}

QString confusionCsv(const ConfusionContent& content) {
    QString csv = QStringLiteral("stimulus,response,count,row_total\n");
    for (std::size_t row = 0; row < content.matrix.patterns(); ++row) {
        for (std::size_t column = 0; column < content.matrix.columns(); ++column)
            csv += QStringLiteral("%1,%2,%3,%4\n")
                       .arg(name(content, row), name(content, column))
                       .arg(content.matrix.count(row, column))
                       .arg(content.matrix.rowTotal(row));
    }
    return csv;
}

} // namespace teleta::study
