// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/time_plot.h"

#include "widgets/base/colour_maps.h"
#include "widgets/base/theme.h"
#include "widgets/plot/plot_style.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::charts {

namespace {

constexpr double kHeaderHeight_em = 1.5;
constexpr double kAxisHeight_em = 1.7;
constexpr double kAxisPadding = 0.05; ///< of the axis' span, so that a curve at its end keeps its full width
constexpr int kMostTicks = 4;
constexpr auto kOverlay = "teleta.overlay";

/// colour: as in CurveStyle.
QColor curveColour(int colour, const QPalette& palette) {
    return colour == 0 ? palette.color(QPalette::PlaceholderText)
                       : base::identityColour(colour, base::isDark(palette));
}

} // namespace

TimePlot::TimePlot(const Shape& shape, QWidget* parent)
    : QCustomPlot(parent)
    , m_shape(shape)
    , m_colours(palette()) {
    setFocusPolicy(Qt::NoFocus);
    setAttribute(Qt::WA_OpaquePaintEvent); // its background covers what is below
    setNoAntialiasingOnDrag(false);
    setPlottingHints(QCP::phCacheLabels);
    plotLayout()->clear();
    plotLayout()->setRowSpacing(0);
    m_header = new HeaderElement(this);
    plotLayout()->addElement(0, 0, m_header);
    m_grid = new QCPLayoutGrid;
    plotLayout()->addElement(1, 0, m_grid);
    m_axisRoom = new QCPLayoutElement(this);
    plotLayout()->addElement(2, 0, m_axisRoom);
    // The cursor and the numbers have their own buffer: moving the mouse does not redraw the curves.
    addLayer(QString::fromLatin1(kOverlay));
    layer(QString::fromLatin1(kOverlay))->setMode(QCPLayer::lmBuffered);
    m_jumps = new TimeLines(this, QStringLiteral("grid"));
    m_cursor = new TimeLines(this, QString::fromLatin1(kOverlay));
    m_header->setLayer(QString::fromLatin1(kOverlay));
}

double TimePlot::em() const {
    return QFontMetricsF(font()).height();
}

void TimePlot::addLane(LaneId id, const std::vector<CurveStyle>& curves, double minimumSpan,
                       double tickStep) {
    Lane lane;
    lane.id = id.number;
    lane.rect = new QCPAxisRect(this, true);
    lane.rect->setAutoMargins(QCP::msNone);
    lane.rect->setMinimumSize(0, 0);
    lane.panel = new ValuePanel(this);
    lane.panel->setLayer(QString::fromLatin1(kOverlay));
    lane.range = base::CalmRange(minimumSpan);
    QCPAxis* bottom = lane.rect->axis(QCPAxis::atBottom);
    QCPAxis* left = lane.rect->axis(QCPAxis::atLeft);
    bottom->setTicker(QSharedPointer<RoundTicker>::create(0.0, tr(" s")));
    bottom->ticker()->setTickCount(8);
    left->setTicker(QSharedPointer<RoundTicker>::create(tickStep));
    left->ticker()->setTickCount(kMostTicks);
    left->grid()->setZeroLinePen(Qt::NoPen);
    bottom->grid()->setZeroLinePen(Qt::NoPen);
    for (const CurveStyle& style : curves) {
        QCPGraph* graph = addGraph(bottom, left);
        graph->setAdaptiveSampling(false); // the polyline has few points already
        lane.curves.push_back({style, graph, base::SteadyNumber(style.whole ? 1.0 : 0.0)});
    }
    const auto row = static_cast<int>(m_lanes.size());
    m_grid->addElement(row, 0, lane.rect);
    m_grid->addElement(row, 1, lane.panel);
    m_lanes.push_back(std::move(lane));
}

void TimePlot::clearLanes() {
    m_jumps->setRects({});
    m_cursor->setRects({});
    placeExtras({});
    clearGraphs();
    m_grid->clear();
    m_lanes.clear();
}

