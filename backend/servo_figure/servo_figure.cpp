// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo_figure/servo_figure.h"

#include "backend/figure/round_step.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace teleta::servo_figure {

namespace {

constexpr double kPlotLeft = 78.0;
constexpr double kLegendTop = 44.0;
constexpr double kLegendRow = 18.0;
constexpr double kBetweenLanes = 18.0;
constexpr double kNameRow = 12.0; ///< room for the name above the first lane
constexpr double kRight = 22.0;
constexpr double kBottom = 46.0;
constexpr double kLeastSize = 400.0;
constexpr double kWide = 1.4;    ///< a picture that is so much wider than high has its lanes in two columns
constexpr double kLetter = 7.0;  ///< about the width of one in small text
constexpr double kSwatch = 22.0; ///< length of a line in the legend
constexpr double kPxPerTick = 22.0; ///< about so far apart are those of a lane
constexpr double kPxPerTimeTick = 90.0;

/// Estimated width of small text; Chinese and Japanese characters are as wide as high.
double lengthOf(const QString& text) {
    double length = 0.0;
    for (const QChar letter : text)
        length += letter.unicode() < 0x2e80 ? kLetter : 12.0;
    return length;
}

struct FigureText {
    Q_DECLARE_TR_FUNCTIONS(FigureText)
};

using Values = std::vector<double> ServoCurves::*;

/// The moment of a weight is gone when |DZMP_y| stays below this; m.
constexpr double kSettledDzmp_m = 0.0005;
constexpr double kStripRow = 10.0; ///< of contacts and limits of a run
constexpr double kStripGap = 6.0;
constexpr double kLimitHeight = 7.0;

struct Line {
    Values values;
    QString name; ///< written into the lane; empty: not
};

struct Lane {
    QString name;
    double factor;            ///< from SI to what is shown
    double leastSpan;         ///< in shown units
    std::vector<Line> lines;  ///< of each run
    Values desired = nullptr; ///< of the first run
    Values truth = nullptr;   ///< of a run alone
    bool marked = false;      ///< where a weight is moved, and where its moment is gone
};

std::vector<Lane> lanesFor(bool alone) {
    std::vector<Lane> lanes{
        {FigureText::tr("Force, N"), 1.0, 1.0, {{&ServoCurves::force_N, {}}}, &ServoCurves::desired_N},
        {FigureText::tr("CoP y, mm"), 1e3, 1.0, {{&ServoCurves::copY_m, {}}}, &ServoCurves::copYDesired_m},
        {FigureText::tr("CoC x, mm"), 1e3, 1.0, {{&ServoCurves::cocX_m, {}}}, &ServoCurves::cocXDesired_m},
        {FigureText::tr("DZMP y, mm"),
         1e3,
         1.0,
         {{&ServoCurves::dzmpY_m, {}}},
         &ServoCurves::dzmpYDesired_m,
         nullptr,
         true},
        {FigureText::tr("\u03b1 z, \u00b0"),
         180.0 / std::numbers::pi,
         2.0,
         {{&ServoCurves::alphaZ_rad, {}}},
         &ServoCurves::alphaZDesired_rad}};
    if (alone) {
        lanes[3].truth = &ServoCurves::dzmpYTrue_m;
        lanes.push_back({FigureText::tr("Turn z, \u00b0"),
                         180.0 / std::numbers::pi,
                         2.0,
                         {{&ServoCurves::turnZ_rad, {}}},
                         &ServoCurves::turnZCommanded_rad});
        lanes.push_back({FigureText::tr("Position, mm"),
                         1e3,
                         1.0,
                         {{&ServoCurves::x_m, QStringLiteral("x")},
                          {&ServoCurves::y_m, QStringLiteral("y")},
                          {&ServoCurves::z_m, QStringLiteral("z")}}});
    } else {
        lanes.push_back({FigureText::tr("Path, mm"), 1e3, 1.0, {{&ServoCurves::way_m, {}}}});
    }
    return lanes;
}

/// Larger values get no axis.
bool isShown(double value) {
    constexpr double kLargestShown = 1e100;
    return std::isfinite(value) && std::abs(value) < kLargestShown;
}

struct Axis {
    double low = 0.0;
    double high = 1.0;
    double step = 0.2;
};

Axis axisOf(double low, double high, double leastSpan, double ticks) {
    if (!(low <= high))
        low = high = 0.0;
    // Values that differ only by rounding count as equal.
    const double least = std::max(leastSpan, 1e-9 * std::max(std::abs(low), std::abs(high)));
    const double missing = std::max(0.0, least - (high - low));
    Axis axis{low - 0.5 * missing, high + 0.5 * missing, 0.0};
    axis.step = figure::roundStep((axis.high - axis.low) / std::max(ticks, 2.0));
    axis.low = axis.step * std::floor(axis.low / axis.step + 1e-9);
    axis.high = axis.step * std::ceil(axis.high / axis.step - 1e-9);
    return axis;
}

QString tickText(double value, double step) {
    const int digits = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    return QString::number(std::abs(value) < 1e-9 * step ? 0.0 : value, 'f', digits)
        .replace(QLatin1Char('-'), QChar(0x2212));
}

QString lineOf(std::size_t series) {
    return QStringLiteral("class=\"hollow thin series%1\"").arg(series % figure::SvgCanvas::kSeries);
}

QString dashes() {
    return QStringLiteral("class=\"dashed\"");
}

QString dots() {
    return QStringLiteral("class=\"dotted\"");
}

enum class Sample { line, contact, limit, cross };

/// A text of the legend and the mark in front of it.
struct Entry {
    QString name;
    QString line;
    Sample sample = Sample::line;
    double x = 0.0;
    double y = 0.0;
};

class Chart {
public:
    Chart(std::span<const ServoCurves> runs, double width, double height)
        : m_runs(runs)
        , m_lanes(lanesFor(runs.size() == 1))
        , m_width(std::max(width, kLeastSize))
        , m_height(std::max(height, kLeastSize))
        , m_columns(m_width > kWide * m_height ? 2 : 1)
        , m_legend(legend())
        , m_canvas(m_width, m_height, FigureText::tr("Tactile servoing: force and features over time")) {
        m_rows = (m_lanes.size() + m_columns - 1) / m_columns;
        m_stripTop = m_legend.back().y + 34.0;
        m_plotTop = m_stripTop;
        if (hasStrip())
            m_plotTop += kStripRow * static_cast<double>(m_runs.size()) + kStripGap;
        m_laneHeight = laneHeight();
        constexpr double kApart = 8.0;
        m_namesAbove = std::ranges::any_of(m_lanes, [&](const Lane& lane) {
            return lengthOf(lane.name) + kApart > m_laneHeight + kBetweenLanes;
        });
        if (m_namesAbove && hasStrip()) {
            m_plotTop += kNameRow;
            m_laneHeight = laneHeight();
        }
        m_time_s = 1e-3;
        for (const ServoCurves& run : runs)
            if (!run.time_s.empty() && isShown(run.time_s.back()))
                m_time_s = std::max(m_time_s, run.time_s.back());
    }

