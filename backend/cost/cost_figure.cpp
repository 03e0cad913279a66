// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/cost_figure.h"

#include "backend/cost/frontier.h"
#include "backend/figure/svg_canvas.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace teleta::cost {

namespace {

using figure::SvgCanvas;
using figure::svgNumber;

struct CostFigureText {
    Q_DECLARE_TR_FUNCTIONS(CostFigureText)
};

constexpr double kFigureWidth = 760.0;
constexpr double kFigureHeight = 520.0;
constexpr double kPlotLeft = 96.0;
constexpr double kPlotTop = 56.0;
constexpr double kPlotRight = kFigureWidth - 28.0;
constexpr double kPlotBottom = kFigureHeight - 84.0;

/// A logarithmic axis over whole decades.
struct LogAxis {
    int low = 0; ///< exponents of ten
    int high = 1;
    double from = 0.0; ///< px
    double to = 1.0;

    [[nodiscard]] double at(double value) const {
        return from + (to - from) * (std::log10(value) - low) / static_cast<double>(high - low);
    }
};

LogAxis axisOver(const std::vector<double>& values, double from, double to) {
    LogAxis axis{.from = from, .to = to};
    if (values.empty())
        return axis;
    const auto [least, most] = std::ranges::minmax_element(values);
    axis.low = static_cast<int>(std::floor(std::log10(*least)));
    axis.high = std::max(axis.low + 1, static_cast<int>(std::ceil(std::log10(*most))));
    return axis;
}

QString powerOfTen(int exponent) {
    return QStringLiteral("1e%1").arg(exponent);
}

QString timeTick(int exponent) {
    int left = exponent;
    for (const char* unit : {"s", "ms", "us", "ns"}) {
        if (left >= 0 && left < 3)
            return QStringLiteral("%1 %2").arg(std::lround(std::pow(10.0, left))).arg(QLatin1String(unit));
        left += 3;
    }
    return powerOfTen(exponent) + QStringLiteral(" s");
}

struct Box {
    double left, top, right, bottom;
    [[nodiscard]] bool meets(const Box& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

struct PlottedRung {
    const RungCost* rung;
    double x;
    double y;
};

bool isPlotted(const RungCost& rung) {
    return rung.isTimed() && rung.timeMedian_s > 0.0 && !std::isnan(rung.errorMean);
}

void drawAxes(SvgCanvas& canvas, const LogAxis& time, const LogAxis& error, const QString& unit,
              bool hasZero) {
    for (int exponent = time.low; exponent <= time.high; ++exponent) {
        const double x = time.at(std::pow(10.0, exponent));
        canvas.line(x, kPlotTop, x, kPlotBottom, QStringLiteral("soft"));
        canvas.text(x, kPlotBottom + 18.0, timeTick(exponent), QStringLiteral("soft small middle"));
    }
    for (int exponent = error.low; exponent <= error.high; ++exponent) {
        const double y = error.at(std::pow(10.0, exponent));
        canvas.line(kPlotLeft, y, kPlotRight, y, QStringLiteral("soft"));
        canvas.text(kPlotLeft - 8.0, y + 4.0, powerOfTen(exponent), QStringLiteral("soft small end"));
    }
    canvas.line(kPlotLeft, kPlotTop, kPlotLeft, kPlotBottom, QStringLiteral("ink"));
    canvas.line(kPlotLeft, kPlotBottom, kPlotRight, kPlotBottom, QStringLiteral("ink"));
    if (hasZero)
        canvas.text(kPlotLeft - 8.0, kPlotBottom + 4.0, QStringLiteral("0"),
                    QStringLiteral("soft small end"));
    canvas.text(0.5 * (kPlotLeft + kPlotRight), kPlotBottom + 40.0,
                CostFigureText::tr("Median time of one call"), QStringLiteral("ink middle"));
    const double middle = 0.5 * (kPlotTop + kPlotBottom);
    canvas.text(22.0, middle,
                unit == QStringLiteral("1") ? CostFigureText::tr("Mean error (share)")
                                            : CostFigureText::tr("Mean error (%1)").arg(unit),
                QStringLiteral("ink middle"),
                QStringLiteral("transform=\"rotate(-90 22 %1)\"").arg(svgNumber(middle)));
}

/// Names beside their points where there is room; those on the front first.
void drawNames(SvgCanvas& canvas, std::vector<PlottedRung> points) {
    constexpr double kLetter = 6.4;
    constexpr double kHeight = 14.0;
    std::vector<Box> taken;
    for (const PlottedRung& point : points)
        taken.push_back({point.x - 6.0, point.y - 6.0, point.x + 6.0, point.y + 6.0});
    std::stable_partition(points.begin(), points.end(),
                          [](const PlottedRung& point) { return point.rung->pareto; });
    for (const PlottedRung& point : points) {
        const QString name = QString::fromStdString(point.rung->name);
        const double width = kLetter * static_cast<double>(name.size()) * (point.rung->pareto ? 1.1 : 1.0);
        constexpr std::array<std::pair<double, double>, 6> kBeside{
            {{10.0, -6.0}, {10.0, 14.0}, {-10.0, -6.0}, {-10.0, 14.0}, {10.0, -20.0}, {-10.0, -20.0}}};
        for (const auto& [dx, dy] : kBeside) {
            const double left = dx > 0.0 ? point.x + dx : point.x + dx - width;
            const Box box{left, point.y + dy - kHeight + 3.0, left + width, point.y + dy + 3.0};
            const bool inside = box.left > kPlotLeft && box.right < kPlotRight && box.top > kPlotTop - 14.0 &&
                                box.bottom < kPlotBottom + 4.0;
            if (!inside || std::ranges::any_of(taken, [&](const Box& other) { return other.meets(box); }))
                continue;
            taken.push_back(box);
            canvas.text(left, point.y + dy, name,
                        point.rung->pareto ? QStringLiteral("ink small bold") : QStringLiteral("soft small"));
            break;
        }
    }
}

} // namespace

std::string costSvg(const LadderCost& ladder, const std::string& title) {
    const QString name = QString::fromStdString(title);
    SvgCanvas canvas(kFigureWidth, kFigureHeight, name);
    canvas.text(kPlotLeft, 32.0, name, QStringLiteral("ink bold"));

    std::vector<double> times_s, errors;
    QStringList left;
    bool hasZero = false;
    const auto over = overLimit(ladder.rungs);
    if (over)
        times_s.push_back(over->limit->timeMedian_s);
    for (const RungCost& rung : ladder.rungs) {
        if (rung.isLimit())
            continue;
        if (!isPlotted(rung)) {
            left << QString::fromStdString(rung.name);
            continue;
        }
        times_s.insert(times_s.end(), {rung.timeMedian_s, std::max(rung.timeMedian_s, rung.timeP99_s)});
        hasZero = hasZero || rung.errorMean <= 0.0;
        for (const double error : {rung.errorMean, rung.errorP95})
            if (error > 0.0)
                errors.push_back(error);
    }
    const LogAxis time = axisOver(times_s, kPlotLeft, kPlotRight);
    const LogAxis error = axisOver(errors, hasZero ? kPlotBottom - 24.0 : kPlotBottom, kPlotTop);
    drawAxes(canvas, time, error, QString::fromStdString(ladder.errorUnit), hasZero);
    if (over) {
        const double x = time.at(over->limit->timeMedian_s);
        canvas.path({{x, kPlotTop}, {x, kPlotBottom}},
                    QStringLiteral("class=\"hollow series1\" stroke-dasharray=\"6 4\""));
        canvas.text(x + 6.0, kPlotTop + 14.0,
                    CostFigureText::tr("Limit: %1").arg(QString::fromStdString(over->limit->parameter)),
                    QStringLiteral("soft small"));
    }

    std::vector<PlottedRung> points;
    for (const RungCost& rung : ladder.rungs)
        if (isPlotted(rung))
            points.push_back({&rung, time.at(rung.timeMedian_s),
                              rung.errorMean > 0.0 ? error.at(rung.errorMean) : kPlotBottom});

    std::vector<PlottedRung> front;
    std::ranges::copy_if(points, std::back_inserter(front),
                         [](const PlottedRung& p) { return p.rung->pareto; });
    std::ranges::sort(front, {}, &PlottedRung::x);
    std::vector<std::pair<double, double>> stairs;
    for (const PlottedRung& point : front) {
        if (!stairs.empty())
            stairs.emplace_back(point.x, stairs.back().second);
        stairs.emplace_back(point.x, point.y);
    }
    if (!stairs.empty()) {
        stairs.emplace_back(kPlotRight, stairs.back().second);
        canvas.path(stairs, QStringLiteral("class=\"hollow series0\""));
    }
    for (const PlottedRung& point : points) {
        canvas.line(point.x, point.y, time.at(std::max(point.rung->timeMedian_s, point.rung->timeP99_s)),
                    point.y, QStringLiteral("soft"));
        if (point.rung->errorP95 > 0.0)
            canvas.line(point.x, point.y, point.x, error.at(point.rung->errorP95), QStringLiteral("soft"));
    }
    for (const PlottedRung& point : points)
        canvas.circle(point.x, point.y, 5.0,
                      point.rung->pareto ? QStringLiteral("class=\"series0\"")
                                         : QStringLiteral("class=\"hollow series1\""));
    drawNames(canvas, points);
    QString remark = CostFigureText::tr(
        "Filled: no other rung is both as quick and as exact. Lines: to the 95 % error and the 99 % time.");
    if (!left.isEmpty())
        remark = CostFigureText::tr("Not measured, the machine was too noisy or there is no error: %1.")
                     .arg(left.join(QStringLiteral(", ")));
    canvas.text(kPlotLeft, kFigureHeight - 14.0, remark, QStringLiteral("soft small"));
    return canvas.standalone();
}

} // namespace teleta::cost
