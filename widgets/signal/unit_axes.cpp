// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/signal/unit_axes.h"

#include "widgets/plot/plot_style.h"
#include "widgets/signal/step_ticker.h"
#include "widgets/signal/unit_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace teleta::signal {

namespace {

struct UnitAxesText {
    Q_DECLARE_TR_FUNCTIONS(UnitAxesText)
};

/// Of an axis whose values are all alike, around them.
double leastSpan(const ValueRange& values) {
    const double largest = std::max(std::abs(values.low), std::abs(values.high));
    // Nothing but zeros has no scale of its own.
    return largest > 0.0 ? std::max(1e-9, 1e-3 * largest) : 1.0;
}

} // namespace

UnitAxes::UnitAxes(QCPAxisRect* rect)
    : m_rect(rect) {
    // The standard axes stay for the grid and the frame; each unit has an axis of its own.
    for (const auto side : {QCPAxis::atLeft, QCPAxis::atRight}) {
        m_rect->axis(side)->setVisible(false);
        m_rect->axis(side)->grid()->setVisible(false);
    }
}

void UnitAxes::setUnits(const std::vector<QString>& units) {
    std::erase_if(m_axes, [&](auto& each) {
        if (std::ranges::find(units, each.first) != units.end())
            return false;
        m_rect->removeAxis(each.second.axis);
        return true;
    });
    for (const QString& unit : units) {
        if (m_axes.contains(unit))
            continue;
        const auto onLeft = std::ranges::count_if(
            m_axes, [](const auto& each) { return each.second.axis->axisType() == QCPAxis::atLeft; });
        const bool left = static_cast<std::size_t>(2 * onLeft) <= m_axes.size();
        QCPAxis* axis = m_rect->addAxis(left ? QCPAxis::atLeft : QCPAxis::atRight);
        axis->setTicker(QSharedPointer<QCPAxisTicker>(new StepTicker));
        m_axes[unit].axis = axis;
        style(unit, *axis);
    }
    // One grid: that of the first axis.
    bool first = true;
    for (const QString& unit : units)
        if (QCPAxis* axis = axisOf(unit)) {
            axis->grid()->setVisible(first);
            first = false;
        }
}

QCPAxis* UnitAxes::axisOf(const QString& unit) const {
    const auto found = m_axes.find(unit);
    return found == m_axes.end() ? nullptr : found->second.axis;
}

void UnitAxes::fit(const QString& unit, std::optional<ValueRange> values, double time_s, bool calm) {
    const auto found = m_axes.find(unit);
    if (found == m_axes.end() || found->second.fixed || !values)
        return;
    Axis& axis = found->second;
    if (!calm)
        axis.range.reset();
    axis.range.setMinimumSpan(leastSpan(*values));
    axis.range.update(values->low, values->high, time_s);
    axis.axis->setRange(axis.range.low(), axis.range.high());
}

void UnitAxes::zoomTo(double lowShare, double highShare) {
    for (auto& [unit, axis] : m_axes) {
        const QCPRange range = axis.axis->range();
        axis.axis->setRange(range.lower + lowShare * range.size(), range.lower + highShare * range.size());
        axis.fixed = true;
    }
}

void UnitAxes::zoomAt(QCPAxis* axis, double factor, double y) {
    for (auto& [unit, each] : m_axes)
        if (each.axis == axis) {
            axis->scaleRange(factor, axis->pixelToCoord(y));
            each.fixed = true;
        }
}

void UnitAxes::followValues() {
    for (auto& [unit, axis] : m_axes) {
        axis.fixed = false;
        axis.range.reset();
    }
}

bool UnitAxes::isFixed() const {
    return std::ranges::any_of(m_axes, [](const auto& each) { return each.second.fixed; });
}

QCPAxis* UnitAxes::at(const QPointF& point) const {
    for (const auto& [unit, axis] : m_axes)
        if (axis.axis->getPartAt(point) != QCPAxis::spNone)
            return axis.axis;
    return nullptr;
}

void UnitAxes::restyle(const QPalette& colours, const QFont& font) {
    m_colours = colours;
    m_font = font;
    for (auto& [unit, axis] : m_axes)
        style(unit, *axis.axis);
}

void UnitAxes::style(const QString& unit, QCPAxis& axis) const {
    plot::styleAxis(axis, m_colours, m_font);
    axis.setLabel(unit.isEmpty() ? UnitAxesText::tr("value") : unitText(unit));
    axis.setSubTickPen(Qt::NoPen);
}

} // namespace teleta::signal
