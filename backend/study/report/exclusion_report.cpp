// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/exclusion_report.h"

#include "backend/core/data/csv_writer.h"
#include "backend/core/data/private_files.h"
#include "backend/study/report/report_html.h"

#include <QCoreApplication>

#include <optional>
#include <string_view>

namespace teleta::study {

namespace {

struct ExclusionReportText {
    Q_DECLARE_TR_FUNCTIONS(ExclusionReport)
};

constexpr std::string_view kExclusionColumns =
    "rule,of,kind,value,origin,participant_id,trials_before,trials,sessions,participants,note";

const char* originOf(const ExclusionLine& line) {
    if (!line.kind)
        return "file";
    return line.afterTheData ? "after the data" : "protocol";
}

std::optional<ExclusionOf> levelOf(const ExclusionLine& line) {
    if (!line.kind)
        return std::nullopt;
    ExclusionRule rule;
    rule.kind = *line.kind;
    return rule.of();
}

QString ruleText(const ExclusionLine& line) {
    const QString id = QString::fromStdString(line.rule);
    if (!line.kind)
        return ExclusionReportText::tr("%1 (marked in the file)").arg(id);
    const QString rule =
        QStringLiteral("%1: %2 %3").arg(id, QLatin1String(toString(*line.kind))).arg(line.value);
    return line.afterTheData ? ExclusionReportText::tr("%1 (made after the data)").arg(rule) : rule;
}

} // namespace

core::Expected<void> writeExclusions(const std::vector<ExclusionLine>& lines, const std::string& folder) {
    const core::PrivateFiles forOwner;
    TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(folder + "/exclusions.csv", kExclusionColumns));
    for (const ExclusionLine& line : lines) {
        const std::optional<ExclusionOf> of = levelOf(line);
        csv.row(line.rule, of ? std::optional<std::string_view>(toString(*of)) : std::nullopt,
                line.kind ? std::optional<std::string_view>(toString(*line.kind)) : std::nullopt,
                line.kind ? std::optional(line.value) : std::nullopt, originOf(line),
                line.participant.empty() ? std::string_view("GROUP") : std::string_view(line.participant),
                line.trialsBefore, line.trials, line.sessions, line.participants,
                line.cellsWithoutSpread > 0
                    ? std::optional<std::string>("MAD 0: nothing excluded, cells " +
                                                 std::to_string(line.cellsWithoutSpread))
                    : std::nullopt);
    }
    return csv.finish();
}

QString exclusionSection(const std::vector<TaskResults>& results, const ExclusionReport& exclusions) {
    if (exclusions.lines.empty())
        return {};
    using namespace report_html;
    HtmlTable rules(
        ExclusionReportText::tr("What was left out, in the order of the rules; nothing was deleted"),
        {ExclusionReportText::tr("Rule"), ExclusionReportText::tr("Trials before"),
         ExclusionReportText::tr("Trials"), ExclusionReportText::tr("Sessions"),
         ExclusionReportText::tr("Participants"), ExclusionReportText::tr("Remark")});
    for (const ExclusionLine& line : exclusions.lines) {
        if (!line.participant.empty())
            continue;
        rules.row({ruleText(line), QString::number(line.trialsBefore), QString::number(line.trials),
                   QString::number(line.sessions), QString::number(line.participants),
                   line.cellsWithoutSpread > 0
                       ? ExclusionReportText::tr("no spread of the times, so nothing was left out, in %n "
                                                 "case(s)",
                                                 nullptr, static_cast<int>(line.cellsWithoutSpread))
                       : QString()});
    }
    HtmlTable both(ExclusionReportText::tr("The results with the rules, and without them"),
                   {ExclusionReportText::tr("Task"), ExclusionReportText::tr("Condition or effect"),
                    ExclusionReportText::tr("Correct, %"),
                    ExclusionReportText::tr("Correct without rules, %"), QStringLiteral("p GG"),
                    ExclusionReportText::tr("p GG without rules")});
    for (const ComparedResult& row : comparedResults(results, exclusions.withoutRules))
        both.row({text(row.task), text(row.name), percent(row.accuracy), percent(row.accuracyWithout),
                  probability(row.p), probability(row.pWithout)},
                 2);
    return QStringLiteral("<section>\n<h2>%1</h2>\n")
               .arg(ExclusionReportText::tr("Exclusions").toHtmlEscaped()) +
           rules.html() + both.html() + QStringLiteral("</section>\n");
}

} // namespace teleta::study
