// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cost/cost_chart.h"

#include "backend/cost/frontier.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/cost/log_ticker.h"
#include "widgets/plot/plot_style.h"

#include <qcustomplot.h>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace teleta::cost {

namespace {

bool isDrawn(const cost::RungCost& rung) {
    return rung.isTimed() && rung.timeMedian_s > 0.0 && !std::isnan(rung.errorMean);
}

QString costCsv(const cost::LadderCost& ladder) {
    QString text = QStringLiteral("rung,error_mean,error_p95,error_max,time_median_s,time_p99_s\n");
    for (const cost::RungCost& rung : ladder.rungs) {
        text += QString::fromStdString(rung.name);
        for (const double value :
             {rung.errorMean, rung.errorP95, rung.errorMax, rung.timeMedian_s, rung.timeP99_s})
            text += QLatin1Char(',') + base::csvNumber(value);
        text += QLatin1Char('\n');
    }
    return text;
}

} // namespace

CostChart::CostChart(QWidget* parent)
    : SizedView(parent, {44, 28}, {})
    , m_plot(new QCustomPlot(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_plot);
    m_plot->xAxis->setScaleType(QCPAxis::stLogarithmic);
    m_plot->yAxis->setScaleType(QCPAxis::stLogarithmic);
    m_plot->xAxis->setTicker(QSharedPointer<QCPAxisTicker>(new LogTicker(QStringLiteral("s"))));
    // Powers of ten with small raised digits, where there is no prefix.
    m_plot->yAxis->setNumberFormat(QStringLiteral("eb"));
    connect(m_plot, &QCustomPlot::mousePress, this, [this](QMouseEvent* event) {
        if (event->button() == Qt::LeftButton)
            onClick(event->position());
    });
    // Names are placed beside their points in pixels.
    connect(m_plot, &QCustomPlot::afterLayout, this, &CostChart::drawNames);
    auto* exporter = new base::FigureExport(m_plot, [this] { return figure(); });
    connect(exporter, &base::FigureExport::failed, this, &CostChart::exportFailed);
    exporter->setContextMenu();
    base::onChange(this, &CostChart::draw, {QEvent::LanguageChange});
    base::onChange(this, [this] { restyle(palette()); }, {QEvent::PaletteChange, QEvent::FontChange});
    restyle(palette());
}

void CostChart::setLadder(const cost::LadderCost& ladder) {
    m_ladder = ladder;
    draw();
}

void CostChart::setRungInUse(const QString& name) {
    if (std::exchange(m_inUse, name) != name)
        draw();
}

void CostChart::setChosen(const QString& name) {
    if (std::exchange(m_chosen, name) != name)
        draw();
}

void CostChart::setBudget(std::optional<double> budget_s) {
    if (std::exchange(m_budget_s, budget_s) != budget_s)
        draw();
}

void CostChart::setRanges() {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    double left = kNone, right = 0.0, low = kNone, high = 0.0;
    bool exact = false;
    for (const cost::RungCost& rung : m_ladder.rungs) {
        if (!isDrawn(rung))
            continue;
        left = std::min(left, rung.timeMedian_s);
        right = std::max(right, rung.timeMedian_s);
        exact = exact || rung.errorMean <= 0.0;
        if (rung.errorMean > 0.0) {
            low = std::min(low, rung.errorMean);
            high = std::max(high, rung.errorMean);
        }
    }
    if (const auto over = cost::overLimit(m_ladder.rungs))
        left = std::min(left, over->limit->timeMedian_s);
    if (m_budget_s && left < kNone) {
        left = std::min(left, *m_budget_s);
        right = std::max(right, *m_budget_s);
    }
    m_plot->xAxis->setRange(left < kNone ? 0.5 * left : 1e-6, right > 0.0 ? 4.0 * right : 1.0);
    m_plot->yAxis->setRange(low < kNone ? low / (exact ? 30.0 : 3.0) : 1e-6, high > 0.0 ? 3.0 * high : 1.0);
}

double CostChart::heightOf(const cost::RungCost& rung) const {
    return rung.errorMean > 0.0 ? rung.errorMean : 1.5 * m_plot->yAxis->range().lower;
}

