// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/study_export.h"

#include "backend/core/data/json_document.h"
#include "backend/core/data/output_file.h"
#include "backend/core/failure.h"
#include "backend/study/protocol/stimulus_set.h"
#include "backend/study/store/trial_table.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QString>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <set>
#include <span>
#include <string_view>
#include <utility>

namespace teleta::study {

namespace {

using nlohmann::ordered_json;

struct ExportText {
    Q_DECLARE_TR_FUNCTIONS(StudyExport)
};

core::Expected<void> writeChecked(const std::string& path, const std::string& content) {
    const QString name = QString::fromStdString(path);
    TELETA_CHECK(core::makeFolder(QFileInfo(name).path().toStdString()));
    TELETA_CHECK(core::writeFile(path, content));
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly) || file.readAll().toStdString() != content)
        return core::failed(core::ErrorKind::ioFailed,
                            ExportText::tr("the file differs from what was written"), {}, {path});
    return {};
}

TableFormat tableFormat(ExportFormat format) {
    switch (format) {
    case ExportFormat::psychds:
        return {};
    case ExportFormat::bids:
        return {'\t', "n/a", '.', false, false, false};
    case ExportFormat::excel:
        break;
    }
    const QString point = QLocale().decimalPoint();
    return {';', "NA", point == QStringLiteral(",") ? ',' : '.', true, true, true};
}

/// Path of a session's file in the study's folder, without its extension.
std::string sessionPath(ExportFormat format, const std::string& label, const std::string& session,
                        const std::string& task) {
    switch (format) {
    case ExportFormat::psychds:
        return "data/subject-" + label + "/subject-" + label + "_session-" + session + "_task-" + task +
               "_data";
    case ExportFormat::bids: {
        const std::string folder = "bids/sub-" + label + "/ses-" + session + "/beh/";
        return folder + "sub-" + label + "_ses-" + session + "_task-" + task + "_beh";
    }
    case ExportFormat::excel:
        break;
    }
    return "excel/" + label + '_' + session + '_' + task;
}

/// Psych-DS and BIDS reserve - and _.
std::string alphanumeric(const std::string& text) {
    std::string kept;
    std::ranges::copy_if(text, std::back_inserter(kept), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    });
    return kept;
}

std::string psychDsDescription(const StudyHead& head) {
    const ordered_json description = {
        {"@context", "https://schema.org/"}, {"@type", "Dataset"},
        {"name", head.protocol.name},        {"description", head.protocol.description},
        {"schemaVersion", "Psych-DS 0.4.0"}, {"variableMeasured", kTrialColumns},
        {"mode", toString(head.mode)},       {"seed", std::to_string(head.seed)}};
    return core::jsonText(description);
}

std::string bidsDescription(const StudyHead& head) {
    const ordered_json description = {
        {"Name", head.protocol.name},
        {"BIDSVersion", "1.8.0"},
        {"DatasetType", "raw"},
        {"GeneratedBy", ordered_json::array({{{"Name", "TeleTA Console"}, {"Version", head.appVersion}}})}};
    return core::jsonText(description);
}

/// Metadata of a session's trials.
ordered_json sessionSidecar(const StudyHead& head, const PlannedSession& plan) {
    const StudyTask& task = head.protocol.tasks[plan.task];
    const std::string& condition = task.conditions[plan.condition];
    ordered_json stimuli = ordered_json::object();
    for (const StudyPattern& pattern : task.patterns) {
        const std::string id = stimulusId(task, pattern, condition);
        ordered_json& stimulus = stimuli[pattern.letter];
        stimulus = {{"name", pattern.name}, {"pattern", id}};
        if (const OwnStimulus* own = head.stimuli.findOwn(id)) {
            stimulus["file"] = own->file;
            // It was parsed when the study was opened.
            stimulus["definition"] = ordered_json::parse(own->json, nullptr, false);
        }
    }
    return {
        {"task", task.name},
        {"condition", condition},
        {"stimuli", std::move(stimuli)},
        {"stimulus_s", head.protocol.stimulus_s},
        {"response_limit_s", head.protocol.responseLimit_s},
        {"response_window", head.protocol.window == ResponseWindow::fromOnset ? "from_onset" : "from_end"},
        {"seed", std::to_string(plan.seed)}};
}

