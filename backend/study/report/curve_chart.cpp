// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/curve_chart.h"

#include "backend/figure/round_step.h"

#include <algorithm>
#include <cmath>

namespace teleta::study {

namespace {

constexpr double kCurveLeft = 76.0;
constexpr double kCurveTop = 64.0;
constexpr double kCurveWidth = 460.0; // of the plotting area
constexpr double kCurveHeight = 300.0;
constexpr double kCurveBottom = 60.0;
constexpr double kCurveRight = 20.0;

QString curveClass(std::size_t index) {
    return QStringLiteral("series%1").arg(index % figure::SvgCanvas::kSeries);
}

} // namespace

double AxisRange::step() const {
    return figure::roundStep((high - low) / 6.0);
}

AxisRange AxisRange::rounded() const {
    const double by = step();
    return {by * std::floor(low / by + 1e-9), by * std::ceil(high / by - 1e-9)};
}

CurveChart::CurveChart(const QString& title, const QString& xTitle, const QString& yTitle, AxisRange x,
                       AxisRange y)
    : m_x(x)
    , m_y(y)
    , m_canvas(kCurveLeft + kCurveWidth + kCurveRight, kCurveTop + kCurveHeight + kCurveBottom, title)
    , m_legend(kCurveLeft + 4.0) {
    const double right = kCurveLeft + kCurveWidth;
    const double bottom = kCurveTop + kCurveHeight;
    m_canvas.text((kCurveLeft + right) / 2.0, 24.0, title, QStringLiteral("ink middle bold"));
    m_canvas.text((kCurveLeft + right) / 2.0, bottom + 46.0, xTitle, QStringLiteral("ink middle"));
    const double middle = (kCurveTop + bottom) / 2.0;
    m_canvas.text(20.0, middle, yTitle, QStringLiteral("ink middle"),
                  QStringLiteral("transform=\"rotate(-90 20 %1)\"").arg(figure::svgNumber(middle)));
    const auto ticks = [](const AxisRange& axis, const auto& draw) {
        const double by = axis.step();
        for (double i = std::ceil(axis.low / by - 1e-9); i * by <= axis.high + 1e-9 * by; i += 1.0)
            draw(i * by);
    };
    ticks(m_y, [&](double value) {
        m_canvas.line(kCurveLeft, down(value), right, down(value), QStringLiteral("soft"));
        m_canvas.text(kCurveLeft - 8.0, down(value) + 5.0, QString::number(value, 'g', 4),
                      QStringLiteral("ink end"));
    });
    ticks(m_x, [&](double value) {
        m_canvas.line(across(value), bottom, across(value), bottom + 5.0, QStringLiteral("ink"));
        m_canvas.text(across(value), bottom + 22.0, QString::number(value, 'g', 4),
                      QStringLiteral("ink middle"));
    });
    m_canvas.line(kCurveLeft, kCurveTop, kCurveLeft, bottom, QStringLiteral("ink"));
    m_canvas.line(kCurveLeft, bottom, right, bottom, QStringLiteral("ink"));
}

double CurveChart::across(double x) const {
    return kCurveLeft + kCurveWidth * std::clamp((x - m_x.low) / (m_x.high - m_x.low), 0.0, 1.0);
}

double CurveChart::down(double y) const {
    return kCurveTop + kCurveHeight * (1.0 - std::clamp((y - m_y.low) / (m_y.high - m_y.low), 0.0, 1.0));
}

void CurveChart::curve(const NamedCurve& curve) {
    std::vector<std::pair<double, double>> points;
    for (const auto& [x, y] : curve.points)
        points.emplace_back(across(x), down(y));
    const QString style = QStringLiteral("class=\"hollow %1\"").arg(curveClass(m_curves));
    if (points.size() > 1)
        m_canvas.path(points, style);
    if (!curve.name.empty()) {
        const QString name = QString::fromStdString(curve.name);
        m_canvas.path({{m_legend, kCurveTop - 17.0}, {m_legend + 16.0, kCurveTop - 17.0}}, style);
        m_canvas.text(m_legend + 22.0, kCurveTop - 12.5, name, QStringLiteral("ink small"));
        m_legend += 40.0 + 7.0 * static_cast<double>(name.size());
    }
    ++m_curves;
}

void CurveChart::bar(double x, double low, double high) {
    const QString style = curveClass(m_curves == 0 ? 0 : m_curves - 1) + QStringLiteral(" bar");
    m_canvas.line(across(x), down(low), across(x), down(high), style);
    for (const double end : {low, high})
        m_canvas.line(across(x) - 5.0, down(end), across(x) + 5.0, down(end), style);
}

void CurveChart::level(double y, const QString& name) {
    const double right = kCurveLeft + kCurveWidth;
    m_canvas.line(kCurveLeft, down(y), right, down(y), QStringLiteral("dashed"));
    m_canvas.text(right - 4.0, down(y) - 6.0, name, QStringLiteral("soft small end"));
}

} // namespace teleta::study
