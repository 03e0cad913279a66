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
#include <vector>

namespace teleta::study {

/// What a study is, once and for all.
struct StudyHead {
    Protocol protocol;
    std::uint64_t seed = 1;
    Mode mode = Mode::run;
    std::size_t plannedParticipants = 0; ///< of a rehearsal; 0: open
    double lapses = 0.0;                 ///< of simulated participants
    QDateTime created;                   ///< UTC
    std::string appVersion;
    std::string stimulusSetSha256; ///< stimulusSetSha256() of the protocol when the study was made
    StimulusSet stimuli;           ///< as the store has them; create() reads those that the protocol names

    /// The patterns of this program are not those with which the study was made; empty: nobody knows, since
    /// the first programs did not keep that.
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

/// Answers to a questionnaire, as they were kept.
struct StoredAnswer {
    std::optional<long long> session; ///< key; empty for those of a participant as a whole
    std::string questionnaire;
    std::string item;
    std::optional<std::string> value; ///< empty: left out
    QDateTime time;                   ///< UTC
};

/// Keeps everybody else from running a participant, as long as it lives; a program that ends in any way, or
/// loses the server, frees it too. It may outlive its store.
class ParticipantClaim {
public:
    ~ParticipantClaim();
    ParticipantClaim(ParticipantClaim&&) noexcept;
    ParticipantClaim& operator=(ParticipantClaim&&) noexcept;

private:
    friend class StudyStore;
    struct Hold;
    explicit ParticipantClaim(std::unique_ptr<Hold> hold);
    std::unique_ptr<Hold> m_hold;
};

/// The truth of a study: one SQLite file, study.sqlite, in the folder of the study. Write-ahead log,
/// synchronous FULL, one transaction a trial: whatever was reported as kept is there after a crash of the
/// program or of the machine. Unique keys refuse what is there already; nothing is ever overwritten.
/// Several stations share a study on a PostgreSQL server (StoreLocation); their exports stay in their
/// folders. When the server is away, every call tries once to reach it and else fails with
/// ErrorKind::unavailable. Thread: the one that made it; several processes may have the same study open.
class StudyStore {
public:
    /// Makes the folder and the store, with copies of the pattern files that the protocol names. Error:
    /// refused when there is a study already, what readOwnStimuli() reports, ioFailed, unavailable.
    [[nodiscard]] static core::Expected<StudyStore> create(const StoreLocation& location,
                                                           const StudyHead& head);

    /// Opens a store, brings its schema up to date, and sends trials that wait in the folder to the server.
    /// The folder of a study on a server is made once the study is found, and marked as its own.
    /// Error: notFound, badInput when the file is no study, refused when a newer program made it or the
    /// folder is another study's, ioFailed, unavailable.
    [[nodiscard]] static core::Expected<StudyStore> open(const StoreLocation& location);

    /// The same for somebody who only reads and does not touch the folder, beside the one who runs the study:
    /// trials that wait stay the other's to send. Also where nothing can be written, a read-only medium for
    /// example; a study that was interrupted and one of an older program have to be copied from there first.
    [[nodiscard]] static core::Expected<StudyStore> openForReading(const StoreLocation& location);

    ~StudyStore();
    StudyStore(StudyStore&&) noexcept;
    StudyStore& operator=(StudyStore&&) noexcept;

    [[nodiscard]] const StudyHead& head() const { return m_head; }
    [[nodiscard]] const StoreLocation& location() const;
    [[nodiscard]] const std::string& folder() const;
    /// Opened for reading: whatever would write is refused.
    [[nodiscard]] bool isReadOnly() const;
    /// The file, or the server without any password: for people.
    [[nodiscard]] const std::string& shownName() const;

    /// For a study on a server: makes sure that nothing of another study is in its folder, and marks it.
    /// Error: refused when it is another study's; ioFailed.
    [[nodiscard]] core::Expected<void> ownFolder() const;

    /// id: any text of 1 to 64 characters but NA, n/a, NONE and GROUP. Error: refused when it is there
    /// already or not fit, ioFailed.
    [[nodiscard]] core::Expected<Participant> enrol(const std::string& id);
    [[nodiscard]] core::Expected<std::vector<Participant>> participants() const;

    /// Takes a participant for a session. Error: refused when somebody has him, naming who.
    [[nodiscard]] core::Expected<ParticipantClaim> claim(const Participant& participant);
    /// Who runs a participant now, this program too; empty: nobody.
    [[nodiscard]] core::Expected<std::optional<std::string>> runner(const Participant& participant) const;

    /// The session of a place in the participant's plan; begun now unless it is there already.
    [[nodiscard]] core::Expected<SessionRecord> beginSession(const Participant& participant,
                                                             std::size_t planIndex,
                                                             const PlannedSession& plan,
                                                             const QDateTime& now);
    [[nodiscard]] core::Expected<void> finishSession(const SessionRecord& session);
    [[nodiscard]] core::Expected<std::vector<SessionRecord>> sessions(const Participant& participant) const;

    /// Keeps a result; it is safe when this returns. ended: UTC of the trial's end. Error: refused when this
    /// attempt of the trial is there already, ioFailed; unavailable when the server is away: then the trial
    /// is safe in the folder with that time, and the same call, or opening the study again, sends it once the
    /// server is back.
    [[nodiscard]] core::Expected<void> keepTrial(const SessionRecord& session, const TrialResult& result,
                                                 const QDateTime& ended);
    /// In the order in which they were kept.
    [[nodiscard]] core::Expected<std::vector<StoredTrial>> trials(const SessionRecord& session) const;

    /// Error: ioFailed, unavailable.
    [[nodiscard]] core::Expected<void> keepNote(const SessionRecord& session, const std::string& text,
                                                const QDateTime& now);
    /// In the order in which they were kept.
    [[nodiscard]] core::Expected<std::vector<StoredNote>> notes(const SessionRecord& session) const;

    /// Keeps all answers of a questionnaire, or none. session: the one that it belongs to; empty for those of
    /// a participant as a whole. The same answers once more are kept already. Error: refused when others are
    /// there already or they do not fit, ioFailed, unavailable.
    [[nodiscard]] core::Expected<void> keepAnswers(const Participant& participant,
                                                   const std::optional<SessionRecord>& session,
                                                   const Questionnaire& questionnaire,
                                                   const std::vector<ItemAnswer>& answers,
                                                   const QDateTime& now);
    /// In the order in which they were kept.
    [[nodiscard]] core::Expected<std::vector<StoredAnswer>> answers(const Participant& participant) const;

private:
    explicit StudyStore(std::shared_ptr<StudyConnection> connection);
    [[nodiscard]] static core::Expected<StudyStore> opened(const StoreLocation& location,
                                                           StudyConnection::Purpose purpose);
    [[nodiscard]] core::Expected<void> readHead();
    [[nodiscard]] core::Expected<void> insertTrial(long long session, const StoredTrial& trial);
    [[nodiscard]] core::Expected<void> insertUnlessKept(long long session, const StoredTrial& trial);
    [[nodiscard]] core::Expected<void> sendPending(long long session);
    [[nodiscard]] core::Expected<void> keepOnServer(const SessionRecord& session, const StoredTrial& trial);

    std::shared_ptr<StudyConnection> m_connection;
    StudyHead m_head;
    bool m_unsure = false; ///< the server went away before it said whether it has the last trial
};

} // namespace teleta::study
