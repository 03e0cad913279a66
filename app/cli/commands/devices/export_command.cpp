// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/devices/export_command.h"

#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/progress_bar.h"
#include "backend/recording/csv_export.h"

#include <QCoreApplication>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <utility>
#include <vector>

namespace teleta::cli {

namespace {

using recording::ExportedFile;
using recording::Recording;

struct ExportText {
    Q_DECLARE_TR_FUNCTIONS(ExportCommand)
};

core::Expected<void> printJson(const Recording& recording, const std::vector<ExportedFile>& files) {
    nlohmann::ordered_json document{{"recording", recording.path()},
                                    {"complete", recording.isComplete()},
                                    {"scene", recording.head().scene},
                                    {"app_version", recording.head().appVersion},
                                    {"files", nlohmann::ordered_json::array()}};
    for (const ExportedFile& file : files)
        document["files"].push_back(
            {{"path", file.path}, {"rows", file.rows}, {"damaged_blocks", file.damagedBlocks}});
    return printDocument(document);
}

core::Expected<void> printFiles(const Recording& recording, const std::vector<ExportedFile>& files) {
    std::vector<std::pair<QString, QString>> fields;
    for (const ExportedFile& file : files) {
        QString text = ExportText::tr("%n row(s)", nullptr, static_cast<int>(file.rows));
        if (file.damagedBlocks > 0)
            text += QStringLiteral(", ") + ExportText::tr("%n damaged block(s) left out", nullptr,
                                                          static_cast<int>(file.damagedBlocks));
        fields.emplace_back(QString::fromStdString(file.path), text);
    }
    if (!recording.isComplete())
        fields.emplace_back(ExportText::tr("Note"),
                            ExportText::tr("The recording was cut off; what had been written is there."));
    return printFields(fields);
}

} // namespace

QString ExportCommand::summary() const {
    return ExportText::tr("Write the streams of a recording as CSV files");
}

const char* ExportCommand::example() const {
    return "teleta simulate tactile-indenter --out run\n"
           "  teleta export run/recording.teleta --csv run/csv";
}

void ExportCommand::declare(CLI::App& app) {
    app.add_option("RECORDING", m_path,
                   ExportText::tr("Recording of the console or of teleta simulate").toStdString())
        ->type_name("")
        ->required();
    app.add_option("--csv", m_folder,
                   ExportText::tr("Folder for a CSV file a stream and events.csv").toStdString())
        ->type_name("DIR")
        ->required();
    app.add_flag("--force", m_force, ExportText::tr("Write over files that are there already").toStdString());
    declareJson(app, m_json);
}

core::Expected<void> ExportCommand::run() {
    TELETA_TRY(const Recording recording, Recording::open(m_path));
    ProgressBar progress(ProgressBar::Unit::frames, false);
    recording::ExportOptions options;
    options.overwrite = m_force;
    options.finishesWhenEnded = true;
    bool stopped = false;
    options.goOn = [&](double done, double all) {
        progress.update(done, all);
        stopped = interrupted();
        return !stopped;
    };
    const auto exported = recording::exportCsv(recording, m_folder, options);
    progress.erase();
    if (!exported) {
        core::Error error = exported.error();
        if (error.kind == core::ErrorKind::refused)
            error.expected = ExportText::tr("another folder, or --force").toStdString();
        return core::Unexpected(std::move(error));
    }
    const core::Expected<void> printed =
        m_json ? printJson(recording, *exported) : printFiles(recording, *exported);
    if (printed && stopped)
        return core::Unexpected(interruption());
    return printed;
}

} // namespace teleta::cli
