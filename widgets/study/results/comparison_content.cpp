// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/results/comparison_content.h"

#include "widgets/study/results/result_cells.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace teleta::study {

namespace {

constexpr double kShareToPercent = 100.0;
constexpr std::size_t kMostCurvePoints = 500;

QString plain(const std::string& value) {
    return QString::fromStdString(value);
}

/// A level's name on the screen; files have its id.
QString levelName(const std::string& effect, const std::string& level, const ConditionNames& names) {
    return effect == "condition" ? names.value(plain(level), plain(level)) : plain(level);
}

/// "shown - shown", and in files "id;id".
ResultCell pairCell(const std::string& effect, const std::string& first, const std::string& second,
                    const ConditionNames& names) {
    return {
        QStringLiteral("%1 \u2013 %2").arg(levelName(effect, first, names), levelName(effect, second, names)),
        plain(first + ";" + second)};
}

ResultCell orMissing(const std::string& text) {
    return text.empty() ? missing() : ResultCell{plain(text)};
}

template <typename Result>
ResultCell refusalCell(const Result& result) {
    return {result ? QString() : QString::fromLatin1(toString(result.error()))};
}

std::optional<double> inPercent(const std::optional<double>& share) {
    return share ? std::optional(kShareToPercent * *share) : std::nullopt;
}

} // namespace

TableContent ComparisonContent::pairs(const TaskComparisons& comparisons, const ConditionNames& names) {
    TableContent table;
    table.header = QStringList{tr("Effect"),   tr("Pattern"), tr("Pair"), tr("n"),      tr("Difference %"),
                               tr("95 %"),     tr("t"),       tr("p"),    tr("p Holm"), tr("d_z"),
                               tr("d_z 95 %"), tr("d_av"),    tr("g_z"),  tr("Note")};
    table.tips = QStringList{{},
                             tr("A comparison of the conditions for this pattern alone"),
                             tr("The first minus the second"),
                             tr("Participants with both values"),
                             {},
                             tr("Of the difference, not corrected"),
                             tr("Paired t test"),
                             {},
                             tr("Corrected over all pairs of the effect; over all patterns where the "
                                "conditions are compared within them"),
                             tr("Difference over the standard deviation of the differences"),
                             tr("From the noncentral t distribution, not corrected"),
                             tr("Difference over the mean standard deviation of the two"),
                             tr("d_z with Hedges' correction"),
                             {}};
    for (const LevelPair& pair : comparisons.pairs) {
        const auto& test = pair.comparison.test;
        const auto value = [&](double PairedTest::*member) {
            return test ? std::optional((*test).*member) : std::nullopt;
        };
        table.rows.push_back({{plain(pair.effect)},
                              orMissing(pair.stimulus),
                              pairCell(pair.effect, pair.first, pair.second, names),
                              count(static_cast<std::int64_t>(pair.comparison.participants)),
                              cell(inPercent(pair.comparison.difference), 1),
                              cell(test ? std::optional(test->interval) : std::nullopt, 1, kShareToPercent),
                              cell(value(&PairedTest::t), 2),
                              pCell(value(&PairedTest::p)),
                              pCell(pair.pHolm),
                              cell(value(&PairedTest::dz), 2),
                              cell(test ? test->dzInterval : std::nullopt, 2),
                              cell(test ? test->dav : std::nullopt, 2),
                              cell(test ? test->gz() : std::nullopt, 2),
                              refusalCell(test)});
    }
    return table;
}

TableContent ComparisonContent::ranks(const TaskComparisons& comparisons, const ConditionNames& names) {
    TableContent table;
    table.header = QStringList{tr("Effect"), tr("Pattern"), tr("Pair"), tr("W+"),  tr("W\u2212"),
                               tr("p"),      tr("p Holm"),  tr("r"),    tr("Note")};
    table.tips = QStringList{{},
                             {},
                             {},
                             tr("Sum of the ranks of positive differences"),
                             tr("Sum of the ranks of negative differences"),
                             tr("Wilcoxon's signed rank test with Pratt's zeros; exact up to 25 differences"),
                             tr("Corrected over all pairs of the effect"),
                             tr("Rank-biserial correlation"),
                             {}};
    for (const LevelPair& pair : comparisons.pairs) {
        const auto& test = pair.ranks;
        const auto value = [&](double SignedRankTest::*member) {
            return test ? std::optional((*test).*member) : std::nullopt;
        };
        table.rows.push_back({{plain(pair.effect)},
                              orMissing(pair.stimulus),
                              pairCell(pair.effect, pair.first, pair.second, names),
                              cell(value(&SignedRankTest::positive), 1),
                              cell(value(&SignedRankTest::negative), 1),
                              pCell(value(&SignedRankTest::p)),
                              pCell(pair.ranksHolm),
                              cell(value(&SignedRankTest::rankBiserial), 2),
                              refusalCell(test)});
    }
    return table;
}