    figure::SvgCanvas drawn() {
        drawLegend();
        for (std::size_t column = 0; column < m_columns; ++column) {
            m_left = kPlotLeft + static_cast<double>(column) * (plotWidth() + kRight + kPlotLeft);
            drawPhases();
            drawStrip();
            const std::size_t first = column * m_rows;
            for (std::size_t i = first; i < std::min(first + m_rows, m_lanes.size()); ++i)
                drawLane(m_lanes[i], top(i - first));
            drawTime();
        }
        return m_canvas;
    }

private:
    [[nodiscard]] double plotWidth() const {
        return m_width / static_cast<double>(m_columns) - kPlotLeft - kRight;
    }
    [[nodiscard]] double laneHeight() const {
        return std::max(24.0, (m_height - m_plotTop - kBottom) / static_cast<double>(m_rows) - kBetweenLanes);
    }
    [[nodiscard]] double right() const { return m_left + plotWidth(); }
    [[nodiscard]] double top(std::size_t row) const {
        return m_plotTop + static_cast<double>(row) * (m_laneHeight + kBetweenLanes);
    }
    [[nodiscard]] double bottom() const { return top(m_rows - 1) + m_laneHeight; }
    [[nodiscard]] double x(double time_s) const { return m_left + plotWidth() * time_s / m_time_s; }

