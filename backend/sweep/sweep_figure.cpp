// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/sweep/sweep_figure.h"

#include "backend/core/data/output_file.h"
#include "backend/figure/round_step.h"
#include "backend/sweep/sweep_map.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <optional>

namespace teleta::sweep {

namespace {

using figure::SvgCanvas;
using figure::svgNumber;

struct SweepFigureText {
    Q_DECLARE_TR_FUNCTIONS(SweepFigure)
};

constexpr double kWidth = 760.0;
constexpr double kLinesHeight = 420.0;
constexpr double kMapHeight = 380.0;
constexpr double kPanelHeight = 240.0;
constexpr std::size_t kMostPanels = 24;
constexpr std::size_t kPanelColumns = 3;
constexpr double kTitleHeight = 44.0;
/// Of labels that are texts, which stand aslant.
constexpr double kTextLabels = 70.0;
constexpr double kPlotLeft = 88.0;
constexpr double kPlotRight = kWidth - 24.0;

std::optional<double> numberOf(const core::TomlValue& value) {
    if (const double* number = std::get_if<double>(&value))
        return *number;
    if (const long long* whole = std::get_if<long long>(&value))
        return static_cast<double>(*whole);
    return std::nullopt;
}

/// Its values are numbers, so that a line between them means something.
bool isOrdered(const SweepAxis& axis) {
    return std::ranges::all_of(axis.values, [](const std::vector<core::TomlValue>& value) {
        return std::ranges::all_of(value,
                                   [](const core::TomlValue& each) { return numberOf(each).has_value(); });
    });
}

/// The cell with these values of the axes.
std::uint64_t cellAt(const SweepPlan& plan, const std::vector<std::size_t>& place) {
    std::uint64_t cell = 0;
    for (std::size_t i = 0; i < place.size(); ++i)
        cell = cell * plan.axes[i].values.size() + place[i];
    return cell;
}

/// Where the values of an axis lie between 0 and 1.
std::vector<double> sharesOf(const SweepAxis& axis) {
    const std::size_t n = axis.values.size();
    std::vector<double> shares(n);
    std::vector<double> numbers;
    if (axis.isNumeric())
        for (const auto& value : axis.values)
            numbers.push_back(*numberOf(value[0]));
    if (!numbers.empty() && std::ranges::all_of(numbers, [](double v) { return v > 0.0; }) &&
        (axis.logarithmic || *std::ranges::max_element(numbers) > 20.0 * *std::ranges::min_element(numbers)))
        for (double& number : numbers)
            number = std::log(number);
    const bool even =
        numbers.empty() || *std::ranges::max_element(numbers) == *std::ranges::min_element(numbers);
    for (std::size_t i = 0; i < n; ++i) {
        shares[i] = even ? (static_cast<double>(i) + 0.5) / static_cast<double>(n)
                         : (numbers[i] - *std::ranges::min_element(numbers)) /
                               (*std::ranges::max_element(numbers) - *std::ranges::min_element(numbers));
    }
    return shares;
}

/// A vertical axis over round steps.
struct UpAxis {
    ValueRange range;
    double step = 0.2;
    double top = 0.0, bottom = 1.0;