/// Frame statistics of the stimuli that were played on a bracelet.
ordered_json frameSidecar(const std::vector<StoredTrial>& trials) {
    ordered_json list = ordered_json::array();
    for (const StoredTrial& stored : trials) {
        const TrialResult& result = stored.result;
        if (!result.frameWrite_ms && !result.framesMissed)
            continue;
        ordered_json frames{{"phase", toString(result.planned.phase)},
                            {"trial", result.planned.trial},
                            {"attempt", result.planned.attempt},
                            {"longest_frame_write_ms", nullptr},
                            {"frames_missed", nullptr}};
        if (result.frameWrite_ms)
            frames["longest_frame_write_ms"] = *result.frameWrite_ms;
        if (result.framesMissed)
            frames["frames_missed"] = *result.framesMissed;
        list.push_back(std::move(frames));
    }
    return list;
}

/// Description of a session's table in BIDS. session: sessionSidecar().
ordered_json bidsSidecar(const ordered_json& session) {
    ordered_json levels = ordered_json::object();
    for (const auto& [letter, stimulus] : session["stimuli"].items())
        levels[letter] = stimulus["name"];
    return {{"TaskName", session["task"]},
            {"response_time_s",
             {{"Description", "From the onset of the stimulus to the answer"}, {"Units", "s"}}},
            {"stimulus", {{"Description", "Pattern that was presented"}, {"Levels", std::move(levels)}}}};
}

/// path: in the study's folder, without an extension. bidsSidecar: description of the table in BIDS. session:
/// what Psych-DS says about the session; null for a table that is not of one.
core::Expected<void> writeTable(const StudyStore& store, const std::string& path,
                                const std::vector<TrialRow>& rows, std::span<const std::string_view> columns,
                                const ordered_json& bidsSidecar, ExportFormat format,
                                const ordered_json& session = nullptr) {
    const std::string whole = store.folder() + '/' + path;
    TELETA_CHECK(writeChecked(whole + (format == ExportFormat::bids ? ".tsv" : ".csv"),
                              tableText(rows, tableFormat(format), columns)));
    if (format == ExportFormat::excel)
        return {};
    ordered_json sidecar = bidsSidecar;
    if (format == ExportFormat::psychds) {
        sidecar = {{"@context", "https://schema.org/"},
                   {"@type", "Dataset"},
                   {"variableMeasured", std::vector(columns.begin(), columns.end())}};
        if (!session.is_null())
            sidecar["session"] = session;
    }
    return writeChecked(whole + ".json", core::jsonText(sidecar));
}

core::Expected<void> writeSession(const StudyStore& store, const Participant& participant,
                                  const std::string& label, const SessionRecord& record,
                                  ExportFormat format) {
    const StudyHead& head = store.head();
    const PlannedSession plan =
        planSessions(head.protocol, head.seed, participant.enrolment).at(record.planIndex);
    TELETA_TRY(const std::vector<StoredTrial> trials, store.trials(record));
    ordered_json session = sessionSidecar(head, plan);
    const ordered_json bids = bidsSidecar(session);
    session["frames"] = frameSidecar(trials);
    return writeTable(
        store, sessionPath(format, label, record.id, alphanumeric(head.protocol.tasks[plan.task].id)),
        trialRows(head, participant, record, plan, trials), kTrialColumns, bids, format, session);
}

/// Path of a participant's table next to those of the sessions, without its extension. name: alphanumeric.
std::string besidePath(ExportFormat format, const std::string& label, const std::string& name) {
    switch (format) {
    case ExportFormat::psychds:
        return "data/subject-" + label + "/subject-" + label + "_description-" + name + "_data";
    case ExportFormat::bids:
        return "bids/phenotype/" + name + '_' + label;
    case ExportFormat::excel:
        break;
    }
    return "excel/" + label + '_' + name;
}

core::Expected<void> writeAnswers(const StudyStore& store, const Participant& participant,
                                  const std::string& label, ExportFormat format) {
    if (store.head().protocol.questionnaires.empty())
        return {};
    TELETA_TRY(const std::vector<StoredAnswer> answers, store.answers(participant));
    TELETA_TRY(const std::vector<SessionRecord> sessions, store.sessions(participant));
    if (answers.empty())
        return {};
    return writeTable(
        store, besidePath(format, label, "questionnaire"),
        answerRows(store.head(), participant, sessions, answers), kAnswerColumns,
        {{"MeasurementToolMetadata", {{"Description", "Questionnaires of " + store.head().protocol.name}}},
         {"answer", {{"Description", "The text, the point of the scale, or the choice"}}}},
        format);
}