void TimePlot::updateLanes() {
    std::vector<QCPAxisRect*> rects;
    for (const Lane& lane : m_lanes)
        if (lane.shown)
            rects.push_back(lane.rect);
    m_jumps->setRects(rects);
    m_cursor->setRects(rects);
    placeExtras(rects);
    setColours(m_colours);
    setMinimumHeight(minimumSizeHint().height());
    updateGeometry();
}

std::size_t TimePlot::shownLanes() const {
    return static_cast<std::size_t>(std::ranges::count_if(m_lanes, &Lane::shown));
}

void TimePlot::arrange() {
    const auto px = [this](double count) { return static_cast<int>(std::lround(count * em())); };
    m_header->setMinimumSize(0, px(kHeaderHeight_em));
    m_header->setMaximumSize(QWIDGETSIZE_MAX, px(kHeaderHeight_em));
    m_header->setMargins(QMargins(px(0.5), 0, px(0.5), 0));
    const QFontMetricsF small(base::sized(font(), base::kSmallText));
    const int left = static_cast<int>(small.horizontalAdvance(m_shape.widestTick) + small.height()) + px(1.0);
    m_grid->setColumnSpacing(px(0.6));
    m_grid->setRowSpacing(shownLanes() > 1 ? px(0.35) : 0);
    // The time axis has its own row, so that all lanes are equally high.
    m_axisRoom->setMinimumSize(0, px(kAxisHeight_em));
    m_axisRoom->setMaximumSize(QWIDGETSIZE_MAX, px(kAxisHeight_em));
    const Lane* last = nullptr;
    for (const Lane& lane : m_lanes) {
        const int top = lane.shown ? px(0.2) : 0;
        const int height = lane.shown ? QWIDGETSIZE_MAX : 0;
        lane.rect->setMargins(QMargins(left, top, 0, 0));
        lane.rect->setMaximumSize(QWIDGETSIZE_MAX, height);
        lane.panel->setMargins(QMargins(0, top, px(0.5), 0));
        lane.panel->setMinimumSize(px(m_shape.panelWidth_em), 0);
        lane.panel->setMaximumSize(px(m_shape.panelWidth_em), height);
        lane.rect->axis(QCPAxis::atBottom)->setTickLabels(false);
        lane.rect->axis(QCPAxis::atLeft)->setLabel(laneUnit(lane.id));
        lane.rect->axis(QCPAxis::atLeft)->setLabelPadding(0);
        if (lane.shown)
            last = &lane;
    }
    if (last)
        last->rect->axis(QCPAxis::atBottom)->setTickLabels(true);
}

void TimePlot::colourLane(Lane& lane) {
    styleAxes(lane.rect, font(), m_colours);
    lane.panel->setInk(base::sized(font(), base::kSmallText), m_colours.color(QPalette::Text),
                       m_colours.color(QPalette::PlaceholderText));
    auto lines = lane.panel->lines();
    for (std::size_t i = 0; i < lane.curves.size(); ++i) {
        const CurveStyle& style = lane.curves[i].style;
        const QColor colour = curveColour(style.colour, m_colours);
        // 1 px: wider lines go through Qt's stroker, which is five to ten times slower.
        lane.curves[i].graph->setPen(QPen(colour, 1.0, style.dashed ? Qt::DotLine : Qt::SolidLine));
        if (i < lines.size())
            lines[i].colour = colour;
    }
    lane.panel->setLines(std::move(lines));
}

void TimePlot::setColours(const QPalette& palette) {
    m_colours = palette;
    setBackground(QBrush(palette.color(QPalette::Base)));
    const QColor text = palette.color(QPalette::Text);
    m_header->setInk(font(), base::mixed(text, palette.color(QPalette::Base), 0.2), palette);
    m_jumps->setPen(QPen(palette.color(QPalette::PlaceholderText), 1.0, Qt::DotLine));
    m_cursor->setPen(QPen(text, 1.0));
    colourExtras(palette);
    for (Lane& lane : m_lanes)
        colourLane(lane);
    arrange();
}

