// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/results/level_content.h"

#include "backend/study/methods/figures/threshold_figures.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace teleta::study {

namespace {

QString shownText(const std::string& text) {
    return QString::fromStdString(text);
}

QString dataNumber(double value) {
    return QLocale::c().toString(value, 'g', QLocale::FloatingPointShortest);
}

ResultCell numberCell(const std::optional<double>& value, int digits = 3) {
    if (!value || !std::isfinite(*value))
        return {QStringLiteral("\u2013"), QStringLiteral("NA")};
    return {QLocale().toString(*value, 'g', digits), dataNumber(*value)};
}

ResultCell endsCell(const std::optional<double>& low, const std::optional<double>& high) {
    if (!low && !high)
        return {QStringLiteral("\u2013"), QStringLiteral("NA;NA")};
    const auto shown = [](const std::optional<double>& end) {
        return end ? QLocale().toString(*end, 'g', 3) : QStringLiteral("?");
    };
    const auto data = [](const std::optional<double>& end) {
        return end ? dataNumber(*end) : QStringLiteral("NA");
    };
    return {QStringLiteral("%1 \u2013 %2").arg(shown(low), shown(high)),
            QStringLiteral("%1;%2").arg(data(low), data(high))};
}

ResultCell endsCell(const std::optional<Interval>& ends) {
    return ends ? endsCell(ends->low, ends->high) : endsCell(std::nullopt, std::nullopt);
}

ResultCell noteCell(const QString& words, const std::string& note) {
    return {words, note.empty() ? QStringLiteral("NA") : shownText(note)};
}

ResultCell countCell(std::int64_t value) {
    return {QString::number(value)};
}

ResultCell nameCell(const std::string& condition, const ConditionNames& names) {
    return {names.value(shownText(condition), shownText(condition)), shownText(condition)};
}

QString placeName(const std::string& condition, const std::string& track, const ConditionNames& names) {
    const QString shown = names.value(shownText(condition), shownText(condition));
    return track == "all" ? shown : shown + QStringLiteral(", ") + shownText(track);
}

QString keyOf(const std::string& participant, const std::string& condition, const std::string& track) {
    return shownText(participant + '\n' + condition + '\n' + track);
}

QString fileOf(const char* kind, const std::string& task, const std::string& condition,
               const std::string& track, const std::string& participant) {
    QString name = QLatin1String(kind);
    for (const std::string& part : {task, condition, track, participant}) {
        if (!part.empty())
            name += QLatin1Char('_') + shownText(part);
    }
    return name;
}

QString countsCsv(const ThresholdLine& line) {
    QString csv = QStringLiteral("level,n,n_positive\n");
    for (const LevelCount& count : line.counts)
        csv += QStringLiteral("%1,%2,%3\n").arg(dataNumber(count.level)).arg(count.trials).arg(count.correct);
    return csv;
}

QString trialsCsv(const ThresholdLine& line) {
    QString csv = QStringLiteral("trial,level,positive,counts\n");
    for (std::size_t i = 0; i < line.trials.size(); ++i) {
        const KeptTrial& trial = line.trials[i].kept;
        csv += QStringLiteral("%1,%2,%3,%4\n")
                   .arg(i + 1)
                   .arg(dataNumber(trial.level))
                   .arg(trial.correct ? 1 : 0)
                   .arg(trial.counts ? 1 : 0);
    }
    return csv;
}

QString tableCsv(const TableContent& table) {
    QString csv = table.header.join(QLatin1Char(',')) + QLatin1Char('\n');
    for (const std::vector<ResultCell>& row : table.rows) {
        QStringList cells;
        for (const ResultCell& cell : row)
            cells << (cell.data.isEmpty() ? cell.shown : cell.data);
        csv += cells.join(QLatin1Char(',')) + QLatin1Char('\n');
    }
    return csv;
}

/// One item for each line of a task.
template <typename Draw>
std::vector<FigureItem> itemsOf(const LevelContent::Shared& results, const QString& task,
                                const ConditionNames& names, const Draw& draw) {
    std::vector<FigureItem> items;
    for (const ThresholdLine& line : results->thresholds.lines) {
        if (shownText(line.task) != task)
            continue;
        items.push_back({keyOf(line.participant, line.condition, line.track),
                         shownText(line.participant) + QStringLiteral(", ") +
                             placeName(line.condition, line.track, names),
                         [results, &line, draw] { return draw(line); }});
    }
    return items;
}

/// "Threshold, s": with the unit of the task's levels.
QString withUnit(const QString& name, const LevelResults& results, const QString& task) {
    for (const ThresholdLine& line : results.thresholds.lines) {
        if (shownText(line.task) == task && !line.facts.unit.empty())
            return name + QStringLiteral(", ") + shownText(line.facts.unit);
    }
    return name;
}

} // namespace

