// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/store/study_store.h"

#include "backend/core/data/output_file.h"
#include "backend/core/data/private_files.h"
#include "backend/core/failure.h"
#include "backend/study/store/file_claim.h"
#include "backend/study/store/folder_owner.h"
#include "backend/study/store/store_values.h"
#include "backend/study/store/trial_journal.h"

#include <QCoreApplication>
#include <QDir>
#include <QStringList>
#include <QSysInfo>

#include <algorithm>
#include <utility>

namespace teleta::study {

namespace {

struct StoreText {
    Q_DECLARE_TR_FUNCTIONS(StoreText)
};

constexpr int kLongestId = 64;
constexpr int kMostAttempts = 100;

std::string claimFile(const std::string& folder, std::size_t enrolment) {
    return QDir(QString::fromStdString(folder))
        .filePath(QStringLiteral("running-%1.lock").arg(enrolment))
        .toStdString();
}

/// Machine and process, for people at other stations.
std::string thisStation() {
    return StoreText::tr("%1, process %2")
        .arg(QSysInfo::machineHostName())
        .arg(QCoreApplication::applicationPid())
        .toStdString();
}

} // namespace

/// Holds a locked file or a lock of the server.
struct ParticipantClaim::Hold {
    std::unique_ptr<FileClaim> file;
    std::weak_ptr<StudyConnection> server;
    long long key = 0;

