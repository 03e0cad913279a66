// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/scenes/study_people.h"

#include "app/cli/base/command_io.h"
#include "app/cli/base/options.h"
#include "backend/core/failure.h"
#include "backend/study/report/exports/participant_deletion.h"
#include "backend/study/store/pseudonym_key.h"
#include "backend/study/store/study_store.h"

#include <QCoreApplication>
#include <QDateTime>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace teleta::cli {

namespace {

struct PeopleText {
    Q_DECLARE_TR_FUNCTIONS(StudyPeople)
};

} // namespace

void StudyPeople::declareCommon(CLI::App& app) {
    addOption(app, "study", m_folder, PeopleText::tr("Folder of the study"), "DIR")->required();
    addOption(
        app, "--store", m_server,
        PeopleText::tr("PostgreSQL server that has the study, postgresql://USER@HOST/DATABASE?study=NAME"),
        "URL");
    declareJson(app, m_json);
}

void StudyPeople::declareKey(CLI::App& app, const char* about) {
    addOption(app, "--key", m_keyPath, PeopleText::tr(about), "KEY.csv");
}

void StudyPeople::declareList(CLI::App& app) {
    declareCommon(app);
    declareKey(app, QT_TRANSLATE_NOOP("StudyPeople", "Also say who is behind the pseudonyms"));
}

void StudyPeople::declareEnrol(CLI::App& app) {
    declareCommon(app);
    addOption(app, "--participant", m_participant,
              PeopleText::tr("Name of the participant in the study; otherwise a pseudonym at random"), "ID");
    declareKey(app,
               QT_TRANSLATE_NOOP("StudyPeople",
                                 "File that keeps who is behind the pseudonyms, for you alone; not in the "
                                 "study's folder"));
    addOption(app, "--name", m_name, PeopleText::tr("Name of the person, for the key"), "NAME");
    addOption(app, "--note", m_note, PeopleText::tr("How to reach the person, for the key"), "TEXT");
}

void StudyPeople::declareDelete(CLI::App& app) {
    declareCommon(app);
    addOption(app, "--participant", m_participant, PeopleText::tr("Whom to delete"), "ID")->required();
    declareKey(app, QT_TRANSLATE_NOOP("StudyPeople", "Delete the person from this key as well"));
    addOption(app, "--reason", m_reason,
              PeopleText::tr("Why, for the record that stays; without anything that tells who it was"),
              "TEXT");
    addFlag(app, "--yes", m_yes, PeopleText::tr("Really delete: this cannot be undone"));
}

core::Expected<void> StudyPeople::list() const {
    TELETA_TRY(const study::StudyStore store, study::StudyStore::openForReading({m_folder, m_server}));
    TELETA_TRY(const std::vector<study::Participant> participants, store.participants());
    TELETA_TRY(const std::vector<study::Deletion> deletions, study::deletions(store));
    std::optional<study::PseudonymKey> key;
    if (!m_keyPath.empty()) {
        TELETA_TRY(key, study::PseudonymKey::open(m_keyPath, m_folder));
    }
    nlohmann::ordered_json people = nlohmann::ordered_json::array();
    Fields fields;
    for (const study::Participant& participant : participants) {
        TELETA_TRY(const std::vector<study::SessionRecord> sessions, store.sessions(participant));
        std::size_t trials = 0;
        std::size_t finished = 0;
        for (const study::SessionRecord& session : sessions) {
            TELETA_TRY(const std::vector<study::StoredTrial> kept, store.trials(session));
            trials += kept.size();
            finished += session.finished ? 1 : 0;
        }
        const std::optional<study::KeyEntry> person = key ? key->find(participant.id) : std::nullopt;
        nlohmann::ordered_json line{{"participant", participant.id},
                                    {"sessions", sessions.size()},
                                    {"finished", finished},
                                    {"trials", trials}};
        if (key)
            line["name"] = person ? textOrNull(person->name) : nullptr;
        people.push_back(std::move(line));
        QString text = PeopleText::tr("%n session(s)", nullptr, static_cast<int>(sessions.size())) +
                       QStringLiteral(", ") +
                       PeopleText::tr("%n trial(s)", nullptr, static_cast<int>(trials));
        if (person)
            text += QStringLiteral(", ") + QString::fromStdString(person->name);
        fields.emplace_back(QString::fromStdString(participant.id), text);
    }
    nlohmann::ordered_json gone = nlohmann::ordered_json::array();
    for (const study::Deletion& deletion : deletions) {
        gone.push_back({{"enrolment", deletion.enrolment + 1},
                        {"sessions", deletion.sessions},
                        {"trials", deletion.trials},
                        {"reason", textOrNull(deletion.reason)},
                        {"time_utc", deletion.time.toString(Qt::ISODateWithMs).toStdString()}});
        fields.emplace_back(PeopleText::tr("Deleted"),
                            PeopleText::tr("number %1 of the enrolment, on %2, %n trial(s)", nullptr,
                                           static_cast<int>(deletion.trials))
                                .arg(deletion.enrolment + 1)
                                .arg(deletion.time.toString(Qt::ISODate)));
    }
    if (m_json)
        return printDocument({{"participants", std::move(people)}, {"deleted", std::move(gone)}});
    if (fields.empty())
        fields.emplace_back(PeopleText::tr("Nobody is enrolled."), QString());
    return printFields(fields);
}

