// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/timeline/timeline_geometry.h"

#include "widgets/base/numbers/calm_range.h"

#include <QFontMetricsF>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace teleta::pattern {

namespace {

constexpr double kSmallest_px = 1.0;
constexpr double kTickApart_em = 5.0;

} // namespace

TimelineGeometry::TimelineGeometry(const QRectF& rect, const QFont& font, double begin, double span)
    : em(QFontMetricsF(font).height())
    , begin_s(begin)
    , span_s(span) {
    const double gutter = 3.6 * em;
    ruler = QRectF(rect.left() + gutter, rect.top(), std::max(kSmallest_px, rect.width() - gutter - 0.5 * em),
                   1.7 * em);
    legend = QRectF(rect.left() + 0.5 * em, rect.bottom() - 1.5 * em, rect.width() - em, 1.5 * em);
    plot = QRectF(ruler.left(), ruler.bottom(), ruler.width(),
                  std::max(kSmallest_px, legend.top() - ruler.bottom()));
    const double height = plot.height() / static_cast<double>(core::kTactors);
    handle = std::clamp(0.27 * em, 3.5, 0.16 * height + 1.5);
    m_padding = std::min(handle + 2.0, 0.2 * height);
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        const double top = plot.top() + height * static_cast<double>(i);
        lane[i] = QRectF(plot.left(), top, plot.width(), height);
        label[i] = QRectF(rect.left(), top, gutter, height);
    }
}

double TimelineGeometry::xOf(double time_s) const {
    return plot.left() + (time_s - begin_s) / span_s * plot.width();
}

double TimelineGeometry::timeAt(double x) const {
    return begin_s + (x - plot.left()) / plot.width() * span_s;
}

double TimelineGeometry::yOf(std::size_t track, double intensity) const {
    const QRectF& rect = lane[track];
    return rect.bottom() - m_padding - intensity * (rect.height() - 2.0 * m_padding);
}

double TimelineGeometry::intensityAt(std::size_t track, double y) const {
    return (lane[track].bottom() - m_padding - y) * intensityPerPixel();
}

double TimelineGeometry::intensityPerPixel() const {
    return 1.0 / std::max(kSmallest_px, lane[0].height() - 2.0 * m_padding);
}

std::optional<std::size_t> TimelineGeometry::laneAt(double y) const {
    for (std::size_t i = 0; i < core::kTactors; ++i)
        if (y >= lane[i].top() && y < lane[i].bottom())
            return i;
    return std::nullopt;
}

double TimelineGeometry::tickStep_s() const {
    const double wanted_s = kTickApart_em * em * secondsPerPixel();
    if (wanted_s <= 10.0)
        return base::niceStep(wanted_s);
    for (const double step_s : {15.0, 30.0, 60.0, 120.0, 300.0, 600.0, 1800.0, 3600.0})
        if (step_s >= wanted_s)
            return step_s;
    return 7200.0 * std::ceil(wanted_s / 7200.0);
}

QString timeText(double time_s, double step_s) {
    constexpr qint64 kMinute_s = 60;
    constexpr qint64 kHour_s = 3600;
    if (step_s < 10.0 && time_s < static_cast<double>(kMinute_s)) {
        int decimals = 0;
        for (double s = step_s; decimals < 6 && std::abs(s - std::round(s)) > 1e-6; s *= 10.0)
            ++decimals;
        return QLocale().toString(time_s, 'f', decimals);
    }
    const auto whole = static_cast<qint64>(std::floor(time_s + 1e-6));
    const double part = time_s - static_cast<double>(whole);
    const auto two = [](qint64 value) { return QStringLiteral("%1").arg(value, 2, 10, QLatin1Char('0')); };
    QString text = whole < kHour_s
                       ? QStringLiteral("%1:%2").arg(whole / kMinute_s).arg(two(whole % kMinute_s))
                       : QStringLiteral("%1:%2:%3")
                             .arg(whole / kHour_s)
                             .arg(two(whole % kHour_s / kMinute_s), two(whole % kMinute_s));
    if (step_s < 1.0) {
        const int decimals = static_cast<int>(std::ceil(-std::log10(step_s) - 1e-9));
        text += QLocale().toString(std::max(part, 0.0), 'f', decimals).mid(1);
    }
    return text;
}

} // namespace teleta::pattern
