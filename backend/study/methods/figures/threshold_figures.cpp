// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/figures/threshold_figures.h"

#include "backend/core/data/output_file.h"
#include "backend/core/data/private_files.h"
#include "backend/study/methods/figures/level_chart.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <set>

namespace teleta::study {

namespace {

struct ThresholdText {
    Q_DECLARE_TR_FUNCTIONS(ThresholdText)
};

constexpr int kCurvePoints = 121;

QString textOf(const std::string& text) {
    return QString::fromStdString(text);
}

QString shortNumber(double value) {
    return QString::number(value, 'g', 3);
}

QString watermarkFor(std::optional<Mode> mode) {
    if (mode == Mode::pilot)
        return ThresholdText::tr("PILOT");
    return mode == Mode::simulated ? ThresholdText::tr("SIMULATED") : QString();
}

QString placeOf(const std::string& condition, const std::string& track) {
    return track == "all" ? textOf(condition) : textOf(condition) + QStringLiteral(", ") + textOf(track);
}

QString levelTitle(const std::string& unit) {
    if (unit == "s")
        return ThresholdText::tr("level, s");
    return unit.empty() ? ThresholdText::tr("level") : ThresholdText::tr("level, %1").arg(textOf(unit));
}

QString shareTitle(const LevelTaskFacts& facts) {
    if (facts.design == Design::yesNo)
        return ThresholdText::tr("share of yes");
    if (facts.design == Design::sameDifferent)
        return ThresholdText::tr("share of different");
    if (facts.design == Design::compare)
        return ThresholdText::tr("share of more");
    return ThresholdText::tr("share of right answers");
}

/// Reaches a little beyond all levels.
ChartAxis levelAxis(const ThresholdLine& line, const QString& title, const std::vector<double>& levels) {
    ChartAxis axis{title, line.guessIsKnown ? line.model.scale : LevelScale::linear, 0.0, 1.0};
    std::vector<double> shown;
    for (const double level : levels) {
        if (axis.scale == LevelScale::linear || level > 0.0)
            shown.push_back(onScale(axis.scale, level));
    }
    if (shown.empty())
        shown = {0.0};
    const auto [low, high] = std::ranges::minmax_element(shown);
    const double margin = *high > *low ? 0.06 * (*high - *low) : 0.5;
    axis.low = fromScale(axis.scale, *low - margin);
    axis.high = fromScale(axis.scale, *high + margin);
    return axis;
}

/// A file name of these letters only.
std::string safeFileName(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        const bool isSafe =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
        safe += isSafe ? c : '_';
    }
    return safe;
}

/// Names that differ, whatever the case.
class UniqueNames {
public:
    [[nodiscard]] std::string add(const std::string& wanted) {
        for (int i = 1;; ++i) {
            const std::string name = i == 1 ? wanted : wanted + "_" + std::to_string(i);
            if (m_taken.insert(textOf(name).toLower()).second)
                return name;
        }
    }

private:
    std::set<QString> m_taken;
};

QString intervalWords(const OpenInterval& interval) {
    if (!interval.low && !interval.high)
        return {};
    const QString low =
        interval.low ? shortNumber(*interval.low) : ThresholdText::tr("open", "end of an interval");
    const QString high =
        interval.high ? shortNumber(*interval.high) : ThresholdText::tr("open", "end of an interval");
    return ThresholdText::tr(" (%1 to %2)", "interval behind a number").arg(low, high);
}

/// Points of the curve between the ends of the axis.
std::vector<double> placesOn(const ChartAxis& axis) {
    std::vector<double> places;
    for (int i = 0; i < kCurvePoints; ++i)
        places.push_back(
            fromScale(axis.scale, std::lerp(onScale(axis.scale, axis.low), onScale(axis.scale, axis.high),
                                            i / (kCurvePoints - 1.0))));
    return places;
}

void drawFit(LevelChart& chart, const ThresholdLine& line, const ChartAxis& axis) {
    const std::optional<PsychometricFunction> curve = line.fit.function(line.model.shape);
    const std::vector<double> places = placesOn(axis);
    if (curve) {
        std::vector<std::pair<double, double>> points;
        std::vector<Interval> band;
        for (const double x : places) {
            points.emplace_back(x, curve->shareAt(x));
            if (const std::optional<Interval> ends = shareBand(line.fit, line.model, x))
                band.push_back(*ends);
        }
        if (band.size() == places.size())
            chart.band(places, band, 0);
        chart.curve(points, 0);
    }
    if (!line.fit.threshold)
        return;
    const double guess = line.fit.guess.value_or(0.0);
    const double lapse = line.fit.lapse.value_or(0.0);
    const double half = guess + 0.5 * (1.0 - guess - lapse);
    const OpenInterval& ends = line.fit.thresholdInterval;
    chart.barAcross(half, {ends.low.value_or(axis.low), ends.high.value_or(axis.high)}, 1);
    chart.dot(*line.fit.threshold, half, 1);
}

void drawReversals(LevelChart& chart, const ThresholdLine& line) {
    for (const std::size_t trial : line.procedure.reversalTrials)
        chart.diamond(static_cast<double>(trial + 1), line.trials[trial].kept.level, 1);
    if (!line.procedure.reversalTrials.empty())
        chart.legend(1, ThresholdText::tr("reversal"), true, true);
    if (line.procedure.staircase)
        chart.levelLine(*line.procedure.staircase, ThresholdText::tr("mean of reversals"));
}

void drawBeliefs(LevelChart& chart, const ThresholdLine& line) {
    const LevelScale scale = line.facts.range->scale;
    std::vector<double> trials;
    std::vector<Interval> band;
    std::vector<std::pair<double, double>> means;
    for (std::size_t i = 0; i < line.procedure.beliefs.size(); ++i) {
        const ThresholdBelief& belief = line.procedure.beliefs[i];
        trials.push_back(static_cast<double>(i + 1));
        band.push_back({fromScale(scale, belief.low), fromScale(scale, belief.high)});
        means.emplace_back(trials.back(), fromScale(scale, belief.mean));
    }
    chart.band(trials, band, 1);
    chart.curve(means, 1);
    chart.legend(1, ThresholdText::tr("threshold, 95 %"));
}

} // namespace

