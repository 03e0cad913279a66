// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/protocol/questionnaire.h"
#include "backend/study/protocol/trial_order.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::study {

/// Practice or test of one condition.
struct PhaseSettings {
    std::size_t repetitions = 0; ///< of each pattern; 0: the phase is left out
    bool feedback = false;       ///< the right answer is shown after each trial
    bool diagram = false;        ///< the pictures of the patterns are in view during the trials
};

/// Rests within a phase, so that skin and attention recover.
struct RestSettings {
    std::size_t everyTrials = 0; ///< completed ones of the phase; 0: no rests
    double atLeast_s = 0.0;      ///< the participant may not go on before
    /// After so many completed trials of a phase that has more.
    [[nodiscard]] bool isDueAfter(std::size_t completed) const {
        return everyTrials > 0 && completed > 0 && completed % everyTrials == 0;
    }
};

/// Patterns that a task has at most: each is answered by one digit.
inline constexpr std::size_t kMostPatterns = 9;

struct StudyPattern {
    std::string letter; ///< what rows have: A, B, ..
    std::string name;
    /// Files of one's own tactile patterns, by condition; a condition without one has the built-in pattern.
    std::map<std::string, std::string> files = {};
};

/// What the participants discriminate, under some conditions. The stimulus of a pattern under a condition is
/// the tactile pattern with the id "task.letter.condition".
struct StudyTask {
    std::string id;
    std::string name;
    std::vector<StudyPattern> patterns;
    std::vector<std::string> conditions;
};

/// When the time to answer begins. Response times are from the onset in either case.
enum class ResponseWindow { fromOnset, fromEnd };

/// A study as its file describes it.
struct Protocol {
    std::string name;
    std::string description;
    double stimulus_s = 2.0;
    double responseLimit_s = 10.0;
    ResponseWindow window = ResponseWindow::fromOnset;
    std::size_t replays = 0; ///< how often a participant may feel a stimulus again
    OrderMethod order = OrderMethod::fullRandom;
    PhaseSettings practice;
    PhaseSettings test;
    RestSettings rest;
    std::string noiseColour; ///< "pink", or "none"
    double noise_dBA = 0.0;
    std::vector<StudyTask> tasks;
    std::vector<Questionnaire> questionnaires;
    std::string source; ///< text of the file, kept with the study

    /// Trials of the test phase that one participant goes through.
    [[nodiscard]] std::size_t testTrials() const;
};

/// Reads a protocol (TOML). Unknown keys, keys without their unit, wrong types, values out of range, and
/// letters or conditions that occur twice are errors with file, line, column and what was expected. Pattern
/// files that it names are looked for beside it; they are not read. Error: notFound, ioFailed, badInput.
/// Thread: any.
[[nodiscard]] core::Expected<Protocol> readProtocol(const std::string& path);

/// The same from text; file is the name that errors show. Paths of pattern files stay as they are.
[[nodiscard]] core::Expected<Protocol> parseProtocol(std::string_view text, const std::string& file);

/// The protocol of the paper: shape (6 patterns) and stiffness (5), each static and dynamic; 18 and 15
/// practice, 30 and 25 test trials. It is the resource :/studies/teleta.toml. Thread: any.
[[nodiscard]] core::Expected<Protocol> paperProtocol();

/// All protocols that come with the program (:/studies/NAME.toml), the paper's first. Thread: any.
[[nodiscard]] core::Expected<std::vector<Protocol>> builtInProtocols();

/// One participant's way through a condition of a task.
struct PlannedSession {
    std::size_t task = 0;
    std::size_t condition = 0;         ///< index in the task's conditions
    std::size_t conditionPosition = 0; ///< from 0: how many conditions of this task came before
    std::size_t sequenceRow = 0;       ///< row of the Williams square
    std::uint64_t seed = 0;
    std::vector<std::size_t> practice; ///< patterns in their order
    std::vector<std::size_t> test;
};

/// All sessions of the participant who is enrolled as number `enrolment` (from 0): tasks as in the protocol,
/// conditions by Williams square. Depends on nothing but its arguments. Thread: any.
[[nodiscard]] std::vector<PlannedSession> planSessions(const Protocol& protocol, std::uint64_t studySeed,
                                                       std::size_t enrolment);

} // namespace teleta::study
