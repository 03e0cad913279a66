// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/scenes/tradeoff_command.h"

#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/progress_bar.h"
#include "app/cli/base/validators.h"
#include "app/cli/commands/scenes/tradeoff_output.h"
#include "backend/cost/ladders/ladders.h"
#include "backend/cost/measurer.h"

#include <QCoreApplication>
#include <QStringList>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace teleta::cli {

namespace {

struct TradeoffText {
    Q_DECLARE_TR_FUNCTIONS(TradeoffCommand)
};

core::Expected<void> printLadders(const std::vector<cost::Ladder>& ladders, bool json) {
    nlohmann::ordered_json document = nlohmann::ordered_json::array();
    std::vector<std::pair<QString, QString>> fields;
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
            throw CLI::ValidationError(
                "name", TradeoffText::tr("there is no ladder \"%1\" (expected %2)")
                            .arg(QString::fromStdString(name), known.join(QStringLiteral(", ")))
                            .toStdString());
    if (!names.empty())
        std::erase_if(ladders, [&](const cost::Ladder& ladder) {
            return std::ranges::find(names, ladder.name) == names.end();
        });
    return ladders;
}

} // namespace

QString TradeoffCommand::summary() const {
    return TradeoffText::tr("Measure on this machine what accuracy costs in time");
}

const char* TradeoffCommand::example() const {
    return "teleta tradeoff stiffness contour --out cost";
}

void TradeoffCommand::declare(CLI::App& app) {
    const auto help = [](const char* text) { return TradeoffText::tr(text).toStdString(); };
    app.add_option("name", m_names,
                   help(QT_TRANSLATE_NOOP("TradeoffCommand", "Ladders of --list; otherwise all of them")))
        ->type_name("NAME");
    app.add_flag("--list", m_list, help(QT_TRANSLATE_NOOP("TradeoffCommand", "List the ladders")));
    app.add_option("--out", m_outFolder,
                   help(QT_TRANSLATE_NOOP("TradeoffCommand",
                                          "Folder for tradeoff.csv and a picture of each ladder (SVG)")))
        ->type_name("DIR");
    app.add_option(
           "--largest-spread", m_largestSpread_percent,
           help(QT_TRANSLATE_NOOP("TradeoffCommand", "Refuse the times of a rung when the machine ran more "
                                                     "unevenly than this meanwhile, in percent")))
        ->type_name("P")
        ->capture_default_str()
        ->check(positive());
    declareJson(app, m_json);
}

core::Expected<void> TradeoffCommand::run() {
    const std::vector<cost::Ladder> ladders = chosen(cost::allLadders(), m_names);
    if (m_list)
        return printLadders(ladders, m_json);
    // A folder that cannot be made is told before the work, not after it.
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
        return core::Unexpected(core::Error{
            core::ErrorKind::refused,
            TradeoffText::tr("the machine was too busy: the times of %n rung(s) were refused", nullptr,
                             static_cast<int>(measured->refused()))
                .toStdString(),
            TradeoffText::tr("a spread of at most %1 %; close other programs, or see --largest-spread")
                .arg(forPeople(m_largestSpread_percent, 3))
                .toStdString(),
            {}});
    return {};
}

} // namespace teleta::cli
