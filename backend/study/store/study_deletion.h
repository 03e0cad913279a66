// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/store/study_store.h"

#include <QDateTime>

#include <cstddef>
#include <string>
#include <vector>

namespace teleta::study {

/// That a participant was deleted; it says nothing of who that was.
struct Deletion {
    std::size_t enrolment = 0; ///< is not given to anybody else
    std::size_t sessions = 0;
    std::size_t trials = 0;
    std::string reason{}; ///< in the experimenter's words; may be empty
    QDateTime time{};     ///< UTC
};

/// Deletes a participant with all sessions, trials, answers and notes from a study, and records that this
/// happened. SQLite overwrites what is deleted; a server does so in its own time. Exported files: see
/// deleteFromStudy(). Error: refused while somebody runs the participant, and when the study is open for
/// reading only; notFound, ioFailed, unavailable. Thread: that of the store.
[[nodiscard]] core::Expected<Deletion> deleteParticipant(StudyStore& store, const Participant& participant,
                                                         const std::string& reason, const QDateTime& now);

/// In the order of deleting. Error: as StudyStore::openForReading(). Thread: that of the store.
[[nodiscard]] core::Expected<std::vector<Deletion>> deletions(const StudyStore& store);

} // namespace teleta::study
