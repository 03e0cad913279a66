// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/strip_plot.h"

#include "widgets/base/theme.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace teleta::charts {

namespace {

constexpr double kStripHeight_em = 4.2; ///< at least: title and two values
constexpr double kHeaderHeight_em = 1.5;
constexpr double kAxisHeight_em = 1.7;
constexpr double kPanelWidth_em = 10.5;
constexpr double kAxisPadding = 0.05; ///< of the axis' span, so that a curve at its end keeps its full width
/// The force axis reaches to this multiple of a taxel's threshold at least, so that noise stays small.
constexpr double kForceOverThreshold = 5.0;
constexpr auto kOverlay = "teleta.overlay";

} // namespace

StripPlot::StripPlot(QWidget* parent)
    : QCustomPlot(parent)
    , m_colours(palette()) {
    setFocusPolicy(Qt::NoFocus);
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
    // The cursor and the numbers have a buffer of their own: moving the mouse redraws no curve.
    addLayer(QString::fromLatin1(kOverlay));
    layer(QString::fromLatin1(kOverlay))->setMode(QCPLayer::lmBuffered);
    m_marks = new TimeLines(this, QStringLiteral("axes"));
    m_jumps = new TimeLines(this, QStringLiteral("grid"));
    m_cursor = new TimeLines(this, QString::fromLatin1(kOverlay));
    m_header->setLayer(QString::fromLatin1(kOverlay));
}

double StripPlot::em() const {
    return QFontMetricsF(font()).height();
}

StripPlot::Row StripPlot::makeRow(Strip strip) {
    Row row;
    row.definition = &definitionOf(strip);
    row.rect = new QCPAxisRect(this, true);
    row.rect->setAutoMargins(QCP::msNone);
    row.panel = new ValuePanel(this);
    row.panel->setLayer(QString::fromLatin1(kOverlay));
    row.range = base::CalmRange(row.definition->minimumSpan);
    QCPAxis* bottom = row.rect->axis(QCPAxis::atBottom);
    QCPAxis* left = row.rect->axis(QCPAxis::atLeft);
    bottom->setTicker(QSharedPointer<RoundTicker>::create(0.0, tr(" s")));
    bottom->ticker()->setTickCount(8);
    left->setTicker(QSharedPointer<RoundTicker>::create(row.definition->fixedStep));
    left->ticker()->setTickCount(4);
    left->grid()->setZeroLinePen(Qt::NoPen);
    bottom->grid()->setZeroLinePen(Qt::NoPen);
    for (const Series& series : row.definition->series) {
        QCPGraph* graph = addGraph(bottom, left);
        graph->setAdaptiveSampling(false); // the polyline has few points already
        row.graphs.push_back(graph);
        row.numbers.emplace_back(series.whole ? 1.0 : 0.0);
    }
    return row;
}

void StripPlot::setStrips(const std::vector<Strip>& strips) {
    m_marks->setRects({});
    m_jumps->setRects({});
    m_cursor->setRects({});
    clearGraphs();
    m_grid->clear();
    m_rows.clear();
    for (const Strip strip : strips) {
        m_rows.push_back(makeRow(strip));
        const auto index = static_cast<int>(m_rows.size()) - 1;
        m_grid->addElement(index, 0, m_rows.back().rect);
        m_grid->addElement(index, 1, m_rows.back().panel);
    }
    m_grid->simplify();
    std::vector<QCPAxisRect*> rects;
    for (const Row& row : m_rows)
        rects.push_back(row.rect);
    m_marks->setRects(rects);
    m_jumps->setRects(rects);
    m_cursor->setRects(rects);
    setColours(m_colours);
    setMinimumHeight(minimumSizeHint().height());
    updateGeometry();
}

void StripPlot::arrange() {
    const auto px = [this](double count) { return static_cast<int>(std::lround(count * em())); };
    m_header->setMinimumSize(0, px(kHeaderHeight_em));
    m_header->setMaximumSize(QWIDGETSIZE_MAX, px(kHeaderHeight_em));
    m_header->setMargins(QMargins(px(0.5), 0, px(0.5), 0));
    const QFontMetricsF small(base::sized(font(), base::kSmallText));
    const int left = static_cast<int>(small.horizontalAdvance(QStringLiteral("\u221288.8"))) + px(1.0);
    m_grid->setColumnSpacing(px(0.6));
    m_grid->setRowSpacing(px(0.35));
    // The time axis has a row of its own, so that all strips get the same height.
    m_axisRoom->setMinimumSize(0, px(kAxisHeight_em));
    m_axisRoom->setMaximumSize(QWIDGETSIZE_MAX, px(kAxisHeight_em));
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        Row& row = m_rows[i];
        row.rect->setMargins(QMargins(left, px(0.2), 0, 0));
        row.panel->setMargins(QMargins(0, px(0.2), px(0.5), 0));
        row.panel->setMinimumSize(px(kPanelWidth_em), 0);
        row.panel->setMaximumSize(px(kPanelWidth_em), QWIDGETSIZE_MAX);
        row.rect->axis(QCPAxis::atBottom)->setTickLabels(i + 1 == m_rows.size());
    }
}

