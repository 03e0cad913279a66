// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/exports/study_export.h"

#include "backend/core/data/json_document.h"
#include "backend/core/failure.h"
#include "backend/study/analysis/trials/stored_exclusions.h"
#include "backend/study/report/exports/bids_export.h"
#include "backend/study/report/exports/codebook.h"
#include "backend/study/report/exports/export_parts.h"
#include "backend/study/store/trial_table.h"

#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QString>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>

namespace teleta::study {

namespace {

using nlohmann::ordered_json;

struct ExportText {
    Q_DECLARE_TR_FUNCTIONS(StudyExport)
};

/// Those of Psych-DS and of the copy for spreadsheets.
TableFormat tableFormat(ExportFormat format) {
    if (format != ExportFormat::excel)
        return {};
    const bool comma = QLocale().decimalPoint() == QStringLiteral(",");
    return {';', "NA", comma ? ',' : '.', true, true, true};
}

/// Path of a session's file in the study's folder, without its extension.
std::string sessionPath(ExportFormat format, const std::string& label, const std::string& session,
                        const std::string& task) {
    if (format == ExportFormat::excel)
        return "excel/" + label + '_' + session + '_' + task;
    return "data/subject-" + label + "/subject-" + label + "_session-" + session + "_task-" + task + "_data";
}

std::string psychDsDescription(const StudyHead& head) {
    ordered_json description = {
        {"@context", "https://schema.org/"}, {"@type", "Dataset"},
        {"name", head.protocol.name},        {"description", head.protocol.description},
        {"schemaVersion", "Psych-DS 0.4.0"}, {"variableMeasured", psychDsVariables("trials", kTrialColumns)},
        {"mode", toString(head.mode)},       {"seed", std::to_string(head.seed)}};
    if (!head.protocol.authors.empty()) {
        ordered_json& authors = description["author"];
        for (const std::string& author : head.protocol.authors)
            authors.push_back({{"@type", "Person"}, {"name", author}});
    }
    return core::jsonText(description);
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

/// path: in the study's folder, without an extension. kind: of the codebook. sidecar: what else Psych-DS says
/// about the table.
core::Expected<void> writeTable(const StudyStore& store, const std::string& path,
                                const std::vector<TrialRow>& rows, std::span<const std::string_view> columns,
                                std::string_view kind, ExportFormat format, ordered_json more = {}) {
    const std::string whole = store.folder() + '/' + path;
    TableFormat table = tableFormat(format);
    // Tables of trials hold words of the protocol, keys and participants' names, none of which is a formula.
    // Free text may be one.
    table.guarded = table.guarded || kind != "trials";
    TELETA_CHECK(writeChecked(whole + ".csv", tableText(rows, table, columns)));
    if (format == ExportFormat::excel)
        return {};
    ordered_json sidecar{{"@context", "https://schema.org/"},
                         {"@type", "Dataset"},
                         {"variableMeasured", psychDsVariables(kind, columns)}};
    if (more.is_object())
        sidecar.update(more);
    return writeChecked(whole + ".json", core::jsonText(sidecar));
}

/// Writes into the rows of a session which rule of the protocol has left each trial out.
core::Expected<void> markExcluded(const StudyStore& store, const Participant& participant,
                                  const SessionRecord& record, const std::vector<StoredTrial>& trials,
                                  std::vector<TrialRow>& rows) {
    TELETA_TRY(const StoredExclusions exclusions, storedExclusions(store, participant));
    const auto column = std::ranges::find(kTrialColumns, "excluded") - kTrialColumns.begin();
    for (std::size_t i = 0; i < trials.size(); ++i) {
        std::string rule = exclusions.ruleOf(record, trials[i].result);
        if (!rule.empty())
            rows[i][static_cast<std::size_t>(column)] = {TrialCell::Kind::text, std::move(rule)};
    }
    return {};
}

core::Expected<void> writeSession(const StudyStore& store, const Participant& participant,
                                  const std::string& label, const SessionRecord& record,
                                  ExportFormat format) {
    const StudyHead& head = store.head();
    const PlannedSession plan =
        planSessions(head.protocol, head.seed, participant.enrolment).at(record.planIndex);
    TELETA_TRY(const std::vector<StoredTrial> trials, store.trials(record));
    ordered_json session = sessionSidecar(head, plan);
    session["frames"] = frameSidecar(trials);
    std::vector<TrialRow> rows = trialRows(head, participant, record, plan, trials);
    TELETA_CHECK(markExcluded(store, participant, record, trials, rows));
    return writeTable(store,
                      sessionPath(format, label, record.id, alphanumeric(head.protocol.tasks[plan.task].id)),
                      rows, kTrialColumns, "trials", format, {{"session", std::move(session)}});
}

/// Path of a participant's table next to those of the sessions, without its extension. name: alphanumeric.
std::string besidePath(ExportFormat format, const std::string& label, const std::string& name) {
    if (format == ExportFormat::excel)
        return "excel/" + label + '_' + name;
    return "data/subject-" + label + "/subject-" + label + "_description-" + name + "_data";
}

core::Expected<void> writeAnswers(const StudyStore& store, const Participant& participant,
                                  const std::string& label, ExportFormat format) {
    if (store.head().protocol.questionnaires.empty())
        return {};
    TELETA_TRY(const std::vector<StoredAnswer> answers, store.answers(participant));
    TELETA_TRY(const std::vector<SessionRecord> sessions, store.sessions(participant));
    if (answers.empty())
        return {};
    ordered_json more;
    if (ordered_json sources = questionnaireSources(store.head().protocol); !sources.empty())
        more = {{"questionnaires", std::move(sources)}};
    return writeTable(store, besidePath(format, label, "questionnaire"),
                      answerRows(store.head(), participant, sessions, answers), kAnswerColumns,
                      "questionnaire", format, std::move(more));
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
    return writeTable(store, besidePath(format, label, "notes"), rows, kNoteColumns, "notes", format);
}

core::Expected<void> writeDescription(const StudyStore& store) {
    TELETA_TRY(const std::string script, analysisScript());
    TELETA_CHECK(writeChecked(store.folder() + "/analysis.R", script));
    return writeChecked(store.folder() + "/dataset_description.json", psychDsDescription(store.head()));
}

/// What concerns all participants.
core::Expected<void> writeWhole(const StudyStore& store, ExportFormat format) {
    TELETA_TRY(const std::string scores, scoreText(store));
    if (!scores.empty())
        TELETA_CHECK(writeChecked(store.folder() + "/questionnaire_scores.csv", scores));
    if (format == ExportFormat::excel)
        return {};
    TELETA_CHECK(
        writeChecked(store.folder() + "/codebook.csv", codebookText(codebookOf(&store.head().protocol))));
    return writeDescription(store);
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
    std::vector<std::string> ids;
    std::vector<std::size_t> numbers;
    for (const Participant& participant : participants) {
        ids.push_back(participant.id);
        numbers.push_back(participant.enrolment + 1);
    }
    return alphanumericLabels(ids, numbers);
}

core::Expected<std::size_t> exportStudy(const StudyStore& store, ExportFormat format) {
    if (format == ExportFormat::bids)
        return exportBids(store);
    TELETA_CHECK(writeWhole(store, format));
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

core::Expected<void> exportAnswers(const StudyStore& store, const Participant& participant) {
    TELETA_TRY(const std::string label, labelOf(store, participant));
    return writeAnswers(store, participant, label, ExportFormat::psychds);
}

core::Expected<void> exportNotes(const StudyStore& store, const Participant& participant) {
    TELETA_TRY(const std::string label, labelOf(store, participant));
    return writeNotes(store, participant, label, ExportFormat::psychds);
}

core::Expected<void> exportSession(const StudyStore& store, const Participant& participant,
                                   const SessionRecord& session) {
    constexpr ExportFormat kFormat = ExportFormat::psychds;
    TELETA_CHECK(writeDescription(store));
    TELETA_TRY(const std::string label, labelOf(store, participant));
    TELETA_CHECK(writeSession(store, participant, label, session, kFormat));
    TELETA_CHECK(writeAnswers(store, participant, label, kFormat));
    return writeNotes(store, participant, label, kFormat);
}

core::Expected<std::string> analysisScript() {
    QFile file(QStringLiteral(":/studies/analysis.R"));
    if (!file.open(QIODevice::ReadOnly))
        return core::failed(core::ErrorKind::notFound, file.errorString(), {},
                            {file.fileName().toStdString()});
    return file.readAll().toStdString();
}

} // namespace teleta::study
