// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/tokens.h"

#include <QPainter>
#include <QRect>
#include <QStyleOption>

namespace teleta::base {

/// Paints the flat parts that ConsoleStyle makes its controls of, by the palette and the state of an option.
/// Leaves the painter as it was. Thread: GUI.
class ControlPainter {
public:
    static constexpr double kRing_px = 2.0; ///< around what has the focus

    ControlPainter(QPainter& painter, const QStyleOption& option);
    ~ControlPainter();
    ControlPainter(const ControlPainter&) = delete;
    ControlPainter& operator=(const ControlPainter&) = delete;

    [[nodiscard]] const ControlColours& colours() const { return m_colours; }
    [[nodiscard]] bool enabled() const { return has(QStyle::State_Enabled); }
    [[nodiscard]] bool under() const { return enabled() && has(QStyle::State_MouseOver); }
    [[nodiscard]] bool pressed() const { return enabled() && has(QStyle::State_Sunken); }
    /// Has the focus, and it came by the keyboard.
    [[nodiscard]] bool focused() const {
        return has(QStyle::State_HasFocus) && has(QStyle::State_KeyboardFocusChange);
    }
    [[nodiscard]] bool has(QStyle::StateFlag state) const { return m_option.state.testFlag(state); }
    /// A token's length in px, of the option's font.
    [[nodiscard]] double px(double grids) const { return m_grid_px * grids; }

    /// A rounded box with an edge; an invalid colour leaves out its part.
    void box(const QRectF& rect, const QColor& ground, const QColor& edge, double radius = kControlRadius,
             double width_px = 1.0);
    /// The ground of a part that is filled: darker under the mouse and while it is pressed, so that white
    /// text on it can be read.
    [[nodiscard]] QColor filled(const QColor& ground) const;
    /// A field for text or a number: the edge of one that has the focus is the accent.
    void field(const QRectF& rect);
    /// A push button; a filled one is that which the view is for.
    void button(bool isFilled, bool isOn);
    void ring(const QRectF& rect, double radius = kControlRadius);
    void tick(const QRectF& box, const QColor& ink);
    void chevron(const QRectF& rect, Qt::ArrowType way, const QColor& ink);
    /// The colour of a mark in a control: text, or faint while it is disabled.
    [[nodiscard]] QColor ink() const;

private:
    QPainter& m_painter;
    const QStyleOption& m_option;
    ControlColours m_colours;
    double m_grid_px;
};

} // namespace teleta::base
