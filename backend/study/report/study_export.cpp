// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/study_export.h"

#include "backend/core/data/output_file.h"
#include "backend/study/analysis/analysis_script.h"
#include "backend/study/protocol/stimulus_set.h"
#include "backend/study/store/trial_table.h"

#include <QCoreApplication>
#include <QDir>
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

core::Unexpected failed(const QString& message, const std::string& path) {
    return core::Unexpected(core::Error{core::ErrorKind::ioFailed, message.toStdString(), {}, {path}});
}

core::Expected<void> writeChecked(const std::string& path, const std::string& content) {
    const QString name = QString::fromStdString(path);
    if (!QDir().mkpath(QFileInfo(name).path()))
        return failed(ExportText::tr("cannot make the folder"), path);
    TELETA_TRY(core::OutputFile output, core::OutputFile::create(path));
    output.write(content);
    if (const core::Expected<void> finished = output.finish(); !finished)
        return finished;
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly) || file.readAll().toStdString() != content)
        return failed(ExportText::tr("the file differs from what was written"), path);
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
    std::copy_if(text.begin(), text.end(), std::back_inserter(kept), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    });
    return kept;
}

ordered_json columnNames(std::span<const std::string_view> columns) {
    ordered_json names = ordered_json::array();
    for (const std::string_view name : columns)
        names.push_back(name);
    return names;
}

std::string psychDsDescription(const StudyHead& head) {
    const ordered_json description = {
        {"@context", "https://schema.org/"}, {"@type", "Dataset"},
        {"name", head.protocol.name},        {"description", head.protocol.description},
        {"schemaVersion", "Psych-DS 0.4.0"}, {"variableMeasured", columnNames(kTrialColumns)},
        {"mode", toString(head.mode)},       {"seed", std::to_string(head.seed)}};
    return description.dump(2) + "\n";
}

