// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/figure/sized_view.h"
#include "widgets/pattern/document/pattern_document.h"

#include <vector>

namespace teleta::pattern {

/// The unrolled forearm. A stroke drawn with the mouse becomes an object of the pattern that starts at the
/// playhead and moves as fast as it was drawn. The width is once around the arm (tactors at 0 to 300
/// degrees); the row of the even tactors is at the top, that of the odd ones below. With keys a cursor adds
/// points kKeyStep_s apart. Thread: GUI.
class StrokePad : public base::SizedView {
    Q_OBJECT
public:
    static constexpr double kKeyStep_s = 0.25;

    explicit StrokePad(PatternDocument* document, QWidget* parent = nullptr);

    /// Sets where the next stroke begins.
    void setStart(double start_s) { m_start_s = start_s; }
    /// Converts angle and place along the arm to a point of the pad, and back.
    [[nodiscard]] QPointF placeOf(double angle_rad, double along) const;
    [[nodiscard]] StrokePoint pointAt(const QPointF& at) const;

signals:
    /// A stroke was added to the pattern.
    void drawn(double begin_s, double end_s);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void retranslate();
    [[nodiscard]] QRectF arm() const;
    void append(const QPointF& at, quint64 timestamp_ms);
    void moveCursor(int key, bool fine);
    void setPointAtCursor();
    void finish();
    void giveUp();

    PatternDocument* m_document;
    std::vector<StrokePoint> m_drawn;
    quint64 m_begin_ms = 0;
    double m_start_s = 0.0;
    bool m_drawing = false;
    StrokePoint m_cursor; ///< moved by the keys
    bool m_cursorShown = false;
};

} // namespace teleta::pattern
