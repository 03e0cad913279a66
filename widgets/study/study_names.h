// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/protocol.h"

#include <QString>

#include <string>

namespace teleta::study {

/// Names to show: those of built-in protocols in the program's language, others as written. Files and rows
/// contain the identifiers and letters, in every language. Thread: any (pure).
[[nodiscard]] QString displayName(const StudyTask& task);
[[nodiscard]] QString displayName(const StudyTask& task, const StudyPattern& pattern);
[[nodiscard]] QString displayCondition(const StudyTask& task, const std::string& condition);

/// The unit of the levels of a task: "s", or "drive" in the language.
[[nodiscard]] QString displayUnit(Vary vary);

/// What a participant is asked in a task with levels, in the language; empty for patterns.
[[nodiscard]] QString displayQuestion(const StudyTask& task);

} // namespace teleta::study
