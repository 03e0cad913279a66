// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/results/interval_chart.h"

#include "widgets/base/colour_maps.h"
#include "widgets/base/numbers/calm_range.h"
#include "widgets/base/theme.h"
#include "widgets/study/watermark.h"

#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace teleta::study {

namespace {

constexpr int kTicks = 5;

QString number(const std::optional<double>& value) {
    return value ? QLocale::c().toString(*value, 'g', QLocale::FloatingPointShortest) : QStringLiteral("NA");
}

/// Series differ in lightness too, to be distinguishable in grey.
QColor seriesColour(std::size_t series, const QPalette& palette) {
    const QColor colour = base::identityColour(static_cast<int>(series) + 1, base::isDark(palette));
    return series % 2 == 0 ? colour : base::mixed(colour, palette.color(QPalette::Base), 0.45);
}

class ChartPainter {
public:
    ChartPainter(QPainter& painter, const QRectF& rect, const IntervalChartContent& content,
                 const QPalette& palette)
        : m_painter(painter)
        , m_content(content)
        , m_palette(palette)
        , m_em(QFontMetricsF(painter.font()).height())
        , m_rect(rect)
        , m_plot(rect.adjusted(4.0 * m_em, 3.6 * m_em, -0.8 * m_em, -1.8 * m_em))
        , m_small(base::sized(painter.font(), base::kSmallText)) {
        // Notes have as many lines as the longest one needs in its room.
        for (const QString& note : content.notes)
            m_notes = std::max(m_notes, QFontMetricsF(m_small)
                                            .boundingRect(QRectF(0.0, 0.0, categoryWidth(), m_rect.height()),
                                                          kNoteFlags, note)
                                            .height());
        m_notes = std::min(m_notes, 0.3 * m_plot.height());
        m_plot.setBottom(m_plot.bottom() - m_notes);
    }

    void paint() {
        paintHead();
        paintAxis();
        const double width = categoryWidth();
        for (qsizetype c = 0; c < m_content.categories.size(); ++c)
            paintCategory(c, QRectF(m_plot.left() + static_cast<double>(c) * width, m_plot.top(), width,
                                    m_plot.height()));
        paintReference();
        paintWatermark(m_painter, m_rect, m_content.mode, m_palette);
    }

private:
    static constexpr int kNoteFlags = Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap;

    [[nodiscard]] double categoryWidth() const {
        return m_plot.width() / static_cast<double>(std::max<qsizetype>(m_content.categories.size(), 1));
    }
    [[nodiscard]] double y(double value) const {
        return m_plot.bottom() - std::clamp(value / m_content.highest, 0.0, 1.0) * m_plot.height();
    }
    [[nodiscard]] QColor text(double share = 1.0) const {
        return base::mixed(m_palette.color(QPalette::Base), m_palette.color(QPalette::Text), share);
    }

    void paintHead() {
        // In two smaller lines where one is too wide.
        const QFont whole = base::bold(m_painter.font());
        const bool fits = QFontMetricsF(whole).horizontalAdvance(m_content.title) <= m_rect.width();
        m_painter.setFont(fits ? whole : base::bold(m_small));
        m_painter.setPen(text());
        m_painter.drawText(QRectF(m_rect.left(), m_rect.top() + 0.1 * m_em, m_rect.width(), 1.7 * m_em),
                           Qt::AlignCenter | Qt::TextWordWrap, m_content.title);
        // Legend, in one line.
        m_painter.setFont(m_small);
        const QFontMetricsF metrics(m_small);
        double width = 0.0;
        for (const ChartSeries& series : m_content.series)
            width += metrics.horizontalAdvance(series.name) + 2.4 * m_em;
        double x = m_rect.center().x() - 0.5 * width;
        for (std::size_t s = 0; s < m_content.series.size(); ++s) {
            const QRectF box(x, m_rect.top() + 2.0 * m_em, 0.8 * m_em, 0.8 * m_em);
            m_painter.fillRect(box, seriesColour(s, m_palette));
            m_painter.setPen(text());
            m_painter.drawText(QRectF(x + 1.1 * m_em, m_rect.top() + 1.7 * m_em, m_rect.width(), 1.4 * m_em),
                               Qt::AlignLeft | Qt::AlignVCenter, m_content.series[s].name);
            x += metrics.horizontalAdvance(m_content.series[s].name) + 2.4 * m_em;
        }
    }

    void paintAxis() {
        m_painter.setFont(m_small);
        const double step = base::niceStep(m_content.highest / kTicks);
        for (double value = 0.0; value <= m_content.highest * (1.0 + 1e-9); value += step) {
            m_painter.setPen(QPen(text(value == 0.0 ? 0.6 : 0.15), 1.0));
            m_painter.drawLine(QPointF(m_plot.left(), y(value)), QPointF(m_plot.right(), y(value)));
            m_painter.setPen(text(0.75));
            m_painter.drawText(
                QRectF(m_plot.left() - 2.4 * m_em, y(value) - 0.6 * m_em, 2.1 * m_em, 1.2 * m_em),
                Qt::AlignRight | Qt::AlignVCenter, QLocale().toString(value, 'g', 4));
        }
        m_painter.save();
        m_painter.translate(m_rect.left() + 0.9 * m_em, m_plot.center().y());
        m_painter.rotate(-90.0);
        m_painter.drawText(QRectF(-0.5 * m_plot.height(), -0.6 * m_em, m_plot.height(), 1.2 * m_em),
                           Qt::AlignCenter, m_content.axis);
        m_painter.restore();
    }