    [[nodiscard]] double at(double value) const { return bottom - (bottom - top) * range.share(value); }
};

UpAxis upAxis(const std::vector<double>& values, bool share, double top, double bottom) {
    UpAxis axis{{0.0, 1.0}, 0.2, top, bottom};
    if (share || values.empty())
        return axis;
    const auto [least, most] = std::ranges::minmax_element(values);
    const double low = *least >= 0.0 && *least < 0.5 * *most ? 0.0 : *least;
    const double span = *most > low ? *most - low : std::max(std::abs(*most), 1e-12);
    axis.step = figure::roundStep(span / 5.0);
    axis.range.low = axis.step * std::floor(low / axis.step + 1e-9);
    axis.range.high = axis.step * std::ceil(std::max(*most, low + axis.step) / axis.step - 1e-9);
    return axis;
}

/// One line: the values of one axis, all others fixed.
struct Series {
    QString name;
    std::vector<const CellMeasure*> measures;
};

std::vector<Series> seriesOf(const SweepPlan& plan, const SweepResults& results, std::size_t measure,
                             const std::vector<std::size_t>& varied) {
    std::vector<Series> lines;
    const std::size_t count = varied.size() > 1 ? plan.axes[varied[1]].values.size() : 1;
    for (std::size_t line = 0; line < count; ++line) {
        Series series;
        std::vector<std::size_t> place(plan.axes.size(), 0);
        if (varied.size() > 1) {
            place[varied[1]] = line;
            series.name = valueText(plan.axes[varied[1]], line);
        }
        for (std::size_t i = 0; i < plan.axes[varied[0]].values.size(); ++i) {
            place[varied[0]] = i;
            series.measures.push_back(&results.cells[cellAt(plan, place)].measures[measure]);
        }
        lines.push_back(std::move(series));
    }
    return lines;
}

void drawGrid(SvgCanvas& canvas, const UpAxis& up, const SweepAxis& x, const std::vector<double>& places) {
    const int steps = static_cast<int>(std::lround((up.range.high - up.range.low) / up.step));
    for (int i = 0; i <= steps; ++i) {
        const double value = up.range.low + i * up.step;
        canvas.line(kPlotLeft, up.at(value), kPlotRight, up.at(value), QStringLiteral("soft"));
        canvas.text(kPlotLeft - 8.0, up.at(value) + 4.0,
                    shortNumber(std::abs(value) < 1e-9 * up.step ? 0.0 : value),
                    QStringLiteral("soft small end"));
    }
    double last = -1e9;
    for (std::size_t i = 0; i < places.size(); ++i) {
        canvas.line(places[i], up.bottom, places[i], up.bottom + 5.0, QStringLiteral("ink"));
        if (!isOrdered(x)) {
            canvas.text(places[i] + 4.0, up.bottom + 16.0, valueText(x, i), QStringLiteral("soft small end"),
                        QStringLiteral("transform=\"rotate(-30 %1 %2)\"")
                            .arg(svgNumber(places[i] + 4.0), svgNumber(up.bottom + 16.0)));
            continue;
        }
        if (places[i] - last < std::max(46.0, 6.6 * static_cast<double>(valueText(x, i).size())))
            continue;
        canvas.text(places[i], up.bottom + 20.0, valueText(x, i), QStringLiteral("soft small middle"));
        last = places[i];
    }
    canvas.line(kPlotLeft, up.bottom, kPlotRight, up.bottom, QStringLiteral("ink"));
    canvas.text(0.5 * (kPlotLeft + kPlotRight), up.bottom + 42.0 + (isOrdered(x) ? 0.0 : kTextLabels),
                axisTitle(x), QStringLiteral("ink middle"));
}

void drawSeries(SvgCanvas& canvas, const UpAxis& up, const std::vector<double>& places, const Series& series,
                std::size_t number, bool share, bool joined, double shift) {
    const QString colour = QStringLiteral("series%1").arg(number % SvgCanvas::kSeries);
    std::vector<std::pair<double, double>> line, low, high;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const CellMeasure& measure = *series.measures[i];
        if (!measure.mean)
            continue;
        line.emplace_back(places[i] + shift, up.at(*measure.mean));
        if (!share && measure.n > 1) {
            low.emplace_back(places[i] + shift, up.at(*measure.p05));
            high.emplace_back(places[i] + shift, up.at(*measure.p95));
        }
    }
    for (std::size_t i = 0; i < (joined ? 0 : low.size()); ++i)
        canvas.path({low[i], high[i]}, QStringLiteral("class=\"hollow thin dotted %1\"").arg(colour));
    for (const auto* edge : {&low, &high})
        if (joined && edge->size() > 1)
            canvas.path(*edge, QStringLiteral("class=\"hollow thin dotted %1\"").arg(colour));
    if (joined && line.size() > 1)
        canvas.path(line, QStringLiteral("class=\"hollow %1\"").arg(colour));
    std::size_t drawn = 0;
    for (const CellMeasure* measure : series.measures) {
        if (!measure->mean)
            continue;
        const auto [x, y] = line[drawn++];
        if (measure->low95 && measure->high95)
            canvas.path({{x, up.at(*measure->low95)}, {x, up.at(*measure->high95)}},
                        QStringLiteral("class=\"hollow thin %1\"").arg(colour));
        canvas.circle(x, y, 4.0, QStringLiteral("class=\"%1\"").arg(colour));
    }
}

void drawLines(SvgCanvas& canvas, const SweepPlan& plan, const std::vector<Series>& lines,
               const std::vector<std::size_t>& varied, bool share) {
    const SweepAxis& x = plan.axes[varied[0]];
    std::vector<double> values;
    for (const Series& series : lines)
        for (const CellMeasure* measure : series.measures) {
            for (const auto& each :
                 {measure->mean, share ? std::nullopt : measure->p05, share ? std::nullopt : measure->p95})
                if (each && std::isfinite(*each))
                    values.push_back(*each);
            if (measure->low95 && measure->high95 && !share)
                values.insert(values.end(), {*measure->low95, *measure->high95});
        }
    const bool legend = lines.size() > 1;
    const UpAxis up = upAxis(values, share, kTitleHeight + (legend ? 28.0 : 8.0),
                             kLinesHeight - 74.0 - (isOrdered(x) ? 0.0 : kTextLabels));
    std::vector<double> places = sharesOf(x);
    for (double& place : places)
        place = kPlotLeft + 20.0 + (kPlotRight - kPlotLeft - 40.0) * place;
    drawGrid(canvas, up, x, places);
    for (std::size_t i = 0; i < lines.size(); ++i)
        drawSeries(canvas, up, places, lines[i], i, share, isOrdered(x),
                   3.0 * (static_cast<double>(i) - 0.5 * static_cast<double>(lines.size() - 1)));
    if (legend) {
        double left = kPlotLeft;
        const QString title = axisTitle(plan.axes[varied[1]]) + QStringLiteral(":");
        canvas.text(left, kTitleHeight + 14.0, title, QStringLiteral("soft small"));
        left += 6.6 * static_cast<double>(title.size()) + 12.0;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            canvas.circle(left, kTitleHeight + 10.0, 4.0,
                          QStringLiteral("class=\"series%1\"").arg(i % SvgCanvas::kSeries));
            canvas.text(left + 9.0, kTitleHeight + 14.0, lines[i].name, QStringLiteral("ink small"));
            left += 6.6 * static_cast<double>(lines[i].name.size()) + 30.0;
        }
    }
    canvas.text(kPlotLeft, kLinesHeight - 8.0,
                share ? SweepFigureText::tr("Bars: Wilson's 95 % interval of the share.")
                      : SweepFigureText::tr(
                            "Points: means with their 95 % interval. Dotted: 5 and 95 % of the runs."),
                QStringLiteral("soft small"));
}

