// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/store/study_deletion.h"

#include <QDateTime>

#include <cstddef>
#include <string>
#include <vector>

namespace teleta::study {

/// What became of a participant who was deleted.
struct DeletedParticipant {
    Deletion record;
    std::size_t files = 0;          ///< exports, recordings and reports that were removed
    std::vector<std::string> stale; ///< results in the study's folder that were computed before
};

/// Deletes a participant from a study: exports in every format, recordings and reports in its folder, and
/// then everything in the store. When a file cannot be removed the store is left as it is, and the call can
/// be repeated. Exports of the others are written again, since some have a row of each participant. Results
/// that were computed before, and copies elsewhere, are not touched. Error: notFound when there is no
/// participant of this name; ioFailed; as deleteParticipant(). Thread: that of the store.
[[nodiscard]] core::Expected<DeletedParticipant>
deleteFromStudy(StudyStore& store, const std::string& id, const std::string& reason, const QDateTime& now);

} // namespace teleta::study
