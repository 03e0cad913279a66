// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/controls/badge.h"
#include "widgets/base/figure_export.h"
#include "widgets/charts/sample_history.h"

#include <QAction>
#include <QPointer>
#include <QWidget>

#include <array>
#include <cstdint>
#include <optional>

class QActionGroup;
class QHBoxLayout;
class QLabel;
class QMenu;
class QToolButton;

namespace teleta::base {
class InlineEdit;
}

namespace teleta::charts {

class TimePlot;

/// What all charts over time have in common: one time axis, in seconds before the right end. Live it follows
/// the newest sample; paused it stands still while samples go on being kept.
///
/// Mouse: hover reads all curves at that time, drag and Shift+wheel scroll, Ctrl+wheel changes the span,
/// double click on an axis types its ends. Keys: Space pauses, Left and Right move the cursor, Shift with
/// them scrolls, + and - change the span, Home and End go to the oldest and to the newest sample, Ctrl+C
/// copies. Thread: GUI.
class TimeChartView : public QWidget {
    Q_OBJECT
public:
    static constexpr std::array<double, 4> kSpans_s{5.0, 10.0, 30.0, 60.0};
    static constexpr double kLongestSpan_s = 600.0;

    /// Repaints if there is something new to see. Cheap otherwise; call it from the display timer.
    void refresh();

    void setProvenance(base::Provenance provenance);
    void setEmptyText(const QString& text);

    [[nodiscard]] QAction* pauseAction() const { return m_pause; }
    [[nodiscard]] bool isPaused() const { return m_end_s.has_value(); }
    void setPaused(bool paused);

    /// Length of the time axis; clamped.
    void setSpan(double span_s);
    [[nodiscard]] double span_s() const { return m_span_s; }
    /// Chart time of the right end.
    [[nodiscard]] double end_s() const { return m_end_s.value_or(history().newestTime_s()); }
    /// Moves the stretch by so many seconds and pauses; beyond the newest sample it goes live again.
    void scrollBy(double seconds);

    /// Cursor in seconds before the right end (0 .. -span); empty: none, and the newest values are shown.
    void setCursorTime(std::optional<double> time_s);
    [[nodiscard]] std::optional<double> cursorTime_s() const { return m_cursor_s; }

    [[nodiscard]] base::Figure figure();
    [[nodiscard]] virtual const SampleHistory& history() const = 0;

signals:
    void spanChanged(double span_s);
    void pausedChanged(bool paused);
    void exported(const QString& path);
    void exportFailed(const QString& message);

protected:
    /// plot: becomes a child. The tool bar is empty and nothing is drawn before the deriving class has called
    /// addTimeTools(), retranslate() and restyle().
    TimeChartView(TimePlot* plot, double shortestSpan_s, QWidget* parent);

    /// Appends a button to the tool bar.
    QToolButton* addTool(QAction* action = nullptr);
    /// Appends the spans and Pause to the tool bar, at its right end.
    void addTimeTools();
    void addTimeActions(QMenu& menu);
    /// Those of the lane's axis, if there is a lane, and those that export.
    void addPlotActions(QMenu& menu, std::optional<int> lane);

    /// After the samples were forgotten: goes live, without a cursor.
    void reset();
    /// The next refresh() draws even when there is no new sample.
    void invalidate() { m_dirty = true; }
    void setDefaultEmptyText(const QString& text);
    virtual void retranslate();
    void restyle();
    /// The sample at the cursor, or the newest one in sight.
    [[nodiscard]] std::optional<std::size_t> shownSample() const;

    /// Gives the plot what it draws besides the curves.
    virtual void prepareExtras() = 0;
    /// Fills the context menu of a lane.
    virtual void fillMenu(QMenu& menu, std::optional<int> lane) = 0;
    /// For the header; both already written for people. time: seconds before the right end.
    [[nodiscard]] virtual QString cursorText(const QString& time, const QString& sourceTime) const = 0;
    /// Without extension.
    [[nodiscard]] virtual QString figureName() const = 0;
    /// Samples first..last (exclusive) with a header line.
    [[nodiscard]] virtual QString csv(std::size_t first, std::size_t last) const = 0;

    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void makeActions();
    void draw();
    void drawCursor();
    void updateHeader();
    void showPause();
    void moveCursor(double seconds);
    void zoomBy(double factor, double anchor_s);
    void editRange(int lane);
    void applyRangeText(int lane, const QString& text);
    void onMouseMove(const QPointF& position, Qt::MouseButtons buttons);
    [[nodiscard]] bool onWheel(QWheelEvent* event);

    TimePlot* m_plot;
    base::Provenance m_provenance = base::Provenance::live;
    QLabel* m_empty;
    bool m_defaultEmptyText = true;
    QHBoxLayout* m_tools = nullptr;
    QActionGroup* m_spanGroup;
    std::array<QAction*, kSpans_s.size()> m_spanActions{};
    QAction* m_pause;
    base::FigureExport* m_export;
    QPointer<base::InlineEdit> m_rangeEdit;
    double m_shortestSpan_s;
    double m_span_s = 10.0;
    std::optional<double> m_end_s; ///< set while paused
    std::optional<double> m_cursor_s;
    std::optional<double> m_keyboardCursor_s;
    std::optional<double> m_dragFrom_px;
    std::uint64_t m_drawn = 0;
    bool m_dirty = true;
};

} // namespace teleta::charts
