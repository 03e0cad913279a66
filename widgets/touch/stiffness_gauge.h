// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/figure/figure_view.h"
#include "widgets/touch/gauge_content.h"
#include "widgets/touch/gauge_painter.h"

#include <optional>

namespace teleta::touch {

/// Stiffness of the object that was touched last, on a logarithmic scale with the classes of the paper's
/// objects: the estimate with its 95 % interval, or the bound when only that is known, and whether the object
/// is safe, by colour, word and shape. Ctrl+C copies the picture. Thread: GUI.
class StiffnessGauge : public base::FigureView {
    Q_OBJECT
public:
    explicit StiffnessGauge(QWidget* parent = nullptr);

    /// Shows an estimate; empty: nothing was touched yet.
    void setTouch(const std::optional<stiffness::TouchStiffness>& touch);
    /// Shows why the last touch has no estimate.
    void setRefusal(stiffness::Refusal refusal);
    /// How long ago the touch was that is shown; empty: it is not known. Call it as often as you like: it
    /// repaints when the text changes, once a second at most.
    void setAge(std::optional<double> age_s);
    void setProvenance(base::Provenance provenance);
    /// What to do while nothing was touched.
    void setEmptyText(const QString& text);

    [[nodiscard]] const GaugeContent& content() const { return m_content; }
    [[nodiscard]] GaugeLayout layoutNow() const;
    [[nodiscard]] QString toolTipAt(const QPointF& point) const override;
    [[nodiscard]] base::Figure figure() override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void retranslate();
    void shown();

    GaugeContent m_content;
    bool m_defaultEmptyText = true;
};

} // namespace teleta::touch