ValueRange rangeOf(const SweepResults& results, std::size_t measure) {
    std::optional<double> least, most;
    for (const CellResult& cell : results.cells)
        if (const auto& mean = cell.measures[measure].mean; mean && std::isfinite(*mean)) {
            least = std::min(least.value_or(*mean), *mean);
            most = std::max(most.value_or(*mean), *mean);
        }
    if (!least)
        return {};
    const double room = *most > *least ? 0.0 : std::max(0.5 * std::abs(*most), 1e-12);
    return {*least - room, *most + room};
}

/// "torque_noise.sd_Nm = 0.001, speed = 2", of the axes that a panel does not have.
QString panelHeading(const SweepPlan& plan, const std::vector<std::size_t>& varied,
                     const std::vector<std::size_t>& place) {
    QStringList parts;
    for (std::size_t i = 0; i + 2 < varied.size(); ++i)
        parts << QStringLiteral("%1 = %2").arg(axisTitle(plan.axes[varied[i]]),
                                               valueText(plan.axes[varied[i]], place[varied[i]]));
    return parts.join(QStringLiteral(", "));
}

void drawPanel(SvgCanvas& canvas, const MapBox& box, const SweepPlan& plan, const SweepResults& results,
               std::size_t measure, const std::vector<std::size_t>& varied, std::vector<std::size_t> place,
               const ValueRange& range) {
    const std::size_t x = varied[varied.size() - 1];
    const std::size_t y = varied[varied.size() - 2];
    drawMap(canvas, box, plan.axes[x], plan.axes[y], range, panelHeading(plan, varied, place),
            [&](std::size_t column, std::size_t row) {
                place[x] = column;
                place[y] = row;
                const auto& mean = results.cells[cellAt(plan, place)].measures[measure].mean;
                return mean && std::isfinite(*mean) ? mean : std::nullopt;
            });
}

} // namespace

std::vector<std::size_t> variedAxes(const SweepPlan& plan) {
    std::vector<std::size_t> varied;
    for (std::size_t i = 0; i < plan.axes.size(); ++i)
        if (plan.axes[i].values.size() > 1)
            varied.push_back(i);
    return varied;
}