bool LevelResults::has(const QString& task) const {
    return std::ranges::any_of(thresholds.lines,
                               [&](const ThresholdLine& line) { return shownText(line.task) == task; });
}

const FeltTask* LevelResults::feltTask(const QString& task) const {
    const auto found =
        std::ranges::find_if(felt, [&](const FeltTask& one) { return shownText(one.task) == task; });
    return found == felt.end() ? nullptr : &*found;
}

bool LevelResults::hasDetection(const QString& task) const {
    return std::ranges::any_of(detection.lines,
                               [&](const DetectionLine& line) { return shownText(line.task) == task; });
}

namespace {

/// Columns of a table of thresholds that not every study has: speed and force of the motors, and thresholds
/// without the rules of exclusion.
class MoreColumns {
    Q_DECLARE_TR_FUNCTIONS(LevelContent)

public:
    MoreColumns(const LevelResults& results, const QString& task, const pattern::MotorProfiles* motors)
        : m_without(results.withoutRules ? &*results.withoutRules : nullptr) {
        if (const FeltTask* felt = results.feltTask(task); felt != nullptr && motors != nullptr) {
            m_strengths = feltStrengths(results.thresholds, *felt, *motors);
            m_isComparison = felt->design == Design::compare;
        }
    }

    void addHeader(TableContent& table) const {
        const auto add = [&table](const QString& header, const QString& tip) {
            table.header << header;
            table.tips << tip;
        };
        if (m_without != nullptr)
            add(tr("Without rules"), tr("Threshold of all trials, including those that the rules leave out"));
        if (m_strengths.empty())
            return;
        add(tr("Speed, Hz"),
            tr("Of the motors at this level, by their measured curves; mean over the tactors"));
        add(tr("Force, %"), tr("Square of that speed over the square of the speed at full drive"));
        if (m_isComparison) {
            add(tr("Weber of speed"),
                tr("By how much the speed rises from the reference to reference + JND"));
            add(tr("Weber of force"),
                tr("By how much the force rises from the reference to reference + JND"));
        }
    }

    /// participant: empty for the mean of all.
    void addCells(std::vector<ResultCell>& row, const std::string& task, const std::string& participant,
                  const std::string& condition, const std::string& track) const {
        if (m_without != nullptr)
            row.push_back(numberCell(withoutRules(task, participant, condition, track)));
        if (m_strengths.empty())
            return;
        const auto line = std::ranges::find_if(m_strengths, [&](const FeltStrength& one) {
            return one.participant == participant && one.condition == condition && one.track == track;
        });
        const std::optional<FeltStrength> found =
            line == m_strengths.end() ? std::nullopt : std::optional(*line);
        const auto add = [&](auto value) {
            row.push_back(numberCell(found ? std::optional<double>(value(*found)) : std::nullopt));
        };
        add([](const FeltStrength& one) { return one.strength.speed_Hz; });
        add([](const FeltStrength& one) { return 100.0 * one.strength.force; });
        if (m_isComparison) {
            row.push_back(numberCell(found ? found->weberSpeed : std::nullopt));
            row.push_back(numberCell(found ? found->weberForce : std::nullopt));
        }
    }

private:
    [[nodiscard]] std::optional<double> withoutRules(const std::string& task, const std::string& participant,
                                                     const std::string& condition,
                                                     const std::string& track) const {
        const auto isOf = [&](const auto& one) {
            return one.task == task && one.condition == condition && one.track == track;
        };
        if (participant.empty()) {
            const auto group = std::ranges::find_if(m_without->groups, isOf);
            return group == m_without->groups.end() ? std::nullopt : group->threshold;
        }
        const auto line = std::ranges::find_if(m_without->lines, [&](const ThresholdLine& one) {
            return isOf(one) && one.participant == participant;
        });
        return line == m_without->lines.end() ? std::nullopt : line->fit.threshold;
    }

    const ThresholdResults* m_without;
    std::vector<FeltStrength> m_strengths;
    bool m_isComparison = false;
};

} // namespace

QString LevelContent::motorNote(const LevelResults& results, const QString& task,
                                const pattern::MotorProfiles* motors) {
    const FeltTask* felt = results.feltTask(task);
    if (felt == nullptr || felt->vary != Vary::intensity)
        return {};
    if (motors == nullptr)
        return tr(
            "A level is a share of the range from a motor's start to its full drive. Connect the bracelet, "
            "and the speed of its motors in Hz and their force are shown beside the levels.");
    if (feltStrengths(results.thresholds, *felt, *motors).empty())
        return tr(
            "A level is a share of the range from a motor's start to its full drive. Measure the motors of "
            "this bracelet on the page Calibrate, and their speed in Hz and their force are shown beside "
            "the levels.");
    return {};
}

