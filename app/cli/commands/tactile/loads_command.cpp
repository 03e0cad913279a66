// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/frame_options.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/commands/tactile/tactile_commands.h"
#include "backend/core/data/csv_number.h"
#include "backend/core/data/csv_reader.h"
#include "backend/core/failure.h"
#include "backend/equilibration/load_calibration_file.h"

#include <QCoreApplication>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::cli {

namespace {

using equilibration::LoadCalibration;

struct LoadsText {
    Q_DECLARE_TR_FUNCTIONS(LoadsCommand)
};

/// Columns that tell which row is which, and are passed on.
constexpr std::array<std::string_view, 3> kKept{"frame", "time_s", "contact_id"};

class LoadsCommand : public CommandGroup {
public:
    void declare(CLI::App& app) {
        CLI::App& fit = addPart(app, "fit", LoadsText::tr("Find the matrix from presses with a known load"),
                                [this] { return runFit(); });
        addOption(fit, "PRESSES", m_tablePath,
                  LoadsText::tr("CSV, a row a press: the signals, and the loads in one or more of force_n, "
                                "shear_x_n, shear_y_n, moment_nm"),
                  "")
            ->required();
        addOption(fit, "--signals", m_signals, LoadsText::tr("Columns of the signals, between commas"),
                  "NAMES")
            ->delimiter(',')
            ->required();
        declareJson(fit, m_output.json);
        declareOut(fit, m_output.outPath);
        CLI::App& apply = addPart(app, "apply", LoadsText::tr("Loads of each row of a table"),
                                  [this] { return runApply(); });
        addOption(apply, "CALIBRATION", m_calibrationPath,
                  LoadsText::tr("What \"teleta loads fit\" has written"), "")
            ->required();
        addOption(apply, "TABLE", m_tablePath, LoadsText::tr("CSV with the same signals"), "")->required();
        declareJson(apply, m_output.json);
        declareOut(apply, m_output.outPath);
    }

private:
    [[nodiscard]] core::Expected<void> runFit() {
        refuseToReplace(m_output.outPath, std::array{m_tablePath});
        for (std::size_t i = 0; i < m_signals.size(); ++i) {
            const std::string& name = m_signals[i];
            if (name.empty() ||
                std::ranges::find(equilibration::kLoadColumns, name) != equilibration::kLoadColumns.end())
                refuse("--signals", LoadsText::tr("\"%1\" is no signal").arg(QString::fromStdString(name)));
            if (std::find(m_signals.begin(), m_signals.begin() + static_cast<std::ptrdiff_t>(i), name) !=
                m_signals.begin() + static_cast<std::ptrdiff_t>(i))
                refuse("--signals", LoadsText::tr("%1 is named twice").arg(QString::fromStdString(name)));
        }
        TELETA_TRY(const auto presses, equilibration::readKnownPresses(m_tablePath, m_signals));
        TELETA_TRY(const LoadCalibration found, equilibration::findLoadCalibration(presses));
        if (!m_output.outPath.empty())
            TELETA_CHECK(equilibration::writeLoadCalibration(found, m_output.outPath));
        if (m_output.json)
            return printDocument(toJson(found, presses));
        if (!m_output.outPath.empty())
            return printSummary(found, presses);
        TELETA_TRY(RowOutput rows, RowOutput::open(equilibration::kLoadCalibrationColumns, {}));
        equilibration::writeLoadCalibrationRows(found, rows);
        return rows.finish();
    }

    [[nodiscard]] static nlohmann::ordered_json toJson(const LoadCalibration& found,
                                                       const equilibration::KnownPresses& presses) {
        nlohmann::ordered_json loads = nlohmann::ordered_json::array();
        for (std::size_t l = 0; l < found.loads.size(); ++l) {
            const auto row = static_cast<Eigen::Index>(l);
            nlohmann::ordered_json gains = nlohmann::ordered_json::object();
            for (std::size_t s = 0; s < found.channels.size(); ++s) {
                const auto column = static_cast<Eigen::Index>(s);
                gains[found.channels[s]] = {{"gain", found.gain(row, column)},
                                            {"gain_se", found.error(row, column)}};
            }
            loads.push_back({{"load", found.loads[l]}, {"scatter", found.scatter[row]}, {"gains", gains}});
        }
        return {{"rows", presses.load.rows()}, {"condition", found.condition}, {"loads", loads}};
    }