core::Expected<void> StudyPeople::enrol() const {
    if (m_keyPath.empty() && !(m_name.empty() && m_note.empty()))
        refuse("--name",
               PeopleText::tr("the key that keeps it is missing: --key with a file apart from the study"));
    if (!m_keyPath.empty() && m_name.empty())
        refuse("--key", PeopleText::tr("the name of the person is missing: --name"));
    TELETA_TRY(study::StudyStore store, study::StudyStore::open({m_folder, m_server}));
    TELETA_TRY(const std::vector<study::Participant> participants, store.participants());
    std::vector<std::string> taken;
    for (const study::Participant& participant : participants)
        taken.push_back(participant.id);
    std::optional<study::PseudonymKey> key;
    if (!m_keyPath.empty()) {
        TELETA_TRY(key, study::PseudonymKey::open(m_keyPath, m_folder));
        for (const study::KeyEntry& entry : key->entries())
            taken.push_back(entry.pseudonym);
    }
    const std::string id = m_participant.empty() ? study::randomPseudonym(taken) : m_participant;
    // The key first: a person without data does less harm than data of nobody.
    if (key)
        TELETA_CHECK(key->add({id, m_name, m_note, QDateTime::currentDateTimeUtc()}));
    const core::Expected<study::Participant> enrolled = store.enrol(id);
    if (!enrolled) {
        if (key)
            (void)key->remove(id);
        return core::Unexpected(enrolled.error());
    }
    if (m_json)
        return printDocument({{"participant", id}, {"enrolment", enrolled->enrolment + 1}});
    return printFields(
        {{PeopleText::tr("Participant"), QString::fromStdString(id)},
         {PeopleText::tr("Number of the enrolment"), QString::number(enrolled->enrolment + 1)}});
}

core::Expected<void> StudyPeople::remove() const {
    if (!m_yes)
        refuse("--yes",
               PeopleText::tr(
                   "it is missing, and all sessions, answers, notes, recordings and exported files of "
                   "\"%1\" would be deleted, which cannot be undone")
                   .arg(QString::fromStdString(m_participant)));
    TELETA_TRY(study::StudyStore store, study::StudyStore::open({m_folder, m_server}));
    std::optional<study::PseudonymKey> key;
    if (!m_keyPath.empty()) {
        TELETA_TRY(key, study::PseudonymKey::open(m_keyPath, m_folder));
    }
    TELETA_TRY(const study::DeletedParticipant deleted,
               study::deleteFromStudy(store, m_participant, m_reason, QDateTime::currentDateTimeUtc()));
    bool wasInKey = false;
    if (key) {
        TELETA_TRY(wasInKey, key->remove(m_participant));
    }
    if (m_json)
        return printDocument({{"enrolment", deleted.record.enrolment + 1},
                              {"sessions", deleted.record.sessions},
                              {"trials", deleted.record.trials},
                              {"files", deleted.files},
                              {"in_key", wasInKey},
                              {"stale_results", deleted.stale}});
    Fields fields{
        {PeopleText::tr("Deleted"),
         PeopleText::tr("%n trial(s)", nullptr, static_cast<int>(deleted.record.trials))},
        {PeopleText::tr("Removed"), PeopleText::tr("%n file(s)", nullptr, static_cast<int>(deleted.files))}};
    if (key)
        fields.emplace_back(PeopleText::tr("Key"), wasInKey ? PeopleText::tr("the person was deleted")
                                                            : PeopleText::tr("has no such person"));
    for (const std::string& path : deleted.stale)
        fields.emplace_back(PeopleText::tr("Still counts the participant"), QString::fromStdString(path));
    if (!deleted.stale.empty())
        fields.emplace_back(QString(),
                            PeopleText::tr("Analyze the study again, and delete what was copied elsewhere."));
    return printFields(fields);
}

} // namespace teleta::cli
