// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/scenes/study_papers.h"

#include "app/cli/base/command_io.h"
#include "app/cli/base/options.h"
#include "backend/core/data/output_file.h"
#include "backend/core/data/private_files.h"
#include "backend/core/device/trigger_port.h"
#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "backend/study/report/exports/codebook.h"
#include "backend/study/report/exports/study_export.h"
#include "backend/study/report/participant_report.h"
#include "backend/study/store/study_store.h"
#include "devices/trigger/trigger_opener.h"

#include <QCoreApplication>
#include <QString>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <chrono>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace teleta::cli {

namespace {

struct PapersText {
    Q_DECLARE_TR_FUNCTIONS(StudyPapers)
};

/// Label of a participant in the names of files, as in exports.
core::Expected<std::string> fileLabel(const study::StudyStore& store, const std::string& id) {
    TELETA_TRY(const std::vector<study::Participant> people, store.participants());
    const std::vector<std::string> labels = study::fileLabels(people);
    for (std::size_t i = 0; i < people.size(); ++i) {
        if (people[i].id == id)
            return labels[i];
    }
    return id;
}

} // namespace

void StudyPapers::declareReport(CLI::App& app) {
    addOption(app, "study", m_study, PapersText::tr("Folder of the study"), "DIR")->required();
    addOption(app, "--participant", m_participant, PapersText::tr("Whose report it is"), "ID")->required();
    addChoice(
        app, "--for", m_reader,
        PapersText::tr("experimenter: everything of this participant; participant: their own answers in "
                       "plain words"),
        {"experimenter", "participant"})
        ->capture_default_str();
    addOption(app, "--out", m_out,
              PapersText::tr("The page; otherwise report-ID.html or report-ID-participant.html in the folder "
                             "of the study"),
              "FILE.html");
    addOption(app, "--store", m_server,
              PapersText::tr("PostgreSQL server that has the study, "
                             "postgresql://USER@HOST/DATABASE?study=NAME; the password comes from "
                             "PGPASSWORD or ~/.pgpass"),
              "URL");
    declareJson(app, m_json);
}

core::Expected<void> StudyPapers::writeReport() const {
    TELETA_TRY(const study::StudyStore store, study::StudyStore::openForReading({m_study, m_server}));
    const bool theirs = m_reader == "participant";
    TELETA_TRY(const std::string page, study::participantReport(store, m_participant,
                                                                theirs ? study::ReportReader::participant
                                                                       : study::ReportReader::experimenter));
    std::string path = m_out;
    if (path.empty()) {
        TELETA_CHECK(store.ownFolder());
        TELETA_TRY(const std::string label, fileLabel(store, m_participant));
        path = store.folder() + "/report-" + label + (theirs ? "-participant.html" : ".html");
    }
    const core::PrivateFiles forOwner;
    TELETA_CHECK(core::writeFile(path, page));
    if (m_json)
        return printDocument({{"participant", m_participant}, {"for", m_reader}, {"report", path}});
    return printFields({{PapersText::tr("Report"), QString::fromStdString(path)}});
}

void StudyPapers::declareCodebook(CLI::App& app) {
    addOption(app, "study", m_study,
              PapersText::tr("Folder of a study, whose questionnaires are described too"), "DIR");
    declareOut(app, m_out);
    declareJson(app, m_json);
}

core::Expected<void> StudyPapers::writeCodebook() const {
    std::optional<study::Protocol> protocol;
    if (!m_study.empty()) {
        TELETA_TRY(const study::StudyStore store, study::StudyStore::openForReading(m_study));
        protocol = store.head().protocol;
    }
    static constexpr std::array<std::string_view, 6> kColumns{"file", "column", "description",
                                                              "unit", "levels", "missing"};
    TELETA_TRY(RowOutput output, RowOutput::open(kColumns, {m_json, m_out}));
    for (const study::CodebookEntry& entry : study::codebookOf(protocol ? &*protocol : nullptr)) {
        for (const std::string* text :
             {&entry.file, &entry.column, &entry.description, &entry.unit, &entry.levels, &entry.missing})
            output.text(text->empty() ? std::string_view("NA") : std::string_view(*text));
        output.endRow();
    }
    return output.finish();
}

void StudyPapers::declareTrigger(CLI::App& app) {
    addOption(
        app, "--test", m_device,
        PapersText::tr("Where one trial's events go: a serial port such as /dev/ttyUSB0, or HOST:PORT for "
                       "OSC by UDP"),
        "DEVICE")
        ->required();
    declareJson(app, m_json);
}

core::Expected<void> StudyPapers::testTrigger() const {
    using Kind = core::TriggerEvent::Kind;
    TELETA_TRY(const core::TriggerSettings settings, trigger::triggerSettingsOf(m_device));
    TELETA_TRY(const auto port, trigger::openTrigger(settings));
    constexpr std::array kEvents{std::pair{Kind::session, 0}, std::pair{Kind::stimulus, 1},
                                 std::pair{Kind::answer, 1}, std::pair{Kind::noAnswer, 0},
                                 std::pair{Kind::sessionEnd, 0}};
    constexpr std::chrono::milliseconds kBetween{50};
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    Fields fields;
    for (const auto& [kind, index] : kEvents) {
        core::TriggerEvent event{kind, static_cast<std::size_t>(index), "test", 1, {}, core::steadyNow_ns()};
        TELETA_CHECK(port->write(event));
        const double write_ms = 1e-6 * static_cast<double>(core::steadyNow_ns() - event.time_ns);
        if (port->pulse_ns() > 0) {
            std::this_thread::sleep_for(std::chrono::nanoseconds(port->pulse_ns()));
            TELETA_CHECK(port->clear());
        }
        const bool serial = settings.kind == core::TriggerSettings::Kind::serial;
        rows.push_back({{"event", event.word()}, {"byte", event.byte()}, {"write_ms", write_ms}});
        const QString what = QString::fromStdString(event.word());
        fields.emplace_back(serial ? QStringLiteral("%1 (%2)").arg(what).arg(event.byte()) : what,
                            PapersText::tr("written in %1 ms").arg(write_ms, 0, 'f', 3));
        std::this_thread::sleep_for(kBetween);
    }
    if (m_json)
        return printDocument({{"device", m_device}, {"events", std::move(rows)}});
    return printFields(fields);
}

} // namespace teleta::cli