void StripPlot::colourRow(Row& row, const QPalette& palette) {
    styleAxes(row.rect, font(), palette);
    for (std::size_t i = 0; i < row.graphs.size(); ++i) {
        const Series& series = row.definition->series[i];
        // 1 px: any wider line goes through Qt's stroker, which costs five to ten times as much.
        QPen pen(seriesColour(series, palette), 1.0);
        if (series.dashed)
            pen.setStyle(Qt::DotLine);
        row.graphs[i]->setPen(pen);
    }
    row.panel->setInk(base::sized(font(), base::kSmallText), palette.color(QPalette::Text),
                      palette.color(QPalette::PlaceholderText));
    auto lines = row.panel->lines();
    for (std::size_t i = 0; i < lines.size(); ++i)
        lines[i].colour = seriesColour(row.definition->series[i], palette);
    row.panel->setLines(std::move(lines));
}

void StripPlot::setColours(const QPalette& palette) {
    m_colours = palette;
    setBackground(QBrush(palette.color(QPalette::Base)));
    const QColor text = palette.color(QPalette::Text);
    m_header->setInk(font(), base::mixed(text, palette.color(QPalette::Base), 0.2),
                     base::statusColours(palette).simulated);
    m_marks->setPen(QPen(palette.color(QPalette::Highlight), 1.0));
    m_jumps->setPen(QPen(palette.color(QPalette::PlaceholderText), 1.0, Qt::DotLine));
    m_cursor->setPen(QPen(text, 1.0));
    for (TimeLines* lines : {m_marks, m_jumps, m_cursor})
        lines->setFont(base::sized(font(), base::kSmallText));
    for (Row& row : m_rows)
        colourRow(row, palette);
    arrange();
}

void StripPlot::setProvenance(base::Provenance provenance) {
    m_header->setBadge(base::provenanceText(provenance));
}

void StripPlot::setFixedRange(Strip strip, std::optional<ValueRange> range) {
    if (range)
        m_fixed[strip] = *range;
    else
        m_fixed.erase(strip);
}

std::optional<ValueRange> StripPlot::fixedRange(Strip strip) const {
    const auto found = m_fixed.find(strip);
    return found == m_fixed.end() ? std::nullopt : std::optional(found->second);
}

void StripPlot::forgetRanges() {
    for (Row& row : m_rows)
        row.range.reset();
}

void StripPlot::fitAxis(Row& row, std::optional<ValueRange> extent, double threshold, double time_s) {
    const StripDefinition& definition = *row.definition;
    ValueRange shown;
    if (const auto fixed = fixedRange(definition.strip)) {
        shown = *fixed;
    } else if (definition.fixedLow < definition.fixedHigh) {
        shown = {definition.fixedLow, definition.fixedHigh};
    } else {
        if (extent) {
            if (definition.strip == Strip::force && threshold > 0.0)
                row.range.setMinimumSpan(kForceOverThreshold * threshold);
            if (definition.fromZero)
                extent = ValueRange{std::min(0.0, extent->low), std::max(0.0, extent->high)};
            row.range.update(extent->low, extent->high, time_s);
        }
        shown = {row.range.low(), row.range.high()};
    }
    const double padding = kAxisPadding * (shown.high - shown.low);
    row.rect->axis(QCPAxis::atLeft)->setRange(shown.low - padding, shown.high + padding);
}

void StripPlot::fillGraphs(Row& row) {
    const QCPRange axis = row.rect->axis(QCPAxis::atLeft)->range();
    QVector<QCPGraphData> points;
    for (std::size_t i = 0; i < row.graphs.size(); ++i) {
        // Cut here and not by the painter: pictures in SVG know no clipping.
        cutPolyline(m_lines[i], {axis.lower, axis.upper});
        points.resize(static_cast<qsizetype>(m_lines[i].size()));
        std::ranges::transform(m_lines[i], points.begin(),
                               [](const PolylinePoint& p) { return QCPGraphData(p.time_s, p.value); });
        row.graphs[i]->data()->set(points, true);
    }
}

void StripPlot::showStretch(const FeatureHistory& history, double end_s, double span_s) {
    m_span_s = span_s;
    const double bucket_s = span_s / std::max(1.0, width() * devicePixelRatioF());
    const double threshold = history.empty() ? 0.0 : history.value(Channel::threshold, history.size() - 1);
    for (Row& row : m_rows) {
        std::optional<ValueRange> extent;
        m_lines.resize(row.graphs.size());
        for (std::size_t i = 0; i < row.graphs.size(); ++i) {
            const Series& series = row.definition->series[i];
            const auto range = makePolyline(history, series.channel, end_s - span_s, end_s, bucket_s,
                                            series.period, m_lines[i]);
            for (PolylinePoint& point : m_lines[i])
                point = {point.time_s - end_s, series.display.of(point.value)};
            if (!range)
                continue;
            const ValueRange shown{series.display.of(range->low), series.display.of(range->high)};
            extent = extent ? ValueRange{std::min(extent->low, shown.low), std::max(extent->high, shown.high)}
                            : shown;
        }
        fitAxis(row, extent, threshold, end_s);
        row.rect->axis(QCPAxis::atBottom)->setRange(-span_s, 0.0);
        fillGraphs(row);
    }
    std::vector<TimeLine> jumps;
    for (std::size_t i = std::max<std::size_t>(1, history.firstAt(end_s - span_s)); i < history.size(); ++i) {
        if (history.time_s(i) > end_s)
            break;
        if (history.breakBefore(i) == Break::jump)
            jumps.push_back({history.time_s(i) - end_s, {}});
    }
    m_jumps->setLines(std::move(jumps));
}

