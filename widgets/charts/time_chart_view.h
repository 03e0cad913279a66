// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/controls/badge.h"
#include "widgets/base/figure/figure_view.h"
#include "widgets/charts/sample_history.h"

#include <QAction>
#include <QActionGroup>
#include <QPointer>

#include <array>
#include <cstdint>
#include <optional>

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace teleta::base {
class InlineEdit;
}

namespace teleta::charts {

class TimePlot;

/// Base of all charts over time: one time axis, in seconds before the right end. Live it follows the newest
/// sample; paused it stands still while samples are still collected.
///
/// Mouse: hover reads all curves at that time, drag and Shift+wheel scroll, Ctrl+wheel changes the span, a
/// double click on an axis edits its range. Keys: Space pauses, Left and Right move the cursor, with Shift
/// they scroll, + and - change the span, Home and End go to the oldest and the newest sample. Thread: GUI.
class TimeChartView : public base::FigureView {
    Q_OBJECT
public:
    static constexpr std::array<double, 4> kSpans_s{5.0, 10.0, 30.0, 60.0};
    static constexpr double kLongestSpan_s = 600.0;

    /// Repaints if anything visible has changed, at little cost otherwise. While samples keep coming, the
    /// chart scrolls in steps of at least two pixels. Call it from the display timer.
    void refresh();

    void setProvenance(base::Provenance provenance);
    void setEmptyText(const QString& text);

    [[nodiscard]] bool isPaused() const { return m_end_s.has_value(); }
    void setPaused(bool paused);

    /// Length of the time axis; clamped.
    void setSpan(double span_s);
    [[nodiscard]] double span_s() const { return m_span_s; }
    /// Chart time of the right end.
    [[nodiscard]] double end_s() const { return m_end_s.value_or(history().newestTime_s()); }
    /// Scrolls by some seconds and pauses; scrolling beyond the newest sample goes live again.
    void scrollBy(double seconds);

    /// Cursor in seconds before the right end (0 .. -span); empty: none, and the newest values are shown.
    void setCursorTime(std::optional<double> time_s);
    [[nodiscard]] std::optional<double> cursorTime_s() const { return m_cursor_s; }

    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] base::Figure figure() override;
    [[nodiscard]] virtual const SampleHistory& history() const = 0;

protected:
    /// plot: becomes a child. The derived class must call addTimeTools(), retranslate() and restyle(); until
    /// then the tool bar is empty and nothing is drawn.
    TimeChartView(TimePlot* plot, double shortestSpan_s, QWidget* parent);

    /// Appends a button to the tool bar.
    QToolButton* addTool(QAction* action = nullptr);
    /// Appends the spans and Pause to the right end of the tool bar.
    void addTimeTools();
    void addTimeActions(QMenu& menu);
    /// Actions for the axis of the lane at that place, if any.
    void addRangeActions(QMenu& menu, const QPoint& position);

    /// Call after clearing the samples: goes live, without a cursor.
    void reset();
    /// The next refresh() draws even without a new sample.
    void invalidate() { m_dirty = true; }
    void setDefaultEmptyText(const QString& text);
    virtual void retranslate();
    void restyle();
    /// The sample at the cursor, or the newest visible one.
    [[nodiscard]] std::optional<std::size_t> shownSample() const;

    /// Passes the plot what it draws besides the curves.
    virtual void prepareExtras() = 0;
    /// Header texts. time: seconds before the right end.
    [[nodiscard]] virtual QString cursorText(const QString& time, const QString& sourceTime) const = 0;
    /// File name without extension.
    [[nodiscard]] virtual QString figureName() const = 0;
    /// Samples first..last (exclusive) with a header line.
    [[nodiscard]] virtual QString csv(std::size_t first, std::size_t last) const = 0;

    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void makeActions();
    /// Those whose name can go: a picture and a tool tip say the same.
    [[nodiscard]] QList<QToolButton*> namedTools() const;
    /// Of the tool bar, with or without these names.
    [[nodiscard]] int toolsWidth(bool named) const;
    void fitTools();
    void draw();
    /// Whether the newest sample lies visibly later than the newest that is drawn.
    [[nodiscard]] bool hasScrolled() const;
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
    QActionGroup* m_spanGroup = new QActionGroup(this);
    std::array<QAction*, kSpans_s.size()> m_spanActions{};
    QAction* m_pause;
    QPointer<base::InlineEdit> m_rangeEdit;
    double m_shortestSpan_s;
    double m_span_s = 10.0;
    std::optional<double> m_end_s; ///< set while paused
    std::optional<double> m_cursor_s;
    std::optional<double> m_keyboardCursor_s;
    std::optional<double> m_dragFrom_px;
    std::uint64_t m_drawn = 0;
    std::uint64_t m_seen = 0; ///< samples at the last refresh
    double m_drawnTime_s = 0.0;
    bool m_dirty = true;
};

} // namespace teleta::charts
