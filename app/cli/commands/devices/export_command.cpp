// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/base/progress_bar.h"
#include "app/cli/commands/devices/devices_commands.h"
#include "backend/frames/recorded/npz_export.h"
#include "backend/mcap/chunk_compression.h"
#include "backend/mcap/recorded/mcap_export.h"
#include "backend/recording/csv_export.h"

#include <QCoreApplication>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <string>
#include <type_traits>
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
        QString text = QString::fromStdString(file.path).endsWith(QLatin1String(".json"))
                           ? ExportText::tr("start, units and origin of these files")
                           : ExportText::tr("%n row(s)", nullptr, static_cast<int>(file.rows));
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

core::Expected<void> printJson(const Recording& recording, const mcap::McapExport& file) {
    nlohmann::ordered_json document{{"recording", recording.path()},
                                    {"complete", recording.isComplete()},
                                    {"scene", recording.head().scene},
                                    {"app_version", recording.head().appVersion},
                                    {"path", file.path},
                                    {"bytes", file.bytes},
                                    {"damaged_blocks", file.damagedBlocks},
                                    {"topics", nlohmann::ordered_json::array()},
                                    {"left_out", file.leftOut},
                                    {"y_turned", file.turned}};
    for (const mcap::McapExport::Topic& topic : file.topics)
        document["topics"].push_back(
            {{"topic", topic.name}, {"type", topic.type}, {"messages", topic.messages}});
    return printDocument(document);
}

core::Expected<void> printTopics(const Recording& recording, const mcap::McapExport& file) {
    Fields fields;
    for (const mcap::McapExport::Topic& topic : file.topics)
        fields.emplace_back(QString::fromStdString(topic.name),
                            ExportText::tr("%n message(s)", nullptr, static_cast<int>(topic.messages)) +
                                QStringLiteral(", ") + QString::fromStdString(topic.type));
    const auto note = [&fields](const QString& text) { fields.emplace_back(ExportText::tr("Note"), text); };
    for (const std::string& stream : file.turned)
        note(ExportText::tr("The camera sees a left-handed frame: y of %1 has changed its sign.")
                 .arg(QString::fromStdString(stream)));
    for (const std::string& stream : file.leftOut)
        note(ExportText::tr("%1 has no messages in ROS and was left out.")
                 .arg(QString::fromStdString(stream)));
    if (file.damagedBlocks > 0)
        note(ExportText::tr("%n damaged block(s) left out", nullptr, static_cast<int>(file.damagedBlocks)));
    if (!recording.isComplete())
        note(ExportText::tr("The recording was cut off; what had been written is there."));
    return printFields(fields);
}

core::Expected<void> printArray(const Recording& recording, const frames::NpzExport& file, bool json) {
    if (json)
        return printDocument({{"recording", recording.path()},
                              {"complete", recording.isComplete()},
                              {"scene", recording.head().scene},
                              {"app_version", recording.head().appVersion},
                              {"path", file.path},
                              {"stream", file.stream},
                              {"shape", file.shape},
                              {"damaged_blocks", file.damagedBlocks}});
    Fields fields{{QString::fromStdString(file.path),
                   ExportText::tr("%n frame(s)", nullptr, static_cast<int>(file.shape.front()))}};
    const auto note = [&fields](const QString& text) { fields.emplace_back(ExportText::tr("Note"), text); };
    if (file.damagedBlocks > 0)
        note(ExportText::tr("%n damaged block(s) left out", nullptr, static_cast<int>(file.damagedBlocks)));
    if (!recording.isComplete())
        note(ExportText::tr("The recording was cut off; what had been written is there."));
    return printFields(fields);
}

core::Expected<void> listStreams(const Recording& recording) {
    std::string text;
    for (const recording::StreamInfo& stream : recording.streams())
        text += stream.name + '\t' + recording::toString(stream.kind) + '\n';
    return printText(text);
}