    [[nodiscard]] static core::Expected<void> printSummary(const LoadCalibration& found,
                                                           const equilibration::KnownPresses& presses) {
        Fields fields{{LoadsText::tr("Presses"), QString::number(presses.load.rows())},
                      {LoadsText::tr("Signals"), QString::number(found.channels.size())},
                      {LoadsText::tr("Condition"), forPeople(found.condition, 3)}};
        for (std::size_t l = 0; l < found.loads.size(); ++l)
            fields.emplace_back(QString::fromStdString(found.loads[l]),
                                LoadsText::tr("off by %1 (standard deviation)")
                                    .arg(forPeople(found.scatter[static_cast<Eigen::Index>(l)], 3)));
        return printFields(fields);
    }

    [[nodiscard]] core::Expected<void> runApply() {
        refuseToReplace(m_output.outPath, std::array{m_calibrationPath, m_tablePath});
        TELETA_TRY(const LoadCalibration calibration, equilibration::readLoadCalibration(m_calibrationPath));
        TELETA_TRY(auto csv, core::CsvReader::open(m_tablePath));
        TELETA_TRY(const auto columns, csv.columns(std::vector<std::string_view>(
                                           calibration.channels.begin(), calibration.channels.end())));
        std::vector<std::string_view> names;
        std::vector<std::size_t> kept;
        for (const std::string_view name : kKept) {
            const auto at = std::ranges::find(csv.header(), name);
            if (at == csv.header().end())
                continue;
            names.push_back(name);
            kept.push_back(static_cast<std::size_t>(at - csv.header().begin()));
        }
        std::vector<std::string> columnNames;
        for (const std::string& load : calibration.loads)
            columnNames.insert(columnNames.end(), {load, load + "_se"});
        names.insert(names.end(), columnNames.begin(), columnNames.end());
        names.emplace_back("extrapolated");
        TELETA_TRY(RowOutput rows, RowOutput::open(names, m_output));
        std::vector<std::string_view> fields;
        Eigen::VectorXd values(static_cast<Eigen::Index>(columns.size()));
        while (!rows.failed()) {
            TELETA_TRY(const bool any, csv.nextText(fields));
            if (!any)
                break;
            for (std::size_t i = 0; i < columns.size(); ++i) {
                const std::optional<double> number = core::numberOrNA(fields[columns[i]]);
                if (!number)
                    return core::failed(core::ErrorKind::badInput, LoadsText::tr("this is no number"),
                                        LoadsText::tr("a number, or NA"), csv.place(columns[i]));
                values[static_cast<Eigen::Index>(i)] = *number;
            }
            for (const std::size_t column : kept)
                rows.number(core::numberOrNA(fields[column]));
            const LoadCalibration::Loads at = calibration.at(values);
            for (Eigen::Index i = 0; i < at.loads.size(); ++i) {
                rows.number(at.loads[i]);
                rows.number(at.errors[i]);
            }
            rows.integer(at.extrapolated ? 1 : 0);
            rows.endRow();
            rows.flushIfDue();
            if (interrupted())
                return core::Unexpected(interruption());
        }
        return rows.finish();
    }

    std::string m_tablePath;
    std::string m_calibrationPath;
    std::vector<std::string> m_signals;
    RowOptions m_output;
};

} // namespace

Command loadsCommand() {
    return makeCommand<LoadsCommand>(
        "loads", LoadsText::tr("Newtons from the signals of a sensor, by presses with a known load"),
        "printf 'field_ut,force_n\\n0,0\\n10,1\\n21,2\\n30,3\\n41,4\\n' > presses.csv\n"
        "  teleta loads fit presses.csv --signals field_ut --out newtons.csv\n"
        "  teleta loads apply newtons.csv presses.csv");
}

} // namespace teleta::cli
