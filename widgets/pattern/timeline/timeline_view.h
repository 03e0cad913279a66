// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/figure/figure_export.h"
#include "widgets/base/figure/sized_view.h"
#include "widgets/pattern/document/pattern_document.h"
#include "widgets/pattern/document/pattern_reference.h"
#include "widgets/pattern/timeline/timeline_curves.h"
#include "widgets/pattern/timeline/timeline_geometry.h"

#include <QPixmap>
#include <QScrollBar>

#include <optional>

class QMenu;

namespace teleta::pattern {

/// The six tracks of a document over time, with commanded and predicted curves in one lane each, breakpoints
/// as handles and objects as blocks. Mouse and keys are described in its What's This. Thread: GUI.
class TimelineView : public base::SizedView {
    Q_OBJECT
public:
    /// document: outlives the view.
    explicit TimelineView(PatternDocument* document, QWidget* parent = nullptr);

    /// Shows the whole pattern.
    void zoomToFit();
    /// Shows [begin, begin + span], limited to a useful range for the pattern.
    void showSpan(double begin_s, double span_s);
    [[nodiscard]] double begin_s() const { return m_begin_s; }
    [[nodiscard]] double span_s() const { return m_span_s; }

    /// Moves the playhead, clamped to the pattern. Emits nothing.
    void setPlayhead(double time_s);
    [[nodiscard]] double playhead_s() const { return m_playhead_s; }

    void setLoop(std::optional<Span> loop);
    [[nodiscard]] const std::optional<Span>& loop() const { return m_loop; }
    /// With the pen each click adds a breakpoint.
    void setPen(bool pen);
    [[nodiscard]] bool pen() const { return m_pen; }
    /// The pattern drawn behind this one for comparison.
    [[nodiscard]] PatternReference* reference() const { return m_reference; }
    [[nodiscard]] PatternOverview* overview() const { return m_overview; }
    /// Scrolls, and zooms out if necessary, to show a span.
    void reveal(Span span);

    [[nodiscard]] TimelineGeometry geometryNow() const;
    /// Number of handles drawn by the last paint event.
    [[nodiscard]] int drawnHandles() const { return m_drawnHandles; }
    [[nodiscard]] std::size_t currentLane() const { return m_lane; }
    [[nodiscard]] base::Figure figure() const;
    void populateMenu(QMenu& menu, std::optional<QPointF> at = std::nullopt);
    /// Opens a field for typing time and intensity of a breakpoint.
    void editPoint(PointRef point);

signals:
    /// The user has moved the playhead.
    void playheadMoved(double time_s);
    void loopChanged();
    void penChanged(bool pen);
    /// The user has pressed Space.
    void playToggled();
    /// Show an object in the inspector.
    void objectActivated(std::size_t object);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    enum class Grab { none, playhead, loop, points, object, box };

    void retranslate();
    void invalidate();
    void updateScrollBar();
    void refreshCurves();
    void movePlayhead(double time_s);
    void dragTo(const QPointF& at, Qt::KeyboardModifiers modifiers);
    void finishBox();
    void zoomAround(double anchor_s, double factor);
    void setCurrentLane(std::size_t lane);
    void stepPoint(int direction, bool extends);
    void stepObject(int direction);
    void nudge(int key, Qt::KeyboardModifiers modifiers);
    [[nodiscard]] std::optional<PointRef> pointAt(const QPointF& at) const;
    [[nodiscard]] std::optional<std::size_t> objectAt(const QPointF& at) const;
    [[nodiscard]] QString describe(const QPointF& at) const;
    [[nodiscard]] QString describePoint(PointRef point) const;
    [[nodiscard]] double longestSpan_s() const;

    PatternDocument* m_document;
    QScrollBar* m_scroll = new QScrollBar(Qt::Horizontal, this);
    base::FigureExport* m_export;
    PatternOverview* m_overview;
    PatternReference* m_reference;
    TimelineCurves m_curves;
    TimelineBands m_bands;
    CompiledPattern m_compiledReference;
    TimelineCurves m_referenceCurves;
    TimelineBands m_referenceBands;
    QPixmap m_layer; ///< everything except the playhead and the selection box
    bool m_layerValid = false;
    int m_drawnHandles = 0;

    double m_begin_s = 0.0;
    double m_span_s = 2.0;
    double m_playhead_s = 0.0;
    std::optional<Span> m_loop;
    std::size_t m_lane = 0;
    bool m_pen = false;

    Grab m_grab = Grab::none;
    bool m_moved = false;
    QPointF m_press, m_now;
    PointRef m_grabbed;
    double m_grabbed_s = 0.0;
    Selection m_beforeBox;
};

} // namespace teleta::pattern
