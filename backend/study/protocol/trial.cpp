// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/trial.h"

#include "backend/core/words.h"

namespace teleta::study {

namespace {

constexpr core::Words<Phase, 2> kPhases{{"practice", "test"}};
constexpr core::Words<Outcome, 5> kOutcomes{{"correct", "incorrect", "timeout", "aborted", "device_error"}};
constexpr core::Words<Mode, 3> kModes{{"run", "pilot", "simulated"}};

} // namespace

const char* toString(Phase phase) {
    return kPhases.of(phase);
}

const char* toString(Outcome outcome) {
    return kOutcomes.of(outcome);
}

const char* toString(Mode mode) {
    return kModes.of(mode);
}

std::optional<Phase> phaseOf(std::string_view word) {
    return kPhases.find(word);
}

std::optional<Outcome> outcomeOf(std::string_view word) {
    return kOutcomes.find(word);
}

std::optional<Mode> modeOf(std::string_view word) {
    return kModes.find(word);
}

} // namespace teleta::study
