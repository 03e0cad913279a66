// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/control_painter.h"

#include "widgets/base/theme.h"

#include <algorithm>

namespace teleta::base {

namespace {

constexpr double kMark_px = 1.6;
constexpr double kChevronGrids = 0.5; ///< half its width
// Shares of black in what is filled.
constexpr double kUnderBlack = 0.12;
constexpr double kPressedBlack = 0.25;

} // namespace

ControlPainter::ControlPainter(QPainter& painter, const QStyleOption& option)
    : m_painter(painter)
    , m_option(option)
    , m_colours(controlColours(option.palette, option.state.testFlag(QStyle::State_Enabled)))
    , m_grid_px(std::max(4.0, 0.5 * option.fontMetrics.height())) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
}

ControlPainter::~ControlPainter() {
    m_painter.restore();
}

void ControlPainter::box(const QRectF& rect, const QColor& ground, const QColor& edge, double radius,
                         double width_px) {
    const double in = edge.isValid() ? 0.5 * width_px : 0.0;
    m_painter.setPen(edge.isValid() ? QPen(edge, width_px) : QPen(Qt::NoPen));
    m_painter.setBrush(ground.isValid() ? QBrush(ground) : QBrush(Qt::NoBrush));
    const double corner = std::max(0.0, px(radius) - in);
    m_painter.drawRoundedRect(rect.adjusted(in, in, -in, -in), corner, corner);
}

void ControlPainter::field(const QRectF& rect) {
    const bool isUsed = enabled() && has(QStyle::State_HasFocus);
    const QColor ground = m_option.palette.color(enabled() ? QPalette::Base : QPalette::Window);
    box(rect, ground, isUsed ? m_colours.ring : m_colours.edge, kControlRadius, isUsed ? kRing_px : 1.0);
}

void ControlPainter::button(bool isFilled, bool isOn) {
    const QRectF rect(m_option.rect);
    if (isFilled) {
        box(rect, filled(m_colours.accent), {});
    } else {
        QColor ground = m_option.palette.color(enabled() ? QPalette::Base : QPalette::Window);
        if (pressed() || isOn)
            ground = m_colours.pressed;
        else if (under())
            ground = mixed(ground, m_option.palette.color(QPalette::Active, QPalette::WindowText), 0.08);
        box(rect, ground, isOn && enabled() ? m_colours.ring : m_colours.edge);
    }
    if (focused())
        ring(rect);
}

QColor ControlPainter::filled(const QColor& ground) const {
    return pressed() ? mixed(ground, Qt::black, kPressedBlack)
           : under() ? mixed(ground, Qt::black, kUnderBlack)
                     : ground;
}

void ControlPainter::ring(const QRectF& rect, double radius) {
    // A gap in the colour of the ground keeps it visible around a filled button.
    box(rect.adjusted(kRing_px, kRing_px, -kRing_px, -kRing_px), {}, m_option.palette.color(QPalette::Window),
        radius);
    box(rect, {}, m_colours.ring, radius, kRing_px);
}

void ControlPainter::tick(const QRectF& box, const QColor& ink) {
    const auto at = [&](double x, double y) {
        return QPointF(box.left() + x * box.width(), box.top() + y * box.height());
    };
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(QPen(ink, kMark_px, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.drawPolyline(QPolygonF{at(0.24, 0.53), at(0.42, 0.71), at(0.76, 0.31)});
}

void ControlPainter::chevron(const QRectF& rect, Qt::ArrowType way, const QColor& ink) {
    const double half = std::min(px(kChevronGrids), 0.4 * std::min(rect.width(), 2.0 * rect.height()));
    const double turn = way == Qt::UpArrow      ? 180.0
                        : way == Qt::LeftArrow  ? 90.0
                        : way == Qt::RightArrow ? -90.0
                                                : 0.0;
    m_painter.save();
    m_painter.translate(rect.center());
    m_painter.rotate(turn);
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(QPen(ink, kMark_px, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.drawPolyline(
        QPolygonF{QPointF(-half, -0.5 * half), QPointF(0.0, 0.5 * half), QPointF(half, -0.5 * half)});
    m_painter.restore();
}

QColor ControlPainter::ink() const {
    return m_option.palette.color(enabled() ? QPalette::Active : QPalette::Disabled, QPalette::WindowText);
}

} // namespace teleta::base
