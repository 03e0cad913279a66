// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/scenes/tradeoff_output.h"

#include "app/cli/base/command_io.h"
#include "backend/core/data/csv_writer.h"
#include "backend/core/data/output_file.h"
#include "backend/cost/cost_figure.h"
#include "backend/cost/cost_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QStringList>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <unistd.h>
#include <vector>

namespace teleta::cli {

namespace {

struct TradeoffOutputText {
    Q_DECLARE_TR_FUNCTIONS(TradeoffCommand)
};

QString titleOf(std::span<const cost::Ladder> ladders, const std::string& name) {
    const auto ladder = std::ranges::find(ladders, name, &cost::Ladder::name);
    return QString::fromStdString(ladder == ladders.end() ? name : ladder->title);
}

/// Three digits with a prefix that people read.
QString timeText(double time_s) {
    if (std::isnan(time_s))
        return TradeoffOutputText::tr("refused");
    if (time_s < 1e-6)
        return forPeople(1e9 * time_s, 3) + QStringLiteral(" ns");
    if (time_s < 1e-3)
        return forPeople(1e6 * time_s, 3) + QStringLiteral(" us");
    if (time_s < 1.0)
        return forPeople(1e3 * time_s, 3) + QStringLiteral(" ms");
    return forPeople(time_s, 3) + QStringLiteral(" s");
}

QString errorText(double error) {
    return std::isnan(error) ? QStringLiteral("NA") : forPeople(error, 3);
}

/// Columns as wide as they need to be, the first two to the left.
QString table(const std::vector<QStringList>& rows) {
    std::vector<qsizetype> widths;
    for (const QStringList& row : rows)
        for (qsizetype i = 0; i < row.size(); ++i) {
            if (static_cast<std::size_t>(i) == widths.size())
                widths.push_back(0);
            widths[static_cast<std::size_t>(i)] =
                std::max(widths[static_cast<std::size_t>(i)], row[i].size());
        }
    QString text;
    for (const QStringList& row : rows) {
        QString line;
        for (qsizetype i = 0; i < row.size(); ++i) {
            const qsizetype width = widths[static_cast<std::size_t>(i)];
            line +=
                QStringLiteral("  ") + (i < 3 ? row[i].leftJustified(width) : row[i].rightJustified(width));
        }
        while (line.endsWith(QLatin1Char(' ')))
            line.chop(1);
        text += line + QLatin1Char('\n');
    }
    return text;
}

core::Expected<void> printTables(const cost::Measurement& measured, std::span<const cost::Ladder> ladders) {
    QString text;
    for (const cost::LadderCost& ladder : measured.ladders) {
        const QString unit =
            ladder.errorUnit == "1" ? QString() : QLatin1Char(' ') + QString::fromStdString(ladder.errorUnit);
        text += titleOf(ladders, ladder.ladder) + QStringLiteral(" (") +
                QString::fromStdString(ladder.ladder) + QStringLiteral(")\n");
        std::vector<QStringList> rows{{QString(), TradeoffOutputText::tr("rung"),
                                       TradeoffOutputText::tr("parameter"),
                                       TradeoffOutputText::tr("mean error") + unit,
                                       TradeoffOutputText::tr("95 %"), TradeoffOutputText::tr("worst"),
                                       TradeoffOutputText::tr("median time"), TradeoffOutputText::tr("99 %"),
                                       TradeoffOutputText::tr("samples"), TradeoffOutputText::tr("spread")}};
        for (const cost::RungCost& rung : ladder.rungs)
            rows.push_back({rung.pareto ? QStringLiteral("*") : QString(), QString::fromStdString(rung.name),
                            QString::fromStdString(rung.parameter), errorText(rung.errorMean),
                            errorText(rung.errorP95), errorText(rung.errorMax), timeText(rung.timeMedian_s),
                            timeText(rung.timeP99_s), QString::number(rung.samples),
                            QStringLiteral("%1 %").arg(forPeople(100.0 * rung.spread, 2))});
        text += table(rows) + QLatin1Char('\n');
    }
    text += TradeoffOutputText::tr("* no other rung is both as quick and as exact. Measured in %1 s.")
                .arg(forPeople(measured.wall_s, 3)) +
            QLatin1Char('\n') +
            TradeoffOutputText::tr(
                "Calls of a few microseconds are timed together; their 99 % is one of means.") +
            QLatin1Char('\n');
    core::OutputFile output = core::OutputFile::standardOutput();
    output.write(text.toStdString());
    return output.finish();
}

core::Expected<void> printJson(const cost::Measurement& measured, std::span<const cost::Ladder> ladders) {
    nlohmann::ordered_json document{{"wall_s", measured.wall_s},
                                    {"interrupted", measured.interrupted},
                                    {"ladders", nlohmann::ordered_json::array()}};
    for (const cost::LadderCost& ladder : measured.ladders) {
        nlohmann::ordered_json rungs = nlohmann::ordered_json::array();
        for (const cost::RungCost& rung : ladder.rungs)
            rungs.push_back({{"rung", rung.name},
                             {"parameter", rung.parameter},
                             {"error_mean", rung.errorMean},
                             {"error_p95", rung.errorP95},
                             {"error_max", rung.errorMax},
                             {"time_median_s", rung.timeMedian_s},
                             {"time_p99_s", rung.timeP99_s},
                             {"samples", rung.samples},
                             {"spread", rung.spread},
                             {"pareto", rung.pareto}});
        document["ladders"].push_back({{"ladder", ladder.ladder},
                                       {"name", titleOf(ladders, ladder.ladder).toStdString()},
                                       {"error_unit", ladder.errorUnit},
                                       {"rungs", rungs}});
    }
    return printDocument(document);
}

} // namespace

core::Expected<void> makeTradeoffFolder(const std::string& folder) {
    if (QDir().mkpath(QString::fromStdString(folder)))
        return {};
    return core::Unexpected(core::Error{core::ErrorKind::ioFailed,
                                        TradeoffOutputText::tr("the folder cannot be made").toStdString(),
                                        {},
                                        {folder, 0, 0}});
}

core::Expected<void> writeTradeoff(const cost::Measurement& measured, std::span<const cost::Ladder> ladders,
                                   const std::string& folder) {
    TELETA_CHECK(cost::writeCostFile(measured.ladders, folder + "/tradeoff.csv"));
    for (const cost::LadderCost& ladder : measured.ladders) {
        TELETA_CHECK(core::writeFile(folder + "/" + ladder.ladder + ".svg",
                                     cost::costSvg(ladder, titleOf(ladders, ladder.ladder).toStdString())));
    }
    return {};
}

core::Expected<void> printTradeoff(const cost::Measurement& measured, std::span<const cost::Ladder> ladders,
                                   bool json, bool inFile) {
    if (json)
        return printJson(measured, ladders);
    if (inFile || isatty(STDOUT_FILENO) != 0)
        return printTables(measured, ladders);
    core::CsvWriter writer(core::OutputFile::standardOutput(), cost::kCostColumns);
    cost::writeCosts(measured.ladders, writer);
    return writer.finish();
}

} // namespace teleta::cli