void StripPlot::showValues(const FeatureHistory& history, std::optional<std::size_t> index, bool steady) {
    for (Row& row : m_rows) {
        const QString unit = StripTexts::unit(row.definition->strip, m_loadUnit);
        std::vector<ValuePanel::Line> lines;
        for (std::size_t i = 0; i < row.graphs.size(); ++i) {
            const Series& series = row.definition->series[i];
            std::optional<double> value;
            if (index)
                value = series.display.of(history.value(series.channel, *index));
            row.numbers[i].update(value);
            const QString number = steady         ? row.numbers[i].text()
                                   : series.whole ? base::wholeNumber(value)
                                                  : base::threeDigits(value);
            lines.push_back({seriesColour(series, m_colours), series.dashed, StripTexts::name(series.channel),
                             base::withUnit(number, unit)});
        }
        row.panel->setTitle(StripTexts::title(row.definition->strip));
        row.panel->setLines(std::move(lines));
    }
}

void StripPlot::setCursorLine(std::optional<TimeLine> line) {
    std::vector<TimeLine> lines;
    if (line)
        lines.push_back(*line);
    m_cursor->setLines(std::move(lines));
}

void StripPlot::repaintOverlay() {
    layer(QString::fromLatin1(kOverlay))->replot();
}

QPicture StripPlot::onPaper() {
    const QPalette screen = m_colours;
    setColours(base::designedPalette(false));
    QPicture picture;
    QCPPainter painter;
    painter.begin(&picture);
    painter.setMode(QCPPainter::pmVectorized);
    toPainter(&painter, width(), height());
    painter.end();
    setColours(screen);
    return picture;
}

const StripPlot::Row* StripPlot::rowOf(Strip strip) const {
    const auto found =
        std::ranges::find_if(m_rows, [strip](const Row& row) { return row.definition->strip == strip; });
    return found == m_rows.end() ? nullptr : &*found;
}

ValueRange StripPlot::rangeOf(Strip strip) const {
    const Row* row = rowOf(strip);
    if (!row)
        return {};
    const QCPRange range = row->rect->axis(QCPAxis::atLeft)->range();
    const double padding = range.size() * kAxisPadding / (1.0 + 2.0 * kAxisPadding);
    return {range.lower + padding, range.upper - padding};
}

QRect StripPlot::plotRect(Strip strip) const {
    const Row* row = rowOf(strip);
    return row ? row->rect->rect() : QRect();
}

QCPGraph* StripPlot::graphOf(Strip strip, std::size_t series) const {
    const Row* row = rowOf(strip);
    return row && series < row->graphs.size() ? row->graphs[series] : nullptr;
}

const ValuePanel* StripPlot::panelOf(Strip strip) const {
    const Row* row = rowOf(strip);
    return row ? row->panel : nullptr;
}

double StripPlot::timeAt(double x) const {
    if (m_rows.empty())
        return 0.0;
    return std::clamp(m_rows.front().rect->axis(QCPAxis::atBottom)->pixelToCoord(x), -m_span_s, 0.0);
}

double StripPlot::xOf(double time_s) const {
    return m_rows.empty() ? 0.0 : m_rows.front().rect->axis(QCPAxis::atBottom)->coordToPixel(time_s);
}

std::optional<Strip> StripPlot::stripAt(const QPointF& point) const {
    for (const Row& row : m_rows)
        if (row.rect->outerRect().contains(point.toPoint()))
            return row.definition->strip;
    return std::nullopt;
}

std::optional<Strip> StripPlot::axisAt(const QPointF& point) const {
    const auto strip = stripAt(point);
    return strip && point.x() < plotRect(*strip).left() ? strip : std::nullopt;
}

QSize StripPlot::minimumSizeHint() const {
    const double height = kHeaderHeight_em + kAxisHeight_em +
                          kStripHeight_em * static_cast<double>(std::max<std::size_t>(1, m_rows.size()));
    return {static_cast<int>(26.0 * em()), static_cast<int>(height * em())};
}

QSize StripPlot::sizeHint() const {
    return {static_cast<int>(48.0 * em()), static_cast<int>(minimumSizeHint().height() * 1.3)};
}

} // namespace teleta::charts
