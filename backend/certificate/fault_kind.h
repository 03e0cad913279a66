// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace teleta::certificate {

/// What is done to a program that drives motors or an arm, or to its line.
enum class FaultKind {
    kill,          ///< SIGKILL
    terminate,     ///< SIGTERM: a service is stopped, a session ends
    interrupt,     ///< SIGINT: Ctrl-C
    hangUp,        ///< SIGHUP: its terminal closes
    sleep,         ///< SIGSTOP and later SIGCONT: the computer sleeps, or the program gets no processor
    unplug,        ///< the line is cut and for a while cannot be opened again
    lateAnswers,   ///< the driver's answers come too late
    lostRequests,  ///< what is sent to the driver does not arrive
    lies,          ///< the driver's answers are wrong
    stop,          ///< STOP, with nothing else
    diskFull,      ///< the recording cannot be written any more, then STOP
    memoryRefused, ///< the program gets no more memory, then STOP
    clockStep,     ///< the wall clock jumps, then STOP
};

inline constexpr std::array kFaultKinds{
    FaultKind::kill,     FaultKind::terminate, FaultKind::interrupt,   FaultKind::hangUp,
    FaultKind::sleep,    FaultKind::unplug,    FaultKind::lateAnswers, FaultKind::lostRequests,
    FaultKind::lies,     FaultKind::stop,      FaultKind::diskFull,    FaultKind::memoryRefused,
    FaultKind::clockStep};

/// Its word on the command line and in files: "kill", "late_answers".
[[nodiscard]] std::string_view toString(FaultKind kind);
/// The inverse; empty for any other word.
[[nodiscard]] std::optional<FaultKind> faultKindOf(std::string_view word);

/// It is done to the line between the program and the driver.
[[nodiscard]] bool isOfLine(FaultKind kind);
/// The program is not there any more afterwards, or cannot be used.
[[nodiscard]] bool endsProgram(FaultKind kind);
/// The program goes on driving; what is measured is whether STOP still works.
[[nodiscard]] bool isFollowedByStop(FaultKind kind);

} // namespace teleta::certificate