void TimePlot::setProvenance(base::Provenance provenance) {
    m_header->setProvenance(provenance);
}

void TimePlot::setFixedLaneRange(LaneId lane, std::optional<ValueRange> range) {
    if (range)
        m_fixed[lane.number] = *range;
    else
        m_fixed.erase(lane.number);
}

std::optional<ValueRange> TimePlot::fixedLaneRange(LaneId lane) const {
    const auto found = m_fixed.find(lane.number);
    return found == m_fixed.end() ? std::nullopt : std::optional(found->second);
}

void TimePlot::forgetRanges() {
    for (Lane& lane : m_lanes)
        lane.range.reset();
}

void TimePlot::fillLane(Lane& lane, const SampleHistory& history, double end_s, double bucket_s) {
    std::optional<ValueRange> extent;
    m_lines.resize(std::max(m_lines.size(), lane.curves.size()));
    for (std::size_t i = 0; i < lane.curves.size(); ++i) {
        const CurveStyle& style = lane.curves[i].style;
        const auto range =
            makePolyline(history, style.column, end_s - m_span_s, end_s, bucket_s, style.period, m_lines[i]);
        for (PolylinePoint& point : m_lines[i])
            point = {point.time_s - end_s, style.display.of(point.value)};
        if (!range)
            continue;
        const ValueRange shown{style.display.of(range->low), style.display.of(range->high)};
        extent =
            extent ? ValueRange{std::min(extent->low, shown.low), std::max(extent->high, shown.high)} : shown;
    }
    const auto fixed = fixedLaneRange(lane.id);
    const ValueRange shown = fixed ? *fixed : automaticRange(lane, extent, history, end_s);
    const double padding = kAxisPadding * (shown.high - shown.low);
    const ValueRange axis{shown.low - padding, shown.high + padding};
    QCPAxis* left = lane.rect->axis(QCPAxis::atLeft);
    left->setRange(axis.low, axis.high);
    // As many labels as a low lane has room for.
    constexpr double kPerLabel_em = 1.1;
    left->ticker()->setTickCount(
        std::clamp(static_cast<int>(lane.rect->height() / (kPerLabel_em * em())), 2, kMostTicks));
    lane.rect->axis(QCPAxis::atBottom)->setRange(-m_span_s, 0.0);
    QVector<QCPGraphData> points;
    for (std::size_t i = 0; i < lane.curves.size(); ++i) {
        // Clipped here and not by the painter, because SVG pictures have no clipping.
        cutPolyline(m_lines[i], axis);
        points.resize(static_cast<qsizetype>(m_lines[i].size()));
        std::ranges::transform(m_lines[i], points.begin(),
                               [](const PolylinePoint& p) { return QCPGraphData(p.time_s, p.value); });
        lane.curves[i].graph->data()->set(points, true);
    }
}

void TimePlot::showStretch(const SampleHistory& history, double end_s, double span_s) {
    m_span_s = span_s;
    const double bucket_s = span_s / std::max(1.0, width() * devicePixelRatioF());
    for (Lane& lane : m_lanes)
        if (lane.shown)
            fillLane(lane, history, end_s, bucket_s);
    std::vector<TimeLine> jumps;
    for (std::size_t i = std::max<std::size_t>(1, history.firstAt(end_s - span_s)); i < history.size(); ++i) {
        if (history.time_s(i) > end_s)
            break;
        if (history.breakBefore(i) == Break::jump)
            jumps.push_back({history.time_s(i) - end_s, {}});
    }
    m_jumps->setLines(std::move(jumps));
}