core::Expected<void> writeNotes(const StudyStore& store, const Participant& participant,
                                const std::string& label, ExportFormat format) {
    const StudyHead& head = store.head();
    TELETA_TRY(const std::vector<SessionRecord> sessions, store.sessions(participant));
    const std::vector<PlannedSession> plans = planSessions(head.protocol, head.seed, participant.enrolment);
    std::vector<TrialRow> rows;
    for (const SessionRecord& session : sessions) {
        TELETA_TRY(const std::vector<StoredNote> notes, store.notes(session));
        std::vector<TrialRow> more = noteRows(head, participant, session, plans.at(session.planIndex), notes);
        std::move(more.begin(), more.end(), std::back_inserter(rows));
    }
    if (rows.empty())
        return {};
    return writeTable(store, besidePath(format, label, "notes"), rows, kNoteColumns,
                      {{"MeasurementToolMetadata", {{"Description", "The experimenter's notes"}}},
                       {"note", {{"Description", "What the experimenter wrote down"}}}},
                      format);
}

core::Expected<void> writeDescription(const StudyStore& store, ExportFormat format) {
    if (format == ExportFormat::bids)
        return writeChecked(store.folder() + "/bids/dataset_description.json", bidsDescription(store.head()));
    if (format == ExportFormat::excel)
        return {};
    TELETA_TRY(const std::string script, analysisScript());
    TELETA_CHECK(writeChecked(store.folder() + "/analysis.R", script));
    return writeChecked(store.folder() + "/dataset_description.json", psychDsDescription(store.head()));
}

core::Expected<std::string> labelOf(const StudyStore& store, const Participant& participant) {
    TELETA_TRY(const std::vector<Participant> participants, store.participants());
    const auto found = std::ranges::find(participants, participant.key, &Participant::key);
    if (found == participants.end())
        return core::failed(
            core::ErrorKind::notFound,
            ExportText::tr("the study has no participant \"%1\"").arg(QString::fromStdString(participant.id)),
            {}, {store.shownName()});
    return fileLabels(participants)[static_cast<std::size_t>(found - participants.begin())];
}

} // namespace

std::vector<std::string> fileLabels(const std::vector<Participant>& participants) {
    std::set<std::string> used;
    std::vector<std::string> labels;
    for (const Participant& participant : participants) {
        const std::string number = 'x' + std::to_string(participant.enrolment + 1);
        std::string label = alphanumeric(participant.id);
        if (label != participant.id)
            label += number;
        // Some file systems ignore case.
        while (!used.insert(QString::fromStdString(label).toLower().toStdString()).second)
            label += number;
        labels.push_back(std::move(label));
    }
    return labels;
}

core::Expected<std::size_t> exportStudy(const StudyStore& store, ExportFormat format) {
    TELETA_CHECK(writeDescription(store, format));
    TELETA_TRY(const std::vector<Participant> participants, store.participants());
    const std::vector<std::string> labels = fileLabels(participants);
    std::size_t written = 0;
    for (std::size_t i = 0; i < participants.size(); ++i) {
        TELETA_TRY(const std::vector<SessionRecord> sessions, store.sessions(participants[i]));
        for (const SessionRecord& session : sessions) {
            TELETA_CHECK(writeSession(store, participants[i], labels[i], session, format));
            ++written;
        }
        TELETA_CHECK(writeAnswers(store, participants[i], labels[i], format));
        TELETA_CHECK(writeNotes(store, participants[i], labels[i], format));
    }
    return written;
}

core::Expected<void> exportAnswers(const StudyStore& store, const Participant& participant,
                                   ExportFormat format) {
    TELETA_TRY(const std::string label, labelOf(store, participant));
    return writeAnswers(store, participant, label, format);
}

core::Expected<void> exportNotes(const StudyStore& store, const Participant& participant,
                                 ExportFormat format) {
    TELETA_TRY(const std::string label, labelOf(store, participant));
    return writeNotes(store, participant, label, format);
}

core::Expected<void> exportSession(const StudyStore& store, const Participant& participant,
                                   const SessionRecord& session, ExportFormat format) {
    TELETA_CHECK(writeDescription(store, format));
    TELETA_TRY(const std::string label, labelOf(store, participant));
    TELETA_CHECK(writeSession(store, participant, label, session, format));
    TELETA_CHECK(writeAnswers(store, participant, label, format));
    return writeNotes(store, participant, label, format);
}

core::Expected<std::string> analysisScript() {
    QFile file(QStringLiteral(":/studies/analysis.R"));
    if (!file.open(QIODevice::ReadOnly))
        return core::failed(core::ErrorKind::notFound, file.errorString(), {},
                            {file.fileName().toStdString()});
    return file.readAll().toStdString();
}

} // namespace teleta::study
