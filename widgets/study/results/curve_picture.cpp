// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/results/curve_picture.h"

#include "widgets/base/colour_maps.h"
#include "widgets/base/numbers/calm_range.h"
#include "widgets/base/theme.h"
#include "widgets/study/watermark.h"

#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QPolygonF>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace teleta::study {

namespace {

constexpr int kCurveTicks = 5;

class CurvePainter {
public:
    CurvePainter(QPainter& painter, const QRectF& rect, const CurveContent& content, const QPalette& palette)
        : m_painter(painter)
        , m_content(content)
        , m_palette(palette)
        , m_em(QFontMetricsF(painter.font()).height())
        , m_rect(rect)
        , m_title(titleRect())
        , m_plot(rect.adjusted(4.0 * m_em, 2.1 * m_em + m_title.height(), -0.8 * m_em, -3.2 * m_em))
        , m_small(base::sized(painter.font(), base::kSmallText)) {}

    void paint() {
        const bool isEmpty = std::ranges::all_of(
            m_content.series, [](const CurveSeries& series) { return series.points.empty(); });
        if (isEmpty && !m_content.nothing.isEmpty()) {
            m_painter.setPen(ink(0.7));
            m_painter.drawText(m_rect.adjusted(2.0 * m_em, m_em, -2.0 * m_em, -m_em),
                               Qt::AlignCenter | Qt::TextWordWrap, m_content.nothing);
            return;
        }
        paintTitle();
        paintAxes();
        for (std::size_t s = 0; s < m_content.series.size(); ++s)
            paintSeries(m_content.series[s], colourOf(s));
        paintWatermark(m_painter, m_rect, m_content.mode, m_palette);
    }

private:
    /// A title that is wider than the picture has more lines than one.
    [[nodiscard]] QRectF titleRect() const {
        const QFontMetricsF metrics(base::bold(m_painter.font()));
        const QRectF room = m_rect.adjusted(0.5 * m_em, 0.3 * m_em, -0.5 * m_em, 0.0);
        const double lines = std::max(
            1.0,
            std::round(
                metrics.boundingRect(room, Qt::AlignHCenter | Qt::TextWordWrap, m_content.title).height() /
                metrics.height()));
        return {room.left(), room.top(), room.width(), lines * 1.2 * m_em + 0.3 * m_em};
    }
    [[nodiscard]] double x(double value) const {
        const double share = (value - m_content.lowestX) / (m_content.highestX - m_content.lowestX);
        return m_plot.left() + std::clamp(share, 0.0, 1.0) * m_plot.width();
    }
    [[nodiscard]] double y(double value) const {
        return m_plot.bottom() - std::clamp(value / m_content.highest, 0.0, 1.0) * m_plot.height();
    }
    [[nodiscard]] QColor ink(double share = 1.0) const {
        return base::mixed(m_palette.color(QPalette::Base), m_palette.color(QPalette::Text), share);
    }
    [[nodiscard]] QColor colourOf(std::size_t series) const {
        return base::identityColour(static_cast<int>(series) + 1, base::isDark(m_palette));
    }

    void paintTitle() {
        m_painter.setFont(base::bold(m_painter.font()));
        m_painter.setPen(ink());
        m_painter.drawText(m_title, Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, m_content.title);
        m_painter.setFont(m_small);
        const QFontMetricsF metrics(m_small);
        double left = m_plot.left();
        for (std::size_t s = 0; s < m_content.series.size(); ++s) {
            const QString& name = m_content.series[s].name;
            if (name.isEmpty())
                continue;
            m_painter.setPen(QPen(colourOf(s), 2.4));
            const double middle = m_title.bottom() + 0.6 * m_em;
            m_painter.drawLine(QPointF(left, middle), QPointF(left + 1.4 * m_em, middle));
            m_painter.setPen(ink());
            m_painter.drawText(QRectF(left + 1.8 * m_em, middle - 0.7 * m_em, m_rect.width(), 1.4 * m_em),
                               Qt::AlignLeft | Qt::AlignVCenter, name);
            left += metrics.horizontalAdvance(name) + 3.0 * m_em;
        }
    }

