// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/trial.h"

#include <initializer_list>

namespace teleta::study {

namespace {

template <typename Value>
std::optional<Value> valueOf(const std::string& word, std::initializer_list<Value> values) {
    for (const Value value : values) {
        if (word == toString(value))
            return value;
    }
    return std::nullopt;
}

} // namespace

const char* toString(Phase phase) {
    return phase == Phase::practice ? "practice" : "test";
}

const char* toString(Outcome outcome) {
    switch (outcome) {
    case Outcome::correct:
        return "correct";
    case Outcome::incorrect:
        return "incorrect";
    case Outcome::timeout:
        return "timeout";
    case Outcome::aborted:
        return "aborted";
    case Outcome::deviceError:
        return "device_error";
    }
    return "";
}

const char* toString(Mode mode) {
    switch (mode) {
    case Mode::run:
        return "run";
    case Mode::pilot:
        return "pilot";
    case Mode::simulated:
        return "simulated";
    }
    return "";
}

std::optional<Phase> phaseOf(const std::string& word) {
    return valueOf(word, {Phase::practice, Phase::test});
}

std::optional<Outcome> outcomeOf(const std::string& word) {
    return valueOf(word, {Outcome::correct, Outcome::incorrect, Outcome::timeout, Outcome::aborted,
                          Outcome::deviceError});
}

std::optional<Mode> modeOf(const std::string& word) {
    return valueOf(word, {Mode::run, Mode::pilot, Mode::simulated});
}

} // namespace teleta::study
