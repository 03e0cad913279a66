// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol.h"

#include <string>

namespace teleta::study {

/// Id of the tactile pattern that a task shows under a condition: "shape.A.static". Thread: any.
[[nodiscard]] std::string stimulusId(const StudyTask& task, const StudyPattern& pattern,
                                     const std::string& condition);

/// SHA-256, in hexadecimal digits, of the ids of all stimuli of a protocol and of what the built-in patterns
/// with these ids are: another value where anything that participants feel has changed. Thread: any.
[[nodiscard]] std::string stimulusSetSha256(const Protocol& protocol);

} // namespace teleta::study
