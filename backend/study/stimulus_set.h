// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol.h"

#include <string>
#include <vector>

namespace teleta::study {

/// Id of the tactile pattern that a task shows under a condition: "shape.A.static". Thread: any.
[[nodiscard]] std::string stimulusId(const StudyTask& task, const StudyPattern& pattern,
                                     const std::string& condition);

/// SHA-256, in hexadecimal digits, of the ids of all stimuli of a protocol and of what the built-in patterns
/// with these ids are: another value where anything that participants feel has changed. Thread: any.
[[nodiscard]] std::string stimulusSetSha256(const Protocol& protocol);

/// Ids of the stimuli of a protocol of which there are no patterns to be felt. Thread: any.
[[nodiscard]] std::vector<std::string> missingStimuli(const Protocol& protocol);

} // namespace teleta::study
