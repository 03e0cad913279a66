// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/store/study_store.h"

#include <string>

namespace teleta::study {

enum class ReportReader {
    experimenter, ///< every session with its numbers, answers to questionnaires, notes
    participant,  ///< plain words about what they felt and answered; nobody's notes, no statistics
};

/// One participant's data as one self-contained HTML 5 page, without anybody else's. Data that are not of a
/// run are marked as such for either reader. id: of the participant. Error: notFound when the study has no
/// such participant; what the store reports. Thread: that of the store.
[[nodiscard]] core::Expected<std::string> participantReport(const StudyStore& store, const std::string& id,
                                                            ReportReader reader);

} // namespace teleta::study