    ~Hold() {
        if (const std::shared_ptr<StudyConnection> connection = server.lock())
            connection->unlock(key);
    }
};

std::optional<bool> StudyHead::stimuliChanged() const {
    return stimulusSetSha256.empty() ? std::nullopt : std::optional(stimulusSetSha256 != stimuli.sha256());
}

core::Expected<StudyStore> StudyStore::create(const StoreLocation& location, const StudyHead& head) {
    // A study needs a pattern for every stimulus.
    TELETA_TRY(const std::vector<OwnStimulus> own, readOwnStimuli(head.protocol));
    const core::PrivateFiles forOwner;
    // A bad server address fails before anything is created here.
    TELETA_CHECK(location.server.empty() ? core::makeFolder(location.folder)
                                         : checkFolderOwner(location.folder, head));
    StudyStore store(std::make_shared<StudyConnection>(location));
    StudyConnection& connection = *store.m_connection;
    TELETA_CHECK(connection.open(StudyConnection::Purpose::create));
    // The row is unique: of two programs that create the same study only one succeeds.
    const core::Expected<void> made = connection.inTransaction([&]() -> core::Expected<void> {
        TELETA_CHECK(
            connection.run(QStringLiteral("INSERT INTO study VALUES (1, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
                           {QString::fromStdString(head.protocol.source), QString::number(head.seed),
                            QString::fromLatin1(toString(head.mode)), sqlValue(head.plannedParticipants),
                            head.lapses, timeText(head.created), QString::fromStdString(head.appVersion),
                            QString::fromStdString(stimulusSetSha256(head.protocol, own)),
                            QString::fromStdString(head.observer)}));
        for (const OwnStimulus& one : own) {
            TELETA_CHECK(
                connection.run(QStringLiteral("INSERT INTO stimulus (id, file, pattern) VALUES (?, ?, ?)"),
                               {QString::fromStdString(one.id), QString::fromStdString(one.file),
                                QString::fromStdString(one.json)}));
        }
        return {};
    });
    if (!made && made.error().kind == core::ErrorKind::refused)
        return connection.isServer()
                   ? connection.refused(StoreText::tr("a study of this name already exists"),
                                        StoreText::tr("a new name, or to continue the study"))
                   : connection.refused(StoreText::tr("this folder already contains a study"),
                                        StoreText::tr("a new folder, or to continue the study"));
    TELETA_CHECK(made);
    TELETA_CHECK(store.readHead().and_then([&] { return store.ownFolder(); }));
    return store;
}

core::Expected<void> StudyStore::ownFolder() const {
    return m_connection->isServer() ? study::ownFolder(folder(), m_head, shownName())
                                    : core::Expected<void>();
}

core::Expected<StudyStore> StudyStore::openForReading(const StoreLocation& location) {
    return opened(location, StudyConnection::Purpose::read);
}

core::Expected<StudyStore> StudyStore::opened(const StoreLocation& location,
                                              StudyConnection::Purpose purpose) {
    StudyStore store(std::make_shared<StudyConnection>(location));
    TELETA_CHECK(store.m_connection->open(purpose).and_then([&] { return store.readHead(); }));
    return store;
}

core::Expected<StudyStore> StudyStore::open(const StoreLocation& location) {
    core::Expected<StudyStore> store = opened(location, StudyConnection::Purpose::open);
    if (store && !store->m_connection->isServer())
        FileClaim::removeUnheld(location.folder, "running-*.lock");
    if (store && store->m_connection->isServer()) {
        TELETA_CHECK(store->ownFolder());
        for (const long long session : TrialJournal::sessionsIn(location.folder)) {
            TELETA_CHECK(store->sendPending(session));
        }
    }
    return store;
}

core::Expected<void> StudyStore::readHead() {
    TELETA_TRY(auto query, m_connection->run(QStringLiteral(
                               "SELECT protocol, seed, mode, planned_participants, lapses, "
                               "created_utc, app_version, stimulus_set_sha256, observer FROM study")));
    if (!query.next())
        return core::failed(core::ErrorKind::badInput, StoreText::tr("the study was not created completely"),
                            {}, {m_connection->shownName()});
    core::Expected<Protocol> protocol = parseProtocol(stringOf(query.value(0)), m_connection->shownName());
    TELETA_CHECK(protocol);
    m_head.protocol = std::move(*protocol);
    m_head.seed = query.value(1).toString().toULongLong();
    m_head.mode = modeOf(stringOf(query.value(2))).value_or(Mode::run);
    m_head.plannedParticipants = count(query.value(3));
    m_head.lapses = query.value(4).toDouble();
    m_head.created = timeOf(query.value(5).toString());
    m_head.appVersion = stringOf(query.value(6));
    m_head.stimulusSetSha256 = stringOf(query.value(7));
    m_head.observer = stringOf(query.value(8));
    TELETA_TRY(auto copies,
               m_connection->run(QStringLiteral("SELECT id, file, pattern FROM stimulus ORDER BY id")));
    std::vector<OwnStimulus> own;
    while (copies.next())
        own.push_back({stringOf(copies.value(0)), stringOf(copies.value(1)), stringOf(copies.value(2))});
    core::Expected<StimulusSet> stimuli =
        StimulusSet::of(m_head.protocol, std::move(own), m_connection->shownName());
    TELETA_CHECK(stimuli);
    m_head.stimuli = std::move(*stimuli);
    return {};
}

core::Expected<Participant> StudyStore::enrol(const std::string& id) {
    const QString text = QString::fromStdString(id);
    // Exports use these words for missing values and for all participants.
    static const QStringList kReserved{QStringLiteral("NA"), QStringLiteral("n/a"), QStringLiteral("NONE"),
                                       QStringLiteral("GROUP")};
    const bool isReserved = kReserved.contains(text);
    // A terminal obeys them.
    const bool hasControls = std::any_of(text.begin(), text.end(), [](QChar c) {
        return c.category() == QChar::Other_Control && !QStringLiteral("\t\n\r").contains(c);
    });
    // Spreadsheets take these for formulas.
    const bool isFormula = !text.isEmpty() && QStringLiteral("=+-@").contains(text.front());
    if (text.trimmed().isEmpty() || text.size() > kLongestId || isReserved || hasControls || isFormula)
        return m_connection->refused(
            StoreText::tr("\"%1\" cannot name a participant").arg(text.left(kLongestId)),
            isReserved ? StoreText::tr("another name: in files, %1 means no value or all participants")
                             .arg(kReserved.join(QStringLiteral(", ")))
                       : StoreText::tr("a text of 1 to %1 characters that does not begin with = + - or @")
                             .arg(kLongestId));
    // Two stations may read the same highest number; then one of them is refused and reads again.
    for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
        const auto made = m_connection->run(
            QStringLiteral("INSERT INTO participant (id, enrolment) SELECT ?, "
                           "COALESCE(MAX(enrolment) + 1, 0) FROM (SELECT enrolment FROM participant "
                           "UNION ALL SELECT enrolment FROM deletion) AS given"),
            {text});
        if (!made && made.error().kind != core::ErrorKind::refused)
            return core::Unexpected(made.error());
        TELETA_TRY(
            auto query,
            m_connection->run(QStringLiteral("SELECT key, enrolment FROM participant WHERE id = ?"), {text}));
        const bool isThere = query.next();
        if (isThere && made)
            return Participant{query.value(0).toLongLong(), id, count(query.value(1))};
        if (isThere)
            return m_connection->refused(
                StoreText::tr("the participant \"%1\" is already enrolled").arg(text),
                StoreText::tr("another name"));
    }
    return m_connection->refused(StoreText::tr("other stations keep enrolling participants"),
                                 StoreText::tr("to try again"));
}

core::Expected<std::vector<Participant>> StudyStore::participants() const {
    TELETA_TRY(auto query, m_connection->run(QStringLiteral(
                               "SELECT key, id, enrolment FROM participant ORDER BY enrolment")));
    std::vector<Participant> all;
    while (query.next())
        all.push_back({query.value(0).toLongLong(), stringOf(query.value(1)), count(query.value(2))});
    return all;
}

core::Expected<ParticipantClaim> StudyStore::claim(const Participant& participant) {
    auto hold = std::make_shared<ParticipantClaim::Hold>();
    const auto taken = [&](const std::string& who) {
        return m_connection->refused(
            StoreText::tr("\"%1\" is already in a session at %2")
                .arg(QString::fromStdString(participant.id), QString::fromStdString(who)),
            StoreText::tr("one session of a participant at a time"));
    };
    if (m_connection->isServer()) {
        TELETA_TRY(const std::optional<std::string> who, runner(participant));
        TELETA_TRY(const bool locked, who ? false : m_connection->lock(participant.key));
        if (!locked)
            return taken(who.value_or(StoreText::tr("another station").toStdString()));
        hold->server = m_connection;
        hold->key = participant.key;
        return ParticipantClaim(std::move(hold));
    }
    const std::string path = claimFile(folder(), participant.enrolment);
    core::Expected<std::unique_ptr<FileClaim>> file = FileClaim::take(path, thisStation());
    TELETA_CHECK(file);
    if (*file == nullptr)
        return taken(FileClaim::holderOf(path).value_or(StoreText::tr("another station").toStdString()));
    hold->file = std::move(*file);
    return ParticipantClaim(std::move(hold));
}

core::Expected<std::optional<std::string>> StudyStore::runner(const Participant& participant) const {
    if (m_connection->isServer()) {
        TELETA_TRY(std::string who, m_connection->lockedBy(participant.key));
        return who.empty() ? std::optional<std::string>() : std::optional(std::move(who));
    }
    return FileClaim::holderOf(claimFile(folder(), participant.enrolment));
}

core::Expected<SessionRecord> StudyStore::beginSession(const Participant& participant, std::size_t planIndex,
                                                       const PlannedSession& plan, const QDateTime& now) {
    if (m_head.stimuliChanged().value_or(false))
        return core::failed(core::ErrorKind::refused,
                            StoreText::tr("the patterns have changed since this study was created"),
                            StoreText::tr("version %1 of the program, or a new study")
                                .arg(QString::fromStdString(m_head.appVersion)),
                            {shownName()});
    const QString second = now.toUTC().toString(QStringLiteral("yyyyMMdd'T'HHmmss"));
    constexpr int kMostRefusals = 10;
    int refusals = 0;
    for (int sameSecond = 1;; ++sameSecond) {
        TELETA_TRY(std::vector<SessionRecord> known, sessions(participant));
        bool taken = false;
        const QString id = sameSecond == 1 ? second : QStringLiteral("%1x%2").arg(second).arg(sameSecond);
        for (SessionRecord& session : known) {
            if (session.planIndex == planIndex)
                return std::move(session);
            taken = taken || session.id == id.toStdString();
        }
        if (taken)
            continue;
        const auto made = m_connection->run(
            QStringLiteral("INSERT INTO session (participant, id, plan_index, seed) VALUES (?, ?, ?, ?)"),
            {participant.key, id, sqlValue(planIndex), QString::number(plan.seed)});
        if (made)
            continue; // the next round reads it
        // Another station may just have begun this session or taken this name; the next round sees it. Any
        // other refusal comes back every time.
        if (made.error().kind != core::ErrorKind::refused || ++refusals == kMostRefusals)
            return core::Unexpected(made.error());
    }
}

core::Expected<void> StudyStore::finishSession(const SessionRecord& session) {
    TELETA_CHECK(
        m_connection->run(QStringLiteral("UPDATE session SET finished = 1 WHERE key = ?"), {session.key}));
    return {};
}

core::Expected<std::vector<SessionRecord>> StudyStore::sessions(const Participant& participant) const {
    TELETA_TRY(auto query,
               m_connection->run(QStringLiteral("SELECT key, id, plan_index, finished FROM session WHERE "
                                                "participant = ? ORDER BY plan_index"),
                                 {participant.key}));
    const std::size_t planned = planSessions(m_head.protocol, m_head.seed, participant.enrolment).size();
    std::vector<SessionRecord> all;
    while (query.next()) {
        all.push_back({query.value(0).toLongLong(), stringOf(query.value(1)), count(query.value(2)),
                       query.value(3).toInt() != 0});
        if (all.back().planIndex >= planned)
            return m_connection->damaged();
    }
    return all;
}

} // namespace teleta::study