std::vector<FigureItem> LevelContent::curves(const Shared& results, const QString& task, Mode mode,
                                             const ConditionNames& names) {
    std::vector<FigureItem> items;
    items.push_back({QStringLiteral("*"), tr("All participants"), [results, task, mode, names] {
                         return base::SvgView::Picture{
                             QStringLiteral("thresholds_") + task, tr("Thresholds of all participants"),
                             thresholdsFigure(results->thresholds, task.toStdString(), mode),
                             tableCsv(thresholdTable(*results, task, names))};
                     }});
    std::vector<FigureItem> each = itemsOf(results, task, names, [mode](const ThresholdLine& line) {
        return base::SvgView::Picture{
            fileOf("curve", line.task, line.condition, line.track, line.participant),
            shownText(line.participant) + QStringLiteral(": ") + thresholdWords(line),
            curveFigure(line, mode), countsCsv(line)};
    });
    items.insert(items.end(), each.begin(), each.end());
    return items;
}

std::vector<FigureItem> LevelContent::tracks(const Shared& results, const QString& task, Mode mode,
                                             const ConditionNames& names) {
    return itemsOf(results, task, names, [mode](const ThresholdLine& line) {
        return base::SvgView::Picture{
            fileOf("track", line.task, line.condition, line.track, line.participant),
            tr("Levels of %1 over the trials").arg(shownText(line.participant)), trackFigure(line, mode),
            trialsCsv(line)};
    });
}

std::vector<FigureItem> LevelContent::detection(const Shared& results, const QString& task, Mode mode,
                                                const ConditionNames& names) {
    std::vector<FigureItem> items;
    for (const DetectionGroup& group : results->detection.groups) {
        if (shownText(group.task) != task)
            continue;
        const QString place = placeName(group.condition, group.track, names);
        items.push_back(
            {keyOf({}, group.condition, group.track), place, [results, &group, place, task, mode, names] {
                 return base::SvgView::Picture{
                     fileOf("detection", group.task, group.condition, group.track, {}),
                     tr("d' and c of all participants, %1").arg(place),
                     detectionFigure(results->detection, group, mode),
                     tableCsv(detectionTable(*results, task, names))};
             }});
    }
    return items;
}

TableContent LevelContent::thresholdTable(const LevelResults& results, const QString& task,
                                          const ConditionNames& names, const pattern::MotorProfiles* motors) {
    const MoreColumns more(results, task, motors);
    TableContent table;
    table.header = {tr("Participant"),
                    tr("Condition"),
                    tr("Track"),
                    tr("Trials"),
                    withUnit(tr("Threshold"), results, task),
                    tr("95 %"),
                    tr("Spread or slope"),
                    tr("Lapses"),
                    tr("p of fit"),
                    withUnit(tr("JND"), results, task),
                    tr("Weber"),
                    tr("What it says")};
    table.tips = {
        {},
        {},
        {},
        {},
        tr("Where the curve is half-way between guessing and its upper end; of a "
           "comparison the level that feels equal"),
        tr("By profile likelihood; of all participants Student's t of their thresholds. ? stands for an "
           "open end"),
        tr("s of gauss and logistic, in the unit of the level; the slope b of weibull"),
        tr("Share of mistakes however strong the stimulus is"),
        tr("Of the deviance, by data sets that are drawn and fitted again; constant stimuli only"),
        tr("Just noticeable difference: half of the way from 25 to 75 %"),
        tr("JND over the reference"),
        {}};
    more.addHeader(table);
    for (const ThresholdLine& line : results.thresholds.lines) {
        if (shownText(line.task) != task)
            continue;
        const PsychometricFit& fit = line.fit;
        table.rows.push_back(
            {{shownText(line.participant)},
             nameCell(line.condition, names),
             {shownText(line.track)},
             countCell(fit.trials),
             numberCell(fit.threshold),
             endsCell(fit.thresholdInterval.low, fit.thresholdInterval.high),
             numberCell(fit.spread),
             numberCell(fit.lapse, 2),
             numberCell(fit.goodness ? std::optional(fit.goodness->pDeviance) : std::nullopt, 2),
             numberCell(line.justNoticeable()),
             numberCell(line.weber()),
             noteCell(thresholdWords(line), line.note())});
        more.addCells(table.rows.back(), line.task, line.participant, line.condition, line.track);
    }
    for (const ThresholdGroup& group : results.thresholds.groups) {
        if (shownText(group.task) != task)
            continue;
        const QString words =
            group.without == 0
                ? tr("mean of %1").arg(group.participants)
                : tr("mean of %1; %2 without threshold").arg(group.participants).arg(group.without);
        table.rows.push_back({{tr("All"), QStringLiteral("GROUP")},
                              nameCell(group.condition, names),
                              {shownText(group.track)},
                              {QStringLiteral("\u2013"), QStringLiteral("NA")},
                              numberCell(group.threshold),
                              endsCell(group.interval),
                              numberCell({}),
                              numberCell({}),
                              numberCell({}),
                              numberCell(group.justNoticeable),
                              numberCell(group.weber),
                              noteCell(words, group.note())});
        more.addCells(table.rows.back(), group.task, {}, group.condition, group.track);
    }
    return table;
}