void CostChart::draw() {
    m_plot->clearPlottables();
    m_plot->clearItems();
    m_plot->xAxis->setLabel(tr("median time of one call"));
    m_plot->yAxis->setLabel(tr("mean error"));
    m_plot->yAxis->setTicker(
        QSharedPointer<QCPAxisTicker>(new LogTicker(QString::fromStdString(m_ladder.errorUnit))));
    m_plot->setAccessibleName(
        tr("Mean error over time of the settings of %1").arg(QString::fromStdString(m_ladder.ladder)));
    setRanges();
    const QColor accent = m_colours.color(QPalette::Highlight);
    const QColor text = m_colours.color(QPalette::Text);

    std::vector<const cost::RungCost*> front;
    QCPGraph* stairs = m_plot->addGraph();
    QCPGraph* best = m_plot->addGraph();
    QCPGraph* others = m_plot->addGraph();
    for (const cost::RungCost& rung : m_ladder.rungs) {
        if (!isDrawn(rung))
            continue;
        (rung.pareto ? best : others)->addData(rung.timeMedian_s, heightOf(rung));
        if (rung.pareto)
            front.push_back(&rung);
    }
    std::ranges::sort(front, {}, &cost::RungCost::timeMedian_s);
    for (const cost::RungCost* rung : front)
        stairs->addData(rung->timeMedian_s, heightOf(*rung));
    if (!front.empty())
        stairs->addData(m_plot->xAxis->range().upper, heightOf(*front.back()));
    stairs->setLineStyle(QCPGraph::lsStepLeft);
    stairs->setPen(QPen(accent, 2.0));
    best->setLineStyle(QCPGraph::lsNone);
    best->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(accent), QBrush(accent), 9.0));
    others->setLineStyle(QCPGraph::lsNone);
    others->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(text, 1.5), Qt::NoBrush, 8.0));

    for (const cost::RungCost& rung : m_ladder.rungs) {
        const QString name = QString::fromStdString(rung.name);
        if (!isDrawn(rung) || (name != m_inUse && name != m_chosen))
            continue;
        QCPGraph* ring = m_plot->addGraph();
        ring->setLineStyle(QCPGraph::lsNone);
        const QColor colour = name == m_inUse ? base::statusColours(m_colours).live : text;
        ring->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(colour, 2.5), Qt::NoBrush,
                                              name == m_inUse ? 18.0 : 14.0));
        ring->addData(rung.timeMedian_s, heightOf(rung));
    }
    if (const auto over = cost::overLimit(m_ladder.rungs)) {
        auto* line = new QCPItemStraightLine(m_plot);
        line->setPen(QPen(m_colours.color(QPalette::PlaceholderText), 1.5, Qt::DotLine));
        line->point1->setCoords(over->limit->timeMedian_s, m_plot->yAxis->range().lower);
        line->point2->setCoords(over->limit->timeMedian_s, m_plot->yAxis->range().upper);
    }
    if (m_budget_s) {
        auto* line = new QCPItemStraightLine(m_plot);
        line->setPen(QPen(base::statusColours(m_colours).stale, 1.5, Qt::DashLine));
        line->point1->setCoords(*m_budget_s, m_plot->yAxis->range().lower);
        line->point2->setCoords(*m_budget_s, m_plot->yAxis->range().upper);
    }
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

