// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/protocol/protocol.h"
#include "backend/study/protocol/stimulus_set.h"
#include "backend/study/protocol/trial.h"
#include "backend/study/store/study_connection.h"

#include <QDateTime>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace teleta::study {

/// What is fixed when a study is created.
struct StudyHead {
    Protocol protocol;
    std::uint64_t seed = 1;
    Mode mode = Mode::run;
    std::size_t plannedParticipants = 0; ///< of a rehearsal; 0: open
    double lapses = 0.0;                 ///< of simulated participants
    std::string observer; ///< of simulated participants: SimulatedObserver in words; empty: the usual one
    QDateTime created;    ///< UTC
    std::string appVersion;
    std::string stimulusSetSha256; ///< stimulusSetSha256() of the protocol when the study was made
    StimulusSet stimuli;           ///< as the store has them; create() reads those that the protocol names

    /// The patterns of this program differ from those with which the study was created; empty: unknown, since
    /// the first programs did not store that.
    [[nodiscard]] std::optional<bool> stimuliChanged() const;
};

struct Participant {
    long long key = 0;
    std::string id;
    std::size_t enrolment = 0; ///< from 0, in the order of enrolment
};

struct SessionRecord {
    long long key = 0;
    std::string id;            ///< UTC of its begin, 20261103T142233; with x2, x3 .. for more in one second
    std::size_t planIndex = 0; ///< place in planSessions() of the participant
    bool finished = false;
};

struct StoredTrial {
    TrialResult result;
    QDateTime time; ///< UTC of its end
};

/// What the experimenter wrote down during a session.
struct StoredNote {
    std::string text;
    QDateTime time; ///< UTC
};

/// A stored answer to a questionnaire.
struct StoredAnswer {
    std::optional<long long> session; ///< key; empty for a participant as a whole
    std::string questionnaire;
    std::string item;
    std::optional<std::string> value; ///< empty: left out
    QDateTime time;                   ///< UTC
};

/// Keeps everybody else from running a participant while it exists; it is also released when the program ends
/// in any way, or loses the server. Copies share it. It may outlive its store.
class ParticipantClaim {
    friend class StudyStore;
    struct Hold;
    explicit ParticipantClaim(std::shared_ptr<const Hold> hold)
        : m_hold(std::move(hold)) {}
    std::shared_ptr<const Hold> m_hold;
};

/// The data of a study: one SQLite file, study.sqlite, in the study's folder. Write-ahead log, synchronous
/// FULL, one transaction per trial: whatever was reported as kept survives a crash of the program or of the
/// machine. Unique keys refuse duplicates; nothing is ever overwritten. Several stations can share a study on
/// a PostgreSQL server (StoreLocation); exports stay in their folders. When the server is unreachable, every
/// call tries to reach it once and then fails with ErrorKind::unavailable. Thread: the one that made it;
/// several processes may have the same study open.
class StudyStore {
public:
    StudyStore(StudyStore&&) = default;
    StudyStore& operator=(StudyStore&&) = default;

    /// Creates the folder and the store, with copies of the pattern files that the protocol names. Error:
    /// refused when a study exists, what readOwnStimuli() reports, ioFailed, unavailable.
    [[nodiscard]] static core::Expected<StudyStore> create(const StoreLocation& location,
                                                           const StudyHead& head);

    /// Opens a store, upgrades its schema, and sends trials that are pending in the folder to the server. The
    /// folder of a study on a server is created once the study is found, and marked as its own. Error:
    /// notFound, badInput when the file is not a study, refused when a newer program made it or the folder
    /// belongs to another study, ioFailed, unavailable.
    [[nodiscard]] static core::Expected<StudyStore> open(const StoreLocation& location);

    /// Opens a store for reading, without touching the folder, even while somebody runs the study; pending
    /// trials are not sent. Works on read-only media too, except for interrupted studies and those of older
    /// programs, which have to be copied first.
    [[nodiscard]] static core::Expected<StudyStore> openForReading(const StoreLocation& location);

