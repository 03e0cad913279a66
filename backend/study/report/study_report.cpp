// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/study_report.h"

#include "backend/core/data/output_file.h"
#include "backend/core/data/private_files.h"
#include "backend/study/comparison/task_comparisons.h"
#include "backend/study/report/comparison_section.h"
#include "backend/study/report/confusion_figure.h"
#include "backend/study/report/report_html.h"
#include "backend/study/report/report_page.h"
#include "backend/study/report/study_figures.h"
#include "backend/study/report/threshold_section.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <algorithm>

namespace teleta::study {

namespace {

using namespace report_html;
using report_html::interval; // beside that of study_files.cpp

struct ReportText {
    Q_DECLARE_TR_FUNCTIONS(ReportText)
};

/// Where the true transfer is: an interval or a bound.
QString range(const std::optional<TransferEstimate>& transfer) {
    if (transfer && transfer->atLeast_bit)
        return ReportText::tr("at least %1").arg(fixed(transfer->atLeast_bit, 3));
    if (transfer && transfer->atMost_bit)
        return ReportText::tr("at most %1").arg(fixed(transfer->atMost_bit, 3));
    return interval(transfer ? transfer->interval : std::nullopt, 1.0, 3);
}

class TaskSection {
public:
    /// hasLevels: shares of right answers depend on the levels that were shown, and are not compared.
    TaskSection(const TaskResults& task, std::optional<Mode> mode, bool hasLevels)
        : m_task(task)
        , m_mode(mode)
        , m_hasLevels(hasLevels) {}

    [[nodiscard]] QString html() const {
        const QString head =
            QStringLiteral("<section>\n<h2>%1</h2>\n").arg(text(m_task.task).toHtmlEscaped());
        const QString end = QStringLiteral("</section>\n");
        if (m_task.groups.empty())
            return head + paragraph(ReportText::tr("There are no test trials.")) + end;
        return head + accuracy() + confusions() + patterns() + times() + timeSection(m_task, m_mode) +
               transfer() + participants() + (m_hasLevels ? QString() : anova() + comparisonSection(m_task)) +
               end;
    }

private:
    /// What to know about the interval of a mean share.
    [[nodiscard]] static QString remarkOf(const std::optional<GroupMean>& mean) {
        if (mean && mean->allAgree())
            return ReportText::tr("all participants have the same share");
        return mean && mean->isCut ? ReportText::tr("the interval is cut off at 0 or 100 %") : QString();
    }

    [[nodiscard]] QString accuracy() const {
        HtmlTable table(
            ReportText::tr("Correct answers of the group; the interval is that of Student's t over "
                           "participants (95 %)"),
            {ReportText::tr("Condition"), ReportText::tr("Participants"), ReportText::tr("Mean, %"),
             ReportText::tr("SD, %"), ReportText::tr("Interval, %"), ReportText::tr("Remark")});
        for (const GroupSummary& group : m_task.groups) {
            const std::optional<GroupMean>& mean = group.accuracy;
            table.row({text(group.condition), QString::number(group.participants),
                       percent(mean ? std::optional(mean->mean) : std::nullopt),
                       percent(mean ? mean->standardDeviation : std::nullopt),
                       interval(mean ? mean->interval : std::nullopt, 100.0, 1), remarkOf(mean)});
        }
        return heading(ReportText::tr("Correct answers")) +
               figure(
                   accuracyFigure(m_task, m_mode),
                   ReportText::tr("Dots: participants. Marks: mean with the t interval over participants.")) +
               table.html();
    }

