// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/confusion_matrix.h"
#include "backend/study/protocol/protocol.h"
#include "backend/study/protocol/trial.h"
#include "widgets/study/session_panel.h"

#include <cstddef>
#include <vector>

namespace teleta::console {

/// The last trials of a session as they are listed, the latest first. Thread: GUI.
[[nodiscard]] std::vector<study::OutcomeLine> outcomeLines(const std::vector<study::TrialResult>& results,
                                                           const study::StudyTask& task);

/// What was answered in the complete trials of a phase. Thread: any.
[[nodiscard]] study::ConfusionMatrix confusionOf(const std::vector<study::TrialResult>& results,
                                                 study::Phase phase, std::size_t patterns);

} // namespace teleta::console