    /// Draws the entries in as many rows as needed.
    [[nodiscard]] std::vector<Entry> legend() const {
        std::vector<Entry> entries;
        for (std::size_t i = 0; i < m_runs.size(); ++i)
            entries.push_back({.name = QString::fromStdString(m_runs[i].name), .line = lineOf(i)});
        entries.push_back({.name = FigureText::tr("desired"), .line = dashes()});
        if (m_runs.size() == 1)
            entries.push_back({.name = FigureText::tr("true"), .line = dots()});
        const auto any = [this](const auto& has) { return std::ranges::any_of(m_runs, has); };
        if (any([](const ServoCurves& run) { return !run.contacts.empty(); }))
            entries.push_back({.name = FigureText::tr("in contact"), .line = {}, .sample = Sample::contact});
        if (any([](const ServoCurves& run) { return !run.limits.empty(); }))
            entries.push_back({.name = limitsName(), .line = {}, .sample = Sample::limit});
        if (any([](const ServoCurves& run) { return run.massMoves_s.has_value(); }))
            entries.push_back({.name = FigureText::tr("weight is moved; its moment is gone"),
                               .line = {},
                               .sample = Sample::cross});
        double at = kPlotLeft;
        double row = kLegendTop;
        for (Entry& entry : entries) {
            const double needed = kSwatch + 30.0 + lengthOf(entry.name);
            if (at > kPlotLeft && at + needed > m_width - kRight) {
                at = kPlotLeft;
                row += kLegendRow;
            }
            entry.x = at;
            entry.y = row;
            at += needed;
        }
        return entries;
    }

    void drawLegend() {
        const bool simulated = std::ranges::any_of(m_runs, &ServoCurves::simulated);
        m_canvas.text(kPlotLeft, 24.0,
                      simulated ? FigureText::tr("Tactile servoing, simulated")
                                : FigureText::tr("Tactile servoing"),
                      QStringLiteral("ink bold"));
        for (const Entry& entry : m_legend) {
            if (entry.sample == Sample::cross)
                cross(entry.x + 0.5 * kSwatch, entry.y);
            else if (entry.sample == Sample::line)
                m_canvas.path({{entry.x, entry.y}, {entry.x + kSwatch, entry.y}}, entry.line);
            else
                bar(entry.x, entry.x + kSwatch, entry.y, 0, entry.sample == Sample::limit);
            m_canvas.text(entry.x + kSwatch + 6.0, entry.y + 4.5, entry.name, QStringLiteral("ink small"));
        }
    }

    /// The last phases are the longest, so names are placed from the end; a name without room is left out.
    void drawPhases() {
        if (m_runs.empty())
            return;
        double room = right();
        for (auto phase = m_runs.front().phases.rbegin(); phase != m_runs.front().phases.rend(); ++phase) {
            const double at = x(phase->first);
            m_canvas.line(at, m_stripTop - 6.0, at, bottom(), QStringLiteral("soft"));
            const QString shown =
                QString::fromStdString(phase->second).replace(QLatin1Char('_'), QLatin1Char(' '));
            if (at + 6.0 + kLetter * static_cast<double>(shown.size()) > room)
                continue;
            m_canvas.text(at + 3.0, m_stripTop - 6.0, shown, QStringLiteral("soft small"));
            room = at;
        }
    }

    [[nodiscard]] bool hasStrip() const {
        return std::ranges::any_of(
            m_runs, [](const ServoCurves& run) { return !run.contacts.empty() || !run.limits.empty(); });
    }

    /// The limits that acted in any run.
    [[nodiscard]] QString limitsName() const {
        servo::ActiveLimits all;
        for (const ServoCurves& run : m_runs)
            for (const ServoCurves::Span& span : run.limits)
                for (std::size_t i = 0; i < servo::kLimits; ++i)
                    if (span.limits.has(static_cast<servo::Limit>(i)))
                        all.set(static_cast<servo::Limit>(i));
        return FigureText::tr("a limit acts (%1)")
            .arg(QString::fromStdString(all.names())
                     .replace(QLatin1Char('_'), QLatin1Char(' '))
                     .replace(QLatin1Char('+'), QLatin1String(", ")));
    }

    /// Draws a bar of a run: thin, or thick where a limit acts.
    void bar(double from, double to, double y, std::size_t series, bool limit) {
        const QString colour = QStringLiteral("series%1").arg(series);
        if (limit)
            m_canvas.rectangle(from, y - 0.5 * kLimitHeight, to - from, kLimitHeight,
                               QStringLiteral("class=\"%1\"").arg(colour));
        else
            m_canvas.line(from, y, to, y, colour + QStringLiteral(" bar"));
    }