    [[nodiscard]] QString confusions() const {
        QString pictures;
        QString tables;
        for (const GroupSummary& group : m_task.groups) {
            const std::string title = m_task.task + ", " + group.condition;
            pictures += figure(
                confusionFigure(group.matrix, m_task.patterns, title, ConfusionValues::percent, m_mode),
                ReportText::tr("Rows: presented; columns: answered. Percent of the row, all participants."));
            QStringList columns{ReportText::tr("Presented")};
            for (const std::string& pattern : m_task.patterns)
                columns << text(pattern);
            columns << QStringLiteral("NONE") << ReportText::tr("Trials");
            HtmlTable table(ReportText::tr("%1: trials and share of the row in percent").arg(text(title)),
                            columns);
            for (std::size_t i = 0; i < m_task.patterns.size(); ++i) {
                QStringList cells{text(m_task.patterns[i])};
                for (std::size_t j = 0; j < group.matrix.columns(); ++j)
                    cells << QStringLiteral("%1 (%2 %)")
                                 .arg(group.matrix.count(i, j))
                                 .arg(fixed(group.matrix.rowPercent(i, j), 1));
                table.row(cells << QString::number(group.matrix.rowTotal(i)));
            }
            tables += table.html();
        }
        return heading(ReportText::tr("Confusion matrices")) +
               QStringLiteral("<div class=\"beside\">\n%1</div>\n").arg(pictures) + tables;
    }

    [[nodiscard]] QString patterns() const {
        QStringList columns{ReportText::tr("Pattern")};
        for (const GroupSummary& group : m_task.groups)
            columns << ReportText::tr("%1, %").arg(text(group.condition));
        if (m_task.groups.size() == 2)
            columns << QStringLiteral("F") << ReportText::tr("df") << QStringLiteral("p")
                    << ReportText::tr("p, Holm");
        const TaskComparisons comparisons = taskComparisons(m_task);
        HtmlTable table(ReportText::tr("Mean of the participants' correct answers for each pattern; "
                                       "two conditions are compared within participants; Holm: "
                                       "corrected over the patterns"),
                        columns);
        for (std::size_t i = 0; i < m_task.patterns.size(); ++i) {
            QStringList cells{text(m_task.patterns[i])};
            for (const GroupSummary& group : m_task.groups) {
                const auto mean = groupShare(patternAccuracies(m_task, group.condition, i));
                cells << percent(mean ? std::optional(mean->mean) : std::nullopt);
            }
            if (m_task.groups.size() == 2)
                cells << comparison(m_task.patterns[i])
                      << probability(patternPHolm(comparisons, m_task.patterns[i]));
            table.row(cells);
        }
        return heading(ReportText::tr("Patterns and conditions")) +
               figure(patternFigure(m_task, m_mode),
                      ReportText::tr("Mean of the participants with the t interval (95 %).")) +
               table.html();
    }

    /// F, df and p of the conditions within one pattern.
    [[nodiscard]] QStringList comparison(const std::string& pattern) const {
        for (const AnovaLine& line : m_task.anova) {
            if (line.stimulus != pattern)
                continue;
            if (!line.row)
                return {text(line.note), QStringLiteral("NA"), QStringLiteral("NA")};
            return {fixed(line.row->f, 3), QStringLiteral("%1, %2").arg(line.row->df1).arg(line.row->df2),
                    probability(line.row->pGg)};
        }
        return {QStringLiteral("NA"), QStringLiteral("NA"), QStringLiteral("NA")};
    }

    [[nodiscard]] QString times() const {
        HtmlTable table(
            ReportText::tr("Participants' median response times of correct, answered test trials, "
                           "from the onset of the stimulus"),
            {ReportText::tr("Condition"), ReportText::tr("Participants"),
             ReportText::tr("Median of the medians, s"), ReportText::tr("Shortest, s"),
             ReportText::tr("Longest, s")});
        for (const GroupSummary& group : m_task.groups) {
            std::vector<double> medians_s;
            for (const ParticipantSummary& person : m_task.participants) {
                if (person.condition == group.condition && person.medianTime_s)
                    medians_s.push_back(*person.medianTime_s);
            }
            const auto [least, most] = std::ranges::minmax_element(medians_s);
            const bool none = medians_s.empty();
            table.row({text(group.condition), QString::number(medians_s.size()), fixed(median(medians_s), 3),
                       fixed(none ? std::nullopt : std::optional(*least), 3),
                       fixed(none ? std::nullopt : std::optional(*most), 3)});
        }
        return heading(ReportText::tr("Response times")) +
               figure(responseTimeFigure(m_task, m_mode),
                      ReportText::tr("Dots: medians of participants. Marks: the median of these.")) +
               table.html();
    }

