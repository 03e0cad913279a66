// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/base/progress_bar.h"
#include "app/cli/commands/scenes/scene_commands.h"
#include "backend/core/data/csv_writer.h"
#include "backend/core/data/output_file.h"
#include "backend/core/error.h"
#include "backend/core/failure.h"
#include "backend/cost/cost_figure.h"
#include "backend/cost/cost_file.h"
#include "backend/cost/frontier.h"
#include "backend/cost/ladder.h"
#include "backend/cost/ladders/ladders.h"
#include "backend/cost/measurer.h"

#include <QCoreApplication>
#include <QDir>
#include <QStringList>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <unistd.h>
#include <vector>

namespace teleta::cli {

namespace {

struct TradeoffText {
    Q_DECLARE_TR_FUNCTIONS(TradeoffCommand)
};

core::Expected<void> printLadders(const std::vector<cost::Ladder>& ladders, bool json) {
    nlohmann::ordered_json document = nlohmann::ordered_json::array();
    Fields fields;
    for (const cost::Ladder& ladder : ladders) {
        document.push_back({{"ladder", ladder.name},
                            {"name", ladder.title},
                            {"truth", ladder.truth},
                            {"error_unit", ladder.errorUnit},
                            {"samples", ladder.trials}});
        fields.emplace_back(QString::fromStdString(ladder.name), QString::fromStdString(ladder.title));
    }
    return json ? printDocument(document) : printFields(fields);
}

/// The named ladders, in the order of the list; all without names.
std::vector<cost::Ladder> chosen(std::vector<cost::Ladder> ladders, const std::vector<std::string>& names) {
    QStringList known;
    for (const cost::Ladder& ladder : ladders)
        known << QString::fromStdString(ladder.name);
    for (const std::string& name : names)
        if (!known.contains(QString::fromStdString(name)))
            refuse("name", TradeoffText::tr("there is no ladder \"%1\" (expected %2)")
                               .arg(QString::fromStdString(name), known.join(QStringLiteral(", "))));
    if (!names.empty())
        std::erase_if(ladders, [&](const cost::Ladder& ladder) {
            return std::ranges::find(names, ladder.name) == names.end();
        });
    return ladders;
}

QString titleOf(std::span<const cost::Ladder> ladders, const std::string& name) {
    const auto ladder = std::ranges::find(ladders, name, &cost::Ladder::name);
    return QString::fromStdString(ladder == ladders.end() ? name : ladder->title);
}

/// Three digits, in the unit that people read most easily.
QString timeText(double time_s) {
    if (std::isnan(time_s))
        return TradeoffText::tr("refused");
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

/// Columns as wide as they need to be, the first three aligned to the left.
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
        std::vector<QStringList> rows{{QString(), TradeoffText::tr("rung"), TradeoffText::tr("parameter"),
                                       TradeoffText::tr("mean error") + unit, TradeoffText::tr("95 %"),
                                       TradeoffText::tr("worst"), TradeoffText::tr("median time"),
                                       TradeoffText::tr("99 %"), TradeoffText::tr("samples"),
                                       TradeoffText::tr("spread")}};
        for (const cost::RungCost& rung : ladder.rungs)
            rows.push_back({rung.pareto ? QStringLiteral("*") : QString(), QString::fromStdString(rung.name),
                            QString::fromStdString(rung.parameter), errorText(rung.errorMean),
                            errorText(rung.errorP95), errorText(rung.errorMax), timeText(rung.timeMedian_s),
                            timeText(rung.timeP99_s), QString::number(rung.samples),
                            QStringLiteral("%1 %").arg(forPeople(100.0 * rung.spread, 2))});
        text += table(rows);
        if (const auto over = cost::overLimit(ladder.rungs))
            text += TradeoffText::tr("Fastest: %1, %2 times the limit (%3: %4).")
                        .arg(QString::fromStdString(over->fastest->name), forPeople(over->times, 3),
                             QString::fromStdString(over->limit->parameter),
                             timeText(over->limit->timeMedian_s)) +
                    QLatin1Char('\n');
        text += QLatin1Char('\n');
    }
    text += TradeoffText::tr("* no other rung is both as quick and as exact. Measured in %1 s.")
                .arg(forPeople(measured.wall_s, 3)) +
            QLatin1Char('\n') +
            TradeoffText::tr("Calls of a few microseconds are timed together; their 99 % is one of means.") +
            QLatin1Char('\n');
    core::OutputFile output = core::OutputFile::standardOutput();
    output.write(text.toStdString());
    return output.finish();
}

nlohmann::ordered_json limitOf(const cost::LadderCost& ladder) {
    const auto over = cost::overLimit(ladder.rungs);
    if (!over)
        return nullptr;
    return {{"parameter", over->limit->parameter},
            {"time_median_s", over->limit->timeMedian_s},
            {"fastest", over->fastest->name},
            {"fastest_over_limit", over->times}};
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
                                       {"rungs", rungs},
                                       {"limit", limitOf(ladder)}});
    }
    return printDocument(document);
}