    /// Over the bars, which it divides.
    void paintReference() {
        if (!m_content.reference)
            return;
        m_painter.setFont(m_small);
        const double at = y(*m_content.reference);
        m_painter.setPen(QPen(text(0.7), 1.2, Qt::DashLine));
        m_painter.drawLine(QPointF(m_plot.left(), at), QPointF(m_plot.right(), at));
        const QSizeF name(QFontMetricsF(m_small).horizontalAdvance(m_content.referenceName) + 0.4 * m_em,
                          1.1 * m_em);
        const QRectF place(QPointF(m_plot.right() - name.width(), at - name.height()), name);
        m_painter.fillRect(place, base::translucent(m_palette.color(QPalette::Base), 0.8F));
        m_painter.setPen(text(0.75));
        m_painter.drawText(place, Qt::AlignCenter, m_content.referenceName);
    }

    void paintCategory(qsizetype category, const QRectF& room) {
        m_painter.setFont(m_small);
        m_painter.setPen(text());
        m_painter.drawText(QRectF(room.left(), m_plot.bottom() + 0.3 * m_em, room.width(), 1.2 * m_em),
                           Qt::AlignCenter, m_content.categories[category]);
        m_painter.setPen(text(0.75));
        m_painter.drawText(QRectF(room.left(), m_plot.bottom() + 1.5 * m_em, room.width(), m_notes),
                           kNoteFlags, m_content.notes.value(category));
        const std::size_t count = std::max<std::size_t>(m_content.series.size(), 1);
        const double width = std::min(0.8 * room.width() / static_cast<double>(count), 3.5 * m_em);
        double x = room.center().x() - 0.5 * width * static_cast<double>(count);
        for (std::size_t s = 0; s < m_content.series.size(); ++s, x += width) {
            const auto& points = m_content.series[s].points;
            if (static_cast<std::size_t>(category) < points.size())
                paintPoint(points[static_cast<std::size_t>(category)], seriesColour(s, m_palette),
                           QRectF(x + 0.06 * width, m_plot.top(), 0.88 * width, m_plot.height()));
        }
    }

    void paintPoint(const ChartPoint& point, const QColor& colour, const QRectF& room) {
        if (!point.value) {
            m_painter.setPen(text(0.6));
            m_painter.drawText(QRectF(room.left(), m_plot.bottom() - 1.3 * m_em, room.width(), 1.2 * m_em),
                               Qt::AlignCenter, QStringLiteral("\u2013"));
            return;
        }
        m_painter.fillRect(
            QRectF(QPointF(room.left(), y(*point.value)), QPointF(room.right(), m_plot.bottom())), colour);
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(text(0.55));
        for (std::size_t i = 0; i < point.single.size(); ++i) {
            // Spread out, so that equal values stay distinguishable.
            const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(point.single.size());
            m_painter.drawEllipse(
                QPointF(room.left() + (0.15 + 0.7 * share) * room.width(), y(point.single[i])), 0.13 * m_em,
                0.13 * m_em);
        }
        m_painter.setBrush(Qt::NoBrush);
        if (!point.interval)
            return;
        const double x = room.center().x();
        const double cap = std::min(0.2 * room.width(), 0.5 * m_em);
        m_painter.setPen(QPen(text(), 1.6));
        m_painter.drawLine(QPointF(x, y(point.interval->low)), QPointF(x, y(point.interval->high)));
        for (const double end : {point.interval->low, point.interval->high})
            m_painter.drawLine(QPointF(x - cap, y(end)), QPointF(x + cap, y(end)));
    }

    QPainter& m_painter;
    const IntervalChartContent& m_content;
    const QPalette& m_palette;
    double m_em;
    QRectF m_rect;
    QRectF m_plot;
    QFont m_small;
    double m_notes = 0.0; ///< their height
};

} // namespace

void paintIntervalChart(QPainter& painter, const QRectF& rect, const IntervalChartContent& content,
                        const QPalette& palette) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    ChartPainter(painter, rect, content, palette).paint();
    painter.restore();
}

QString intervalChartCsv(const IntervalChartContent& content) {
    QString csv = QStringLiteral("category,series,value,low,high,singles\n");
    for (qsizetype c = 0; c < content.categories.size(); ++c) {
        for (const ChartSeries& series : content.series) {
            const ChartPoint point = static_cast<std::size_t>(c) < series.points.size()
                                         ? series.points[static_cast<std::size_t>(c)]
                                         : ChartPoint{};
            QStringList singles;
            for (const double value : point.single)
                singles << number(value);
            csv += QStringList{content.categories[c],
                               series.name,
                               number(point.value),
                               number(point.interval ? std::optional(point.interval->low) : std::nullopt),
                               number(point.interval ? std::optional(point.interval->high) : std::nullopt),
                               singles.isEmpty() ? QStringLiteral("NA") : singles.join(QLatin1Char(';'))}
                       .join(QLatin1Char(',')) +
                   QLatin1Char('\n');
        }
    }
    return csv;
}

IntervalChart::IntervalChart(QWidget* parent)
    : FigureView(parent, {26, 17}, {16, 13}) {
    setFocusPolicy(Qt::NoFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void IntervalChart::setContent(IntervalChartContent content) {
    m_content = std::move(content);
    setAccessibleName(m_content.title);
    update();
}

base::Figure IntervalChart::figure() {
    base::Figure figure;
    figure.name = m_content.name;
    figure.size_px = QSizeF(720.0, 420.0);
    figure.paint = [content = m_content, size = figure.size_px, font = font()](QPainter& painter) {
        painter.setFont(font);
        paintIntervalChart(painter, QRectF(QPointF(), size), content, base::designedPalette(false));
    };
    figure.csv = [content = m_content] { return intervalChartCsv(content); };
    return figure;
}

void IntervalChart::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    paintIntervalChart(painter, rect(), m_content, palette());
}

} // namespace teleta::study
