// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/frame_options.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/base/progress_bar.h"
#include "app/cli/commands/devices/devices_commands.h"
#include "backend/core/data/input_file.h"
#include "backend/frames/recorded/frame_import.h"
#include "backend/mcap/recorded/mcap_import.h"

#include <QCoreApplication>
#include <QLocale>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <optional>
#include <span>
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

core::Expected<void> printFrames(const frames::FrameImport& import, bool json) {
    const core::TaxelLayout& layout = import.layout;
    const core::ArrayLayout& grid = layout.grid();
    if (json) {
        nlohmann::ordered_json document{{"recording", import.path}, {"stream", import.stream}};
        if (layout.isGrid())
            document.update({{"rows", grid.rows}, {"columns", grid.columns}});
        else
            document["taxels"] = layout.taxels();
        if (layout.isVector())
            document["components"] = layout.components();
        document["frames"] = import.frames;
        document["rate_hz"] = orNull(import.rate_Hz > 0.0 ? std::optional(import.rate_Hz) : std::nullopt);
        return printDocument(document);
    }
    QString shape = layout.isGrid() ? QStringLiteral("%1 x %2").arg(grid.rows).arg(grid.columns)
                                    : QString::number(layout.taxels());
    if (layout.isVector())
        shape += QStringLiteral(" x %1").arg(layout.components());
    Fields fields{{ImportText::tr("Array"), shape},
                  {ImportText::tr("Frames"), QString::number(import.frames)}};
    if (import.rate_Hz > 0.0)
        fields.emplace_back(ImportText::tr("Rate"),
                            QStringLiteral("%1 Hz").arg(QLocale::c().toString(import.rate_Hz, 'g', 6)));
    return printFields(fields);
}

class ImportCommand {
public:
    void declare(CLI::App& app) {
        addOption(
            app, "FILE", m_path,
            ImportText::tr("MCAP file with ROS 2 messages, or frames of an array; the options below supply "
                           "what a file of frames does not say"),
            "")
            ->required();
        addOption(app, "--out", m_out, ImportText::tr("Recording to be made"), "REC.teleta")->required();
        addOption(app, "--topic", m_topics,
                  ImportText::tr("Read a topic as array, camera or joints, where its type leaves a choice"),
                  "/TOPIC=KIND");
        m_array.declare(app);
        m_array.declareLayout(app);
        addOption(app, "--gain", m_gain, ImportText::tr("Load in one unit of the values"))->check(nonZero());
        addOption(
            app, "--unit", m_unit,
            ImportText::tr("Unit of the loads; default: as the file says, else N or counts, by the array"),
            "NAME");
        addOption(app, "-t,--threshold", m_threshold,
                  ImportText::tr("Load from which a taxel is in contact, in the recording's settings; 0.2 "
                                 "unless the unit is another one than N and counts"),
                  "LOAD")
            ->check(positive());
        declareJson(app, m_json);
        m_app = &app;
    }

    [[nodiscard]] core::Expected<void> run() {
        TELETA_CHECK(core::requireFile(m_path));
        return mcap::looksLikeMcap(m_path) ? importMessages() : importFrames();
    }

private:
    /// Refuses options that say something of another kind of file.
    void refuseOptions(std::span<const char* const> options, const QString& why) const {
        for (const char* option : options)
            if (m_app->get_option(option)->count() > 0)
                refuse(option, why);
    }

    [[nodiscard]] core::Expected<void> importFrames() {
        refuseOptions(std::array{"--topic"}, ImportText::tr("this is for MCAP files only"));
        TELETA_TRY(frames::FrameRequest request, m_array.request(m_path));
        request.guessesShape = true;
        const auto goOn = [] { return !interrupted(); };
        auto reader = frames::FrameReader::open(request, goOn);
        if (!reader)
            return core::Unexpected(interruptedInstead(std::move(reader).error()));
        warnOfUnused(*reader);
        frames::FrameImportOptions options;
        TELETA_TRY(options.settings.conditioning, m_array.conditioning(reader->taxels(), m_path));
        TELETA_TRY(const std::optional<double> newtons, m_array.newtonsPerUnit(reader->unit()));
        options.settings.conditioning.gain = m_gain.value_or(newtons.value_or(1.0));
        options.settings.loadUnit = m_unit.empty() && newtons && !m_gain ? "N" : m_unit;
        const std::string& unit =
            options.settings.loadUnit.empty() ? reader->unit() : options.settings.loadUnit;
        TELETA_TRY(const double threshold, m_array.threshold(m_threshold, unit));
        options.settings.features.threshold_N = options.settings.segmentation.threshold_N = threshold;
        ProgressBar progress(ProgressBar::Unit::share, false);
        options.goOn = [&](double share) {
            progress.update(share, 1.0);
            return goOn();
        };
        const auto imported = frames::importFrames(std::move(*reader), m_path, m_out, options);
        progress.erase();
        if (!imported)
            return core::Unexpected(interruptedInstead(imported.error()));
        return printFrames(*imported, m_json);
    }

    [[nodiscard]] core::Expected<void> importMessages() {
        refuseOptions(std::array{"--rows", "--columns", "--pitch-mm", "--rate", "--array", "--frame-axis",
                                 "--tare", "--time-column", "--time-unit", "--invert", "--dead", "--layout",
                                 "--gain", "--unit", "--threshold"},
                      ImportText::tr("this is for frames, not for MCAP files"));
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
            return core::Unexpected(interruptedInstead(imported.error()));
        return m_json ? printJson(*imported) : printTopics(*imported);
    }

    std::string m_path;
    std::string m_out;
    std::vector<std::string> m_topics;
    ArrayOptions m_array;
    std::optional<double> m_gain;
    std::optional<double> m_threshold;
    std::string m_unit;
    bool m_json = false;
    CLI::App* m_app = nullptr;
};

} // namespace

Command importCommand() {
    return makeCommand<ImportCommand>(
        "import", ImportText::tr("Make a recording of an MCAP file, or of the frames of another program"),
        "teleta simulate tactile-indenter --out run\n"
        "  teleta export run/recording.teleta --mcap run/recording.mcap\n"
        "  teleta import run/recording.mcap --out run/again.teleta\n"
        "  teleta import run/frames.csv --tare median --out run/frames.teleta");
}

} // namespace teleta::cli
