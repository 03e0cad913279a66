// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/protocol/protocol.h"
#include "backend/study/protocol/trial.h"
#include "backend/study/session/trigger_sender.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace teleta::study {

/// Free space needed in a study's folder: its trials need less than 1 MB, exports and the write-ahead log
/// some more.
inline constexpr std::int64_t kNeededSpace_B = 100'000'000;

/// The bracelet as it is now.
enum class BraceletCondition {
    missing, ///< none is open
    notLive, ///< open, but its connection is lost or it does not answer
    stopped, ///< STOP is engaged: nothing would be felt
    live,
};

/// State of a study's folder.
struct FolderCondition {
    std::string path;
    bool exists = false;
    bool writable = false; ///< a test file reached the disk
    std::string reason;    ///< the system's, if it is not
    std::int64_t free_B = 0;
};

/// Checks a folder by writing and removing a file: permissions alone do not show that a file system is
/// read-only. Thread: any but the GUI's (I/O).
[[nodiscard]] FolderCondition lookAtFolder(const std::string& path);

/// Everything that decides whether a run may start.
struct RunConditions {
    Mode mode = Mode::run;
    /// Protocol, or what is wrong with it.
    core::Expected<const Protocol*> protocol = nullptr;
    std::vector<std::string> missingStimuli; ///< ids of stimuli without a pattern
    /// The patterns differ from those with which the study was created; empty: unknown.
    std::optional<bool> stimuliChanged = false;
    std::string madeBy;                ///< version of the program that created the study
    std::string participant;           ///< empty: none is chosen
    std::optional<std::string> runner; ///< who runs the participant now; empty: nobody else
    bool finished = false;             ///< the session was finished before
    BraceletCondition bracelet = BraceletCondition::missing;
    std::string braceletName;
    bool braceletIsSimulated = false;
    std::optional<double> slowestFall_s; ///< of its motors, from a speed to 10 % of it; empty: not measured
    FolderCondition folder;
    std::optional<core::Error> store;          ///< why the store cannot be used; empty: it can
    bool noiseConfirmed = false;               ///< by the experimenter, for this session
    std::optional<TriggerStatus> trigger = {}; ///< of the line for triggers; empty: the study has none
    /// Whether the desktop keeps the screen on; empty: nobody asked it.
    std::optional<bool> screenHeld = {};
};

enum class RunCheckKind {
    protocol,
    stimuli,
    participant,
    bracelet,
    folder,
    space,
    store,
    noise,
    trigger,
    screen
};

/// The check of one condition.
struct RunCheck {
    RunCheckKind kind = RunCheckKind::protocol;
    bool passed = false;
    std::string name;    ///< a word or two
    std::string finding; ///< a sentence without full stop
    std::string remedy;  ///< what to do; of a check that has passed: advice
};

/// Checks all conditions of a run, in the order in which they are best met; it may start when all pass. A
/// simulated bracelet fails in mode run, since nobody feels it; noise is checked if people take part and the
/// protocol has it. The trigger is only there when the study has one. The screen never prevents a run: the
/// check only tells. Texts are translated. Thread: any (pure).
[[nodiscard]] std::vector<RunCheck> preRunChecks(const RunConditions& conditions);

[[nodiscard]] bool allPassed(const std::vector<RunCheck>& checks);

} // namespace teleta::study
