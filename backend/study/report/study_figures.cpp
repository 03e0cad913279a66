// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/study_figures.h"

#include "backend/core/data/output_file.h"
#include "backend/core/data/private_files.h"
#include "backend/figure/round_step.h"
#include "backend/study/report/comparison_section.h"
#include "backend/study/report/confusion_figure.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <cmath>
#include <set>

namespace teleta::study {

namespace {

struct ChartText {
    Q_DECLARE_TR_FUNCTIONS(ChartText)
};

constexpr double kPlotLeft = 76.0;
constexpr double kPlotTop = 64.0;
constexpr double kPlotHeight = 300.0; // of the plotting area
constexpr double kPlotBottom = 44.0;
constexpr double kPlotRight = 20.0;
constexpr double kDot = 5.0;

QString series(std::size_t index) {
    return QStringLiteral("series%1").arg(index % figure::SvgCanvas::kSeries);
}

QString classes(const QString& names) {
    return QStringLiteral("class=\"%1\"").arg(names);
}

/// About five steps per span.
double tickStep(double span) {
    return figure::roundStep(span / 6.0);
}

/// A chart with categories along x and values from 0 to `top` along y.
class CategoryChart {
public:
    CategoryChart(const QString& title, const QString& yTitle, const std::vector<std::string>& categories,
                  double categoryWidth, double top)
        : m_slot(categoryWidth)
        , m_top(top)
        , canvas(kPlotLeft + kPlotRight +
                     std::max(categoryWidth * static_cast<double>(categories.size()), 260.0),
                 kPlotTop + kPlotHeight + kPlotBottom, title) {
        m_slot = std::max(categoryWidth, 260.0 / static_cast<double>(categories.size()));
        m_width = m_slot * static_cast<double>(categories.size());
        canvas.text(kPlotLeft + m_width / 2.0, 24.0, title, QStringLiteral("ink middle bold"));
        const double middle = kPlotTop + kPlotHeight / 2.0;
        canvas.text(20.0, middle, yTitle, QStringLiteral("ink middle"),
                    QStringLiteral("transform=\"rotate(-90 20 %1)\"").arg(figure::svgNumber(middle)));
        const double step = tickStep(top);
        for (int i = 0; i * step <= top * (1.0 + 1e-9); ++i) {
            const double value = i * step;
            canvas.line(kPlotLeft, y(value), kPlotLeft + m_width, y(value), QStringLiteral("soft"));
            canvas.text(kPlotLeft - 8.0, y(value) + 5.0, QString::number(value, 'g', 4),
                        QStringLiteral("ink end"));
        }
        canvas.line(kPlotLeft, kPlotTop, kPlotLeft, kPlotTop + kPlotHeight, QStringLiteral("ink"));
        canvas.line(kPlotLeft, kPlotTop + kPlotHeight, kPlotLeft + m_width, kPlotTop + kPlotHeight,
                    QStringLiteral("ink"));
        for (std::size_t i = 0; i < categories.size(); ++i)
            canvas.text(x(i), kPlotTop + kPlotHeight + 22.0, QString::fromStdString(categories[i]),
                        QStringLiteral("ink middle"));
    }

    [[nodiscard]] double x(std::size_t category, double offset = 0.0) const {
        return kPlotLeft + m_slot * (static_cast<double>(category) + 0.5) + offset;
    }
    [[nodiscard]] double y(double value) const {
        return kPlotTop + kPlotHeight * (1.0 - std::clamp(value / m_top, 0.0, 1.0));
    }

    void interval(double atX, const Interval& ends, const QString& series) {
        const QString style = series + QStringLiteral(" bar");
        canvas.line(atX, y(ends.low), atX, y(ends.high), style);
        for (const double end : {ends.low, ends.high})
            canvas.line(atX - 7.0, y(end), atX + 7.0, y(end), style);
    }

    /// Spread sideways, so that they do not hide each other.
    void dots(std::size_t category, const std::vector<double>& values, double offset, const QString& series) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double spread = 28.0 * (static_cast<double>((i * 7U) % 11U) / 10.0 - 0.5);
            canvas.circle(x(category, offset + spread), y(values[i]), kDot - 1.0,
                          classes(series + QStringLiteral(" faint")));
        }
    }

    void level(double value, const QString& name) {
        canvas.line(kPlotLeft, y(value), kPlotLeft + m_width, y(value), QStringLiteral("dashed"));
        canvas.text(kPlotLeft + m_width - 4.0, y(value) - 6.0, name, QStringLiteral("soft small end"));
    }

