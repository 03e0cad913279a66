// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/comparison_section.h"

#include "backend/study/comparison/task_comparisons.h"
#include "backend/study/comparison/time_comparisons.h"
#include "backend/study/model/accuracy_model.h"
#include "backend/study/report/confusion_figure.h"
#include "backend/study/report/curve_chart.h"
#include "backend/study/report/report_html.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace teleta::study {

namespace {

namespace html = report_html;

constexpr std::size_t kMostCurvePoints = 500;

struct ComparisonText {
    Q_DECLARE_TR_FUNCTIONS(ComparisonText)
};

QString effectName(const std::string& effect, const std::string& stimulus) {
    return html::text(stimulus.empty() ? effect : effect + ", " + stimulus);
}

QString pairTable(const TaskComparisons& comparisons) {
    html::HtmlTable table(
        ComparisonText::tr(
            "Pairs of levels, paired t tests of the shares of correct answers. Holm: corrected "
            "over all pairs of the effect. The intervals (95 %) are not corrected"),
        {ComparisonText::tr("Effect"), ComparisonText::tr("Pair"), ComparisonText::tr("Participants"),
         ComparisonText::tr("Difference, %"), ComparisonText::tr("Interval, %"), QStringLiteral("t"),
         QStringLiteral("p"), ComparisonText::tr("p, Holm"), QStringLiteral("d z"),
         ComparisonText::tr("Interval"), QStringLiteral("d av"), QStringLiteral("g z"),
         ComparisonText::tr("Remark")});
    for (const LevelPair& pair : comparisons.pairs) {
        const auto& test = pair.comparison.test;
        const auto value = [&](double PairedTest::*member) {
            return test ? std::optional((*test).*member) : std::nullopt;
        };
        table.row({effectName(pair.effect, pair.stimulus),
                   QStringLiteral("%1 – %2").arg(html::text(pair.first), html::text(pair.second)),
                   QString::number(pair.comparison.participants), html::percent(pair.comparison.difference),
                   html::interval(test ? std::optional(test->interval) : std::nullopt, 100.0, 1),
                   html::fixed(value(&PairedTest::t), 3), html::probability(value(&PairedTest::p)),
                   html::probability(pair.pHolm), html::fixed(value(&PairedTest::dz), 3),
                   html::interval(test ? test->dzInterval : std::nullopt, 1.0, 2),
                   html::fixed(test ? test->dav : std::nullopt, 3),
                   html::fixed(test ? test->gz() : std::nullopt, 3),
                   test ? QString() : html::text(toString(test.error()))},
                  2);
    }
    return table.html();
}

QString rankTables(const TaskComparisons& comparisons) {
    html::HtmlTable pairs(
        ComparisonText::tr(
            "The same pairs by ranks: Wilcoxon's signed rank test with Pratt's zeros, exact up to "
            "25 differences"),
        {ComparisonText::tr("Effect"), ComparisonText::tr("Pair"), QStringLiteral("W+"), QStringLiteral("W−"),
         QStringLiteral("p"), ComparisonText::tr("p, Holm"), ComparisonText::tr("Rank-biserial r"),
         ComparisonText::tr("Remark")});
    for (const LevelPair& pair : comparisons.pairs) {
        const auto& test = pair.ranks;
        const auto value = [&](double SignedRankTest::*member) {
            return test ? std::optional((*test).*member) : std::nullopt;
        };
        pairs.row({effectName(pair.effect, pair.stimulus),
                   QStringLiteral("%1 – %2").arg(html::text(pair.first), html::text(pair.second)),
                   html::fixed(value(&SignedRankTest::positive), 1),
                   html::fixed(value(&SignedRankTest::negative), 1),
                   html::probability(value(&SignedRankTest::p)), html::probability(pair.ranksHolm),
                   html::fixed(value(&SignedRankTest::rankBiserial), 3),
                   test ? QString() : html::text(toString(test.error()))},
                  2);
    }
    html::HtmlTable friedman(ComparisonText::tr("Friedman's test of effects with three levels and more"),
                             {ComparisonText::tr("Effect"), QStringLiteral("χ²"), ComparisonText::tr("df"),
                              QStringLiteral("p"), ComparisonText::tr("Kendall's W"),
                              ComparisonText::tr("Remark")});
    bool hasFriedman = false;
    for (const EffectSupplement& effect : comparisons.effects) {
        if (!effect.friedman)
            continue;
        hasFriedman = true;
        const auto& test = *effect.friedman;
        const auto value = [&](double FriedmanTest::*member) {
            return test ? std::optional((*test).*member) : std::nullopt;
        };
        friedman.row({effectName(effect.effect, effect.stimulus), html::fixed(value(&FriedmanTest::chi2), 3),
                      html::fixed(value(&FriedmanTest::df), 0), html::probability(value(&FriedmanTest::p)),
                      html::fixed(value(&FriedmanTest::w), 3),
                      test ? QString() : html::text(toString(test.error()))});
    }
    return pairs.html() + (hasFriedman ? friedman.html() : QString());
}

QString etaTable(const TaskResults& task, const TaskComparisons& comparisons) {
    html::HtmlTable table(
        ComparisonText::tr(
            "Partial η² with its interval (95 %), where sphericity holds (ε GG at least 0.75)"),
        {ComparisonText::tr("Effect"), QStringLiteral("η²"), ComparisonText::tr("Interval"),
         ComparisonText::tr("Remark")});
    for (std::size_t i = 0; i < comparisons.effects.size(); ++i) {
        const EffectSupplement& effect = comparisons.effects[i];
        const std::optional<AnovaEffect>& row = task.anova[i].row;
        if (!effect.stimulus.empty())
            continue;
        table.row({effectName(effect.effect, effect.stimulus),
                   html::fixed(row ? std::optional(row->partialEta2) : std::nullopt, 4),
                   html::interval(effect.partialEta2, 1.0, 4), html::text(effect.note)});
    }
    return table.html();
}

QString modelTable(const TaskResults& task) {
    const auto model = accuracyModel(task);
    const QString title = html::heading(ComparisonText::tr("Model of single answers"));
    if (!model)
        return title +
               html::paragraph(
                   ComparisonText::tr("There are no numbers: %1.").arg(html::text(toString(model.error()))));
    html::HtmlTable table(
        ComparisonText::tr("Logit of a correct answer: an intercept that differs between participants, and "
                           "the conditions against %1; Wald's intervals (95 %)")
            .arg(html::text(model->reference)),
        {ComparisonText::tr("Term"), ComparisonText::tr("Estimate"), ComparisonText::tr("SE"),
         ComparisonText::tr("Interval"), ComparisonText::tr("Odds ratio")});
    for (std::size_t i = 0; i < model->fit.b.size(); ++i)
        table.row({i == 0 ? ComparisonText::tr("intercept (%1)").arg(html::text(model->reference))
                          : html::text(model->terms[i - 1]),
                   html::fixed(model->fit.b[i], 4), html::fixed(model->fit.standardError(i), 4),
                   html::interval(model->fit.interval(i), 1.0, 4),
                   i == 0 ? QStringLiteral("NA") : html::fixed(std::exp(model->fit.b[i]), 3)});
    QString text = model->fit.s > 0.0
                       ? ComparisonText::tr("Standard deviation of the participants: %1.")
                             .arg(html::fixed(model->fit.s, 4))
                       : ComparisonText::tr("The participants do not differ more than chance makes them.");
    if (model->condition)
        text += QLatin1Char(' ') +
                ComparisonText::tr("Conditions: likelihood ratio χ²(%1) = %2, p %3.")
                    .arg(model->condition->df)
                    .arg(html::fixed(model->condition->chi2, 3), html::probability(model->condition->p));
    return title + table.html() + html::paragraph(text);
}

} // namespace