class ExportCommand {
public:
    void declare(CLI::App& app) {
        addOption(app, "RECORDING", m_path, ExportText::tr("Recording of the console or of teleta simulate"),
                  "")
            ->required();
        addOption(app, "--csv", m_folder,
                  ExportText::tr("Folder for a CSV file a stream, events.csv and recording.json"), "DIR");
        addFlag(app, "--list", m_list, ExportText::tr("List the streams of the recording: name and kind"));
        addFlag(app, "--utc", m_utc,
                ExportText::tr("Add a last column utc_s: Unix time in s with nine decimals"));
        addOption(app, "--mcap", m_mcapPath, ExportText::tr("MCAP file for Foxglove and ROS 2"), "FILE");
        addOption(app, "--npz", m_npzPath,
                  ExportText::tr("NumPy file with the arrays frames and time_s of a tactile array"), "FILE");
        addOption(app, "--stream", m_streams,
                  ExportText::tr("Only these streams into the MCAP file; the array of the NumPy file"),
                  "NAME");
        addChoice(app, "--compression", m_compression, ExportText::tr("Compression of the MCAP file"),
                  {"zstd", "lz4", "none"})
            ->capture_default_str();
        addOption(app, "--chunk-mb", m_chunk_MB, ExportText::tr("Size of a chunk of the MCAP file in MiB"),
                  between(0.01, 64.0), "NUMBER");
        addFlag(app, "--force", m_force, ExportText::tr("Write over files that are there already"));
        declareJson(app, m_json);
    }

    [[nodiscard]] core::Expected<void> run() {
        const int outputs = static_cast<int>(!m_folder.empty()) + static_cast<int>(!m_mcapPath.empty()) +
                            static_cast<int>(!m_npzPath.empty());
        if (!m_list && outputs != 1)
            refuse("--csv", ExportText::tr("either a folder here or a file after --mcap or --npz is needed"));
        if (!m_folder.empty() && !m_streams.empty())
            refuse("--stream", ExportText::tr("only with --mcap or --npz"));
        if (!m_npzPath.empty() && m_streams.size() > 1)
            refuse("--stream", ExportText::tr("only one with --npz"));
        TELETA_TRY(const Recording recording, Recording::open(m_path));
        if (m_list)
            return listStreams(recording);
        if (!m_npzPath.empty())
            return writeNpz(recording);
        return m_mcapPath.empty() ? writeCsv(recording) : writeMcap(recording);
    }

private:
    [[nodiscard]] core::Expected<void> writeMcap(const Recording& recording) {
        mcap::McapExportOptions options;
        options.streams = m_streams;
        options.compression =
            m_compression == "none" ? mcap::Compression::none : mcap::compressionOf(m_compression).value();
        options.chunkBytes = static_cast<std::size_t>(m_chunk_MB * (1U << 20U));
        TELETA_TRY(const auto exported, withProgress(options, m_mcapPath, [&] {
                       return mcap::exportMcap(recording, m_mcapPath, options);
                   }));
        return m_json ? printJson(recording, exported) : printTopics(recording, exported);
    }

    [[nodiscard]] core::Expected<void> writeNpz(const Recording& recording) {
        frames::NpzExportOptions options;
        if (!m_streams.empty())
            options.stream = m_streams.front();
        TELETA_TRY(const auto exported, withProgress(options, m_npzPath, [&] {
                       return frames::exportNpz(recording, m_npzPath, options);
                   }));
        return printArray(recording, exported, m_json);
    }

    /// Runs an export into one file with a bar of progress. Completes the options that all exports have, and
    /// names
    /// --force where a file stands in the way.
    template <typename Options, typename Work>
    [[nodiscard]] std::invoke_result_t<Work> withProgress(Options& options, const std::string& path,
                                                          Work work) {
        ProgressBar progress(ProgressBar::Unit::frames, false);
        options.overwrite = m_force;
        options.goOn = [&](double done, double all) {
            progress.update(done, all);
            return !interrupted();
        };
        auto exported = work();
        progress.erase();
        if (!exported && exported.error().kind == core::ErrorKind::refused &&
            exported.error().where.file == path)
            exported.error().expected = ExportText::tr("another name, or --force").toStdString();
        return exported;
    }

    [[nodiscard]] core::Expected<void> writeCsv(const Recording& recording) {
        ProgressBar progress(ProgressBar::Unit::frames, false);
        recording::ExportOptions options;
        options.utc = m_utc;
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

    std::string m_path;
    std::string m_folder;
    std::string m_mcapPath;
    std::string m_npzPath;
    std::vector<std::string> m_streams;
    std::string m_compression = "zstd";
    double m_chunk_MB = 4.0;
    bool m_list = false;
    bool m_utc = false;
    bool m_force = false;
    bool m_json = false;
};

} // namespace

Command exportCommand() {
    return makeCommand<ExportCommand>(
        "export", ExportText::tr("Write the streams of a recording as CSV, MCAP or NumPy files"),
        "teleta simulate tactile-indenter --out run\n"
        "  teleta export run/recording.teleta --csv run/csv\n"
        "  teleta export run/recording.teleta --mcap run/recording.mcap\n"
        "  teleta export run/recording.teleta --npz run/array.npz");
}

} // namespace teleta::cli