TableContent ComparisonContent::effects(const TaskResults& task, const TaskComparisons& comparisons) {
    TableContent table;
    table.header = QStringList{
        tr("Effect"), tr("Pattern"), tr("partial eta\u00b2"), tr("95 %"), tr("Friedman \u03c7\u00b2"),
        tr("df"),     tr("p"),       tr("Kendall's W"),       tr("Note")};
    table.tips =
        QStringList{{},
                    {},
                    {},
                    tr("From the noncentral F distribution; only with sphericity, eps GG at least 0.75"),
                    tr("By ranks, of three levels and more"),
                    {},
                    tr("Of Friedman's test"),
                    tr("Concordance of the participants"),
                    {}};
    for (std::size_t i = 0; i < comparisons.effects.size(); ++i) {
        const EffectSupplement& effect = comparisons.effects[i];
        const std::optional<AnovaEffect>& row = task.anova[i].row;
        const bool hasRanks = effect.friedman && *effect.friedman;
        const auto value = [&](double FriedmanTest::*member) {
            return hasRanks ? std::optional((**effect.friedman).*member) : std::nullopt;
        };
        table.rows.push_back({{plain(effect.effect)},
                              orMissing(effect.stimulus),
                              cell(row ? std::optional(row->partialEta2) : std::nullopt, 3),
                              cell(effect.partialEta2, 3),
                              cell(value(&FriedmanTest::chi2), 2),
                              cell(value(&FriedmanTest::df), 0),
                              pCell(value(&FriedmanTest::p)),
                              cell(value(&FriedmanTest::w), 2),
                              {plain(effect.note)}});
    }
    return table;
}

TableContent ComparisonContent::model(const tl::expected<AccuracyModel, ModelRefusal>& model,
                                      const ConditionNames& names) {
    TableContent table;
    table.header = QStringList{tr("Term"), tr("Estimate"), tr("SE"), tr("95 %"), tr("Odds ratio")};
    table.tips = QStringList{{}, tr("Logit of a right answer"), {}, tr("Wald's interval"), {}};
    if (!model)
        return table;
    for (std::size_t i = 0; i < model->fit.b.size(); ++i) {
        const std::string& condition = i == 0 ? model->reference : model->terms[i - 1];
        const QString name = levelName("condition", condition, names);
        table.rows.push_back({{i == 0 ? tr("intercept (%1)").arg(name) : name, plain(condition)},
                              cell(model->fit.b[i], 3),
                              cell(model->fit.standardError(i), 3),
                              cell(std::optional(model->fit.interval(i)), 3),
                              i == 0 ? missing() : cell(std::exp(model->fit.b[i]), 2)});
    }
    return table;
}

QString ComparisonContent::modelNote(const tl::expected<AccuracyModel, ModelRefusal>& model) {
    if (!model) {
        switch (model.error()) {
        case ModelRefusal::tooFewParticipants:
            return tr("A model of single answers needs at least 5 participants.");
        case ModelRefusal::separable:
            return tr(
                "No model of single answers: under one condition all answers are right, or all wrong, so "
                "that its effect has no finite estimate.");
        case ModelRefusal::noData:
        case ModelRefusal::notConverged:
        case ModelRefusal::falls:
            break;
        }
        return tr("No model of single answers: the search has found no maximum.");
    }
    QString note = model->fit.s > 0.0
                       ? tr("Each participant has an own intercept, with a standard deviation of %1.")
                             .arg(QLocale().toString(model->fit.s, 'f', 3))
                       : tr("The participants do not differ more than chance makes them.");
    if (model->condition)
        note += QLatin1Char(' ') + tr("Conditions: likelihood ratio \u03c7\u00b2(%1) = %2, p %3.")
                                       .arg(QLocale().toString(model->condition->df),
                                            QLocale().toString(model->condition->chi2, 'f', 2),
                                            pRelation(model->condition->p));
    return note;
}