    [[nodiscard]] QString transfer() const {
        HtmlTable table(
            ReportText::tr("Information transfer of the pooled answers in bit. Corrected: without "
                           "bias, by the jackknife over participants. Interval: of the true "
                           "transfer (95 %)"),
            {ReportText::tr("Condition"), ReportText::tr("Trials"), ReportText::tr("Measured"),
             ReportText::tr("Bias"), ReportText::tr("Corrected"), ReportText::tr("Interval"),
             ReportText::tr("A guesser would show"), ReportText::tr("Remark")});
        for (const GroupSummary& group : m_task.groups) {
            const std::optional<TransferEstimate>& bits = group.transfer;
            QStringList remarks;
            if (bits && bits->fewTrials)
                remarks << ReportText::tr("few trials: fewer than 5 k²");
            if (bits && bits->doubt != TransferDoubt::none)
                remarks << text(explain(bits->doubt));
            table.row(
                {text(group.condition), QString::number(group.matrix.total()),
                 fixed(bits ? std::optional(bits->measured_bit) : std::nullopt, 3),
                 fixed(bits ? std::optional(bits->measured_bit - bits->corrected_bit) : std::nullopt, 3),
                 fixed(bits ? std::optional(bits->corrected_bit) : std::nullopt, 3), range(bits),
                 fixed(guesserTransfer(group.matrix, m_task.alternatives()), 2),
                 remarks.join(QStringLiteral("; "))});
        }
        return heading(ReportText::tr("Information transfer")) +
               figure(
                   transferFigure(m_task, m_mode),
                   ReportText::tr(
                       "Filled: measured. Hollow: less the bias, with the interval of the true transfer.")) +
               QStringLiteral("<p class=\"warning\">%1</p>\n")
                   .arg(ReportText::tr(
                       "The measured value is too high with few trials: even a participant who "
                       "only guesses shows more than 0 bit. Compare it with the column of the "
                       "guesser, and use the corrected value with care.")) +
               table.html();
    }

    [[nodiscard]] QString participants() const {
        HtmlTable table(
            ReportText::tr("Each participant, test trials; intervals of 95 %, p of so many correct "
                           "answers by chance"),
            {ReportText::tr("Participant"), ReportText::tr("Condition"), ReportText::tr("Correct"),
             ReportText::tr("No answer"), ReportText::tr("Accuracy, %"), ReportText::tr("Wilson, %"),
             ReportText::tr("Clopper-Pearson, %"), ReportText::tr("p of chance"),
             ReportText::tr("Transfer, bit"), ReportText::tr("Guesser, bit"),
             ReportText::tr("Corrected, bit"), ReportText::tr("Median time, s"), ReportText::tr("Times")});
        const double chance = 1.0 / static_cast<double>(m_task.alternatives());
        for (const ParticipantSummary& person : m_task.participants) {
            const std::int64_t n = person.matrix.total();
            const std::int64_t correct = person.matrix.correct();
            const auto bits = informationTransfer(person.matrix);
            table.row({text(person.participant), text(person.condition),
                       QStringLiteral("%1/%2").arg(correct).arg(n),
                       QString::number(person.matrix.unanswered()), percent(person.matrix.accuracy()),
                       interval(wilsonInterval(correct, n), 100.0, 1),
                       interval(clopperPearsonInterval(correct, n), 100.0, 1),
                       probability(chanceProbability(correct, n, chance)),
                       fixed(bits ? std::optional(bits->measured_bit) : std::nullopt, 3),
                       fixed(guesserTransfer(person.matrix, m_task.alternatives()), 2),
                       fixed(bits ? std::optional(bits->corrected_bit) : std::nullopt, 3),
                       fixed(person.medianTime_s, 3), QString::number(person.times_s.size())},
                      2);
        }
        return heading(ReportText::tr("Participants")) + table.html();
    }