    void paintAxes() {
        m_painter.setFont(m_small);
        const double step = base::niceStep(m_content.highest / kCurveTicks);
        for (double value = 0.0; value <= m_content.highest * (1.0 + 1e-9); value += step) {
            m_painter.setPen(QPen(ink(value == 0.0 ? 0.6 : 0.15), 1.0));
            m_painter.drawLine(QPointF(m_plot.left(), y(value)), QPointF(m_plot.right(), y(value)));
            m_painter.setPen(ink(0.75));
            m_painter.drawText(
                QRectF(m_plot.left() - 2.4 * m_em, y(value) - 0.6 * m_em, 2.1 * m_em, 1.2 * m_em),
                Qt::AlignRight | Qt::AlignVCenter, QLocale().toString(value, 'g', 4));
        }
        const double across = base::niceStep((m_content.highestX - m_content.lowestX) / kCurveTicks);
        for (double i = std::ceil(m_content.lowestX / across - 1e-9);
             i * across <= m_content.highestX + 1e-9 * across; i += 1.0) {
            const double at = x(i * across);
            m_painter.setPen(QPen(ink(0.6), 1.0));
            m_painter.drawLine(QPointF(at, m_plot.bottom()), QPointF(at, m_plot.bottom() + 0.25 * m_em));
            m_painter.setPen(ink(0.75));
            m_painter.drawText(QRectF(at - 3.0 * m_em, m_plot.bottom() + 0.3 * m_em, 6.0 * m_em, 1.2 * m_em),
                               Qt::AlignCenter, QLocale().toString(i * across, 'g', 4));
        }
        m_painter.drawText(QRectF(m_plot.left(), m_plot.bottom() + 1.6 * m_em, m_plot.width(), 1.2 * m_em),
                           Qt::AlignCenter, m_content.xAxis);
        m_painter.save();
        m_painter.translate(m_rect.left() + 0.9 * m_em, m_plot.center().y());
        m_painter.rotate(-90.0);
        m_painter.drawText(QRectF(-0.5 * m_plot.height(), -0.6 * m_em, m_plot.height(), 1.2 * m_em),
                           Qt::AlignCenter, m_content.yAxis);
        m_painter.restore();
        if (!m_content.reference)
            return;
        const double at = y(*m_content.reference);
        m_painter.setPen(QPen(ink(0.7), 1.2, Qt::DashLine));
        m_painter.drawLine(QPointF(m_plot.left(), at), QPointF(m_plot.right(), at));
        m_painter.setPen(ink(0.75));
        m_painter.drawText(QRectF(m_plot.left(), at - 1.2 * m_em, m_plot.width() - 0.2 * m_em, 1.2 * m_em),
                           Qt::AlignRight | Qt::AlignVCenter, m_content.referenceName);
    }

    void paintSeries(const CurveSeries& series, const QColor& colour) {
        QPolygonF line;
        for (const CurvePoint& point : series.points)
            line << QPointF(x(point.x), y(point.y));
        m_painter.setPen(QPen(colour, 2.0));
        m_painter.setBrush(Qt::NoBrush);
        m_painter.drawPolyline(line);
        for (const CurvePoint& point : series.points) {
            if (point.interval) {
                const double cap = 0.25 * m_em;
                m_painter.setPen(QPen(ink(), 1.4));
                m_painter.drawLine(QPointF(x(point.x), y(point.interval->low)),
                                   QPointF(x(point.x), y(point.interval->high)));
                for (const double end : {point.interval->low, point.interval->high})
                    m_painter.drawLine(QPointF(x(point.x) - cap, y(end)), QPointF(x(point.x) + cap, y(end)));
            }
            if (series.marks) {
                m_painter.setPen(Qt::NoPen);
                m_painter.setBrush(colour);
                m_painter.drawEllipse(QPointF(x(point.x), y(point.y)), 0.22 * m_em, 0.22 * m_em);
                m_painter.setBrush(Qt::NoBrush);
            }
        }
    }

    QPainter& m_painter;
    const CurveContent& m_content;
    const QPalette& m_palette;
    double m_em;
    QRectF m_rect;
    QRectF m_title;
    QRectF m_plot;
    QFont m_small;
};

} // namespace

void paintCurves(QPainter& painter, const QRectF& rect, const CurveContent& content,
                 const QPalette& palette) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    CurvePainter(painter, rect, content, palette).paint();
    painter.restore();
}

QString curvesCsv(const CurveContent& content) {
    const auto number = [](const std::optional<double>& value) {
        return value ? QLocale::c().toString(*value, 'g', QLocale::FloatingPointShortest)
                     : QStringLiteral("NA");
    };
    QString csv = QStringLiteral("series,x,y,low,high\n");
    for (const CurveSeries& series : content.series) {
        for (const CurvePoint& point : series.points)
            csv += QStringList{series.name, number(point.x), number(point.y),
                               number(point.interval ? std::optional(point.interval->low) : std::nullopt),
                               number(point.interval ? std::optional(point.interval->high) : std::nullopt)}
                       .join(QLatin1Char(',')) +
                   QLatin1Char('\n');
    }
    return csv;
}

} // namespace teleta::study
