// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/signal/series.h"
#include "widgets/base/numbers/calm_range.h"

#include <qcustomplot.h>
#include <QFont>
#include <QPalette>
#include <QString>

#include <map>
#include <optional>
#include <vector>

namespace teleta::signal {

/// The value axes of a plot: one a unit, in turn on the left and on the right. An axis follows its values
/// unless somebody has set its range. Thread: GUI.
class UnitAxes {
public:
    explicit UnitAxes(QCPAxisRect* rect);

    /// Keeps the axes of these units and makes those that are missing. Graphs of axes that go must be gone.
    void setUnits(const std::vector<QString>& units);
    [[nodiscard]] QCPAxis* axisOf(const QString& unit) const;
    [[nodiscard]] std::size_t count() const { return m_axes.size(); }

    /// Extremes of what the axis shows. calm: they narrow only after a while.
    void fit(const QString& unit, std::optional<ValueRange> values, double time_s, bool calm);
    /// By the user; all of them by shares of the height, 0 below.
    void zoomTo(double lowShare, double highShare);
    void zoomAt(QCPAxis* axis, double factor, double y);
    void followValues();
    [[nodiscard]] bool isFixed() const;
    /// The axis at a point; null: none.
    [[nodiscard]] QCPAxis* at(const QPointF& point) const;

    void restyle(const QPalette& colours, const QFont& font);

private:
    struct Axis {
        QCPAxis* axis = nullptr;
        base::CalmRange range{1e-12};
        bool fixed = false;
    };

    void style(const QString& unit, QCPAxis& axis) const;

    QCPAxisRect* m_rect;
    std::map<QString, Axis> m_axes;
    QPalette m_colours;
    QFont m_font;
};

} // namespace teleta::signal
