// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/exports/bids_export.h"

#include "backend/core/data/json_document.h"
#include "backend/study/protocol/standard_questionnaire.h"
#include "backend/study/report/exports/codebook.h"
#include "backend/study/report/exports/export_parts.h"
#include "backend/study/report/exports/study_export.h"
#include "backend/study/store/trial_table.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace teleta::study {

namespace {

using nlohmann::ordered_json;

constexpr std::array<std::string_view, 4> kParticipantColumns{"participant_id", "study_id", "enrolment",
                                                              "mode"};
constexpr std::array<std::string_view, 2> kSessionColumns{"session_id", "acq_time"};
constexpr std::array<std::string_view, 2> kPhenotypeColumns{"participant_id", "session_id"};

/// A participant who has a folder, and everything of theirs.
struct Person {
    Participant participant;
    std::string label;
    std::vector<PlannedSession> plans;
    std::vector<SessionRecord> sessions;
    std::vector<StoredAnswer> answers;
};

/// isFree: people's own words are in it, which must be no formula of a spreadsheet.
core::Expected<void> writeTsv(const std::string& path, const std::vector<TrialRow>& rows,
                              std::span<const std::string_view> columns, bool isFree = false) {
    const TableFormat format{'\t', "n/a", '.', false, false, isFree};
    return writeChecked(path, tableText(rows, format, columns));
}

core::Expected<void> writeJson(const std::string& path, const ordered_json& document) {
    return writeChecked(path, core::jsonText(document));
}

/// Labels of a protocol's sessions, by task and condition: the same for everybody.
class SessionLabels {
public:
    explicit SessionLabels(const Protocol& protocol) {
        std::vector<std::string> names;
        for (const StudyTask& task : protocol.tasks) {
            m_firsts.push_back(names.size());
            for (const std::string& condition : task.conditions)
                names.push_back(alphanumeric(task.id) + alphanumeric(condition));
        }
        m_labels = alphanumericLabels(names);
    }
    [[nodiscard]] const std::string& of(std::size_t task, std::size_t condition) const {
        return m_labels.at(m_firsts.at(task) + condition);
    }
    [[nodiscard]] const std::string& of(const PlannedSession& plan) const {
        return of(plan.task, plan.condition);
    }

private:
    std::vector<std::string> m_labels;
    std::vector<std::size_t> m_firsts; ///< of each task
};

core::Expected<std::vector<Person>> peopleWithSessions(const StudyStore& store) {
    TELETA_TRY(const std::vector<Participant> participants, store.participants());
    const std::vector<std::string> labels = fileLabels(participants);
    std::vector<Person> people;
    for (std::size_t i = 0; i < participants.size(); ++i) {
        Person person{participants[i], labels[i], {}, {}, {}};
        TELETA_TRY(person.sessions, store.sessions(person.participant));
        if (person.sessions.empty())
            continue;
        TELETA_TRY(person.answers, store.answers(person.participant));
        person.plans = planSessions(store.head().protocol, store.head().seed, person.participant.enrolment);
        people.push_back(std::move(person));
    }
    return people;
}

core::Expected<void> writeDataset(const StudyHead& head, const std::vector<Person>& people,
                                  const std::string& folder) {
    ordered_json description{
        {"Name", head.protocol.name},
        {"BIDSVersion", "1.8.0"},
        {"DatasetType", "raw"},
        {"GeneratedBy", ordered_json::array({{{"Name", "TeleTA Console"}, {"Version", head.appVersion}}})}};
    if (!head.protocol.authors.empty())
        description["Authors"] = head.protocol.authors;
    TELETA_CHECK(writeJson(folder + "/dataset_description.json", description));
    std::string readme = head.protocol.name + "\n\n" + head.protocol.description + "\n\n";
    readme +=
        "A study of vibrotactile patterns on a bracelet. Each session has one task under one condition; "
        "its trials are in beh/, questionnaires in phenotype/. Mode of the data: ";
    readme += toString(head.mode);
    readme += ".\nThe columns are described in the .json files.\n";
    TELETA_CHECK(writeChecked(folder + "/README", readme));
    std::vector<TrialRow> rows;
    for (const Person& person : people)
        rows.push_back({wordCell("sub-" + person.label), wordCell(person.participant.id),
                        numberCell(person.participant.enrolment + 1), wordCell(toString(head.mode))});
    TELETA_CHECK(writeTsv(folder + "/participants.tsv", rows, kParticipantColumns));
    return writeJson(folder + "/participants.json", bidsColumns("participants.tsv", kParticipantColumns));
}

core::Expected<void> writeSession(const StudyStore& store, const Person& person, const SessionRecord& record,
                                  const SessionLabels& labels, const std::string& folder) {
    const StudyHead& head = store.head();
    const PlannedSession& plan = person.plans.at(record.planIndex);
    TELETA_TRY(const std::vector<StoredTrial> trials, store.trials(record));
    TELETA_TRY(const std::vector<StoredNote> notes, store.notes(record));
    const std::string& label = labels.of(plan);
    const std::string name = "sub-" + person.label + "_ses-" + label + "_task-" +
                             alphanumeric(head.protocol.tasks[plan.task].id) + "_beh";
    const std::string path = folder + "/ses-" + label + "/beh/" + name;
    TELETA_CHECK(
        writeTsv(path + ".tsv", trialRows(head, person.participant, record, plan, trials), kTrialColumns));
    const ordered_json session = sessionSidecar(head, plan);
    ordered_json levels = ordered_json::object();
    for (const auto& [letter, stimulus] : session["stimuli"].items())
        levels[letter] = stimulus["name"];
    ordered_json sidecar{{"TaskName", session["task"]}};
    sidecar.update(bidsColumns("trials", kTrialColumns));
    if (!levels.empty()) {
        sidecar["stimulus"]["Levels"] = levels;
        sidecar["response"]["Levels"] = std::move(levels);
    }
    sidecar["Session"] = session;
    ordered_json said = ordered_json::array();
    for (const StoredNote& note : notes)
        said.push_back(
            {{"time_utc", note.time.toString(Qt::ISODateWithMs).toStdString()}, {"note", note.text}});
    if (!said.empty())
        sidecar["Notes"] = std::move(said);
    return writeJson(path + ".json", sidecar);
}

core::Expected<void> writePerson(const StudyStore& store, const Person& person, const SessionLabels& labels,
                                 const std::string& bids) {
    const std::string folder = bids + "/sub-" + person.label;
    std::vector<TrialRow> rows;
    for (const SessionRecord& record : person.sessions) {
        TELETA_CHECK(writeSession(store, person, record, labels, folder));
        // The id begins with the UTC of its begin, 20261103T142233.
        const std::string& id = record.id;
        const std::string time = id.substr(0, 4) + '-' + id.substr(4, 2) + '-' + id.substr(6, 5) + ':' +
                                 id.substr(11, 2) + ':' + id.substr(13, 2) + 'Z';
        rows.push_back({wordCell("ses-" + labels.of(person.plans.at(record.planIndex))), wordCell(time)});
    }
    return writeTsv(folder + "/sub-" + person.label + "_sessions.tsv", rows, kSessionColumns);
}

/// A questionnaire at one place: answers of the people with a session of a task and condition, or of all
/// people when there is none.
struct Place {
    std::string suffix;  ///< of the file's name
    std::string session; ///< label; empty: of the study as a whole
    std::size_t task = 0;
    std::size_t condition = 0;
};

std::vector<ItemAnswer> answersAt(const Questionnaire& questionnaire, const Place& place,
                                  const Person& person) {
    if (place.session.empty())
        return answersTo(questionnaire, nullptr, person.answers);
    for (const SessionRecord& record : person.sessions) {
        const PlannedSession& plan = person.plans.at(record.planIndex);
        if (plan.task == place.task && plan.condition == place.condition)
            return answersTo(questionnaire, &record, person.answers);
    }
    return {};
}

TrialRow phenotypeRow(const Questionnaire& questionnaire, const Place& place, const Person& person) {
    const std::vector<ItemAnswer> given = answersAt(questionnaire, place, person);
    TrialRow row{wordCell("sub-" + person.label),
                 wordCell(place.session.empty() ? std::string() : "ses-" + place.session)};
    for (const QuestionnaireItem& item : questionnaire.items) {
        const auto answer = std::ranges::find(given, item.id, &ItemAnswer::item);
        const bool has = answer != given.end() && answer->value;
        const bool isNumber = item.kind == ItemKind::likert || item.kind == ItemKind::scale;
        row.push_back(
            has ? TrialCell{isNumber ? TrialCell::Kind::number : TrialCell::Kind::text, *answer->value}
                : TrialCell{});
    }
    for (const QuestionnaireScore& score : questionnaireScores(questionnaire, given))
        row.push_back(score.value ? numberCell(*score.value) : TrialCell{});
    return row;
}

core::Expected<void> writePhenotype(const Questionnaire& questionnaire, const std::string& name,
                                    const Place& place, const std::vector<Person>& people,
                                    const std::string& bids) {
    std::vector<std::string_view> columns(kPhenotypeColumns.begin(), kPhenotypeColumns.end());
    ordered_json tool{{"Description", questionnaire.title}};
    if (questionnaire.use != StandardQuestionnaire::none) {
        tool["Source"] = sourceOf(questionnaire.use);
        tool["LanguageShown"] = languageOf(questionnaire.use);
    }
    ordered_json sidecar{{"MeasurementToolMetadata", std::move(tool)}};
    sidecar.update(bidsColumns("phenotype", kPhenotypeColumns));
    const std::vector<CodebookEntry> entries = questionnaireEntries(questionnaire);
    for (const CodebookEntry& entry : entries) {
        columns.push_back(entry.column);
        sidecar[entry.column] = bidsColumn(entry);
    }
    std::vector<TrialRow> rows;
    for (const Person& person : people)
        rows.push_back(phenotypeRow(questionnaire, place, person));
    const std::string path = bids + "/phenotype/" + name + place.suffix;
    TELETA_CHECK(writeTsv(path + ".tsv", rows, columns, true));
    return writeJson(path + ".json", sidecar);
}

core::Expected<void> writePhenotypes(const StudyHead& head, const std::vector<Person>& people,
                                     const SessionLabels& labels, const std::string& bids) {
    const Protocol& protocol = head.protocol;
    std::vector<std::string> ids;
    for (const Questionnaire& questionnaire : protocol.questionnaires)
        ids.push_back(questionnaire.id);
    const std::vector<std::string> names = alphanumericLabels(ids);
    for (std::size_t q = 0; q < ids.size(); ++q) {
        const Questionnaire& questionnaire = protocol.questionnaires[q];
        std::vector<Place> places{{}};
        if (isOfSession(questionnaire.when)) {
            places.clear();
            for (std::size_t t = 0; t < protocol.tasks.size(); ++t) {
                for (std::size_t c = 0; c < protocol.tasks[t].conditions.size(); ++c)
                    places.push_back({'_' + labels.of(t, c), labels.of(t, c), t, c});
            }
        }
        for (const Place& place : places)
            TELETA_CHECK(writePhenotype(questionnaire, names[q], place, people, bids));
    }
    return {};
}

} // namespace

core::Expected<std::size_t> exportBids(const StudyStore& store) {
    const std::string bids = store.folder() + "/bids";
    TELETA_TRY(const std::vector<Person> people, peopleWithSessions(store));
    const SessionLabels labels(store.head().protocol);
    TELETA_CHECK(writeDataset(store.head(), people, bids));
    std::size_t sessions = 0;
    for (const Person& person : people) {
        TELETA_CHECK(writePerson(store, person, labels, bids));
        sessions += person.sessions.size();
    }
    if (!people.empty())
        TELETA_CHECK(writePhenotypes(store.head(), people, labels, bids));
    return sessions;
}

} // namespace teleta::study