    /// Draws a row for each run: thin where it is in contact, thick where a limit acts.
    void drawStrip() {
        for (std::size_t i = 0; i < m_runs.size(); ++i) {
            const double middle = m_stripTop + (static_cast<double>(i) + 0.5) * kStripRow;
            spans(m_runs[i].contacts, middle, i, false);
            spans(m_runs[i].limits, middle, i, true);
        }
    }

    /// Joins spans that are less than one px apart.
    void spans(const std::vector<ServoCurves::Span>& spans, double y, std::size_t series, bool limit) {
        std::optional<std::pair<double, double>> open;
        const auto close = [&] {
            if (open)
                bar(open->first, std::max(open->second, open->first + 1.5), y, series, limit);
        };
        for (const ServoCurves::Span& span : spans) {
            if (!isShown(span.begin_s) || !isShown(span.end_s))
                continue;
            if (open && x(span.begin_s) - open->second < 1.0) {
                open->second = std::max(open->second, x(span.end_s));
                continue;
            }
            close();
            open = {x(span.begin_s), x(span.end_s)};
        }
        close();
    }

    void cross(double x, double y) {
        constexpr double kArm = 4.0;
        for (const double rise : {kArm, -kArm})
            m_canvas.path({{x - kArm, y - rise}, {x + kArm, y + rise}},
                          QStringLiteral("class=\"hollow series1\""));
    }

    /// Draws the paper's crosses: when the weight is moved, and when the moment that it causes is gone for
    /// good.
    template <typename Y>
    void drawMarks(const ServoCurves& run, const Y& y) {
        if (!run.massMoves_s)
            return;
        std::optional<std::size_t> moved;
        std::optional<std::size_t> last;
        for (std::size_t i = 0; i < run.time_s.size(); ++i) {
            if (!(run.time_s[i] >= *run.massMoves_s))
                continue;
            moved = moved.value_or(i);
            const double truth_m = run.dzmpYTrue_m[i];
            if (!(std::abs(std::isfinite(truth_m) ? truth_m : run.dzmpY_m[i]) < kSettledDzmp_m))
                last = i;
        }
        const auto mark = [&](std::size_t i) {
            if (isShown(run.dzmpY_m[i]) && isShown(run.time_s[i]))
                cross(x(run.time_s[i]), y(run.dzmpY_m[i]));
        };
        if (moved)
            mark(*moved);
        if (last && *last + 1 < run.time_s.size())
            mark(*last + 1);
    }

    [[nodiscard]] Axis axisOfLane(const Lane& lane) const {
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        const auto include = [&](const std::vector<double>& values) {
            for (const double value : values)
                if (isShown(lane.factor * value)) {
                    low = std::min(low, lane.factor * value);
                    high = std::max(high, lane.factor * value);
                }
        };
        for (const ServoCurves& run : m_runs)
            for (const Line& line : lane.lines)
                include(run.*line.values);
        for (const Values reference : {lane.desired, lane.truth})
            if (reference != nullptr && !m_runs.empty())
                include(m_runs.front().*reference);
        return axisOf(low, high, lane.leastSpan, m_laneHeight / kPxPerTick);
    }

    /// Beside the axis, or above the lanes when these are lower than a name is long.
    void nameLane(const QString& name, double upper) {
        if (m_namesAbove) {
            m_canvas.text(m_left + 5.0, upper - 4.0, name, QStringLiteral("ink small"));
            return;
        }
        const double middle = upper + 0.5 * m_laneHeight;
        const double nameAt = m_left - kPlotLeft + 20.0;
        m_canvas.text(nameAt, middle, name, QStringLiteral("ink small middle"),
                      QStringLiteral("transform=\"rotate(-90 %1 %2)\"")
                          .arg(figure::svgNumber(nameAt), figure::svgNumber(middle)));
    }

