// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/signal/series.h"
#include "backend/signal/spectrum.h"
#include "widgets/base/controls/badge.h"
#include "widgets/base/figure/figure_export.h"
#include "widgets/base/figure/sized_view.h"
#include "widgets/signal/unit_axes.h"

#include <QPalette>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

class QCustomPlot;
class QCPGraph;
class QCPItemStraightLine;
class QCPItemText;
class QMenu;
class QRubberBand;

namespace teleta::signal {

/// A line of the plot.
struct PlotCurve {
    QString name;
    QString unit;
    int colour = 1;                           ///< of an identity
    std::shared_ptr<const Series> series;     ///< null: its source is not there
    std::shared_ptr<const Spectrum> spectrum; ///< null: none is shown
    bool events = false;                      ///< points without a line
    double shift_s = 0.0;                     ///< from the times of the series to those of the axis
    bool grows = true;                        ///< not a recording as a whole
};

/// Signals over time, one value axis a unit, with two cursors; below, their spectra. The time axis follows
/// the newest sample, of what grows if anything does, or stands still.
///
/// Mouse: drag scrolls, Ctrl and drag zooms into a rectangle, the wheel zooms the time at the pointer, over a
/// value axis that axis, Shift and wheel scrolls, a double click shows everything; a cursor can be dragged.
/// Keys: Space follows or holds, + and - zoom, Left and Right move cursor A, with Ctrl cursor B, with Shift
/// they scroll, C shows the cursors, Home shows everything, End follows, Ctrl+C copies the picture.
/// Thread: GUI.
class SignalPlot : public base::SizedView {
    Q_OBJECT

public:
    static constexpr double kShortestSpan_s = 1e-5;

    explicit SignalPlot(QWidget* parent = nullptr);

    void setCurves(std::vector<PlotCurve> curves);
    [[nodiscard]] const std::vector<PlotCurve>& curves() const { return m_curves; }
    void setProvenance(base::Provenance provenance);
    /// Times are clock times, Unix times in s, instead of those since the start of each source.
    void setClockTime(bool clock);
    /// Spectra show the density of power instead of the amplitude.
    void setDensity(bool density);
    /// Draws if anything has changed, at little cost otherwise. Call it from the display timer.
    void refresh();

    [[nodiscard]] double from_s() const { return m_from_s; }
    [[nodiscard]] double to_s() const { return m_to_s; }
    [[nodiscard]] double span_s() const { return m_to_s - m_from_s; }
    /// Holds this time range.
    void setRange(double from_s, double to_s);
    [[nodiscard]] bool isFollowing() const { return m_following; }
    void setFollowing(bool following);
    /// All samples, and value axes that follow their values.
    void showEverything();
    void zoomBy(double factor, double at_s);

    [[nodiscard]] bool hasCursors() const { return m_cursors.has_value(); }
    void setCursors(bool shown);
    /// Times of A and B; empty: not shown.
    [[nodiscard]] std::optional<std::array<double, 2>> cursors_s() const { return m_cursors; }
    void moveCursor(int cursor, double time_s);

    [[nodiscard]] base::Figure figure();
    void addPictureActions(QMenu& menu) { m_export->addPictureActions(menu); }

    /// Where a time is drawn, in this widget.
    [[nodiscard]] double xOf(double time_s) const;
    [[nodiscard]] QCustomPlot* plot() const { return m_plot; }
    [[nodiscard]] const UnitAxes& axes() const { return m_axes; }

signals:
    void followingChanged(bool following);
    void cursorsChanged();
    void menuRequested(const QPoint& global);
    void exportFailed(const QString& message);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum class Drag { none, scroll, rectangle, cursor };

    void arrange();
    void draw();
    void drawSpectra();
    void drawCursors();
    /// Draws them alone.
    void showCursors();
    void restyle(const QPalette& colours);
    void onPress(const QMouseEvent& event);
    void onMove(const QMouseEvent& event);
    void onRelease(const QMouseEvent& event);
    void onWheel(const QWheelEvent& event);
    [[nodiscard]] std::optional<int> cursorAt(const QPointF& point) const;
    [[nodiscard]] double timeAt(double x) const;
    /// Oldest and newest of all samples, or of those of what grows.
    [[nodiscard]] std::optional<ValueRange> extent_s(bool growing = false) const;
    void styleTime();
    [[nodiscard]] std::uint64_t appended() const;

    std::vector<PlotCurve> m_curves;
    QPalette m_colours;
    QCustomPlot* m_plot;
    base::FigureExport* m_export;
    UnitAxes m_axes;
    std::vector<QCPGraph*> m_graphs;
    QCPAxisRect* m_spectrumRect = nullptr; ///< null: no spectrum is shown
    std::array<QCPItemStraightLine*, 2> m_lines{};
    std::array<QCPItemText*, 2> m_letters{};
    QRubberBand* m_band;

    double m_from_s = 0.0, m_to_s = 10.0;
    bool m_following = true;
    bool m_density = false;
    bool m_clock = false;
    base::Provenance m_provenance = base::Provenance::live;
    std::optional<std::array<double, 2>> m_cursors;
    bool m_dirty = true;
    std::uint64_t m_drawn = 0;
    std::vector<Sample> m_line; ///< reused

    Drag m_drag = Drag::none;
    int m_dragged = 0; ///< cursor
    QPointF m_dragFrom;
    double m_dragFrom_s = 0.0;
};

} // namespace teleta::signal
