// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/frame_options.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/commands/tactile/tactile_commands.h"
#include "backend/equilibration/taxel_gain_file.h"
#include "backend/frames/frame_reader.h"

#include <QCoreApplication>
#include <QStringList>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace teleta::cli {

namespace {

using equilibration::TaxelGain;
using equilibration::TaxelGains;

struct GainsText {
    Q_DECLARE_TR_FUNCTIONS(GainsCommand)
};

nlohmann::ordered_json toJson(const TaxelGains& gains) {
    const equilibration::GainRange range = gains.range().value_or(equilibration::GainRange());
    nlohmann::ordered_json taxels = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < gains.taxels.size(); ++i) {
        const auto columns = static_cast<std::size_t>(gains.layout.columns);
        const TaxelGain& taxel = gains.taxels[i];
        taxels.push_back({{"taxel", i},
                          {"row", i / columns},
                          {"column", i % columns},
                          {"gain", taxel.gain},
                          {"gain_se", taxel.error},
                          {"state", equilibration::toString(taxel.state)}});
    }
    return {{"presses", gains.presses},
            {"frames", gains.frames},
            {"good", gains.good()},
            {"least_gain", range.least},
            {"greatest_gain", range.greatest},
            {"level", gains.level},
            {"scatter", gains.scatter},
            {"repeatability", gains.repeatability},
            {"tilt_x", gains.tilt_x},
            {"tilt_y", gains.tilt_y},
            {"tilted", gains.isTilted},
            {"taxels", std::move(taxels)}};
}

core::Expected<void> printTable(const TaxelGains& gains) {
    const equilibration::GainRange range = gains.range().value_or(equilibration::GainRange());
    const auto percent = [](double share) { return forPeople(100.0 * share, 3); };
    Fields fields{
        {GainsText::tr("Frames under load"), QString::number(gains.frames)},
        {GainsText::tr("Taxels used"), GainsText::tr("%1 of %2").arg(gains.good()).arg(gains.taxels.size())},
        {GainsText::tr("Gains"),
         GainsText::tr("%1 to %2").arg(forPeople(range.least), forPeople(range.greatest))},
        {GainsText::tr("Largest standard error"), GainsText::tr("%1 %").arg(percent(range.largestError))},
        {GainsText::tr("Not explained"), GainsText::tr("%1 % of the level").arg(percent(gains.scatter))},
        {GainsText::tr("Tilt"),
         GainsText::tr("%1 % along x, %2 % along y").arg(percent(gains.tilt_x), percent(gains.tilt_y))}};
    if (gains.presses > 1)
        fields.emplace_back(GainsText::tr("From press to press"),
                            GainsText::tr("%1 %").arg(percent(gains.repeatability)));
    return printFields(fields);
}

core::Expected<void> printRows(const TaxelGains& gains) {
    TELETA_TRY(RowOutput rows, RowOutput::open(equilibration::kTaxelGainColumns, {}));
    equilibration::writeTaxelGainRows(gains, rows);
    return rows.finish();
}

/// Warns of unused taxels and of an uneven load.
void warnOf(const TaxelGains& gains) {
    QStringList unused;
    for (std::size_t i = 0; i < gains.taxels.size(); ++i) {
        if (!gains.taxels[i].isGood())
            unused << QStringLiteral("%1 (%2)").arg(i).arg(
                QString::fromUtf8(equilibration::toString(gains.taxels[i].state).data()));
    }
    if (!unused.isEmpty())
        warn(GainsText::tr("These taxels are not used: %1.").arg(unused.join(QStringLiteral(", "))));
    if (gains.isTilted)
        warn(GainsText::tr("The response changes by %1 % along x and %2 % along y: the load may have been "
                           "uneven. Turn what presses round by half, press again and give both files.")
                 .arg(forPeople(100.0 * gains.tilt_x, 3), forPeople(100.0 * gains.tilt_y, 3)));
}

class GainsCommand {
public:
    void declare(CLI::App& app) {
        addOption(app, "FRAMES", m_paths,
                  GainsText::tr("Recorded frames in which an even load presses on the whole array, a file a "
                                "press: time_s,t0,t1,..."),
                  "")
            ->required();
        m_array.declare(app);
        declareJson(app, m_output.json);
        declareOut(app, m_output.outPath);
    }

    [[nodiscard]] core::Expected<void> run() {
        std::vector<std::string> inputs = m_paths;
        inputs.push_back(m_array.tarePath());
        refuseToReplace(m_output.outPath, inputs);
        std::vector<frames::FrameSeries> presses;
        std::vector<contact::ConditioningSettings> settings;
        for (const std::string& path : m_paths) {
            TELETA_TRY(frames::FrameRequest request, m_array.request(path));
            request.needsTimes = false;
            if (!presses.empty()) {
                request.rows = presses.front().layout.rows;
                request.columns = presses.front().layout.columns;
            }
            auto press = frames::readFrames(request, [] { return !interrupted(); });
            if (!press)
                return core::Unexpected(interrupted() ? interruption() : press.error());
            TELETA_TRY(contact::ConditioningSettings conditioning, m_array.conditioning(press->layout, path));
            presses.push_back(std::move(*press));
            settings.push_back(std::move(conditioning));
        }
        std::vector<equilibration::GainPress> read;
        for (std::size_t i = 0; i < presses.size(); ++i)
            read.push_back({presses[i].values, settings[i]});
        TELETA_TRY(const TaxelGains gains, equilibration::findTaxelGains(presses.front().layout, read));
        if (interrupted())
            return core::Unexpected(interruption());
        warnOf(gains);
        if (!m_output.outPath.empty())
            TELETA_CHECK(equilibration::writeTaxelGains(gains, m_output.outPath));
        if (m_output.json)
            return printDocument(toJson(gains));
        return m_output.outPath.empty() ? printRows(gains) : printTable(gains);
    }

private:
    std::vector<std::string> m_paths;
    ArrayOptions m_array;
    RowOptions m_output;
};

} // namespace

Command gainsCommand() {
    return makeCommand<GainsCommand>("gains",
                                     GainsText::tr("Gain of each taxel from frames under an even load"),
                                     "teleta simulate tactile-even-load --out run\n"
                                     "  teleta gains run/frames.csv --out gains.csv");
}

} // namespace teleta::cli
