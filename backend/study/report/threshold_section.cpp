// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/threshold_section.h"

#include "backend/study/methods/figures/threshold_figures.h"
#include "backend/study/methods/results/bracelet_results.h"
#include "backend/study/report/report_html.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <set>

namespace teleta::study {

namespace {

using namespace report_html;

struct ThresholdSectionText {
    Q_DECLARE_TR_FUNCTIONS(ThresholdSection)
};

QString number(const std::optional<double>& value) {
    return value ? QString::number(*value, 'g', 4) : QStringLiteral("NA");
}

QString ends(const OpenInterval& interval) {
    const auto one = [](const std::optional<double>& end) {
        return end ? number(end) : ThresholdSectionText::tr("open", "end of an interval");
    };
    return interval.low || interval.high
               ? ThresholdSectionText::tr("%1 to %2", "interval").arg(one(interval.low), one(interval.high))
               : QStringLiteral("NA");
}

QString ends(const std::optional<Interval>& interval) {
    return interval ? ends(OpenInterval{interval->low, interval->high}) : QStringLiteral("NA");
}

/// Empty for the fit of all tracks together.
QString trackCell(const std::string& track) {
    return track == "all" ? QString() : text(track);
}

QStringList placeCells(const std::string& participant, const std::string& condition,
                       const std::string& track) {
    return {text(participant), text(condition), trackCell(track)};
}

QStringList placeColumns() {
    return {ThresholdSectionText::tr("Participant"), ThresholdSectionText::tr("Condition"),
            ThresholdSectionText::tr("Track")};
}

QString participantTable(const ThresholdResults& thresholds, const std::string& task) {
    HtmlTable table(
        ThresholdSectionText::tr("Each participant; intervals of 95 % by profile likelihood unless the "
                                 "tables say otherwise"),
        placeColumns() +
            QStringList{
                ThresholdSectionText::tr("Trials"), ThresholdSectionText::tr("Threshold"),
                ThresholdSectionText::tr("95 %"), ThresholdSectionText::tr("Slope or spread"),
                ThresholdSectionText::tr("Just noticeable difference"),
                ThresholdSectionText::tr("Weber fraction"), ThresholdSectionText::tr("p of the deviance"),
                ThresholdSectionText::tr("Estimate of the procedure"), ThresholdSectionText::tr("Remark")});
    for (const ThresholdLine& line : thresholds.lines) {
        if (line.task != task)
            continue;
        const PsychometricFit& fit = line.fit;
        const ProcedureEstimate& own = line.procedure;
        table.row(
            placeCells(line.participant, line.condition, line.track) +
                QStringList{QString::number(fit.trials), number(fit.threshold), ends(fit.thresholdInterval),
                            number(fit.spread), number(line.justNoticeable()), number(line.weber()),
                            probability(fit.goodness ? std::optional(fit.goodness->pDeviance) : std::nullopt),
                            number(own.staircase ? own.staircase : own.bayesMean), text(line.note())},
            3);
    }
    return table.html();
}

QString groupTable(const ThresholdResults& thresholds, const std::string& task) {
    HtmlTable table(
        ThresholdSectionText::tr("All participants: the mean of their thresholds with Student's t "
                                 "interval, and one fit of all with a threshold for each"),
        {ThresholdSectionText::tr("Condition"), ThresholdSectionText::tr("Track"),
         ThresholdSectionText::tr("Participants"), ThresholdSectionText::tr("Mean"),
         ThresholdSectionText::tr("95 %"), ThresholdSectionText::tr("One fit of all"),
         ThresholdSectionText::tr("95 %"), ThresholdSectionText::tr("Spread of the participants"),
         ThresholdSectionText::tr("Remark")});
    for (const ThresholdGroup& group : thresholds.groups) {
        if (group.task != task)
            continue;
        const std::optional<HierarchicalThreshold>& all = group.hierarchical;
        QStringList remarks;
        if (group.without > 0)
            remarks << text(group.note());
        if (!all)
            remarks << ThresholdSectionText::tr("no fit of all: %1").arg(text(group.withoutHierarchical));
        table.row({text(group.condition), trackCell(group.track), QString::number(group.participants),
                   number(group.threshold), ends(group.interval),
                   number(all ? std::optional(all->threshold) : std::nullopt),
                   all ? ends(all->interval) : QStringLiteral("NA"),
                   number(all ? std::optional(all->participantSd) : std::nullopt),
                   remarks.join(QStringLiteral("; "))},
                  2);
    }
    return table.html();
}

QString stepsTable(const ThresholdResults& thresholds, const std::string& task) {
    HtmlTable table(
        ThresholdSectionText::tr("Intensities that can be told apart, from the start of the motor to its "
                                 "full drive"),
        {ThresholdSectionText::tr("Participant"), ThresholdSectionText::tr("Track"),
         ThresholdSectionText::tr("References"), ThresholdSectionText::tr("Steps")});
    bool any = false;
    for (const StepsLine& line : intensityStepsOf(thresholds)) {
        if (line.task != task)
            continue;
        any = true;
        table.row({text(line.participant), trackCell(line.track), QString::number(line.references),
                   line.steps ? QString::number(*line.steps) : QStringLiteral("NA")},
                  2);
    }
    return any ? table.html() : QString();
}

QString doubtText(OnsetDoubt doubt) {
    switch (doubt) {
    case OnsetDoubt::tooFewTimes:
        return ThresholdSectionText::tr("fewer than three times");
    case OnsetDoubt::noTop:
        return ThresholdSectionText::tr("the share of yes has no highest point");
    case OnsetDoubt::outside:
        return ThresholdSectionText::tr("the highest point is outside the times that were shown");
    case OnsetDoubt::none:
        break;
    }
    return {};
}

QString onsetTable(const ThresholdResults& thresholds, const std::string& task) {
    HtmlTable table(ThresholdSectionText::tr("The time from burst to burst with the most yes, s"),
                    placeColumns() + QStringList{ThresholdSectionText::tr("Best"),
                                                 ThresholdSectionText::tr("95 %"),
                                                 ThresholdSectionText::tr("Remark")});
    bool any = false;
    for (const OnsetLine& line : bestOnsetsOf(thresholds)) {
        if (line.task != task)
            continue;
        any = true;
        const bool isKnown = line.best.doubt == OnsetDoubt::none;
        table.row(placeCells(line.participant, line.condition, line.track) +
                      QStringList{number(isKnown ? std::optional(line.best.onset_s) : std::nullopt),
                                  isKnown ? ends(OpenInterval{line.best.low_s, line.best.high_s})
                                          : QStringLiteral("NA"),
                                  doubtText(line.best.doubt)},
                  3);
    }
    return any ? table.html() : QString();
}

QString detectionTable(const DetectionResults& detection, const std::string& task) {
    HtmlTable table(ThresholdSectionText::tr("Sensitivity d' and criterion c over all levels"),
                    placeColumns() + QStringList{ThresholdSectionText::tr("Hits"),
                                                 ThresholdSectionText::tr("False alarms"),
                                                 QStringLiteral("d'"), ThresholdSectionText::tr("95 %"),
                                                 QStringLiteral("c"), ThresholdSectionText::tr("Method")});
    bool any = false;
    const auto of = [](std::int64_t count, std::int64_t all) {
        return QStringLiteral("%1/%2").arg(count).arg(all);
    };
    for (const DetectionLine& line : detection.lines) {
        if (line.task != task)
            continue;
        any = true;
        const std::optional<Detection>& found = line.detection;
        table.row(placeCells(line.participant, line.condition, line.track) +
                      QStringList{of(line.hits, line.signalTrials),
                                  line.falseAlarms ? of(*line.falseAlarms, line.noiseTrials.value_or(0))
                                                   : QStringLiteral("NA"),
                                  number(found ? std::optional(found->sensitivity) : std::nullopt),
                                  ends(found ? found->interval : std::nullopt),
                                  number(found ? found->criterion : std::nullopt), text(line.method)},
                  3);
    }
    for (const DetectionGroup& group : detection.groups) {
        if (group.task == task && group.participants > 1)
            table.row(QStringList{ThresholdSectionText::tr("Mean of %1").arg(group.participants),
                                  text(group.condition), trackCell(group.track), QString(), QString(),
                                  number(group.sensitivity), ends(group.interval), QString(),
                                  QStringLiteral("t")},
                      3);
    }
    return any ? table.html() : QString();
}

} // namespace

QString thresholdSection(const ThresholdResults& thresholds, const DetectionResults& detection,
                         std::optional<Mode> mode) {
    QString html;
    std::set<std::string> seen;
    for (const ThresholdLine& line : thresholds.lines) {
        const std::string& task = line.task;
        if (!seen.insert(task).second)
            continue;
        const QString unit =
            line.facts.unit.empty() ? ThresholdSectionText::tr("as in the data") : text(line.facts.unit);
        html +=
            QStringLiteral("<section>\n<h2>%1</h2>\n")
                .arg(ThresholdSectionText::tr("Thresholds: %1").arg(text(task)).toHtmlEscaped()) +
            paragraph(
                ThresholdSectionText::tr("The threshold is where half of the way from guessing to the most "
                                         "right answers is reached. Unit of the levels: %1.")
                    .arg(unit)) +
            figure(thresholdsFigure(thresholds, task, mode),
                   ThresholdSectionText::tr(
                       "Thresholds of the participants, and their means with t intervals.")) +
            groupTable(thresholds, task) + participantTable(thresholds, task) + stepsTable(thresholds, task) +
            onsetTable(thresholds, task) + detectionTable(detection, task) + QStringLiteral("</section>\n");
    }
    return html;
}

} // namespace teleta::study