QString thresholdWords(const ThresholdLine& line) {
    if (!line.guessIsKnown)
        return ThresholdText::tr("not fitted: the table does not say what guessing gives");
    const QString unit = line.facts.unit.empty() ? QString() : QLatin1Char(' ') + textOf(line.facts.unit);
    switch (line.fit.note) {
    case FitNote::noData:
        return ThresholdText::tr("no trials");
    case FitNote::falls:
        return ThresholdText::tr("worse with more of it: are levels or answers swapped?");
    case FitNote::noRise:
        return ThresholdText::tr("the answers do not depend on the level");
    case FitNote::belowRange:
        return ThresholdText::tr("below %1%2, the lowest level").arg(shortNumber(line.fit.lowestLevel), unit);
    case FitNote::aboveRange:
        return ThresholdText::tr("above %1%2, the highest level")
            .arg(shortNumber(line.fit.highestLevel), unit);
    case FitNote::tooFewLevels:
        return ThresholdText::tr("too few levels for a fit; one less is enough with a fixed lapse rate");
    case FitNote::levelsNotAbove0:
        return ThresholdText::tr("no level is above 0");
    case FitNote::none:
    case FitNote::slopeAtLimit:
    case FitNote::lapseAtLimit:
        break;
    }
    QString words =
        line.isComparison() ? ThresholdText::tr("equal at %1") : ThresholdText::tr("threshold %1");
    if (!line.fit.threshold)
        return ThresholdText::tr("a step between two levels, without a threshold");
    words = words.arg(shortNumber(*line.fit.threshold)) + intervalWords(line.fit.thresholdInterval) + unit;
    if (const std::optional<double> difference = line.justNoticeable())
        words += ThresholdText::tr(", just noticeable %1").arg(shortNumber(*difference));
    if (line.fit.note == FitNote::slopeAtLimit)
        words += ThresholdText::tr("; a step between two levels");
    if (line.fit.note == FitNote::lapseAtLimit)
        words += ThresholdText::tr("; many lapses, or no upper end");
    return words;
}