QString comparisonSection(const TaskResults& task) {
    const TaskComparisons comparisons = taskComparisons(task);
    if (comparisons.pairs.empty())
        return {};
    return html::heading(ComparisonText::tr("Comparisons and effect sizes")) + etaTable(task, comparisons) +
           pairTable(comparisons) + rankTables(comparisons) + modelTable(task);
}

figure::SvgCanvas cumulativeTimeFigure(const TaskResults& task, std::optional<Mode> mode) {
    double longest_s = 0.0;
    std::vector<NamedCurve> curves;
    for (const GroupSummary& group : task.groups) {
        std::vector<double> times_s;
        for (const ParticipantSummary& person : task.participants) {
            if (person.condition == group.condition)
                times_s.insert(times_s.end(), person.times_s.begin(), person.times_s.end());
        }
        std::ranges::sort(times_s);
        NamedCurve curve{group.condition, {}};
        if (!times_s.empty()) {
            curve.points.emplace_back(0.0, 0.0);
            longest_s = std::max(longest_s, times_s.back());
        }
        // A figure has no more than some 500 pixels.
        const std::size_t stride = std::max<std::size_t>(1, times_s.size() / kMostCurvePoints);
        for (std::size_t i = 0; i < times_s.size(); ++i) {
            if (i % stride == 0 || i + 1 == times_s.size())
                curve.points.emplace_back(times_s[i], 100.0 * static_cast<double>(i + 1) /
                                                          static_cast<double>(times_s.size()));
        }
        curves.push_back(std::move(curve));
    }
    CurveChart chart(
        QStringLiteral("%1: %2").arg(html::text(task.task), ComparisonText::tr("response times, cumulative")),
        ComparisonText::tr("time from the onset, s"), ComparisonText::tr("answered, %"),
        AxisRange{0.0, longest_s > 0.0 ? longest_s : 1.0}.rounded(), {0.0, 100.0});
    for (const NamedCurve& curve : curves)
        chart.curve(curve);
    chart.canvas().watermark(watermarkOf(mode));
    return chart.canvas();
}

QString timeSection(const TaskResults& task, std::optional<Mode> mode) {
    const TimeComparisons times = timeComparisons(task);
    const bool hasTimes =
        std::ranges::any_of(times.participants, [](const ParticipantTimes& person) { return person.n > 0; });
    if (!hasTimes)
        return {};
    QString section =
        html::figure(cumulativeTimeFigure(task, mode),
                     ComparisonText::tr("Share of the correct answers of all participants that were given "
                                        "within a time."));
    if (times.pairs.empty())
        return section;
    html::HtmlTable table(
        ComparisonText::tr("Conditions compared by the participants' geometric means: how many times as long "
                           "the first takes; paired t tests of the logarithms"),
        {ComparisonText::tr("Pair"), ComparisonText::tr("Participants"), ComparisonText::tr("Ratio"),
         ComparisonText::tr("Interval"), QStringLiteral("t"), QStringLiteral("p"),
         ComparisonText::tr("p, Holm"), ComparisonText::tr("Remark")});
    for (const TimePair& pair : times.pairs) {
        const auto& test = pair.logs.test;
        table.row({QStringLiteral("%1 / %2").arg(html::text(pair.first), html::text(pair.second)),
                   QString::number(pair.logs.participants), html::fixed(pair.ratio(), 3),
                   html::interval(pair.ratioInterval(), 1.0, 3),
                   html::fixed(test ? std::optional(test->t) : std::nullopt, 3),
                   html::probability(test ? std::optional(test->p) : std::nullopt),
                   html::probability(pair.pHolm), test ? QString() : html::text(toString(test.error()))});
    }
    return section + table.html();
}

} // namespace teleta::study
