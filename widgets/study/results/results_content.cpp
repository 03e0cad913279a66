// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/results/results_content.h"

#include "backend/study/analysis/information_transfer.h"
#include "backend/study/analysis/proportion.h"
#include "widgets/study/results/participant_picker.h"
#include "widgets/study/results/result_cells.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::study {

namespace {

constexpr double kPercent = 100.0;

QString text(const std::string& value) {
    return QString::fromStdString(value);
}

QString conditionName(const std::string& condition, const ConditionNames& names) {
    return names.value(text(condition), text(condition));
}

QStringList conditionNamesOf(const TaskResults& task, const ConditionNames& names) {
    QStringList shown;
    for (const std::string& condition : task.conditions)
        shown << conditionName(condition, names);
    return shown;
}

/// Data contain the id, in every language.
ResultCell conditionCell(const std::string& condition, const ConditionNames& names) {
    return {conditionName(condition, names), text(condition)};
}

/// Interval of the true transfer, or a bound: "NA" stands for the end that is not known.
ResultCell rangeCell(const std::optional<TransferEstimate>& transfer) {
    if (transfer && transfer->atLeast_bit) {
        const ResultCell bound = cell(transfer->atLeast_bit, 2);
        return {QStringLiteral("\u2265 ") + bound.shown, bound.data + QStringLiteral(";NA")};
    }
    if (transfer && transfer->atMost_bit) {
        const ResultCell bound = cell(transfer->atMost_bit, 2);
        return {QStringLiteral("\u2264 ") + bound.shown, QStringLiteral("NA;") + bound.data};
    }
    return cell(transfer ? transfer->interval : std::nullopt, 2);
}

std::optional<double> percent(const std::optional<double>& share) {
    return share ? std::optional(kPercent * *share) : std::nullopt;
}

std::optional<Interval> percent(const std::optional<Interval>& share) {
    return share ? std::optional(Interval{kPercent * share->low, kPercent * share->high}) : std::nullopt;
}

/// The point of a group from its participants' values.
ChartPoint groupPoint(const std::vector<double>& values) {
    ChartPoint point;
    if (const std::optional<GroupMean> mean = groupMean(values)) {
        point.value = mean->mean;
        point.interval = mean->interval;
    }
    point.single = values;
    return point;
}

/// The same from shares, in percent.
ChartPoint groupSharePoint(const std::vector<double>& shares) {
    ChartPoint point;
    if (const std::optional<GroupMean> mean = groupShare(shares)) {
        point.value = percent(std::optional(mean->mean));
        point.interval = percent(mean->interval);
    }
    for (const double share : shares)
        point.single.push_back(kPercent * share);
    return point;
}

ChartPoint sharePoint(std::int64_t correct, std::int64_t trials) {
    ChartPoint point;
    if (trials > 0) {
        point.value = kPercent * static_cast<double>(correct) / static_cast<double>(trials);
        point.interval = percent(wilsonInterval(correct, trials));
    }
    return point;
}

/// Right answers, to one pattern or to all: the share of a single participant, or the mean of a group.
ChartPoint rightPoint(const std::vector<const ParticipantSummary*>& people, bool isSingle,
                      std::optional<std::size_t> pattern = {}) {
    if (isSingle && people.empty())
        return {};
    if (isSingle) {
        const ConfusionMatrix& matrix = people.front()->matrix;
        return pattern ? sharePoint(matrix.count(*pattern, *pattern), matrix.rowTotal(*pattern))
                       : sharePoint(matrix.correct(), matrix.total());
    }
    std::vector<double> values;
    for (const ParticipantSummary* one : people) {
        if (!pattern)
            values.push_back(one->matrix.accuracy().value_or(0.0));
        else if (const std::optional<double> share = one->matrix.rowPercent(*pattern, *pattern))
            values.push_back(*share / kPercent);
    }
    return groupSharePoint(values);
}

std::vector<const ParticipantSummary*> under(const TaskResults& task, const std::string& condition,
                                             const QStringList& group) {
    std::vector<const ParticipantSummary*> found;
    for (const ParticipantSummary& summary : task.participants) {
        if (summary.condition == condition && (group.isEmpty() || group.contains(text(summary.participant))))
            found.push_back(&summary);
    }
    return found;
}

/// For one participant the interval is over trials, for a group over participants.
bool isOne(const QStringList& group) {
    return group.size() == 1;
}

bool areAllOne(const ShownPeople& shown) {
    return std::ranges::all_of(shown.groups(), isOne);
}

} // namespace

