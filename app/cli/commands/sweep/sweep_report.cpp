// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/sweep/sweep_report.h"

#include "app/cli/base/command_io.h"
#include "app/common/duration_text.h"
#include "backend/core/steady_time.h"

#include <QCoreApplication>
#include <QStringList>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <unistd.h>

namespace teleta::cli {

namespace {

constexpr std::int64_t kBetweenScreens_ns = 500'000'000;

struct SweepReportText {
    Q_DECLARE_TR_FUNCTIONS(SweepReport)
};

QString settingsText(const sweep::SweepPlan& plan, std::uint64_t cell) {
    QStringList parts;
    for (const auto& [key, value] : plan.settingsOf(cell))
        parts << QString::fromStdString(key + " = " + core::plainText(value));
    return parts.join(QStringLiteral(", "));
}

nlohmann::ordered_json valueOf(const core::TomlValue& value) {
    return std::visit([](const auto& plain) { return nlohmann::ordered_json(plain); }, value);
}

nlohmann::ordered_json documentOf(const sweep::SweepPlan& plan, const sweep::SweepResults& results,
                                  const std::string& folder) {
    nlohmann::ordered_json document{{"folder", folder},
                                    {"runs", results.all},
                                    {"done", results.done},
                                    {"failed", results.failed},
                                    {"cells", nlohmann::ordered_json::array()}};
    for (const sweep::CellResult& cell : results.cells) {
        nlohmann::ordered_json settings = nlohmann::ordered_json::object();
        for (const auto& [key, value] : plan.settingsOf(cell.cell))
            settings[key] = valueOf(value);
        nlohmann::ordered_json measures = nlohmann::ordered_json::object();
        for (std::size_t i = 0; i < results.measures.size(); ++i) {
            const sweep::CellMeasure& measure = cell.measures[i];
            measures[results.measures[i]] = {{"n", measure.n},
                                             {"mean", orNull(measure.mean)},
                                             {"sd", orNull(measure.sd)},
                                             {"median", orNull(measure.median)},
                                             {"p05", orNull(measure.p05)},
                                             {"p95", orNull(measure.p95)},
                                             {"low95", orNull(measure.low95)},
                                             {"high95", orNull(measure.high95)}};
        }
        document["cells"].push_back({{"cell", cell.cell},
                                     {"settings", std::move(settings)},
                                     {"runs", cell.runs},
                                     {"failed", cell.failed},
                                     {"measures", std::move(measures)}});
    }
    return document;
}

} // namespace

SweepScreen::SweepScreen(const sweep::SweepPlan& plan)
    : m_plan(plan)
    , m_shown(isatty(STDERR_FILENO) != 0) {
}

void SweepScreen::erase() {
    for (; m_lines > 0; --m_lines)
        std::fputs("\x1b[1A\x1b[2K", stderr);
}

void SweepScreen::update(const sweep::SweepProgress& progress) {
    if (!m_shown || core::steadyNow_ns() < m_next_ns)
        return;
    m_next_ns = core::steadyNow_ns() + kBetweenScreens_ns;
    erase();
    QStringList lines{SweepReportText::tr("%1 of %2 runs, %3 failed, %4 left")
                          .arg(progress.done)
                          .arg(progress.all)
                          .arg(progress.failed)
                          .arg(app::durationText(progress.left_s))};
    if (!progress.worst.empty())
        lines << SweepReportText::tr("Worst cells so far:");
    for (const sweep::WorstCell& worst : progress.worst) {
        QString line = QStringLiteral("  ") + settingsText(m_plan, worst.cell) + QStringLiteral(": ");
        if (worst.failed > 0)
            line += SweepReportText::tr("%1 of %2 failed; ").arg(worst.failed).arg(worst.runs);
        if (worst.mean)
            line += QString::fromStdString(progress.measure) + QStringLiteral(" ") + forPeople(*worst.mean);
        lines << line;
    }
    for (const QString& line : lines)
        std::fputs((line.left(118) + QLatin1Char('\n')).toUtf8().constData(), stderr);
    m_lines = static_cast<int>(lines.size());
}

core::Expected<void> printSweep(const sweep::SweepPlan& plan, const sweep::SweepResults& results,
                                const std::string& folder, bool json) {
    if (json)
        return printDocument(documentOf(plan, results, folder));
    double processor_s = 0.0;
    for (const sweep::CellResult& cell : results.cells)
        processor_s += cell.processor_s;
    Fields fields{{SweepReportText::tr("Folder"), QString::fromStdString(folder)},
                  {SweepReportText::tr("Runs"),
                   results.done == results.all
                       ? QString::number(results.all)
                       : SweepReportText::tr("%1 of %2").arg(results.done).arg(results.all)},
                  {SweepReportText::tr("Failed"), QString::number(results.failed)},
                  {SweepReportText::tr("Cells"), QString::number(results.cells.size())},
                  {SweepReportText::tr("Processor time"), app::durationText(processor_s)}};
    for (std::size_t i = 0; i < results.measures.size(); ++i) {
        std::optional<double> least, most;
        for (const sweep::CellResult& cell : results.cells)
            if (const auto& mean = cell.measures[i].mean) {
                least = std::min(least.value_or(*mean), *mean);
                most = std::max(most.value_or(*mean), *mean);
            }
        if (least)
            fields.emplace_back(QString::fromStdString(results.measures[i]),
                                *least == *most ? forPeople(*least)
                                                : SweepReportText::tr("%1 to %2 (means of the cells)")
                                                      .arg(forPeople(*least), forPeople(*most)));
    }
    return printFields(fields);
}

} // namespace teleta::cli