figure::SvgCanvas curveFigure(const ThresholdLine& line, std::optional<Mode> mode) {
    std::vector<double> levels;
    std::int64_t most = 1;
    for (const LevelCount& count : line.counts) {
        levels.push_back(count.level);
        most = std::max(most, count.trials);
    }
    const ChartAxis axis = levelAxis(line, levelTitle(line.facts.unit), levels);
    LevelChart chart(textOf(line.participant) + QStringLiteral(", ") + textOf(line.task) +
                         QStringLiteral(", ") + placeOf(line.condition, line.track),
                     axis, {shareTitle(line.facts), LevelScale::linear, 0.0, 1.0});
    chart.remark(thresholdWords(line));
    if (line.fit.goodness && line.fit.goodness->pDeviance < 0.05)
        chart.remark(ThresholdText::tr("the curve does not fit: p of the deviance %1")
                         .arg(shortNumber(line.fit.goodness->pDeviance)));
    drawFit(chart, line, axis);
    for (const LevelCount& count : line.counts) {
        const auto trials = static_cast<double>(count.trials);
        chart.dot(count.level, static_cast<double>(count.correct) / trials, 0,
                  0.5 + 3.5 * trials / static_cast<double>(most));
    }
    chart.canvas().watermark(watermarkFor(mode));
    return chart.canvas();
}

figure::SvgCanvas trackFigure(const ThresholdLine& line, std::optional<Mode> mode) {
    std::vector<double> levels;
    for (const LevelTrial& trial : line.trials) {
        if (trial.kept.counts)
            levels.push_back(trial.kept.level);
    }
    const auto trials = static_cast<double>(std::max<std::size_t>(line.trials.size(), 1));
    LevelChart chart(textOf(line.participant) + QStringLiteral(", ") + textOf(line.task) +
                         QStringLiteral(", ") + placeOf(line.condition, line.track),
                     {ThresholdText::tr("trial"), LevelScale::linear, 0.0, trials + 1.0},
                     levelAxis(line, levelTitle(line.facts.unit), levels));
    if (!line.procedure.beliefs.empty())
        drawBeliefs(chart, line);
    for (std::size_t i = 0; i < line.trials.size(); ++i) {
        if (line.trials[i].kept.counts)
            chart.dot(static_cast<double>(i + 1), line.trials[i].kept.level, 0, 0.7,
                      !line.trials[i].kept.correct);
    }
    const bool isRight = !line.facts.design || line.facts.design == Design::interval;
    chart.legend(0, isRight ? ThresholdText::tr("right")
                            : ThresholdText::tr("felt", "answer: yes, different, more"));
    chart.legend(
        0, isRight ? ThresholdText::tr("wrong") : ThresholdText::tr("not felt", "answer: no, same, less"),
        true);
    drawReversals(chart, line);
    if (line.procedure.note != TrackNote::none)
        chart.remark(textOf(toString(line.procedure.note)));
    chart.canvas().watermark(watermarkFor(mode));
    return chart.canvas();
}

figure::SvgCanvas thresholdsFigure(const ThresholdResults& results, const std::string& task,
                                   std::optional<Mode> mode) {
    std::vector<const ThresholdGroup*> groups;
    for (const ThresholdGroup& group : results.groups) {
        if (group.task == task)
            groups.push_back(&group);
    }
    std::vector<double> levels;
    for (const ThresholdLine& line : results.lines) {
        if (line.task == task && line.fit.threshold)
            levels.push_back(*line.fit.threshold);
    }
    for (const ThresholdGroup* group : groups) {
        if (group->interval) {
            levels.push_back(group->interval->low);
            levels.push_back(group->interval->high);
        }
    }
    ThresholdLine shape;
    const std::string unit = groups.empty() ? std::string() : groups.front()->facts.unit;
    if (!groups.empty())
        shape.model.scale = groups.front()->scale;
    LevelChart chart(
        textOf(task) + QStringLiteral(", ") + ThresholdText::tr("thresholds"),
        {{}, LevelScale::linear, 0.0, static_cast<double>(std::max<std::size_t>(groups.size(), 1))},
        levelAxis(shape, levelTitle(unit), levels));
    chart.legend(0, ThresholdText::tr("participants"), true);
    chart.legend(1, ThresholdText::tr("mean, 95 %"));
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const double middle = static_cast<double>(i) + 0.5;
        std::size_t shown = 0;
        for (const ThresholdLine& line : results.lines) {
            if (line.task == task && line.condition == groups[i]->condition &&
                line.track == groups[i]->track && line.fit.threshold)
                chart.dot(middle - 0.15 - 0.02 * static_cast<double>(shown++ * 7U % 11U), *line.fit.threshold,
                          0, 0.7, true);
        }
        if (groups[i]->interval)
            chart.barUp(middle + 0.15, *groups[i]->interval, 1);
        if (groups[i]->threshold)
            chart.dot(middle + 0.15, *groups[i]->threshold, 1);
        chart.category(middle, placeOf(groups[i]->condition, groups[i]->track));
    }
    chart.canvas().watermark(watermarkFor(mode));
    return chart.canvas();
}

