// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/equilibration/load_calibration.h"
#include "backend/pipeline/touch/frame_loads.h"
#include "backend/pipeline/touch/touch_snapshot.h"
#include "widgets/base/figure/figure_view.h"
#include "widgets/base/numbers/calm_range.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/steady_estimate.h"
#include "widgets/tactile/heatmap_content.h"
#include "widgets/tactile/heatmap_painter.h"

#include <QAction>
#include <QPointer>
#include <QPointF>

#include <array>
#include <optional>

namespace teleta::base {
class InlineEdit;
}

namespace teleta::tactile {

/// The tactile array as a picture: loads as colours, contacts, centres, principal axis, dead taxels. Shows
/// the last snapshot given to it.
///
/// Mouse: hover reads a taxel, Ctrl+wheel zooms, dragging moves a zoomed picture, a double click shows all of
/// it again, a double click on the colour bar edits its upper end. Keys: arrows move the read-out, + - 0
/// zoom, Shift+arrows move the picture. Thread: GUI.
class HeatmapView : public base::FigureView {
    Q_OBJECT
public:
    using Overlay = tactile::Overlay;

    explicit HeatmapView(QWidget* parent = nullptr);

    /// Shows a new snapshot. One whose vectors do not fit its layout clears the view.
    void setSnapshot(const pipeline::TouchSnapshot& snapshot);
    /// The loads that a calibration of the array gives of its frame; nothing: there are none.
    void setLoads(const std::optional<pipeline::LoadReading>& loads);
    /// What the header said when it was last painted, see HeatmapPainter; empty while there is no frame.
    [[nodiscard]] QString headerText() const { return m_content.valid ? m_painter.headerText() : QString(); }
    void clear();
    void setEmptyText(const QString& text);
    void setProvenance(base::Provenance provenance);
    /// Whether the source sends nothing any more; its last frame is shown faded then, and says so.
    void setOld(bool old);

    /// Checkable; for menus and for remembering.
    [[nodiscard]] QAction* overlayAction(Overlay overlay) const;

    /// Upper end of the colours; empty: follows the data. > 0 and finite, others are ignored.
    void setFixedRange(std::optional<double> top);
    [[nodiscard]] std::optional<double> fixedRange() const { return m_fixedTop; }
    /// The upper end in use.
    [[nodiscard]] double rangeTop() const { return m_content.rangeTop; }

    void resetZoom();
    [[nodiscard]] double zoomFactor() const { return m_content.zoom.factor; }

    /// The taxel being read, by mouse or keyboard.
    [[nodiscard]] std::optional<Taxel> cursorTaxel() const { return m_content.cursor; }
    /// Text of the read-out; empty without a cursor.
    [[nodiscard]] QString readout() const;

    /// The whole array, whatever part is visible.
    [[nodiscard]] base::Figure figure() override;

    [[nodiscard]] HeatmapLayout layoutNow() const;

protected:
    [[nodiscard]] QString toolTipAt(const QPointF& pixel) const override;
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void addOwnActions(QMenu& menu, const QPoint& position) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void retranslate();
    void updateRange();
    void setCursorTaxel(std::optional<Taxel> taxel);
    void moveCursor(int rows, int columns);
    void zoomBy(double factor, const QPointF& pixel);
    void panBy(const QPointF& taxels);
    void editRange();
    [[nodiscard]] QRectF rangeEditArea() const;

    HeatmapContent m_content;
    HeatmapPainter m_painter;
    base::CalmRange m_range;
    base::CalmRange m_shearRange;
    std::optional<double> m_fixedTop;
    base::SteadyNumber m_force;
    base::SteadyNumber m_shear;
    base::SteadyNumber m_angle{1.0};
    std::array<base::SteadyEstimate, equilibration::kLoadColumns.size()> m_loads;
    std::array<QAction*, kOverlays> m_overlayActions{};
    QPointer<base::InlineEdit> m_rangeEdit;
    std::optional<Taxel> m_keyboardTaxel;
    std::optional<QPointF> m_dragFrom;
};

} // namespace teleta::tactile
