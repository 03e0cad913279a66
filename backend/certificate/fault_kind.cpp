// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/certificate/fault_kind.h"

#include <algorithm>

namespace teleta::certificate {

std::string_view toString(FaultKind kind) {
    switch (kind) {
    case FaultKind::kill:
        return "kill";
    case FaultKind::terminate:
        return "terminate";
    case FaultKind::interrupt:
        return "interrupt";
    case FaultKind::hangUp:
        return "hang_up";
    case FaultKind::sleep:
        return "sleep";
    case FaultKind::unplug:
        return "unplug";
    case FaultKind::lateAnswers:
        return "late_answers";
    case FaultKind::lostRequests:
        return "lost_requests";
    case FaultKind::lies:
        return "lies";
    case FaultKind::stop:
        return "stop";
    case FaultKind::diskFull:
        return "disk_full";
    case FaultKind::memoryRefused:
        return "memory_refused";
    case FaultKind::clockStep:
        return "clock_step";
    }
    return "";
}

std::optional<FaultKind> faultKindOf(std::string_view word) {
    const auto* const found = std::ranges::find(kFaultKinds, word, toString);
    return found == kFaultKinds.end() ? std::nullopt : std::optional(*found);
}

bool isOfLine(FaultKind kind) {
    return kind == FaultKind::unplug || kind == FaultKind::lateAnswers || kind == FaultKind::lostRequests ||
           kind == FaultKind::lies;
}

bool endsProgram(FaultKind kind) {
    switch (kind) {
    case FaultKind::kill:
    case FaultKind::terminate:
    case FaultKind::interrupt:
    case FaultKind::hangUp:
    case FaultKind::diskFull:
    case FaultKind::memoryRefused:
        return true;
    default:
        return false;
    }
}

bool isFollowedByStop(FaultKind kind) {
    return kind == FaultKind::diskFull || kind == FaultKind::memoryRefused || kind == FaultKind::clockStep;
}

} // namespace teleta::certificate