ResultCell ResultsContent::groupRemark(const GroupSummary& group) {
    QStringList remarks;
    if (group.accuracy && group.accuracy->isCut)
        remarks << tr("the t interval is cut off at 0 or 100 %");
    if (group.accuracy && group.accuracy->allAgree())
        remarks << tr("all participants have the same share");
    const bool isDoubtful = group.transfer && group.transfer->doubt != TransferDoubt::none;
    if (isDoubtful)
        remarks << text(explain(group.transfer->doubt));
    return {remarks.join(QStringLiteral("; ")),
            isDoubtful ? QString::fromLatin1(toString(group.transfer->doubt)) : QString()};
}

std::vector<QStringList> ShownPeople::groups() const {
    return beside ? std::vector{group, *beside} : std::vector{group};
}

QString ResultsContent::nameOf(const QStringList& group) {
    return group.isEmpty() ? tr("all participants") : ParticipantPicker::describe(group);
}

ConfusionMatrix ResultsContent::matrix(const TaskResults& task, const std::string& condition,
                                       const QStringList& group) {
    ConfusionMatrix sum(std::max<std::size_t>(task.patterns.size(), 1));
    for (const ParticipantSummary* one : under(task, condition, group))
        sum.add(one->matrix);
    return sum;
}

IntervalChartContent ResultsContent::accuracy(const TaskResults& task, const ShownPeople& shown,
                                              const ConditionNames& names) {
    IntervalChartContent chart;
    chart.name = QStringLiteral("accuracy_") + text(task.task);
    chart.title = areAllOne(shown) ? tr("Right answers, 95 % Wilson interval")
                                   : tr("Right answers, mean of participants, 95 % t interval");
    chart.axis = tr("right, %");
    chart.highest = kPercent;
    chart.reference = kPercent / static_cast<double>(task.alternatives());
    chart.referenceName = tr("chance");
    chart.categories = conditionNamesOf(task, names);
    for (const QStringList& group : shown.groups()) {
        ChartSeries series{shown.beside ? nameOf(group) : tr("test"), {}};
        for (const std::string& condition : task.conditions)
            series.points.push_back(rightPoint(under(task, condition, group), isOne(group)));
        chart.series.push_back(std::move(series));
    }
    return chart;
}

IntervalChartContent ResultsContent::patterns(const TaskResults& task, const ShownPeople& shown,
                                              const ConditionNames& names,
                                              const TaskComparisons* comparisons) {
    IntervalChartContent chart;
    chart.name = QStringLiteral("patterns_") + text(task.task);
    chart.title =
        task.conditions.size() > 1
            ? tr("Each pattern: %1", "conditions").arg(conditionNamesOf(task, names).join(tr(" against ")))
            : tr("Each pattern");
    chart.axis = tr("right, %");
    chart.highest = kPercent;
    chart.reference = kPercent / static_cast<double>(task.alternatives());
    chart.referenceName = tr("chance");
    for (const std::string& pattern : task.patterns) {
        chart.categories << text(pattern);
        QString note;
        for (const AnovaLine& line : task.anova) {
            if (line.stimulus == pattern && line.row)
                note = tr("p %1").arg(pRelation(line.row->p));
        }
        if (const auto corrected = comparisons ? patternPHolm(*comparisons, pattern) : std::nullopt)
            note = tr("%1; Holm %2", "p of a pattern, corrected p").arg(note, pText(*corrected));
        // The comparison covers all participants.
        chart.notes << (shown.isEverybody() ? note : QString());
    }
    for (const std::string& condition : task.conditions) {
        for (const QStringList& group : shown.groups()) {
            ChartSeries series{shown.beside ? tr("%1, %2", "condition, participant")
                                                  .arg(conditionName(condition, names), nameOf(group))
                                            : conditionName(condition, names),
                               {}};
            const auto people = under(task, condition, group);
            for (std::size_t p = 0; p < task.patterns.size(); ++p)
                series.points.push_back(rightPoint(people, isOne(group), p));
            chart.series.push_back(std::move(series));
        }
    }
    return chart;
}