    void legend(const std::vector<std::string>& names) {
        double at = kPlotLeft + 4.0;
        for (std::size_t i = 0; i < names.size(); ++i) {
            const QString name = QString::fromStdString(names[i]);
            mark(i, at + 6.0, kPlotTop - 17.0);
            canvas.text(at + 18.0, kPlotTop - 12.5, name, QStringLiteral("ink small"));
            at += 36.0 + 7.0 * static_cast<double>(name.size());
        }
    }

    /// Series differ in shape too.
    void mark(std::size_t index, double atX, double atY) {
        if (index % 2 == 0)
            canvas.circle(atX, atY, kDot, classes(series(index)));
        else
            canvas.diamond(atX, atY, kDot + 2.0, classes(series(index)));
    }

private:
    double m_slot;
    double m_width = 0.0;
    double m_top;

public:
    figure::SvgCanvas canvas;
};

std::vector<std::string> conditionsOf(const TaskResults& task) {
    std::vector<std::string> names;
    for (const GroupSummary& group : task.groups)
        names.push_back(group.condition);
    return names;
}

Interval inPercent(const Interval& shares) {
    return {100.0 * shares.low, 100.0 * shares.high};
}

QString titled(const TaskResults& task, const QString& what) {
    return QStringLiteral("%1: %2").arg(QString::fromStdString(task.task), what);
}

QString safeName(const std::string& name) {
    QString safe = QString::fromStdString(name);
    for (QChar& c : safe) {
        const bool plain = c.unicode() < 128 && (c.isLetterOrNumber() || c == QLatin1Char('-'));
        c = plain ? c : QLatin1Char('_');
    }
    return safe;
}

/// File names, unique even after characters were replaced and without regard to case.
class FileNames {
public:
    QString add(const QString& name) {
        QString unique = name;
        for (int number = 2; !m_used.insert(unique.toLower()).second; ++number)
            unique = QStringLiteral("%1-%2").arg(name).arg(number);
        return unique;
    }

private:
    std::set<QString> m_used;
};

} // namespace

figure::SvgCanvas accuracyFigure(const TaskResults& task, std::optional<Mode> mode) {
    CategoryChart chart(titled(task, ChartText::tr("correct answers")), ChartText::tr("correct, %"),
                        conditionsOf(task), 130.0, 100.0);
    chart.level(100.0 / static_cast<double>(task.alternatives()), ChartText::tr("chance"));
    for (std::size_t i = 0; i < task.groups.size(); ++i) {
        const GroupSummary& group = task.groups[i];
        std::vector<double> shares;
        for (const ParticipantSummary& person : task.participants) {
            if (person.condition == group.condition)
                shares.push_back(100.0 * person.matrix.accuracy().value_or(0.0));
        }
        chart.dots(i, shares, -24.0, series(i));
        if (!group.accuracy)
            continue;
        if (group.accuracy->interval)
            chart.interval(chart.x(i, 22.0), inPercent(*group.accuracy->interval), series(i));
        chart.mark(i, chart.x(i, 22.0), chart.y(100.0 * group.accuracy->mean));
    }
    chart.canvas.watermark(watermarkOf(mode));
    return chart.canvas;
}

std::vector<double> patternAccuracies(const TaskResults& task, const std::string& condition,
                                      std::size_t pattern) {
    std::vector<double> shares;
    for (const ParticipantSummary& person : task.participants) {
        if (person.condition != condition)
            continue;
        if (const std::optional<double> percent = person.matrix.rowPercent(pattern, pattern))
            shares.push_back(*percent / 100.0);
    }
    return shares;
}

figure::SvgCanvas patternFigure(const TaskResults& task, std::optional<Mode> mode) {
    const double between = 26.0;
    const auto conditions = static_cast<double>(task.groups.size());
    CategoryChart chart(titled(task, ChartText::tr("correct answers by pattern")),
                        ChartText::tr("correct, %"), task.patterns, between * conditions + 34.0, 100.0);
    for (std::size_t c = 0; c < task.groups.size(); ++c) {
        const double offset = between * (static_cast<double>(c) - (conditions - 1.0) / 2.0);
        for (std::size_t i = 0; i < task.patterns.size(); ++i) {
            const std::optional<GroupMean> mean =
                groupShare(patternAccuracies(task, task.groups[c].condition, i));
            if (!mean)
                continue;
            if (mean->interval)
                chart.interval(chart.x(i, offset), inPercent(*mean->interval), series(c));
            chart.mark(c, chart.x(i, offset), chart.y(100.0 * mean->mean));
        }
    }
    chart.legend(conditionsOf(task));
    chart.canvas.watermark(watermarkOf(mode));
    return chart.canvas;
}

