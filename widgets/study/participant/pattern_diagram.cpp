// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/participant/pattern_diagram.h"

#include "widgets/base/theme.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace teleta::study {

namespace {

constexpr double kOn = 0.02;         ///< below it a tactor counts as off
constexpr double kSame = 0.01;       ///< two tactors that never differ by more do the same
constexpr double kArm = 0.55;        ///< radius of the arm in that of the ring
constexpr double kTactor = 0.27;     ///< radius of a tactor in that of the ring
constexpr double kRingHeight = 0.68; ///< share of the picture's height

bool isOn(const PatternDiagram& diagram, std::size_t tactor) {
    return diagram.strongest[tactor] > kOn;
}

std::vector<std::size_t> tactorsOn(const PatternDiagram& diagram) {
    std::vector<std::size_t> on;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        if (isOn(diagram, i))
            on.push_back(i);
    }
    return on;
}

bool allTheSame(const PatternDiagram& diagram, const std::vector<std::size_t>& tactors) {
    return std::all_of(diagram.course.begin(), diagram.course.end(), [&](const core::Intensities& at) {
        return std::all_of(tactors.begin(), tactors.end(),
                           [&](std::size_t i) { return std::abs(at[i] - at[tactors.front()]) <= kSame; });
    });
}

QPainterPath curve(const PatternDiagram& diagram, std::size_t tactor, const QRectF& lane) {
    QPainterPath path(lane.bottomLeft());
    const double step = lane.width() / static_cast<double>(PatternDiagram::kColumns);
    for (std::size_t c = 0; c < PatternDiagram::kColumns; ++c) {
        const double y = lane.bottom() - diagram.course[c][tactor] * lane.height();
        path.lineTo(lane.left() + static_cast<double>(c) * step, y);
        path.lineTo(lane.left() + static_cast<double>(c + 1) * step, y);
    }
    path.lineTo(lane.bottomRight());
    path.closeSubpath();
    return path;
}

void paintRing(QPainter& painter, const QRectF& rect, const PatternDiagram& diagram,
               const QPalette& palette) {
    const QColor ground = palette.color(QPalette::Base);
    const QColor text = palette.color(QPalette::Text);
    const QColor accent = palette.color(QPalette::Highlight);
    const QPointF middle = rect.center();
    const double radius = 0.5 * std::min(rect.width(), rect.height()) / (1.0 + kTactor);
    painter.setPen(QPen(base::mixed(ground, text, 0.35), std::max(1.0, 0.03 * radius)));
    painter.setBrush(base::mixed(ground, text, 0.06));
    painter.drawEllipse(middle, kArm * radius, kArm * radius);
    QFont font = base::bold(painter.font());
    font.setPixelSize(std::max(7, static_cast<int>(0.34 * radius)));
    painter.setFont(font);
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        const double angle_rad =
            std::numbers::pi * (0.5 + 2.0 * static_cast<double>(i) / static_cast<double>(core::kTactors));
        const QPointF at = middle + radius * QPointF(std::cos(angle_rad), -std::sin(angle_rad));
        const QColor fill = isOn(diagram, i) ? base::mixed(ground, accent, diagram.strongest[i]) : ground;
        painter.setPen(
            QPen(base::mixed(ground, text, isOn(diagram, i) ? 0.9 : 0.4), std::max(1.0, 0.04 * radius)));
        painter.setBrush(fill);
        painter.drawEllipse(at, kTactor * radius, kTactor * radius);
        if (diagram.turn[i] > 0) {
            painter.setPen(base::readableOn(fill));
            painter.drawText(QRectF(at - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius)),
                             Qt::AlignCenter, QString::number(diagram.turn[i]));
        }
    }
}

} // namespace

PatternDiagram diagramOf(const pattern::Pattern& pattern, double span_s) {
    PatternDiagram diagram;
    diagram.span_s = span_s;
    const pattern::CompiledPattern compiled(pattern);
    std::array<std::size_t, core::kTactors> begin{};
    begin.fill(PatternDiagram::kColumns);
    for (std::size_t c = 0; c < PatternDiagram::kColumns; ++c) {
        // Columns are evaluated at their centre: at a step either side would do.
        const double t_s =
            span_s * (static_cast<double>(c) + 0.5) / static_cast<double>(PatternDiagram::kColumns);
        diagram.course[c] = compiled.evaluate(t_s);
        for (std::size_t i = 0; i < core::kTactors; ++i) {
            diagram.strongest[i] = std::max(diagram.strongest[i], diagram.course[c][i]);
            if (diagram.course[c][i] > kOn)
                begin[i] = std::min(begin[i], c);
        }
    }
    std::vector<std::size_t> begins;
    for (const std::size_t i : tactorsOn(diagram))
        begins.push_back(begin[i]);
    std::sort(begins.begin(), begins.end());
    // Onsets within one column of the previous one count as simultaneous.
    std::vector<std::size_t> groups;
    for (const std::size_t at : begins) {
        if (groups.empty() || at > groups.back() + 1)
            groups.push_back(at);
    }
    if (groups.size() < 2)
        return diagram;
    for (const std::size_t i : tactorsOn(diagram)) {
        const auto later = std::upper_bound(groups.begin(), groups.end(), begin[i]);
        diagram.turn[i] = static_cast<int>(later - groups.begin());
    }
    return diagram;
}

void paintDiagram(QPainter& painter, const QRectF& rect, const PatternDiagram& diagram,
                  const QPalette& palette) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF ring(rect.left(), rect.top(), rect.width(), kRingHeight * rect.height());
    paintRing(painter, ring, diagram, palette);

    const QRectF strip(rect.left() + 0.06 * rect.width(), ring.bottom() + 0.05 * rect.height(),
                       0.88 * rect.width(), rect.bottom() - ring.bottom() - 0.07 * rect.height());
    const QColor ground = palette.color(QPalette::Base);
    const QColor text = palette.color(QPalette::Text);
    painter.setPen(QPen(base::mixed(ground, text, 0.35), 1.0));
    painter.drawLine(strip.bottomLeft(), strip.bottomRight());
    const std::vector<std::size_t> on = tactorsOn(diagram);
    if (!on.empty()) {
        const std::size_t lanes = allTheSame(diagram, on) ? 1 : on.size();
        const double height = strip.height() / static_cast<double>(lanes);
        const QColor accent = palette.color(QPalette::Highlight);
        painter.setPen(QPen(base::mixed(accent, text, 0.2), 1.0));
        painter.setBrush(base::mixed(ground, accent, 0.55));
        for (std::size_t lane = 0; lane < lanes; ++lane)
            painter.drawPath(curve(diagram, on[lane],
                                   QRectF(strip.left(), strip.top() + static_cast<double>(lane) * height,
                                          strip.width(), 0.92 * height)));
    }
    painter.restore();
}

} // namespace teleta::study
