// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/arm_device.h"
#include "backend/pipeline/touch_record.h"
#include "backend/stiffness/joint_sample.h"
#include "widgets/base/badge.h"
#include "widgets/base/figure_export.h"
#include "widgets/charts/sample_history.h"

#include <QAction>
#include <QWidget>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

class QActionGroup;
class QLabel;
class QMenu;

namespace teleta::charts {

class JointPlot;

/// Torques and, if wanted, angles of the arm's joints over time. The torques between which a touch is
/// evaluated are marked as a band, each touch is shaded from its first torque to its estimate. Live it
/// follows the newest sample; paused it stands still while samples go on being kept.
///
/// Mouse: hover reads all curves at that time, drag and Shift+wheel scroll, Ctrl+wheel changes the span.
/// Keys: Space pauses, Left and Right move the cursor, Shift with them scrolls, + and - change the span, Home
/// and End go to the oldest and to the newest sample, Ctrl+C copies. Thread: GUI.
class JointChartView : public QWidget {
    Q_OBJECT
public:
    static constexpr std::array<double, 4> kSpans_s{5.0, 10.0, 30.0, 60.0};
    static constexpr double kShortestSpan_s = 0.05; ///< a quick touch fills the picture
    static constexpr double kLongestSpan_s = 600.0;

    explicit JointChartView(QWidget* parent = nullptr);

    /// Keeps samples; nothing is drawn before refresh().
    void append(std::span<const core::JointSample> samples);
    /// Shades a touch. False when its start is no longer kept.
    bool addTouch(const pipeline::TouchRecord& touch);
    /// Repaints if there is something new to see. Cheap otherwise; call it from the display timer.
    void refresh();
    /// Forgets samples and touches, and goes live.
    void clear();

    void setWindow(const stiffness::TorqueWindow& window);
    void setProvenance(base::Provenance provenance);
    void setEmptyText(const QString& text);
    [[nodiscard]] QAction* anglesAction() const { return m_angles; }
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
    /// Pauses so that a touch lies in the middle. False when it is no longer kept.
    bool showTouch(std::uint64_t number);
    /// Cursor in seconds before the right end (0 .. -span); empty: none.
    void setCursorTime(std::optional<double> time_s);
    [[nodiscard]] std::optional<double> cursorTime_s() const { return m_cursor_s; }

    [[nodiscard]] base::Figure figure();
    void populateMenu(QMenu& menu);
    [[nodiscard]] const SampleHistory& history() const { return m_history; }
    [[nodiscard]] JointPlot* plot() const { return m_plot; }

signals:
    void spanChanged(double span_s);
    void pausedChanged(bool paused);
    void anglesChanged(bool shown);
    void exported(const QString& path);
    void exportFailed(const QString& message);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    struct Touch {
        std::uint64_t number = 0;
        double from_s = 0.0, to_s = 0.0; ///< chart times
    };

    QWidget* makeToolBar();
    void retranslate();
    void restyle();
    void draw();
    void drawCursor();
    void updateHeader();
    void moveCursor(double seconds);
    void zoomBy(double factor, double anchor_s);
    [[nodiscard]] bool onWheel(QWheelEvent* event);
    [[nodiscard]] std::optional<std::size_t> shownSample() const;
    [[nodiscard]] QString csv() const;

    SampleHistory m_history;
    std::vector<Touch> m_touches;
    JointPlot* m_plot;
    QLabel* m_empty;
    bool m_defaultEmptyText = true;
    QActionGroup* m_spanGroup;
    std::array<QAction*, kSpans_s.size()> m_spanActions{};
    QAction* m_angles;
    QAction* m_pause;
    base::FigureExport* m_export;
    double m_span_s = 10.0;
    std::optional<double> m_end_s; ///< set while paused
    std::optional<double> m_cursor_s;
    std::optional<double> m_keyboardCursor_s;
    std::optional<double> m_dragFrom_px;
    std::uint64_t m_drawn = 0;
    bool m_dirty = true;
};

} // namespace teleta::charts
