// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/protocol.h"
#include "backend/study/trial.h"

#include <QDateTime>
#include <QSqlDatabase>

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

/// The truth of a study: one SQLite file, study.sqlite, in the folder of the study. Write-ahead log,
/// synchronous FULL, one transaction a trial: whatever was reported as kept is there after a crash of the
/// program or of the machine. Unique keys refuse what is there already; nothing is ever overwritten.
/// Thread: the one that made it; several processes may have the same study open.
class StudyStore {
public:
    /// Makes the folder and the store. Error: refused when there is a study already, ioFailed.
    [[nodiscard]] static core::Expected<StudyStore> create(const std::string& folder, const StudyHead& head);

    /// Opens a store and brings its schema up to date. Error: notFound, badInput when the file is no study,
    /// refused when a newer program made it, ioFailed.
    [[nodiscard]] static core::Expected<StudyStore> open(const std::string& folder);

    ~StudyStore();
    StudyStore(StudyStore&&) noexcept;
    StudyStore& operator=(StudyStore&&) noexcept;

    [[nodiscard]] const StudyHead& head() const { return m_head; }
    [[nodiscard]] const std::string& folder() const { return m_folder; }

    /// id: any text of 1 to 64 characters but NA, n/a, NONE and GROUP. Error: refused when it is there
    /// already or not fit, ioFailed.
    [[nodiscard]] core::Expected<Participant> enrol(const std::string& id);
    [[nodiscard]] core::Expected<std::vector<Participant>> participants() const;

    /// The session of a place in the participant's plan; begun now unless it is there already.
    [[nodiscard]] core::Expected<SessionRecord> beginSession(const Participant& participant,
                                                             std::size_t planIndex,
                                                             const PlannedSession& plan,
                                                             const QDateTime& now);
    [[nodiscard]] core::Expected<void> finishSession(const SessionRecord& session);
    [[nodiscard]] core::Expected<std::vector<SessionRecord>> sessions(const Participant& participant) const;

    /// Keeps a result; it is safe when this returns. Error: refused when this attempt of the trial is there
    /// already, ioFailed.
    [[nodiscard]] core::Expected<void> keepTrial(const SessionRecord& session, const TrialResult& result,
                                                 const QDateTime& now);
    /// In the order in which they were kept.
    [[nodiscard]] core::Expected<std::vector<StoredTrial>> trials(const SessionRecord& session) const;

private:
    class Connection;
    StudyStore(std::string folder, std::unique_ptr<Connection> connection);
    [[nodiscard]] core::Expected<void> readHead();

    std::string m_folder;
    std::unique_ptr<Connection> m_connection;
    StudyHead m_head;
};

} // namespace teleta::study