    void drawLane(const Lane& lane, double upper) {
        const Axis axis = axisOfLane(lane);
        const auto y = [&](double value) {
            return upper + m_laneHeight * (axis.high - lane.factor * value) / (axis.high - axis.low);
        };
        const auto ticks = std::lround((axis.high - axis.low) / axis.step);
        for (long i = 0; i <= ticks; ++i) {
            const double tick = axis.low + static_cast<double>(i) * axis.step;
            const double at = y(tick / lane.factor);
            m_canvas.line(m_left, at, right(), at, QStringLiteral("soft"));
            m_canvas.text(m_left - 8.0, at + 4.0, tickText(tick, axis.step),
                          QStringLiteral("soft small end"));
        }
        nameLane(lane.name, upper);
        if (m_runs.empty())
            return;
        if (lane.desired != nullptr)
            curve(m_runs.front(), m_runs.front().*lane.desired, y, dashes());
        for (std::size_t i = 0; i < m_runs.size(); ++i)
            for (std::size_t k = 0; k < lane.lines.size(); ++k)
                curve(m_runs[i], m_runs[i].*lane.lines[k].values, y, lineOf(i + k));
        if (lane.truth != nullptr)
            curve(m_runs.front(), m_runs.front().*lane.truth, y, dots());
        if (lane.marked)
            for (const ServoCurves& run : m_runs)
                drawMarks(run, y);
        for (std::size_t k = 0; k < lane.lines.size(); ++k)
            if (!lane.lines[k].name.isEmpty())
                m_canvas.text(right() + 5.0, upper + 12.0 + 14.0 * static_cast<double>(k), lane.lines[k].name,
                              QStringLiteral("small series%1").arg(k));
    }

    void drawTime() {
        m_canvas.line(m_left, bottom(), right(), bottom(), QStringLiteral("ink"));
        const double step_s = figure::roundStep(m_time_s / std::max(plotWidth() / kPxPerTimeTick, 2.0));
        const auto last = std::lround(std::floor(m_time_s / step_s * (1.0 + 1e-9)));
        for (long i = 0; i <= last; ++i) {
            const double tick_s = static_cast<double>(i) * step_s;
            m_canvas.text(x(tick_s), bottom() + 18.0, tickText(tick_s, step_s),
                          QStringLiteral("soft small middle"));
        }
        m_canvas.text(m_left + 0.5 * plotWidth(), bottom() + 36.0, FigureText::tr("time, s"),
                      QStringLiteral("ink small middle"));
    }

    /// Reduces a curve to what the figure can show: the lowest and the highest point of each px, in their
    /// order.
    template <typename Y>
    void curve(const ServoCurves& run, const std::vector<double>& values, const Y& y,
               const QString& attributes) {
        std::vector<std::pair<double, double>> points;
        const auto finish = [&] {
            if (points.size() == 1) // a single value is a dot
                points.emplace_back(points.front().first + 0.5, points.front().second);
            m_canvas.path(points, attributes);
            points.clear();
        };
        const auto isDrawn = [&](std::size_t i) {
            return isShown(values[i]) && std::isfinite(run.time_s[i]);
        };
        for (std::size_t i = 0; i < values.size();) {
            if (!isDrawn(i)) {
                finish();
                ++i;
                continue;
            }
            std::size_t lowest = i;
            std::size_t highest = i;
            const double px = std::floor(x(run.time_s[i]));
            for (; i < values.size() && isDrawn(i) && std::floor(x(run.time_s[i])) == px; ++i) {
                lowest = values[i] < values[lowest] ? i : lowest;
                highest = values[i] > values[highest] ? i : highest;
            }
            const auto [first, second] = std::minmax(lowest, highest);
            points.emplace_back(x(run.time_s[first]), y(values[first]));
            if (second != first)
                points.emplace_back(x(run.time_s[second]), y(values[second]));
        }
        finish();
    }

    std::span<const ServoCurves> m_runs;
    std::vector<Lane> m_lanes;
    double m_width;
    double m_height;
    std::size_t m_columns;
    std::vector<Entry> m_legend;
    figure::SvgCanvas m_canvas;
    std::size_t m_rows = 0;
    double m_left = kPlotLeft; ///< of the plot of the column that is drawn
    double m_stripTop = 0.0;
    double m_plotTop = 0.0;
    double m_laneHeight = 0.0;
    bool m_namesAbove = false; ///< of the lanes, in the gap between two
    double m_time_s = 0.0;
};

} // namespace

figure::SvgCanvas servoFigure(std::span<const ServoCurves> runs, double width, double height) {
    constexpr std::size_t kMost = figure::SvgCanvas::kSeries;
    return Chart(runs.first(std::min(runs.size(), kMost)), width, height).drawn();
}

} // namespace teleta::servo_figure
