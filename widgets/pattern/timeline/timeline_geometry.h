// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/tactors.h"

#include <QFont>
#include <QRectF>
#include <QString>

#include <array>
#include <cstddef>
#include <optional>

namespace teleta::pattern {

/// Layout of the timeline and conversion between places, times and intensities. Thread: any (pure).
struct TimelineGeometry {
    /// Shows [begin_s, begin_s + span_s]; span_s > 0.
    TimelineGeometry(const QRectF& rect, const QFont& font, double begin_s, double span_s);

    double em = 16.0;
    double begin_s = 0.0;
    double span_s = 1.0;
    double handle = 4.0; ///< radius of a breakpoint's handle
    QRectF ruler, plot, legend;
    std::array<QRectF, core::kTactors> lane; ///< the whole lane, to the right of its label
    std::array<QRectF, core::kTactors> label;

    [[nodiscard]] double end_s() const { return begin_s + span_s; }
    [[nodiscard]] double xOf(double time_s) const;
    [[nodiscard]] double timeAt(double x) const;
    [[nodiscard]] double secondsPerPixel() const { return span_s / plot.width(); }
    [[nodiscard]] double yOf(std::size_t track, double intensity) const;
    /// Not clamped to 0..1.
    [[nodiscard]] double intensityAt(std::size_t track, double y) const;
    [[nodiscard]] double intensityPerPixel() const;
    [[nodiscard]] std::optional<std::size_t> laneAt(double y) const;
    /// Time between two marks of the ruler: 1, 2 or 5 times a power of ten.
    [[nodiscard]] double tickStep_s() const;

private:
    double m_padding = 5.0;
};

/// Formats a time of the ruler with as many decimals as the step needs: "0.25", "1:05", "1:00:00".
[[nodiscard]] QString timeText(double time_s, double step_s);

} // namespace teleta::pattern
