// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/figures/level_chart.h"

#include "backend/figure/round_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::study {

namespace {

constexpr double kLeftEdge = 72.0;
constexpr double kRightEdge = 24.0;
constexpr double kTopEdge = 92.0;
constexpr double kBottomEdge = 58.0;
constexpr double kInnerWidth = LevelChart::kWidth - kLeftEdge - kRightEdge;
constexpr double kInnerHeight = LevelChart::kHeight - kTopEdge - kBottomEdge;
constexpr double kRadius = 4.5;

QString seriesClass(std::size_t series, const QString& others = {}) {
    return QStringLiteral("class=\"%1series%2\"")
        .arg(others.isEmpty() ? QString() : others + QLatin1Char(' '))
        .arg(series % figure::SvgCanvas::kSeries);
}

double shareOf(const ChartAxis& axis, double value) {
    const double low = onScale(axis.scale, axis.low);
    const double high = onScale(axis.scale, axis.high);
    const double place = axis.scale == LevelScale::log10 && value <= 0.0 ? low : onScale(axis.scale, value);
    return std::clamp((place - low) / (high - low), 0.0, 1.0);
}

} // namespace

std::vector<double> ticksOf(const ChartAxis& axis) {
    std::vector<double> ticks;
    if (axis.scale == LevelScale::linear) {
        const double step = figure::roundStep((axis.high - axis.low) / 6.0);
        for (double i = std::ceil(axis.low / step - 1e-9); i * step <= axis.high + 1e-9 * step; ++i)
            ticks.push_back(i * step);
        return ticks;
    }
    for (int power = -9; power <= 9; ++power) {
        for (const double factor : {1.0, 2.0, 5.0}) {
            const double tick = factor * std::pow(10.0, power);
            if (tick >= axis.low * (1.0 - 1e-9) && tick <= axis.high * (1.0 + 1e-9))
                ticks.push_back(tick);
        }
    }
    return ticks;
}

LevelChart::LevelChart(const QString& title, ChartAxis x, ChartAxis y)
    : m_x(std::move(x))
    , m_y(std::move(y))
    , m_canvas(kWidth, kHeight, title)
    , m_legend(kLeftEdge + 8.0) {
    m_canvas.text(kLeftEdge + kInnerWidth / 2.0, 24.0, title, QStringLiteral("ink middle bold"));
    drawAxes();
}

double LevelChart::across(double x) const {
    return kLeftEdge + kInnerWidth * shareOf(m_x, x);
}

double LevelChart::down(double y) const {
    return kTopEdge + kInnerHeight * (1.0 - shareOf(m_y, y));
}

void LevelChart::drawAxes() {
    const double bottom = kTopEdge + kInnerHeight;
    for (const double tick : ticksOf(m_y)) {
        m_canvas.line(kLeftEdge, down(tick), kLeftEdge + kInnerWidth, down(tick), QStringLiteral("soft"));
        m_canvas.text(kLeftEdge - 8.0, down(tick) + 5.0, QString::number(tick, 'g', 4),
                      QStringLiteral("ink end"));
    }
    if (!m_x.title.isEmpty()) {
        for (const double tick : ticksOf(m_x)) {
            m_canvas.line(across(tick), bottom, across(tick), bottom + 5.0, QStringLiteral("ink"));
            m_canvas.text(across(tick), bottom + 21.0, QString::number(tick, 'g', 4),
                          QStringLiteral("ink middle"));
        }
        m_canvas.text(kLeftEdge + kInnerWidth / 2.0, bottom + 45.0, m_x.title, QStringLiteral("ink middle"));
    }
    const double middle = kTopEdge + kInnerHeight / 2.0;
    m_canvas.text(18.0, middle, m_y.title, QStringLiteral("ink middle"),
                  QStringLiteral("transform=\"rotate(-90 18 %1)\"").arg(figure::svgNumber(middle)));
    m_canvas.line(kLeftEdge, kTopEdge, kLeftEdge, bottom, QStringLiteral("ink"));
    m_canvas.line(kLeftEdge, bottom, kLeftEdge + kInnerWidth, bottom, QStringLiteral("ink"));
}

