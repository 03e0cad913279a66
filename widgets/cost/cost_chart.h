// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/cost/cost_result.h"
#include "widgets/base/figure/figure_export.h"
#include "widgets/base/figure/sized_view.h"

#include <QPalette>

#include <optional>

class QCustomPlot;

namespace teleta::cost {

/// Mean error of the rungs of a ladder over the time of a call, both on logarithmic axes: the frontier as a
/// staircase through filled points, the others hollow, a ring around the rung in use, a line at the time
/// budget. A rung without any error lies on the lower border. Thread: GUI.
class CostChart : public base::SizedView {
    Q_OBJECT
public:
    explicit CostChart(QWidget* parent = nullptr);

    void setLadder(const cost::LadderCost& ladder);
    /// Empty: none of these.
    void setRungInUse(const QString& name);
    /// Only calls that end left of it are quick enough.
    void setBudget(std::optional<double> budget_s);
    void setChosen(const QString& name);

    [[nodiscard]] base::Figure figure();
    /// Where a rung is drawn, in this widget; empty for one that is not.
    [[nodiscard]] std::optional<QPointF> pointOf(const QString& name) const;

signals:
    /// A click on a point.
    void rungClicked(const QString& name);
    void exportFailed(const QString& message);

private:
    void restyle(const QPalette& colours);
    void draw();
    void setRanges();
    void drawNames();
    [[nodiscard]] double heightOf(const cost::RungCost& rung) const;
    void onClick(const QPointF& position);

    cost::LadderCost m_ladder;
    QString m_inUse;
    QString m_chosen;
    std::optional<double> m_budget_s;
    QPalette m_colours;
    QCustomPlot* m_plot;
};

} // namespace teleta::cost