figure::SvgCanvas detectionFigure(const DetectionResults& results, const DetectionGroup& group,
                                  std::optional<Mode> mode) {
    std::vector<const DetectionLine*> lines;
    double low = -0.5;
    double high = 2.0;
    const auto include = [&](double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    };
    for (const DetectionLine& line : results.lines) {
        if (line.task != group.task || line.condition != group.condition || line.track != group.track)
            continue;
        lines.push_back(&line);
        if (!line.detection)
            continue;
        include(line.detection->sensitivity);
        if (line.detection->interval) {
            include(line.detection->interval->low);
            include(line.detection->interval->high);
        }
        if (line.detection->criterion)
            include(*line.detection->criterion);
    }
    if (group.interval) {
        include(group.interval->low);
        include(group.interval->high);
    }
    const auto places = static_cast<double>(lines.size() + 1);
    LevelChart chart(textOf(group.task) + QStringLiteral(", ") + placeOf(group.condition, group.track),
                     {{}, LevelScale::linear, 0.0, places},
                     {ThresholdText::tr("d', c"), LevelScale::linear, low - 0.1, high + 0.1});
    chart.legend(0, ThresholdText::tr("d', 95 %"));
    chart.legend(2, ThresholdText::tr("c (above 0: rather no)"), true);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double x = static_cast<double>(i) + 0.5;
        chart.category(x, textOf(lines[i]->participant));
        const std::optional<Detection>& detection = lines[i]->detection;
        if (!detection)
            continue;
        if (detection->interval)
            chart.barUp(x - 0.08, *detection->interval, 0);
        chart.dot(x - 0.08, detection->sensitivity, 0);
        if (detection->criterion)
            chart.dot(x + 0.12, *detection->criterion, 2, 1.0, true);
    }
    chart.category(places - 0.5, ThresholdText::tr("mean"));
    if (group.interval)
        chart.barUp(places - 0.5, *group.interval, 1);
    if (group.sensitivity)
        chart.dot(places - 0.5, *group.sensitivity, 1);
    chart.canvas().watermark(watermarkFor(mode));
    return chart.canvas();
}

std::vector<ThresholdFigure> thresholdFigures(const ThresholdResults& thresholds,
                                              const DetectionResults& detection, std::optional<Mode> mode) {
    std::vector<ThresholdFigure> figures;
    UniqueNames names;
    const auto add = [&](const std::string& name, figure::SvgCanvas picture) {
        figures.push_back({names.add(name), std::move(picture)});
    };
    std::set<std::string> tasks;
    for (const ThresholdGroup& group : thresholds.groups)
        tasks.insert(group.task);
    for (const std::string& task : tasks)
        add("thresholds_" + safeFileName(task), thresholdsFigure(thresholds, task, mode));
    for (const ThresholdLine& line : thresholds.lines) {
        const std::string place = safeFileName(line.task) + '_' + safeFileName(line.condition) + '_' +
                                  safeFileName(line.track) + '_' + safeFileName(line.participant);
        add("curve_" + place, curveFigure(line, mode));
        add("track_" + place, trackFigure(line, mode));
    }
    for (const DetectionGroup& group : detection.groups) {
        add("detection_" + safeFileName(group.task) + '_' + safeFileName(group.condition) + '_' +
                safeFileName(group.track),
            detectionFigure(detection, group, mode));
    }
    return figures;
}

core::Expected<void> writeThresholdFigures(const ThresholdResults& thresholds,
                                           const DetectionResults& detection, const std::string& folder,
                                           std::optional<Mode> mode,
                                           const std::vector<ThresholdFigureFormat>& formats) {
    if (thresholds.empty())
        return {};
    const core::PrivateFiles forOwner;
    const std::string figures = folder + "/figures";
    TELETA_CHECK(core::makeFolder(figures));
    for (const ThresholdFigure& figure : thresholdFigures(thresholds, detection, mode)) {
        const std::string svg = figure.picture.standalone();
        for (const ThresholdFigureFormat& format : formats) {
            TELETA_TRY(const std::string content,
                       format.convert ? format.convert(svg) : core::Expected<std::string>(svg));
            TELETA_CHECK(core::writeFile(figures + '/' + figure.name + '.' + format.extension, content));
        }
    }
    return {};
}

} // namespace teleta::study