    [[nodiscard]] QString anova() const {
        HtmlTable table(
            ReportText::tr("Analysis of variance within participants of the shares of correct answers; "
                           "p with the corrections of Greenhouse and Geisser and of Huynh and Feldt"),
            {ReportText::tr("Effect"), ReportText::tr("df"), QStringLiteral("F"), QStringLiteral("p"),
             QStringLiteral("ε GG"), QStringLiteral("p GG"), QStringLiteral("ε HF"), QStringLiteral("p HF"),
             ReportText::tr("partial η²"), ReportText::tr("generalised η²"), ReportText::tr("Participants"),
             ReportText::tr("Remark")});
        for (const AnovaLine& line : m_task.anova) {
            if (!line.stimulus.empty())
                continue;
            const std::optional<AnovaEffect>& row = line.row;
            const auto value = [&](double AnovaEffect::*member) {
                return row ? std::optional((*row).*member) : std::nullopt;
            };
            const std::optional<double> hf = row ? row->epsilonHf : std::nullopt;
            QStringList remarks;
            if (!line.note.empty())
                remarks << text(line.note);
            for (const std::string& person : line.dropped)
                remarks << ReportText::tr("%1 is left out: a cell is missing").arg(text(person));
            table.row({text(line.effect),
                       row ? QStringLiteral("%1, %2").arg(row->df1).arg(row->df2) : QStringLiteral("NA"),
                       fixed(value(&AnovaEffect::f), 4), probability(value(&AnovaEffect::p)),
                       fixed(value(&AnovaEffect::epsilonGg), 4), probability(value(&AnovaEffect::pGg)),
                       fixed(hf ? std::optional(std::min(1.0, *hf)) : std::nullopt, 4),
                       probability(row ? row->pHf : std::nullopt), fixed(value(&AnovaEffect::partialEta2), 4),
                       fixed(value(&AnovaEffect::generalizedEta2), 4), QString::number(line.participants),
                       remarks.join(QStringLiteral("; "))});
        }
        return heading(ReportText::tr("Analysis of variance")) + table.html();
    }

    const TaskResults& m_task;
    std::optional<Mode> m_mode;
    bool m_hasLevels;
};

QString framesText(const TrialTally::Frames& frames) {
    const int trials = static_cast<int>(frames.trials);
    const QString played =
        frames.longestWrite_ms
            ? ReportText::tr(
                  "Stimuli: %n trial(s) were played on a bracelet; the longest write of a frame took %1 ms.",
                  nullptr, trials)
                  .arg(*frames.longestWrite_ms, 0, 'f', 2)
            : ReportText::tr("Stimuli: the frames of %n trial(s) were counted.", nullptr, trials);
    return ReportText::tr("%1 Frames were missed in %2 of them, %3 in all.", "the sentence before, numbers")
        .arg(played)
        .arg(frames.trialsWithMisses)
        .arg(frames.missed);
}

} // namespace

std::string reportHtml(const std::vector<TaskResults>& results, const ReportHeading& heading) {
    QStringList sources;
    for (const std::string& source : heading.sources)
        sources << text(source);
    QString body = paragraph(ReportText::tr("Data: %1. TeleTA Console %2.")
                                 .arg(sources.join(QStringLiteral(", ")), text(heading.appVersion)));
    if (heading.frames.trials > 0)
        body += paragraph(framesText(heading.frames));
    body += exclusionSection(results, heading.exclusions);
    for (const TaskResults& task : results) {
        const bool hasLevels = std::ranges::find(heading.thresholds.lines, task.task, &ThresholdLine::task) !=
                               heading.thresholds.lines.end();
        body += TaskSection(task, heading.mode, hasLevels).html();
    }
    body += thresholdSection(heading.thresholds, heading.detection, heading.mode);
    body += QStringLiteral("<section>\n<h2>%1</h2>\n<p>%2</p>\n</section>\n")
                .arg(ReportText::tr("Compute it again"),
                     ReportText::tr("analysis.R beside this page computes its numbers again from "
                                    "confusion_long.csv, except the response times, which that file does not "
                                    "have: Rscript analysis.R. In the folder of the study it computes the "
                                    "response times too, from the exported trials."));
    return reportPage(text(heading.title), heading.mode, body).toStdString();
}

core::Expected<void> writeReport(const std::vector<TaskResults>& results, const ReportHeading& heading,
                                 const std::string& folder) {
    const core::PrivateFiles forOwner;
    TELETA_CHECK(core::makeFolder(folder));
    return core::writeFile(folder + "/report.html", reportHtml(results, heading));
}

} // namespace teleta::study