IntervalChartContent ResultsContent::times(const TaskResults& task, const ShownPeople& shown,
                                           const ConditionNames& names) {
    IntervalChartContent chart;
    chart.name = QStringLiteral("response_times_") + text(task.task);
    chart.title =
        areAllOne(shown) ? tr("Median response time") : tr("Median response times, 95 % t interval");
    chart.axis = tr("s from the onset");
    double highest = 0.0;
    chart.categories = conditionNamesOf(task, names);
    for (const QStringList& group : shown.groups()) {
        ChartSeries series{shown.beside ? nameOf(group) : tr("right answers of the test"), {}};
        for (const std::string& condition : task.conditions) {
            std::vector<double> medians;
            for (const ParticipantSummary* one : under(task, condition, group)) {
                if (one->medianTime_s)
                    medians.push_back(*one->medianTime_s);
            }
            series.points.push_back(groupPoint(medians));
            if (isOne(group))
                series.points.back().single.clear();
            for (const double median : medians)
                highest = std::max(highest, median);
            if (const auto& interval = series.points.back().interval)
                highest = std::max(highest, interval->high);
        }
        chart.series.push_back(std::move(series));
    }
    chart.highest = std::max(1.0, std::ceil(1.1 * highest));
    return chart;
}

TableContent ResultsContent::groups(const TaskResults& task, const ConditionNames& names) {
    TableContent table;
    table.header = QStringList{tr("Condition"),       tr("Participants"), tr("Right %"), tr("SD"),
                               tr("95 % t interval"), tr("Trials"),       tr("IT bit"),  tr("Bias bit"),
                               tr("IT corrected"),    tr("IT 95 %"),      tr("Remark")};
    table.tips = QStringList{{},
                             {},
                             tr("Mean of the participants' shares of right answers"),
                             tr("Standard deviation between participants"),
                             tr("Of the mean, from Student's t over participants"),
                             tr("Of all participants together"),
                             tr("Information transfer of the pooled matrix, as counted"),
                             tr("Average overestimate, from the jackknife over participants"),
                             tr("Measured less bias"),
                             tr("Interval or bound of the true transfer, from the jackknife over "
                                "participants"),
                             {}};
    for (const GroupSummary& group : task.groups) {
        const std::optional<TransferEstimate>& bits = group.transfer;
        const auto value = [&](double TransferEstimate::*member) {
            return bits ? std::optional((*bits).*member) : std::nullopt;
        };
        const std::optional<double> bias_bit =
            bits ? std::optional(bits->measured_bit - bits->corrected_bit) : std::nullopt;
        table.rows.push_back(
            {conditionCell(group.condition, names), count(static_cast<std::int64_t>(group.participants)),
             cell(percent(group.accuracy ? std::optional(group.accuracy->mean) : std::nullopt), 1),
             cell(percent(group.accuracy ? group.accuracy->standardDeviation : std::nullopt), 1),
             cell(group.accuracy ? group.accuracy->interval : std::nullopt, 1, kPercent),
             count(group.matrix.total()), cell(value(&TransferEstimate::measured_bit), 2), cell(bias_bit, 2),
             cell(value(&TransferEstimate::corrected_bit), 2), rangeCell(bits), groupRemark(group)});
    }
    return table;
}

TableContent ResultsContent::people(const TaskResults& task, const ShownPeople& shown,
                                    const ConditionNames& names) {
    TableContent table;
    table.header =
        QStringList{tr("Participant"), tr("Condition"), tr("Trials"),      tr("Right"),
                    tr("No answer"),   tr("Right %"),   tr("Wilson 95 %"), tr("Clopper-Pearson 95 %"),
                    tr("p by chance"), tr("IT bit"),    tr("Bias bit"),    tr("IT corrected"),
                    tr("Median s"),    tr("of n")};
    table.tips = QStringList{{},
                             {},
                             {},
                             {},
                             tr("In time"),
                             {},
                             {},
                             {},
                             tr("Probability of so many right answers, or more, by guessing"),
                             tr("Information transfer as counted"),
                             tr("Average overestimate"),
                             tr("Measured less bias"),
                             tr("Response time of right answers"),
                             {}};
    const double chance = 1.0 / static_cast<double>(task.alternatives());
    for (const ParticipantSummary& one : task.participants) {
        const auto has = [&](const QStringList& group) {
            return group.isEmpty() || group.contains(text(one.participant));
        };
        if (std::ranges::none_of(shown.groups(), has))
            continue;
        const std::int64_t n = one.matrix.total();
        const std::int64_t correct = one.matrix.correct();
        const auto bits = informationTransfer(one.matrix);
        const auto value = [&](double InformationTransfer::*member) {
            return bits ? std::optional((*bits).*member) : std::nullopt;
        };
        table.rows.push_back({{text(one.participant)},
                              conditionCell(one.condition, names),
                              count(n),
                              count(correct),
                              count(one.matrix.unanswered()),
                              cell(percent(one.matrix.accuracy()), 1),
                              cell(wilsonInterval(correct, n), 1, kPercent),
                              cell(clopperPearsonInterval(correct, n), 1, kPercent),
                              pCell(chanceProbability(correct, n, chance)),
                              cell(value(&InformationTransfer::measured_bit), 2),
                              cell(value(&InformationTransfer::bias_bit), 2),
                              cell(value(&InformationTransfer::corrected_bit), 2),
                              cell(one.medianTime_s, 2),
                              count(static_cast<std::int64_t>(one.times_s.size()))});
    }
    return table;
}

