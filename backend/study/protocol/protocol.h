// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/trigger_port.h"
#include "backend/core/error.h"
#include "backend/study/protocol/exclusion_rule.h"
#include "backend/study/protocol/level_task.h"
#include "backend/study/protocol/questionnaire.h"
#include "backend/study/protocol/trial_order.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::study {

/// Settings of practice or test.
struct PhaseSettings {
    std::size_t repetitions = 0; ///< of each pattern; 0: the phase is skipped
    bool feedback = false;       ///< the right answer is shown after each trial
    bool diagram = false;        ///< the pictures of the patterns are in view during the trials
};

/// Rests within a phase, so that skin and attention recover.
struct RestSettings {
    std::size_t everyTrials = 0; ///< completed in the phase; 0: no rests
    double atLeast_s = 0.0;      ///< the shortest rest
    /// completed: trials of a phase that has more to come.
    [[nodiscard]] bool isDueAfter(std::size_t completed) const {
        return everyTrials > 0 && completed > 0 && completed % everyTrials == 0;
    }
};

/// The most patterns of a task: each is answered by one digit.
inline constexpr std::size_t kMostPatterns = 9;

struct StudyPattern {
    std::string letter; ///< what rows have: A, B, ..
    std::string name;
    /// Files of custom tactile patterns, or ids of built-in ones, by condition; other conditions use the
    /// built-in pattern of this task, letter and condition.
    std::map<std::string, std::string> files = {};
};

/// What participants discriminate, under one or more conditions. The stimulus of a pattern under a condition
/// is the tactile pattern with the id "task.letter.condition".
struct StudyTask {
    std::string id;
    std::string name;
    std::vector<StudyPattern> patterns;
    std::vector<std::string> conditions;
    Design design = Design::identification;
    /// Of all designs but identification; `patterns` are then the answers that the design has.
    LevelTask levels = {};
    /// References of conditions that have their own.
    std::map<std::string, double> references = {};

    /// The level to which a condition compares.
    [[nodiscard]] double referenceOf(const std::string& condition) const;
};

/// When the time to answer starts. Response times are measured from the onset in either case.
enum class ResponseWindow { fromOnset, fromEnd };

/// A study as its file describes it.
struct Protocol {
    std::string name;
    std::string description;
    std::vector<std::string> authors; ///< for descriptions of exported data; may be empty
    double stimulus_s = 2.0;
    double responseLimit_s = 10.0;
    ResponseWindow window = ResponseWindow::fromOnset;
    std::size_t replays = 0; ///< how often a participant may repeat a stimulus
    OrderMethod order = OrderMethod::fullRandom;
    PhaseSettings practice;
    PhaseSettings test;
    RestSettings rest;
    std::string noiseColour; ///< "pink", or "none"
    double noise_dBA = 0.0;
    std::vector<StudyTask> tasks;
    std::vector<Questionnaire> questionnaires;
    core::TriggerSettings trigger;
    bool recordSessions = false;           ///< the streams of each session are recorded into a file
    std::vector<ExclusionRule> exclusions; ///< in the order in which they apply
    std::string source;                    ///< text of the file, kept with the study

    void describeKeys(core::Keys& keys);

    /// Test trials of one participant; with adaptive procedures at most, without catch and same trials.
    [[nodiscard]] std::size_t testTrials() const;
};

/// Reads a protocol (TOML). Unknown keys, keys without their unit, wrong types, values out of range, and
/// letters or conditions that occur twice are errors with file, line, column and what was expected. Paths of
/// pattern files are relative to the protocol, ids of built-in patterns are none; the files are not read.
/// Error: notFound, ioFailed, badInput. Thread: any.
[[nodiscard]] core::Expected<Protocol> readProtocol(const std::string& path);

/// The same from text. file: name for errors. Paths of pattern files stay as they are.
[[nodiscard]] core::Expected<Protocol> parseProtocol(std::string_view text, const std::string& file);

/// A protocol as TOML: parseProtocol() gives the same protocol back. Validity is not checked here but by
/// parseProtocol(). Thread: any.
[[nodiscard]] std::string protocolText(const Protocol& protocol);

/// The protocol of the paper: shape (6 patterns) and stiffness (5), each static and dynamic; 18 and 15
/// practice, 30 and 25 test trials. The resource :/studies/teleta.toml. Thread: any.
[[nodiscard]] core::Expected<Protocol> paperProtocol();

/// A file, or where there is none of this name the built-in protocol "tactor-detection" and so on. Error: as
/// readProtocol(). Thread: any.
[[nodiscard]] core::Expected<Protocol> readNamedProtocol(const std::string& name);

/// All built-in protocols (:/studies/NAME.toml), the paper's first. Thread: any.
[[nodiscard]] core::Expected<std::vector<Protocol>> builtInProtocols();

/// Parts of a session's seed, see derivedSeed().
inline constexpr std::uint64_t kSeedOfPractice = 0; ///< the order of its trials
inline constexpr std::uint64_t kSeedOfTest = 1;
inline constexpr std::uint64_t kSeedOfAnswers = 2; ///< of simulated participants
/// Of a session's or a participant's seed: answers of simulated participants to questionnaires.
inline constexpr std::uint64_t kSeedOfQuestionnaires = 1'000'000;
inline constexpr std::uint64_t kSeedOfPairs = 1'000'001; ///< the order in which pairs are shown

/// One participant's session: one condition of a task.
struct PlannedSession {
    std::size_t task = 0;
    std::size_t condition = 0;         ///< index in the task's conditions
    std::size_t conditionPosition = 0; ///< from 0: how many conditions of this task came before
    std::size_t sequenceRow = 0;       ///< row of the Williams square
    std::uint64_t seed = 0;
    std::vector<std::size_t> practice; ///< patterns in their order; of a task with levels none
    std::vector<std::size_t> test;
    std::size_t practiceTrials = 0; ///< how many trials it has
    std::size_t testTrials = 0;     ///< likewise; of adaptive procedures at most
};

/// All sessions of participant number `enrolment` (from 0): tasks as in the protocol, conditions by Williams
/// square. Depends on its arguments alone. Thread: any.
[[nodiscard]] std::vector<PlannedSession> planSessions(const Protocol& protocol, std::uint64_t studySeed,
                                                       std::size_t enrolment);

} // namespace teleta::study
