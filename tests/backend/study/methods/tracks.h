// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/methods/adaptive/track.h"

#include <string_view>
#include <vector>

namespace teleta::study {

/// The trials of a track whose answers are given as digits (1 correct, 0 wrong), at the levels that the
/// procedure asked for. Answers after the end are left out.
inline std::vector<KeptTrial> answeredTrials(const Procedure& procedure, const LevelRange& range,
                                             std::string_view answers) {
    std::vector<KeptTrial> kept;
    for (const char answer : answers) {
        const TrackStep step = nextStep(procedure, range, 1, kept);
        const auto* next = std::get_if<NextLevel>(&step);
        if (next == nullptr)
            break;
        kept.push_back({next->level, answer == '1' ? 0U : 1U, answer == '1'});
    }
    return kept;
}

} // namespace teleta::study