/// Makes the folder for writeTradeoff(). Error: ioFailed.
core::Expected<void> makeTradeoffFolder(const std::string& folder) {
    if (QDir().mkpath(QString::fromStdString(folder)))
        return {};
    return core::failed(core::ErrorKind::ioFailed, TradeoffText::tr("the folder cannot be made"), {},
                        {folder});
}

/// tradeoff.csv (cost_file.h), and LADDER.svg of each ladder (cost_figure.h). Error: ioFailed.
core::Expected<void> writeTradeoff(const cost::Measurement& measured, std::span<const cost::Ladder> ladders,
                                   const std::string& folder) {
    TELETA_CHECK(cost::writeCostFile(measured.ladders, folder + "/tradeoff.csv"));
    for (const cost::LadderCost& ladder : measured.ladders) {
        TELETA_CHECK(core::writeFile(folder + "/" + ladder.ladder + ".svg",
                                     cost::costSvg(ladder, titleOf(ladders, ladder.ladder).toStdString())));
    }
    return {};
}

/// On standard output: one JSON document, {"wall_s","interrupted","ladders":[{"ladder","name","error_unit",
/// "rungs":[{"rung","parameter","error_mean",..,"spread","pareto"}],"limit":{"parameter","time_median_s",
/// "fastest","fastest_over_limit"} or null}]}; or a table a ladder, for a terminal
/// and when the CSV is in a file; or the CSV.
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

class TradeoffCommand {
public:
    void declare(CLI::App& app) {
        addOption(app, "name", m_names, TradeoffText::tr("Ladders of --list; otherwise all of them"), "NAME");
        addFlag(app, "--list", m_list, TradeoffText::tr("List the ladders"));
        addOption(app, "-o,--out", m_outFolder,
                  TradeoffText::tr("Folder for tradeoff.csv and a picture of each ladder (SVG)"), "DIR");
        addOption(app, "--largest-spread", m_largestSpread_percent,
                  TradeoffText::tr("Refuse the times of a rung when the machine ran more unevenly than this "
                                   "meanwhile, in percent"),
                  positive(), "P");
        declareJson(app, m_json);
    }

    [[nodiscard]] core::Expected<void> run() {
        const std::vector<cost::Ladder> ladders = chosen(cost::allLadders(), m_names);
        if (m_list)
            return printLadders(ladders, m_json);
        // If the folder cannot be made, this fails before the work, not after it.
        if (!m_outFolder.empty())
            TELETA_CHECK(makeTradeoffFolder(m_outFolder));

        ProgressBar progress(ProgressBar::Unit::share, false);
        cost::MeasureSettings settings;
        settings.largestSpread = 0.01 * m_largestSpread_percent;
        settings.goOn = [&progress](const cost::MeasureProgress& now) {
            progress.update(now.share, 1.0);
            return !interrupted();
        };
        const core::Expected<cost::Measurement> measured = cost::measureLadders(ladders, settings);
        progress.erase();
        TELETA_CHECK(measured);
        if (!m_outFolder.empty())
            TELETA_CHECK(writeTradeoff(*measured, ladders, m_outFolder));
        TELETA_CHECK(printTradeoff(*measured, ladders, m_json, !m_outFolder.empty()));
        if (measured->interrupted)
            return core::Unexpected(interruption());
        if (measured->refused() > 0)
            return core::failed(
                core::ErrorKind::refused,
                TradeoffText::tr("the machine was too busy: the times of %n rung(s) were refused", nullptr,
                                 static_cast<int>(measured->refused())),
                TradeoffText::tr("a spread of at most %1 %; close other programs, or see --largest-spread")
                    .arg(forPeople(m_largestSpread_percent, 3)));
        return {};
    }

private:
    std::vector<std::string> m_names;
    bool m_list = false;
    bool m_json = false;
    std::string m_outFolder;
    double m_largestSpread_percent = 25.0;
};

} // namespace

Command tradeoffCommand() {
    return makeCommand<TradeoffCommand>(
        "tradeoff", TradeoffText::tr("Measure on this machine what accuracy costs in time"),
        "teleta tradeoff stiffness contour --out cost");
}

} // namespace teleta::cli