TableContent LevelContent::trackTable(const LevelResults& results, const QString& task,
                                      const ConditionNames& names) {
    TableContent table;
    table.header = {tr("Participant"),
                    tr("Condition"),
                    tr("Track"),
                    tr("Trials"),
                    withUnit(tr("Mean of reversals"), results, task),
                    tr("Reversals"),
                    withUnit(tr("Posterior mean"), results, task),
                    tr("Its sd"),
                    tr("Note")};
    table.tips = {{},
                  {},
                  {},
                  {},
                  tr("The estimate of a staircase"),
                  {},
                  tr("The estimate of a Bayesian procedure"),
                  tr("On the scale of the levels: in log10 units on a logarithmic one")};
    for (const ThresholdLine& line : results.thresholds.lines) {
        if (shownText(line.task) != task || !line.facts.settings)
            continue;
        const ProcedureEstimate& own = line.procedure;
        const QString note = QLatin1String(toString(own.note));
        table.rows.push_back(
            {{shownText(line.participant)},
             nameCell(line.condition, names),
             {shownText(line.track)},
             countCell(static_cast<std::int64_t>(line.trials.size())),
             numberCell(own.staircase),
             own.reversals ? countCell(static_cast<std::int64_t>(*own.reversals)) : numberCell({}),
             numberCell(own.bayesMean),
             numberCell(own.bayesSd, 2),
             {note.isEmpty() ? QStringLiteral("\u2013") : note,
              note.isEmpty() ? QStringLiteral("NA") : note}});
    }
    return table;
}

TableContent LevelContent::detectionTable(const LevelResults& results, const QString& task,
                                          const ConditionNames& names) {
    TableContent table;
    table.header = {tr("Participant"), tr("Condition"), tr("Track"), tr("Hits"),  tr("False alarms"),
                    tr("d'"),          tr("95 %"),      tr("c"),     tr("Method")};
    table.tips = {{},
                  {},
                  {},
                  tr("Of how many trials with a stimulus; of several intervals right answers"),
                  tr("Of how many trials without"),
                  tr("Sensitivity; rates are (count + 1/2) / (trials + 1)"),
                  {},
                  tr("Criterion: above 0 rather no; of two intervals below 0 rather the first")};
    const auto shareCell = [](const std::optional<std::int64_t>& count,
                              const std::optional<std::int64_t>& all) {
        return count && all ? ResultCell{QStringLiteral("%1/%2").arg(*count).arg(*all)}
                            : ResultCell{QStringLiteral("\u2013"), QStringLiteral("NA")};
    };
    for (const DetectionLine& line : results.detection.lines) {
        if (shownText(line.task) != task)
            continue;
        table.rows.push_back(
            {{shownText(line.participant)},
             nameCell(line.condition, names),
             {shownText(line.track)},
             shareCell(line.hits, line.signalTrials),
             shareCell(line.falseAlarms, line.noiseTrials),
             numberCell(line.detection ? std::optional(line.detection->sensitivity) : std::nullopt),
             endsCell(line.detection ? line.detection->interval : std::nullopt),
             numberCell(line.detection ? line.detection->criterion : std::nullopt),
             {shownText(line.method)}});
    }
    for (const DetectionGroup& group : results.detection.groups) {
        if (shownText(group.task) != task)
            continue;
        table.rows.push_back({{tr("All"), QStringLiteral("GROUP")},
                              nameCell(group.condition, names),
                              {shownText(group.track)},
                              shareCell({}, {}),
                              shareCell({}, {}),
                              numberCell(group.sensitivity),
                              endsCell(group.interval),
                              numberCell({}),
                              {tr("mean of %1").arg(group.participants)}});
    }
    return table;
}

} // namespace teleta::study