TableContent ResultsContent::anova(const TaskResults& task) {
    TableContent table;
    table.header =
        QStringList{tr("Effect"),         tr("Pattern"), tr("df"),     tr("F"),    tr("p"),
                    tr("eps GG"),         tr("p GG"),    tr("eps HF"), tr("p HF"), tr("partial eta\u00b2"),
                    tr("gen. eta\u00b2"), tr("n"),       tr("Note")};
    table.tips = QStringList{{},
                             tr("A comparison of the conditions for this pattern alone"),
                             {},
                             {},
                             {},
                             tr("Greenhouse and Geisser"),
                             {},
                             tr("Huynh and Feldt, at most 1"),
                             {},
                             {},
                             tr("Generalised eta squared"),
                             tr("Participants with complete data"),
                             {}};
    for (const AnovaLine& line : task.anova) {
        QStringList notes;
        if (!line.note.empty())
            notes << text(line.note);
        if (!line.dropped.empty()) {
            QStringList dropped;
            for (const std::string& person : line.dropped)
                dropped << text(person);
            notes << tr("without %1").arg(dropped.join(QStringLiteral(", ")));
        }
        std::vector<ResultCell> row{{text(line.effect)},
                                    line.stimulus.empty() ? missing() : ResultCell{text(line.stimulus)}};
        if (line.row) {
            const AnovaEffect& effect = *line.row;
            const QLocale locale;
            row.push_back(
                {QStringLiteral("%1; %2").arg(locale.toString(effect.df1), locale.toString(effect.df2)),
                 QStringLiteral("%1;%2").arg(effect.df1).arg(effect.df2)});
            row.push_back(cell(effect.f, 2));
            row.push_back(pCell(effect.p));
            row.push_back(cell(effect.epsilonGg, 3));
            row.push_back(pCell(effect.pGg));
            row.push_back(
                cell(effect.epsilonHf ? std::optional(std::min(1.0, *effect.epsilonHf)) : std::nullopt, 3));
            row.push_back(pCell(effect.pHf));
            row.push_back(cell(effect.partialEta2, 3));
            row.push_back(cell(effect.generalizedEta2, 3));
        } else {
            row.resize(row.size() + 9, missing());
        }
        row.push_back(count(static_cast<std::int64_t>(line.participants)));
        row.push_back({notes.join(QStringLiteral("; "))});
        table.rows.push_back(std::move(row));
    }
    return table;
}

QString ResultsContent::transferNote(const TaskResults& task) {
    const std::size_t k = task.alternatives();
    std::int64_t trials = 0;
    bool few = false;
    for (const GroupSummary& group : task.groups) {
        if (group.participants > 0)
            trials = std::max(trials, group.matrix.total() / static_cast<std::int64_t>(group.participants));
        few = few || (group.transfer && group.transfer->fewTrials);
    }
    if (trials == 0 || k < 2)
        return {};
    ConfusionMatrix presented(k);
    for (std::size_t pattern = 0; pattern < k; ++pattern)
        presented.add(pattern, pattern, std::max<std::int64_t>(1, trials / static_cast<std::int64_t>(k)));
    QString note = tr("Few trials give too high an information transfer: with %1 trials, guessing alone "
                      "shows %2 bit on average. Use the corrected value next to it.")
                       .arg(trials)
                       .arg(QLocale().toString(guesserTransfer(presented).value_or(0.0), 'f', 2));
    if (few)
        note += QLatin1Char(' ') + tr("With fewer than 5 k\u00b2 trials even the corrected value is rough.");
    return note;
}

QString ResultsContent::anovaNote(const TaskResults& task) {
    return task.conditions.size() < 2 ? tr("There is only one condition, so the patterns are compared.")
                                      : tr("Within participants, condition \u00d7 pattern, of the shares of "
                                           "right answers; below, the conditions "
                                           "compared for each pattern.");
}

} // namespace teleta::study