TableContent ComparisonContent::times(const TimeComparisons& times, const ConditionNames& names) {
    TableContent table;
    table.header =
        QStringList{tr("Pair"), tr("n"), tr("Ratio"), tr("95 %"), tr("t"), tr("p"), tr("p Holm"), tr("Note")};
    table.tips = QStringList{tr("The first divided by the second"),
                             tr("Participants with times under both"),
                             tr("Of the geometric means of the response times of right answers"),
                             {},
                             tr("Paired t test of the mean logarithms"),
                             {},
                             {},
                             {}};
    for (const TimePair& pair : times.pairs) {
        const auto& test = pair.logs.test;
        table.rows.push_back(
            {pairCell("condition", pair.first, pair.second, names),
             count(static_cast<std::int64_t>(pair.logs.participants)), cell(pair.ratio(), 3),
             cell(pair.ratioInterval(), 3), cell(test ? std::optional(test->t) : std::nullopt, 2),
             pCell(test ? std::optional(test->p) : std::nullopt), pCell(pair.pHolm), refusalCell(test)});
    }
    return table;
}

CurveContent ComparisonContent::cumulativeTimes(const TaskResults& task, const ConditionNames& names) {
    CurveContent chart;
    chart.name = QStringLiteral("cumulative_times_") + plain(task.task);
    chart.title = tr("Right answers given within a time");
    chart.xAxis = tr("s from the onset");
    chart.yAxis = tr("answered, %");
    chart.highest = kShareToPercent;
    double longest_s = 0.0;
    for (const GroupSummary& group : task.groups) {
        std::vector<double> times_s;
        for (const ParticipantSummary& person : task.participants) {
            if (person.condition == group.condition)
                times_s.insert(times_s.end(), person.times_s.begin(), person.times_s.end());
        }
        std::ranges::sort(times_s);
        CurveSeries series{levelName("condition", group.condition, names), {}};
        if (!times_s.empty()) {
            series.points.push_back({0.0, 0.0});
            longest_s = std::max(longest_s, times_s.back());
        }
        const std::size_t stride = std::max<std::size_t>(1, times_s.size() / kMostCurvePoints);
        for (std::size_t i = 0; i < times_s.size(); ++i) {
            if (i % stride == 0 || i + 1 == times_s.size())
                series.points.push_back({times_s[i], kShareToPercent * static_cast<double>(i + 1) /
                                                         static_cast<double>(times_s.size())});
        }
        chart.series.push_back(std::move(series));
    }
    chart.highestX = std::max(1.0, std::ceil(longest_s));
    return chart;
}

TableContent ComparisonContent::rules(const std::vector<ExclusionLine>& lines) {
    TableContent table;
    table.header = QStringList{tr("Rule"),   tr("Value"),    tr("Made"),         tr("Trials before"),
                               tr("Trials"), tr("Sessions"), tr("Participants"), tr("Note")};
    table.tips = QStringList{{},
                             {},
                             tr("Before the data, in the protocol, or after them"),
                             tr("What the rules before have left"),
                             tr("Left out"),
                             tr("Left out as a whole"),
                             tr("Left out as a whole"),
                             {}};
    for (const ExclusionLine& line : lines) {
        if (!line.participant.empty())
            continue;
        const bool isMarked = !line.kind;
        const QString note = line.cellsWithoutSpread > 0
                                 ? tr("no spread of the times in %n case(s): nothing left out", nullptr,
                                      static_cast<int>(line.cellsWithoutSpread))
                                 : QString();
        table.rows.push_back({{plain(line.rule)},
                              isMarked ? missing() : cell(line.value, 3),
                              {isMarked            ? tr("in the file")
                               : line.afterTheData ? tr("after the data")
                                                   : tr("before the data"),
                               isMarked            ? QStringLiteral("file")
                               : line.afterTheData ? QStringLiteral("after the data")
                                                   : QStringLiteral("protocol")},
                              count(static_cast<std::int64_t>(line.trialsBefore)),
                              count(static_cast<std::int64_t>(line.trials)),
                              count(static_cast<std::int64_t>(line.sessions)),
                              count(static_cast<std::int64_t>(line.participants)),
                              {note}});
    }
    return table;
}

TableContent ComparisonContent::withAndWithout(const std::string& task,
                                               const std::vector<TaskResults>& results,
                                               const std::vector<TaskResults>& withoutRules) {
    TableContent table;
    table.header = QStringList{tr("Condition or effect"), tr("Right %"), tr("Right % without rules"),
                               tr("p GG"), tr("p GG without rules")};
    table.tips = QStringList{};
    for (const ComparedResult& row : comparedResults(results, withoutRules)) {
        if (row.task == task)
            table.rows.push_back({{plain(row.name)},
                                  cell(inPercent(row.accuracy), 1),
                                  cell(inPercent(row.accuracyWithout), 1),
                                  pCell(row.p),
                                  pCell(row.pWithout)});
    }
    return table;
}

} // namespace teleta::study
