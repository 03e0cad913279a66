// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/strip_plot.h"

#include "widgets/base/theme.h"

#include <algorithm>

namespace teleta::charts {

namespace {

/// The force axis extends to at least this multiple of a taxel's threshold, so that noise is not magnified.
constexpr double kForceOverThreshold = 5.0;

constexpr Strip stripOfLane(int lane) {
    return static_cast<Strip>(lane);
}

} // namespace

StripPlot::StripPlot(QWidget* parent)
    : TimePlot({.width_em = 26.0,
                .laneHeight_em = 3.0, // title and two values, closely
                .panelWidth_em = 10.5,
                .widestTick = QStringLiteral("\u221288.8")},
               parent)
    , m_marks(new TimeLines(this, QStringLiteral("axes"))) {
}

void StripPlot::setStrips(const std::vector<Strip>& strips) {
    clearLanes();
    for (const Strip strip : strips) {
        const StripDefinition& definition = definitionOf(strip);
        addLane(strip, definition.curves, definition.minimumSpan, definition.fixedStep);
    }
    updateLanes();
}

void StripPlot::colourExtras(const QPalette& palette) {
    m_marks->setPen(QPen(palette.color(QPalette::Highlight), 1.0));
    m_marks->setFont(base::sized(font(), base::kSmallText));
}

ValueRange StripPlot::automaticRange(Lane& lane, std::optional<ValueRange> extent,
                                     const SampleHistory& history, double end_s) {
    const StripDefinition& definition = definitionOf(stripOfLane(lane.id));
    if (definition.fixedLow < definition.fixedHigh)
        return {definition.fixedLow, definition.fixedHigh};
    if (extent) {
        if (definition.strip == Strip::force) {
            const double threshold =
                history.value(static_cast<std::size_t>(Channel::threshold), history.size() - 1);
            if (threshold > 0.0)
                lane.range.setMinimumSpan(kForceOverThreshold * threshold);
        }
        if (definition.fromZero)
            extent = ValueRange{std::min(0.0, extent->low), std::max(0.0, extent->high)};
        lane.range.update(extent->low, extent->high, end_s);
    }
    return {lane.range.low(), lane.range.high()};
}

QString StripPlot::laneTitle(int lane) const {
    return titleOf(stripOfLane(lane));
}

QString StripPlot::laneUnit(int lane) const {
    const Strip strip = stripOfLane(lane);
    return strip == Strip::force || strip == Strip::shear ? m_loadUnit
                                                          : QString::fromUtf8(definitionOf(strip).unit);
}

QString StripPlot::curveName(int lane, std::size_t curve) const {
    return nameOf(static_cast<Channel>(definitionOf(stripOfLane(lane)).curves[curve].column));
}

} // namespace teleta::charts
