// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/servo/force_strip.h"

#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/numbers/tabular_text.h"
#include "widgets/base/numbers/unit_title.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QPainter>
#include <QPolygonF>

#include <algorithm>

namespace teleta::servo {

namespace {

constexpr int kTickStep_s = 5;

} // namespace

ForceStrip::ForceStrip(QWidget* parent)
    : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    base::keepTranslated(this, &ForceStrip::describe);
}

void ForceStrip::describe() {
    setAccessibleName(tr("Force over time"));
    setToolTip(tr("Measured force (line) and desired force (dashes) over the last 20 s"));
}

QSize ForceStrip::sizeHint() const {
    return {base::em(this, 22), base::em(this, 7.7)};
}

void ForceStrip::setReport(const std::optional<ServoReport>& report) {
    if (!report || report->restarts != m_restarts ||
        (!m_steps.empty() && report->time_s < m_steps.back().time_s)) {
        m_steps.clear();
        m_range = base::CalmRange{2.0};
    }
    if (report) {
        m_restarts = report->restarts;
        if (m_steps.empty() || report->time_s > m_steps.back().time_s)
            m_steps.push_back({report->time_s, report->output.actual[kZ] / report->normalCompliance_mPerN,
                               report->output.desired[kZ] / report->normalCompliance_mPerN});
        while (m_steps.back().time_s - m_steps.front().time_s > kSpan_s)
            m_steps.pop_front();
        double high_N = 0.0;
        for (const Step& step : m_steps)
            high_N = std::max({high_N, step.actual_N, step.desired_N});
        m_range.update(0.0, high_N, report->time_s);
    }
    update();
}

void ForceStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double em = base::em(this, 1);
    const QColor text = palette().color(QPalette::WindowText);
    const QColor window = palette().color(QPalette::Window);
    const QColor quiet = base::mixed(text, window, 0.35);
    const QRectF plot(2.6 * em, 1.5 * em, width() - 3.1 * em, height() - 3.1 * em);

    painter.setFont(base::sized(font(), base::kSmallText));
    painter.setPen(text);
    painter.drawText(QRectF(0.5 * em, 0.0, 0.5 * width(), 1.4 * em), Qt::AlignLeft | Qt::AlignVCenter,
                     base::titleWithUnit(tr("Force"), QStringLiteral("N")));
    // The legend is next to the title.
    const double legend = width() - 0.5 * em;
    const QFontMetricsF metrics(painter.font());
    const QPen wanted(quiet, 1.2, Qt::DashLine);
    const QPen read(palette().color(QPalette::Highlight), 1.6);
    double right = legend;
    for (const auto& [name, pen] : {std::pair(tr("actual"), read), std::pair(tr("desired"), wanted)}) {
        const double width_px = metrics.horizontalAdvance(name);
        painter.setPen(quiet);
        painter.drawText(QRectF(right - width_px, 0.0, width_px + 1.0, 1.4 * em),
                         Qt::AlignLeft | Qt::AlignVCenter, name);
        painter.setPen(pen);
        painter.drawLine(QPointF(right - width_px - 2.0 * em, 0.7 * em),
                         QPointF(right - width_px - 0.4 * em, 0.7 * em));
        right -= width_px + 3.0 * em;
    }

    const double low = std::min(0.0, m_range.low());
    const double span = std::max(m_range.high() - low, 1e-9);
    const auto y = [&](double force_N) { return plot.bottom() - plot.height() * (force_N - low) / span; };
    for (const double tick : {low, low + 0.5 * span, low + span}) {
        painter.setPen(base::mixed(text, window, 0.8));
        painter.drawLine(QPointF(plot.left(), y(tick)), QPointF(plot.right(), y(tick)));
        painter.setPen(quiet);
        base::drawTabularText(painter, QRectF(0.0, y(tick) - 0.7 * em, 2.3 * em, 1.4 * em),
                              Qt::AlignRight | Qt::AlignVCenter,
                              base::fixedDigits(tick, span < 10.0 ? 1 : 0));
    }
    for (int tick_s = 0; tick_s <= static_cast<int>(kSpan_s); tick_s += kTickStep_s) {
        const double x = plot.right() - plot.width() * tick_s / kSpan_s;
        painter.setPen(base::mixed(text, window, 0.8));
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom() + 0.2 * em));
        const QString name = base::withUnit(base::fixedDigits(-tick_s, 0), QStringLiteral("s"));
        const double width_px = metrics.horizontalAdvance(name) + 1.0;
        const double left = std::min(x - 0.5 * width_px, width() - width_px);
        painter.setPen(quiet);
        painter.drawText(QRectF(left, plot.bottom() + 0.2 * em, width_px, 1.2 * em), Qt::AlignCenter, name);
    }
    if (m_steps.empty())
        return;
    painter.setClipRect(plot.adjusted(0.0, -1.0, 0.0, 1.0));
    const double end_s = m_steps.back().time_s;
    QPolygonF actual;
    QPolygonF desired;
    for (const Step& step : m_steps) {
        const double x = plot.right() - plot.width() * (end_s - step.time_s) / kSpan_s;
        actual << QPointF(x, y(step.actual_N));
        desired << QPointF(x, y(step.desired_N));
    }
    painter.setPen(wanted);
    painter.drawPolyline(desired);
    painter.setPen(read);
    painter.drawPolyline(actual);
}

} // namespace teleta::servo
