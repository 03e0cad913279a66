// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/keys/keys.h"
#include "backend/study/protocol/protocol.h"

namespace teleta::study {

/// Describes the keys that tasks of this design have besides id, name, design and condition: question,
/// tracks, stimulus, level, procedure. Everything that does not go together is refused at its key. Fills the
/// answers of the design into task.patterns. protocol: what was read before the tasks.
void describeLevelTask(core::Keys& keys, StudyTask& task, const Protocol& protocol);

} // namespace teleta::study