    [[nodiscard]] const StudyHead& head() const { return m_head; }
    [[nodiscard]] const StoreLocation& location() const { return m_connection->location(); }
    [[nodiscard]] const std::string& folder() const { return location().folder; }
    /// Opened for reading: writes are refused.
    [[nodiscard]] bool isReadOnly() const { return m_connection->isReadOnly(); }
    /// The file, or the server without any password: for people.
    [[nodiscard]] const std::string& shownName() const { return m_connection->shownName(); }

    /// For a study on a server: checks that its folder does not belong to another study, and marks it. Error:
    /// refused when it does; ioFailed.
    [[nodiscard]] core::Expected<void> ownFolder() const;

    /// id: any text of 1 to 64 characters except NA, n/a, NONE and GROUP. Error: refused when it is taken or
    /// not valid, ioFailed.
    [[nodiscard]] core::Expected<Participant> enrol(const std::string& id);
    [[nodiscard]] core::Expected<std::vector<Participant>> participants() const;

    /// Claims a participant for a session. Error: refused when somebody else has the claim, naming who.
    [[nodiscard]] core::Expected<ParticipantClaim> claim(const Participant& participant);
    /// Who runs a participant now, possibly this program; empty: nobody.
    [[nodiscard]] core::Expected<std::optional<std::string>> runner(const Participant& participant) const;

    /// The session at a place in the participant's plan; it begins now unless it exists.
    [[nodiscard]] core::Expected<SessionRecord> beginSession(const Participant& participant,
                                                             std::size_t planIndex,
                                                             const PlannedSession& plan,
                                                             const QDateTime& now);
    [[nodiscard]] core::Expected<void> finishSession(const SessionRecord& session);
    [[nodiscard]] core::Expected<std::vector<SessionRecord>> sessions(const Participant& participant) const;

    /// Stores a result; it is safe when this returns. ended: UTC of the trial's end. Error: refused when this
    /// attempt of the trial exists, ioFailed; unavailable when the server is unreachable: then the trial is
    /// safe in the folder with that time, and the same call, or opening the study again, sends it once the
    /// server is back.
    [[nodiscard]] core::Expected<void> keepTrial(const SessionRecord& session, const TrialResult& result,
                                                 const QDateTime& ended);
    /// In the order of storing.
    [[nodiscard]] core::Expected<std::vector<StoredTrial>> trials(const SessionRecord& session) const;

    /// Error: ioFailed, unavailable.
    [[nodiscard]] core::Expected<void> keepNote(const SessionRecord& session, const std::string& text,
                                                const QDateTime& now);
    /// In the order of storing.
    [[nodiscard]] core::Expected<std::vector<StoredNote>> notes(const SessionRecord& session) const;

    /// Stores all answers of a questionnaire, or none. session: the one that it belongs to; empty for those
    /// of a participant as a whole. Storing the same answers again succeeds. Error: refused when different
    /// ones exist or they are not valid, ioFailed, unavailable.
    [[nodiscard]] core::Expected<void> keepAnswers(const Participant& participant,
                                                   const std::optional<SessionRecord>& session,
                                                   const Questionnaire& questionnaire,
                                                   const std::vector<ItemAnswer>& answers,
                                                   const QDateTime& now);
    /// In the order of storing.
    [[nodiscard]] core::Expected<std::vector<StoredAnswer>> answers(const Participant& participant) const;

private:
    explicit StudyStore(std::shared_ptr<StudyConnection> connection)
        : m_connection(std::move(connection)) {}
    [[nodiscard]] static core::Expected<StudyStore> opened(const StoreLocation& location,
                                                           StudyConnection::Purpose purpose);
    [[nodiscard]] core::Expected<void> readHead();
    [[nodiscard]] core::Expected<void> insertTrial(long long session, const StoredTrial& trial);
    [[nodiscard]] core::Expected<void> insertUnlessKept(long long session, const StoredTrial& trial);
    [[nodiscard]] core::Expected<void> sendPending(long long session);
    [[nodiscard]] core::Expected<void> keepOnServer(const SessionRecord& session, const StoredTrial& trial);

    std::shared_ptr<StudyConnection> m_connection;
    StudyHead m_head;
    bool m_unsure = false; ///< the server was lost before it confirmed the last trial
};

} // namespace teleta::study