std::string bidsDescription(const StudyHead& head) {
    const ordered_json description = {
        {"Name", head.protocol.name},
        {"BIDSVersion", "1.8.0"},
        {"DatasetType", "raw"},
        {"GeneratedBy", ordered_json::array({{{"Name", "TeleTA Console"}, {"Version", head.appVersion}}})}};
    return description.dump(2) + "\n";
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

std::string sidecarText(const StudyHead& head, const PlannedSession& plan,
                        const std::vector<StoredTrial>& trials, ExportFormat format) {
    ordered_json sidecar;
    if (format == ExportFormat::psychds) {
        sidecar = {{"@context", "https://schema.org/"},
                   {"@type", "Dataset"},
                   {"variableMeasured", columnNames(kTrialColumns)}};
        sidecar["session"] = sessionSidecar(head, plan);
        sidecar["session"]["frames"] = frameSidecar(trials);
    } else {
        const ordered_json session = sessionSidecar(head, plan);
        sidecar = {{"TaskName", session["task"]}};
        sidecar["response_time_s"] = {{"Description", "From the onset of the stimulus to the answer"},
                                      {"Units", "s"}};
        sidecar["stimulus"] = {{"Description", "Pattern that was presented"},
                               {"Levels", ordered_json::object()}};
        for (const auto& [letter, stimulus] : session["stimuli"].items())
            sidecar["stimulus"]["Levels"][letter] = stimulus["name"];
    }
    return sidecar.dump(2) + "\n";
}

core::Expected<void> writeSession(const StudyStore& store, const Participant& participant,
                                  const std::string& label, const SessionRecord& session,
                                  ExportFormat format) {
    const StudyHead& head = store.head();
    const PlannedSession plan =
        planSessions(head.protocol, head.seed, participant.enrolment).at(session.planIndex);
    TELETA_TRY(const std::vector<StoredTrial> trials, store.trials(session));
    const std::string path =
        QDir(QString::fromStdString(store.folder()))
            .filePath(QString::fromStdString(
                sessionPath(format, label, session.id, alphanumeric(head.protocol.tasks[plan.task].id))))
            .toStdString();
    const std::vector<TrialRow> rows = trialRows(head, participant, session, plan, trials);
    const std::string extension = format == ExportFormat::bids ? ".tsv" : ".csv";
    const core::Expected<void> written = writeChecked(path + extension, tableText(rows, tableFormat(format)));
    if (!written || format == ExportFormat::excel)
        return written;
    return writeChecked(path + ".json", sidecarText(head, plan, trials, format));
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

/// bidsSidecar: description of the table in BIDS.
core::Expected<void> writeBeside(const StudyStore& store, const std::string& path,
                                 const std::vector<TrialRow>& rows, std::span<const std::string_view> columns,
                                 const ordered_json& bidsSidecar, ExportFormat format) {
    const std::string whole =
        QDir(QString::fromStdString(store.folder())).filePath(QString::fromStdString(path)).toStdString();
    const std::string extension = format == ExportFormat::bids ? ".tsv" : ".csv";
    const core::Expected<void> written =
        writeChecked(whole + extension, tableText(rows, tableFormat(format), columns));
    if (!written || format == ExportFormat::excel)
        return written;
    ordered_json sidecar = bidsSidecar;
    if (format == ExportFormat::psychds)
        sidecar = {{"@context", "https://schema.org/"},
                   {"@type", "Dataset"},
                   {"variableMeasured", columnNames(columns)}};
    return writeChecked(whole + ".json", sidecar.dump(2) + "\n");
}

core::Expected<void> writeAnswers(const StudyStore& store, const Participant& participant,
                                  const std::string& label, ExportFormat format) {
    if (store.head().protocol.questionnaires.empty())
        return {};
    TELETA_TRY(const std::vector<StoredAnswer> answers, store.answers(participant));
    TELETA_TRY(const std::vector<SessionRecord> sessions, store.sessions(participant));
    if (answers.empty())
        return {};
    return writeBeside(
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
    return writeBeside(store, besidePath(format, label, "notes"), rows, kNoteColumns,
                       {{"MeasurementToolMetadata", {{"Description", "The experimenter's notes"}}},
                        {"note", {{"Description", "What the experimenter wrote down"}}}},
                       format);
}

core::Expected<void> writeDescription(const StudyStore& store, ExportFormat format) {
    const QDir folder(QString::fromStdString(store.folder()));
    switch (format) {
    case ExportFormat::psychds: {
        TELETA_TRY(const std::string script, analysisScript());
        return writeChecked(folder.filePath(QStringLiteral("analysis.R")).toStdString(), script)
            .and_then([&] {
                return writeChecked(folder.filePath(QStringLiteral("dataset_description.json")).toStdString(),
                                    psychDsDescription(store.head()));
            });
    }
    case ExportFormat::bids:
        return writeChecked(folder.filePath(QStringLiteral("bids/dataset_description.json")).toStdString(),
                            bidsDescription(store.head()));
    case ExportFormat::excel:
        break;
    }
    return {};
}

core::Expected<std::string> labelOf(const StudyStore& store, const Participant& participant) {
    TELETA_TRY(const std::vector<Participant> participants, store.participants());
    const auto found = std::find_if(participants.begin(), participants.end(),
                                    [&](const Participant& one) { return one.key == participant.key; });
    if (found == participants.end())
        return core::Unexpected(core::Error{core::ErrorKind::notFound,
                                            ExportText::tr("the study has no participant \"%1\"")
                                                .arg(QString::fromStdString(participant.id))
                                                .toStdString(),
                                            {},
                                            {store.shownName()}});
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
            const core::Expected<void> done =
                writeSession(store, participants[i], labels[i], session, format);
            TELETA_CHECK(done);
            ++written;
        }
        const core::Expected<void> beside =
            writeAnswers(store, participants[i], labels[i], format).and_then([&] {
                return writeNotes(store, participants[i], labels[i], format);
            });
        TELETA_CHECK(beside);
    }
    return written;
}

core::Expected<void> exportAnswers(const StudyStore& store, const Participant& participant,
                                   ExportFormat format) {
    return labelOf(store, participant).and_then([&](const std::string& label) {
        return writeAnswers(store, participant, label, format);
    });
}

core::Expected<void> exportNotes(const StudyStore& store, const Participant& participant,
                                 ExportFormat format) {
    return labelOf(store, participant).and_then([&](const std::string& label) {
        return writeNotes(store, participant, label, format);
    });
}

core::Expected<void> exportSession(const StudyStore& store, const Participant& participant,
                                   const SessionRecord& session, ExportFormat format) {
    if (const core::Expected<void> described = writeDescription(store, format); !described)
        return described;
    return labelOf(store, participant).and_then([&](const std::string& label) {
        return writeSession(store, participant, label, session, format)
            .and_then([&] { return writeAnswers(store, participant, label, format); })
            .and_then([&] { return writeNotes(store, participant, label, format); });
    });
}

} // namespace teleta::study
