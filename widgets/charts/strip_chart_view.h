// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch_snapshot.h"
#include "widgets/base/badge.h"
#include "widgets/base/figure_export.h"
#include "widgets/charts/feature_history.h"
#include "widgets/charts/strips.h"

#include <QAction>
#include <QPointer>
#include <QPointF>
#include <QWidget>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

class QActionGroup;
class QLabel;
class QMenu;
class QToolButton;

namespace teleta::base {
class InlineEdit;
}

namespace teleta::charts {

class StripPlot;
struct ValueRange;

/// Features over time: strips one below the other with one time axis, in seconds before the right end. Live
/// it follows the newest sample; paused it stands still while samples go on being kept.
///
/// Mouse: hover reads all strips at that time, drag and Shift+wheel scroll, Ctrl+wheel changes the span,
/// double click on an axis types its ends. Keys: Space pauses, Left and Right move the cursor, Shift with
/// them scrolls, + and - change the span, Home and End go to the oldest and to the newest sample, M marks,
/// Ctrl+C copies. Thread: GUI.
class StripChartView : public QWidget {
    Q_OBJECT
public:
    static constexpr std::array<double, 4> kSpans_s{5.0, 10.0, 30.0, 60.0};
    static constexpr double kShortestSpan_s = 0.2;
    static constexpr double kLongestSpan_s = 600.0;

    explicit StripChartView(QWidget* parent = nullptr);

    /// Keeps samples; nothing is drawn before refresh().
    void append(const pipeline::FeatureSample& sample);
    void append(std::span<const pipeline::FeatureSample> samples);
    /// Repaints if there is something new to see. Cheap otherwise; call it from the display timer.
    void refresh();
    /// Forgets samples and marks, and goes live.
    void clear();

    void setLoadUnit(const QString& unit);
    void setProvenance(base::Provenance provenance);
    void setEmptyText(const QString& text);

    /// Checkable; for menus and for remembering.
    [[nodiscard]] QAction* stripAction(Strip strip) const;
    [[nodiscard]] std::vector<Strip> shownStrips() const;
    [[nodiscard]] QAction* pauseAction() const { return m_pause; }
    [[nodiscard]] bool isPaused() const { return m_end_s.has_value(); }
    void setPaused(bool paused);

    /// Length of the time axis; clamped.
    void setSpan(double span_s);
    [[nodiscard]] double span_s() const { return m_span_s; }
    /// Chart time of the right end.
    [[nodiscard]] double end_s() const { return m_end_s.value_or(m_history.newestTime_s()); }
    /// Moves the stretch by so many seconds and pauses; beyond the newest sample it goes live again.
    void scrollBy(double seconds);

    /// A vertical line with a label where the stream was at that time of its own. False when it is no longer
    /// kept.
    bool addMark(double sourceTime_s, const QString& label);
    [[nodiscard]] std::size_t marks() const { return m_marks.size(); }

    /// Cursor in seconds before the right end (0 .. -span); empty: none, and the newest values are shown.
    void setCursorTime(std::optional<double> time_s);
    [[nodiscard]] std::optional<double> cursorTime_s() const { return m_cursor_s; }

    [[nodiscard]] base::Figure figure();
    void populateMenu(QMenu& menu, std::optional<Strip> strip = std::nullopt);

    [[nodiscard]] const FeatureHistory& history() const { return m_history; }
    [[nodiscard]] StripPlot* plot() const { return m_plot; }

signals:
    /// The user wants a mark at that time of the stream.
    void markRequested(double sourceTime_s);
    void stripsChanged();
    void spanChanged(double span_s);
    void pausedChanged(bool paused);
    void exported(const QString& path);
    void exportFailed(const QString& message);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    struct Mark {
        double time_s = 0.0; ///< chart time
        QString label;
    };

    void makeActions();
    QWidget* makeToolBar();
    void retranslate();
    void restyle();
    void takeStrips();
    void draw();
    void drawCursor();
    void updateHeader();
    void moveCursor(double seconds);
    void zoomBy(double factor, double anchor_s);
    void requestMark();
    void editRange(Strip strip);
    void applyRangeText(Strip strip, const QString& text);
    void onMouseMove(const QPointF& position, Qt::MouseButtons buttons);
    [[nodiscard]] bool onWheel(QWheelEvent* event);
    [[nodiscard]] std::optional<std::size_t> shownSample() const;

    FeatureHistory m_history;
    std::vector<Mark> m_marks;
    StripPlot* m_plot = nullptr;
    QLabel* m_empty = nullptr;
    QToolButton* m_stripsButton = nullptr;
    QMenu* m_stripsMenu = nullptr;
    std::array<QAction*, kStrips> m_stripActions{};
    QActionGroup* m_spanGroup = nullptr;
    std::array<QAction*, kSpans_s.size()> m_spanActions{};
    QAction* m_pause = nullptr;
    QAction* m_mark = nullptr;
    base::FigureExport* m_export = nullptr;
    QPointer<base::InlineEdit> m_rangeEdit;
    double m_span_s = 10.0;
    std::optional<double> m_end_s; ///< set while paused
    std::optional<double> m_cursor_s;
    std::optional<double> m_keyboardCursor_s;
    std::optional<double> m_dragFrom_px;
    std::uint64_t m_drawn = 0;
    bool m_dirty = true;
};

} // namespace teleta::charts