void TimePlot::showValues(const SampleHistory& history, std::optional<std::size_t> index, bool steady) {
    for (Lane& lane : m_lanes) {
        const QString unit = laneUnit(lane.id);
        std::vector<ValuePanel::Line> lines;
        for (std::size_t i = 0; i < lane.curves.size(); ++i) {
            Curve& curve = lane.curves[i];
            std::optional<double> value;
            if (index)
                value = curve.style.display.of(history.value(curve.style.column, *index));
            curve.number.update(value);
            const QString number = steady              ? curve.number.text()
                                   : curve.style.whole ? base::wholeNumber(value)
                                                       : base::threeDigits(value);
            lines.push_back({curveColour(curve.style.colour, m_colours), curve.style.dashed,
                             curveName(lane.id, i), base::withUnit(number, unit)});
        }
        if (QCPAxis* axis = lane.rect->axis(QCPAxis::atLeft); axis->label() != unit)
            axis->setLabel(unit);
        lane.panel->setTitle(laneTitle(lane.id));
        lane.panel->setLines(std::move(lines));
    }
}

void TimePlot::setCursorLine(std::optional<double> time_s) {
    m_cursor->setLines(time_s ? std::vector<TimeLine>{{*time_s, {}}} : std::vector<TimeLine>{});
}

void TimePlot::repaintOverlay() {
    layer(QString::fromLatin1(kOverlay))->replot();
}

QPicture TimePlot::onPaper() {
    const QPalette screen = m_colours;
    setColours(base::designedPalette(false));
    QPicture picture = plot::pictureOf(*this);
    setColours(screen);
    return picture;
}

const TimePlot::Lane* TimePlot::laneOf(LaneId id) const {
    const auto found = std::ranges::find(m_lanes, id.number, &Lane::id);
    return found == m_lanes.end() ? nullptr : &*found;
}

ValueRange TimePlot::laneRange(LaneId id) const {
    const Lane* lane = laneOf(id);
    if (!lane || !lane->shown)
        return {};
    const QCPRange range = lane->rect->axis(QCPAxis::atLeft)->range();
    const double padding = range.size() * kAxisPadding / (1.0 + 2.0 * kAxisPadding);
    return {range.lower + padding, range.upper - padding};
}

QRect TimePlot::laneRect(LaneId id) const {
    const Lane* lane = laneOf(id);
    return lane && lane->shown ? lane->rect->rect() : QRect();
}

const ValuePanel* TimePlot::lanePanel(LaneId id) const {
    const Lane* lane = laneOf(id);
    return lane ? lane->panel : nullptr;
}

QCPGraph* TimePlot::laneGraph(LaneId id, std::size_t curve) const {
    const Lane* lane = laneOf(id);
    return lane && curve < lane->curves.size() ? lane->curves[curve].graph : nullptr;
}

double TimePlot::timeAt(double x) const {
    if (m_lanes.empty())
        return 0.0;
    return std::clamp(m_lanes.front().rect->axis(QCPAxis::atBottom)->pixelToCoord(x), -m_span_s, 0.0);
}

double TimePlot::xOf(double time_s) const {
    return m_lanes.empty() ? 0.0 : m_lanes.front().rect->axis(QCPAxis::atBottom)->coordToPixel(time_s);
}

std::optional<int> TimePlot::laneAt(const QPointF& point) const {
    for (const Lane& lane : m_lanes)
        if (lane.shown && lane.rect->outerRect().contains(point.toPoint()))
            return lane.id;
    return std::nullopt;
}

std::optional<int> TimePlot::laneAxisAt(const QPointF& point) const {
    const auto lane = laneAt(point);
    return lane && point.x() < laneRect(*lane).left() ? lane : std::nullopt;
}

QSize TimePlot::minimumSizeHint() const {
    const double height = kHeaderHeight_em + kAxisHeight_em +
                          m_shape.laneHeight_em * static_cast<double>(std::max<std::size_t>(1, shownLanes()));
    return {static_cast<int>(m_shape.width_em * em()), static_cast<int>(height * em())};
}

QSize TimePlot::sizeHint() const {
    return {static_cast<int>(48.0 * em()), static_cast<int>(minimumSizeHint().height() * 1.3)};
}

} // namespace teleta::charts