void LevelChart::dot(double x, double y, std::size_t series, double area, bool hollow) {
    m_canvas.circle(across(x), down(y), kRadius * std::sqrt(area),
                    seriesClass(series, hollow ? QStringLiteral("hollow") : QString()));
}

void LevelChart::diamond(double x, double y, std::size_t series) {
    m_canvas.diamond(across(x), down(y), kRadius + 5.0, seriesClass(series, QStringLiteral("hollow")));
}

void LevelChart::curve(const std::vector<std::pair<double, double>>& points, std::size_t series) {
    std::vector<std::pair<double, double>> way;
    for (const auto& [x, y] : points)
        way.emplace_back(across(x), down(y));
    m_canvas.path(way, seriesClass(series, QStringLiteral("hollow")));
}

void LevelChart::band(const std::vector<double>& x, const std::vector<Interval>& y, std::size_t series) {
    std::vector<std::pair<double, double>> way;
    for (std::size_t i = 0; i < x.size(); ++i)
        way.emplace_back(across(x[i]), down(y[i].high));
    for (std::size_t i = x.size(); i-- > 0;)
        way.emplace_back(across(x[i]), down(y[i].low));
    m_canvas.path(way, seriesClass(series) + QStringLiteral(" fill-opacity=\"0.16\""));
}

void LevelChart::barAcross(double y, const Interval& x, std::size_t series) {
    const QString style = QStringLiteral("bar series%1").arg(series % figure::SvgCanvas::kSeries);
    m_canvas.line(across(x.low), down(y), across(x.high), down(y), style);
    for (const double end : {x.low, x.high})
        m_canvas.line(across(end), down(y) - 6.0, across(end), down(y) + 6.0, style);
}

void LevelChart::barUp(double x, const Interval& y, std::size_t series) {
    const QString style = QStringLiteral("bar series%1").arg(series % figure::SvgCanvas::kSeries);
    m_canvas.line(across(x), down(y.low), across(x), down(y.high), style);
    for (const double end : {y.low, y.high})
        m_canvas.line(across(x) - 6.0, down(end), across(x) + 6.0, down(end), style);
}

void LevelChart::levelLine(double y, const QString& name) {
    m_canvas.line(kLeftEdge, down(y), kLeftEdge + kInnerWidth, down(y), QStringLiteral("dashed"));
    m_canvas.text(kLeftEdge + kInnerWidth - 4.0, down(y) - 5.0, name, QStringLiteral("soft small end"));
}

void LevelChart::placeLine(double x) {
    m_canvas.line(across(x), kTopEdge, across(x), kTopEdge + kInnerHeight, QStringLiteral("dashed"));
}

void LevelChart::remark(const QString& text) {
    m_canvas.text(kLeftEdge + kInnerWidth / 2.0, 44.0 + 16.0 * m_remarks++, text,
                  QStringLiteral("soft small middle"));
}

void LevelChart::legend(std::size_t series, const QString& name, bool hollow, bool isDiamond) {
    const double y = kTopEdge - 14.0;
    const QString look = seriesClass(series, hollow || isDiamond ? QStringLiteral("hollow") : QString());
    if (isDiamond)
        m_canvas.diamond(m_legend, y, kRadius + 3.0, look);
    else
        m_canvas.circle(m_legend, y, kRadius, look);
    m_canvas.text(m_legend + 12.0, y + 4.5, name, QStringLiteral("ink small"));
    m_legend += 34.0 + 6.6 * static_cast<double>(name.size());
}

void LevelChart::category(double x, const QString& name) {
    m_canvas.text(across(x), kTopEdge + kInnerHeight + 21.0, name, QStringLiteral("ink small middle"));
}

} // namespace teleta::study