figure::SvgCanvas responseTimeFigure(const TaskResults& task, std::optional<Mode> mode) {
    double longest_s = 0.0;
    for (const ParticipantSummary& person : task.participants)
        longest_s = std::max(longest_s, person.medianTime_s.value_or(0.0));
    const double top_s =
        longest_s > 0.0 ? tickStep(longest_s) * std::ceil(longest_s / tickStep(longest_s)) : 1.0;
    CategoryChart chart(titled(task, ChartText::tr("response times")),
                        ChartText::tr("median of correct answers, s"), conditionsOf(task), 130.0, top_s);
    for (std::size_t i = 0; i < task.groups.size(); ++i) {
        std::vector<double> medians_s;
        for (const ParticipantSummary& person : task.participants) {
            if (person.condition == task.groups[i].condition && person.medianTime_s)
                medians_s.push_back(*person.medianTime_s);
        }
        chart.dots(i, medians_s, -24.0, series(i));
        if (const std::optional<double> middle_s = median(medians_s))
            chart.mark(i, chart.x(i, 22.0), chart.y(*middle_s));
    }
    chart.canvas.watermark(watermarkOf(mode));
    return chart.canvas;
}

figure::SvgCanvas transferFigure(const TaskResults& task, std::optional<Mode> mode) {
    const double most_bit = std::log2(static_cast<double>(task.alternatives()));
    CategoryChart chart(titled(task, ChartText::tr("information transfer")), ChartText::tr("bit"),
                        conditionsOf(task), 150.0, std::max(0.5, std::ceil(2.0 * most_bit) / 2.0));
    chart.level(most_bit, ChartText::tr("all patterns told apart"));
    for (std::size_t i = 0; i < task.groups.size(); ++i) {
        const std::optional<TransferEstimate>& bits = task.groups[i].transfer;
        if (!bits)
            continue;
        if (bits->interval)
            chart.interval(chart.x(i, 36.0), *bits->interval, series(i));
        chart.mark(i, chart.x(i, -36.0), chart.y(bits->measured_bit));
        chart.canvas.circle(chart.x(i, 36.0), chart.y(bits->corrected_bit), kDot,
                            classes(series(i) + QStringLiteral(" hollow")));
        chart.canvas.text(chart.x(i, -36.0), kPlotTop + kPlotHeight + 38.0, ChartText::tr("measured"),
                          QStringLiteral("soft small middle"));
        chart.canvas.text(chart.x(i, 36.0), kPlotTop + kPlotHeight + 38.0, ChartText::tr("less bias"),
                          QStringLiteral("soft small middle"));
    }
    chart.canvas.watermark(watermarkOf(mode));
    return chart.canvas;
}

std::vector<StudyFigure> studyFigures(const std::vector<TaskResults>& results, std::optional<Mode> mode) {
    std::vector<StudyFigure> figures;
    FileNames tasks;
    FileNames files;
    const auto add = [&](const QString& name, figure::SvgCanvas picture) {
        figures.push_back({files.add(name).toStdString(), std::move(picture)});
    };
    for (const TaskResults& task : results) {
        const QString id = tasks.add(safeName(task.task));
        for (const GroupSummary& group : task.groups) {
            const QString place = id + QLatin1Char('_') + safeName(group.condition);
            const std::string title = task.task + ", " + group.condition;
            add(QStringLiteral("confusion_") + place,
                confusionFigure(group.matrix, task.patterns, title, ConfusionValues::percent, mode));
            add(QStringLiteral("confusion_counts_") + place,
                confusionFigure(group.matrix, task.patterns, title, ConfusionValues::counts, mode));
        }
        if (task.groups.empty())
            continue;
        add(QStringLiteral("accuracy_") + id, accuracyFigure(task, mode));
        add(QStringLiteral("patterns_") + id, patternFigure(task, mode));
        add(QStringLiteral("response_time_") + id, responseTimeFigure(task, mode));
        add(QStringLiteral("cumulative_time_") + id, cumulativeTimeFigure(task, mode));
        add(QStringLiteral("transfer_") + id, transferFigure(task, mode));
    }
    return figures;
}

core::Expected<void> writeFigures(const std::vector<TaskResults>& results, const std::string& folder,
                                  std::optional<Mode> mode, const std::vector<FigureFormat>& formats) {
    const core::PrivateFiles forOwner;
    const std::string figures = folder + "/figures";
    TELETA_CHECK(core::makeFolder(figures));
    for (const StudyFigure& figure : studyFigures(results, mode)) {
        const std::string svg = figure.picture.standalone();
        for (const FigureFormat& format : formats) {
            TELETA_TRY(const std::string content,
                       format.convert ? format.convert(svg) : core::Expected<std::string>(svg));
            TELETA_CHECK(core::writeFile(figures + '/' + figure.name + '.' + format.extension, content));
        }
    }
    return {};
}

} // namespace teleta::study