QString axisTitle(const SweepAxis& axis) {
    QStringList parts;
    for (const SweepAxis::Key& key : axis.keys)
        parts << QString::fromStdString(key.name.substr(key.name.rfind('.') + 1));
    parts.removeDuplicates();
    return parts.join(QStringLiteral(", "));
}

QString valueText(const SweepAxis& axis, std::size_t value) {
    QStringList parts;
    for (const core::TomlValue& each : axis.values[value])
        parts << (std::holds_alternative<double>(each) ? shortNumber(std::get<double>(each))
                                                       : QString::fromStdString(core::plainText(each)));
    parts.removeDuplicates();
    return parts.join(QStringLiteral(", "));
}

std::optional<figure::SvgCanvas> sweepFigure(const SweepPlan& plan, const SweepResults& results,
                                             std::size_t measure) {
    const std::vector<std::size_t> varied = variedAxes(plan);
    const bool known = std::ranges::any_of(
        results.cells, [&](const CellResult& cell) { return cell.measures[measure].mean.has_value(); });
    if (varied.empty() || !known)
        return std::nullopt;
    const bool share = results.shares[measure];
    const bool lines = varied.size() == 1 ||
                       (varied.size() == 2 && plan.axes[varied[1]].values.size() <= SvgCanvas::kSeries);
    std::size_t panels = varied.size() > 1 ? 1 : 0;
    for (std::size_t i = 0; i + 2 < varied.size(); ++i)
        panels *= plan.axes[varied[i]].values.size();
    const std::size_t shown = std::min(panels, kMostPanels);
    const std::size_t columns = std::min(shown, kPanelColumns);
    const std::size_t rows = columns > 0 ? (shown + columns - 1) / columns : 0;
    const double panelHeight = shown == 1 ? kMapHeight : kPanelHeight;
    const double mapsTop = lines ? kLinesHeight + 8.0 : kTitleHeight;
    const double mapsHeight = rows > 0 ? static_cast<double>(rows) * panelHeight + 56.0 : 0.0;

    const QString name = QString::fromStdString(results.measures[measure]);
    SvgCanvas canvas(kWidth, mapsTop + mapsHeight, name);
    canvas.text(kPlotLeft, 28.0, name, QStringLiteral("ink bold"));
    if (lines)
        drawLines(canvas, plan, seriesOf(plan, results, measure, varied), varied, share);
    const ValueRange range = share ? ValueRange{0.0, 1.0} : rangeOf(results, measure);
    std::vector<std::size_t> place(plan.axes.size(), 0);
    for (std::size_t panel = 0; panel < shown; ++panel) {
        std::size_t rest = panel;
        for (std::size_t i = varied.size() - 2; i-- > 0;) {
            place[varied[i]] = rest % plan.axes[varied[i]].values.size();
            rest /= plan.axes[varied[i]].values.size();
        }
        const double width = (kWidth - 12.0) / static_cast<double>(columns);
        drawPanel(canvas,
                  {static_cast<double>(panel % columns) * width,
                   mapsTop + static_cast<double>(panel / columns) * panelHeight, width, panelHeight},
                  plan, results, measure, varied, place, range);
    }
    if (shown > 0) {
        const double top = mapsTop + static_cast<double>(rows) * panelHeight + 14.0;
        drawMapLegend(canvas, kPlotLeft, top, 220.0, range);
        canvas.text(kPlotLeft + 240.0, top + 10.0,
                    shown < panels
                        ? SweepFigureText::tr("Means. The first %1 of %2 maps.").arg(shown).arg(panels)
                        : SweepFigureText::tr("Means. Crossed out: no run has it."),
                    QStringLiteral("soft small"));
    }
    return canvas;
}

core::Expected<void> writeSweepFigures(const SweepPlan& plan, const SweepResults& results,
                                       const std::string& folder) {
    for (std::size_t i = 0; i < results.measures.size(); ++i) {
        const std::optional<figure::SvgCanvas> picture = sweepFigure(plan, results, i);
        if (!picture)
            continue;
        TELETA_CHECK(core::makeFolder(folder));
        std::string name = results.measures[i];
        std::ranges::replace(name, '[', '-');
        std::ranges::replace(name, '/', '-');
        std::erase(name, ']');
        TELETA_CHECK(core::writeFile(folder + "/" + name + ".svg", picture->standalone()));
    }
    return {};
}

} // namespace teleta::sweep