/// Beside their points where there is room, those on the front first.
void CostChart::drawNames() {
    for (int i = m_plot->itemCount() - 1; i >= 0; --i)
        if (auto* text = qobject_cast<QCPItemText*>(m_plot->item(i)))
            m_plot->removeItem(text);
    std::vector<const cost::RungCost*> rungs;
    std::vector<QRectF> taken;
    const auto pixelOf = [&](const cost::RungCost& rung) {
        return QPointF(m_plot->xAxis->coordToPixel(rung.timeMedian_s),
                       m_plot->yAxis->coordToPixel(heightOf(rung)));
    };
    for (const cost::RungCost& rung : m_ladder.rungs)
        if (isDrawn(rung)) {
            rungs.push_back(&rung);
            taken.emplace_back(pixelOf(rung) - QPointF(6.0, 6.0), QSizeF(12.0, 12.0));
        }
    std::ranges::stable_partition(rungs, [this](const cost::RungCost* rung) {
        return rung->pareto || QString::fromStdString(rung->name) == m_inUse;
    });
    const auto takeLine = [&taken](const QPointF& a, const QPointF& b) {
        taken.push_back(QRectF(a, b).normalized().adjusted(-2.0, -2.0, 2.0, 2.0));
    };
    const QRectF inside = m_plot->axisRect()->rect();
    if (m_budget_s) {
        const double x = m_plot->xAxis->coordToPixel(*m_budget_s);
        takeLine({x, inside.top()}, {x, inside.bottom()});
    }
    std::vector<const cost::RungCost*> front;
    std::ranges::copy_if(rungs, std::back_inserter(front), &cost::RungCost::pareto);
    std::ranges::sort(front, {}, &cost::RungCost::timeMedian_s);
    for (std::size_t i = 0; i < front.size(); ++i) {
        const QPointF here = pixelOf(*front[i]);
        const QPointF next =
            i + 1 < front.size() ? pixelOf(*front[i + 1]) : QPointF(inside.right(), here.y());
        takeLine(here, {next.x(), here.y()});
        takeLine({next.x(), here.y()}, next);
    }
    QFont small = base::sized(font(), base::kSmallText);
    const QFontMetricsF metrics(small);
    for (const cost::RungCost* rung : rungs) {
        const QString name =
            rung->errorMean > 0.0
                ? QString::fromStdString(rung->name)
                : tr("%1 (exact)", "name of a setting").arg(QString::fromStdString(rung->name));
        const QPointF point = pixelOf(*rung);
        const QSizeF size(metrics.horizontalAdvance(name), metrics.height());
        const double right = 8.0, left = -8.0 - size.width(), middle = -0.5 * size.width();
        const double above = -size.height() - 3.0, below = 3.0, farAbove = -size.height() - 8.0,
                     level = -0.5 * size.height();
        for (const QPointF& beside :
             {QPointF(right, above), QPointF(right, below), QPointF(right, level), QPointF(left, above),
              QPointF(left, below), QPointF(left, level), QPointF(middle, farAbove), QPointF(middle, 8.0),
              QPointF(right + 4.0, 1.6 * above), QPointF(left - 4.0, size.height())}) {
            const QRectF box(point + beside, size);
            if (!inside.contains(box) ||
                std::ranges::any_of(taken, [&](const QRectF& other) { return other.intersects(box); }))
                continue;
            taken.push_back(box);
            auto* text = new QCPItemText(m_plot);
            text->position->setType(QCPItemPosition::ptAbsolute);
            text->position->setCoords(box.topLeft());
            text->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
            text->setFont(small);
            text->setText(name);
            text->setPadding({});
            text->setColor(rung->pareto ? m_colours.color(QPalette::Text)
                                        : m_colours.color(QPalette::PlaceholderText));
            break;
        }
    }
}

std::optional<QPointF> CostChart::pointOf(const QString& name) const {
    for (const cost::RungCost& rung : m_ladder.rungs)
        if (isDrawn(rung) && QString::fromStdString(rung.name) == name)
            return m_plot->mapToParent(QPointF(m_plot->xAxis->coordToPixel(rung.timeMedian_s),
                                               m_plot->yAxis->coordToPixel(heightOf(rung))));
    return std::nullopt;
}

void CostChart::onClick(const QPointF& position) {
    constexpr double kReach_px = 14.0;
    double nearest = kReach_px;
    QString found;
    for (const cost::RungCost& rung : m_ladder.rungs) {
        const QString name = QString::fromStdString(rung.name);
        const std::optional<QPointF> point = pointOf(name);
        if (!point)
            continue;
        const double distance = QLineF(*point, m_plot->mapToParent(position)).length();
        if (distance < nearest) {
            nearest = distance;
            found = name;
        }
    }
    if (!found.isEmpty())
        emit rungClicked(found);
}

void CostChart::restyle(const QPalette& colours) {
    m_colours = colours;
    plot::stylePlot(*m_plot, colours, font());
    for (QCPAxis* axis : {m_plot->xAxis, m_plot->yAxis})
        axis->setSubTickPen(QPen(plot::gridColour(colours)));
    draw();
}

base::Figure CostChart::figure() {
    base::Figure figure;
    figure.name = QString::fromStdString(m_ladder.ladder);
    figure.size_px = m_plot->size();
    restyle(base::designedPalette(false)); // for paper
    const QPicture picture = plot::pictureOf(*m_plot);
    restyle(palette());
    figure.paint = [picture](QPainter& painter) { painter.drawPicture(0, 0, picture); };
    figure.csv = [ladder = m_ladder] { return costCsv(ladder); };
    return figure;
}

} // namespace teleta::cost
