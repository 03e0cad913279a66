// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibrate/latency_chart.h"

#include "backend/core/quantile.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/numbers/unit_title.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/plot/plot_style.h"

#include <qcustomplot.h>
#include <QStringList>
#include <QVBoxLayout>

#include <algorithm>

namespace teleta::calibrate {

namespace {

constexpr double kDot_px = 7.0;
/// Of the axis, while no click is longer.
constexpr double kLeastTop_ms = 5.0;
constexpr double kRoomAbove = 1.25;

} // namespace

LatencyChart::LatencyChart(QWidget* parent)
    : QWidget(parent)
    , m_plot(new QCustomPlot(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_plot);
    plot::keepTicksApart(*m_plot);
    setMinimumSize(base::em(this, 24), base::em(this, 10));
    restyle();
    base::onChange(this, &LatencyChart::draw, {QEvent::LanguageChange});
    base::onChange(this, &LatencyChart::restyle, {QEvent::PaletteChange, QEvent::FontChange});
}

void LatencyChart::setClicks(const std::vector<double>& clicks_s, int of) {
    if (clicks_s == m_clicks_s && of == m_of)
        return;
    m_clicks_s = clicks_s;
    m_of = of;
    draw();
}

void LatencyChart::draw() {
    m_plot->clearPlottables();
    m_plot->clearItems();
    m_plot->xAxis->setLabel(tr("click"));
    m_plot->yAxis->setLabel(base::titleWithUnit(tr("latency"), QStringLiteral("ms")));
    QCPGraph* dots = m_plot->addGraph();
    dots->setLineStyle(QCPGraph::lsNone);
    dots->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, palette().color(QPalette::Highlight),
                                          palette().color(QPalette::Highlight), kDot_px));
    QStringList spoken;
    double highest_ms = kLeastTop_ms / kRoomAbove;
    for (std::size_t i = 0; i < m_clicks_s.size(); ++i) {
        const double click_ms = 1e3 * m_clicks_s[i];
        dots->addData(static_cast<double>(i + 1), click_ms);
        highest_ms = std::max(highest_ms, click_ms);
        spoken << base::fixedDigits(click_ms, 1);
    }
    if (!m_clicks_s.empty()) {
        const double median_ms = 1e3 * core::medianOf(std::vector(m_clicks_s));
        auto* line = new QCPItemStraightLine(m_plot);
        line->setPen(QPen(palette().color(QPalette::PlaceholderText), 1.0, Qt::DashLine));
        line->point1->setCoords(0.0, median_ms);
        line->point2->setCoords(1.0, median_ms);
    }
    m_plot->xAxis->setRange(0.5, std::max(1, m_of) + 0.5);
    m_plot->yAxis->setRange(0.0, kRoomAbove * highest_ms);
    m_plot->setAccessibleName(
        spoken.isEmpty() ? tr("Latency of the clicks: none was heard yet")
                         : tr("Latency of the clicks: %1 ms").arg(spoken.join(QStringLiteral(", "))));
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void LatencyChart::restyle() {
    plot::stylePlot(*m_plot, palette(), font());
    for (QCPAxis* axis : {m_plot->xAxis, m_plot->yAxis})
        axis->setSubTickPen(Qt::NoPen);
    draw();
}

} // namespace teleta::calibrate
