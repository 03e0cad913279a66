// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/base/progress_bar.h"
#include "app/cli/commands/devices/devices_commands.h"
#include "backend/recording/csv_export.h"

#include <QCoreApplication>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <string>
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
    Fields fields;
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

class ExportCommand {
public:
    void declare(CLI::App& app) {
        addOption(app, "RECORDING", m_path, ExportText::tr("Recording of the console or of teleta simulate"),
                  "")
            ->required();
        addOption(app, "--csv", m_folder, ExportText::tr("Folder for a CSV file a stream and events.csv"),
                  "DIR")
            ->required();
        addFlag(app, "--force", m_force, ExportText::tr("Write over files that are there already"));
        declareJson(app, m_json);
    }

    [[nodiscard]] core::Expected<void> run() {
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
        return unlessCut(m_json ? printJson(recording, *exported) : printFiles(recording, *exported),
                         stopped);
    }

private:
    std::string m_path;
    std::string m_folder;
    bool m_force = false;
    bool m_json = false;
};

} // namespace

Command exportCommand() {
    return makeCommand<ExportCommand>("export",
                                      ExportText::tr("Write the streams of a recording as CSV files"),
                                      "teleta simulate tactile-indenter --out run\n"
                                      "  teleta export run/recording.teleta --csv run/csv");
}

} // namespace teleta::cli
