// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/base/progress_bar.h"
#include "app/cli/commands/devices/devices_commands.h"
#include "backend/mcap/recorded/mcap_import.h"

#include <QCoreApplication>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace teleta::cli {

namespace {

using mcap::McapImport;

struct ImportText {
    Q_DECLARE_TR_FUNCTIONS(ImportCommand)
};

core::Expected<void> printJson(const McapImport& import) {
    nlohmann::ordered_json document{{"recording", import.path},
                                    {"complete", import.isComplete},
                                    {"bytes", import.bytes},
                                    {"whole_bytes", import.wholeBytes},
                                    {"data_section_damaged", import.isDataSectionDamaged},
                                    {"damaged_chunks", import.badChunks},
                                    {"damaged_records", import.badRecords},
                                    {"frames", import.frames},
                                    {"topics", nlohmann::ordered_json::array()}};
    for (const McapImport::Topic& topic : import.topics)
        document["topics"].push_back({{"topic", topic.name},
                                      {"type", topic.type},
                                      {"stream", topic.stream.empty() ? nlohmann::ordered_json(nullptr)
                                                                      : nlohmann::ordered_json(topic.stream)},
                                      {"messages", topic.messages},
                                      {"damaged_messages", topic.bad}});
    return printDocument(document);
}

core::Expected<void> printTopics(const McapImport& import) {
    Fields fields;
    for (const McapImport::Topic& topic : import.topics) {
        QString text = topic.messages == 0 && topic.bad == 0
                           ? ImportText::tr("left out")
                           : ImportText::tr("%n message(s)", nullptr, static_cast<int>(topic.messages));
        if (topic.bad > 0)
            text += QStringLiteral(", ") +
                    ImportText::tr("%n damaged or of another shape", nullptr, static_cast<int>(topic.bad));
        fields.emplace_back(QString::fromStdString(topic.name),
                            text + QStringLiteral(", ") + QString::fromStdString(topic.type));
    }
    const auto note = [&fields](const QString& text) { fields.emplace_back(ImportText::tr("Note"), text); };
    if (!import.isComplete)
        note(ImportText::tr("The file was cut off: %1 of %2 bytes could be read.")
                 .arg(import.wholeBytes)
                 .arg(import.bytes));
    if (import.badChunks > 0)
        note(ImportText::tr("%n damaged chunk(s) left out", nullptr, static_cast<int>(import.badChunks)));
    if (import.badRecords > 0)
        note(ImportText::tr("%n damaged record(s) left out", nullptr, static_cast<int>(import.badRecords)));
    if (import.isDataSectionDamaged)
        note(ImportText::tr("The checksum of the file is wrong: it was damaged somewhere."));
    return printFields(fields);
}

class ImportCommand {
public:
    void declare(CLI::App& app) {
        addOption(app, "FILE", m_path, ImportText::tr("MCAP file with messages of ROS 2"), "")->required();
        addOption(app, "--out", m_out, ImportText::tr("Recording to be made"), "REC.teleta")->required();
        addOption(app, "--topic", m_topics,
                  ImportText::tr("Read a topic as array, camera or joints, where its type leaves a choice"),
                  "/TOPIC=KIND");
        declareJson(app, m_json);
    }

    [[nodiscard]] core::Expected<void> run() {
        mcap::McapImportOptions options;
        for (const std::string& text : m_topics) {
            const std::size_t sign = text.rfind('=');
            const auto kind =
                sign == std::string::npos ? std::nullopt : mcap::topicKindOf(text.substr(sign + 1));
            if (!kind)
                refuse("--topic", ImportText::tr("'%1' is not /TOPIC=array, /TOPIC=camera or /TOPIC=joints")
                                      .arg(QString::fromStdString(text)));
            options.topics[text.substr(0, sign)] = *kind;
        }
        ProgressBar progress(ProgressBar::Unit::share, false);
        options.goOn = [&](double share) {
            progress.update(share, 1.0);
            return !interrupted();
        };
        const auto imported = mcap::importMcap(m_path, m_out, options);
        progress.erase();
        if (!imported)
            return core::Unexpected(imported.error().kind == core::ErrorKind::cancelled ? interruption()
                                                                                        : imported.error());
        return m_json ? printJson(*imported) : printTopics(*imported);
    }

private:
    std::string m_path;
    std::string m_out;
    std::vector<std::string> m_topics;
    bool m_json = false;
};

} // namespace

Command importCommand() {
    return makeCommand<ImportCommand>("import", ImportText::tr("Make a recording of an MCAP file"),
                                      "teleta simulate tactile-indenter --out run\n"
                                      "  teleta export run/recording.teleta --mcap run/recording.mcap\n"
                                      "  teleta import run/recording.mcap --out run/again.teleta");
}

} // namespace teleta::cli
