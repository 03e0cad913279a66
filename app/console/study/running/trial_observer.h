// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/interface.h"
#include "backend/study/protocol/trial.h"

#include <cstdint>
#include <functional>

namespace teleta::console {

/// Hears of the trials of a session as they happen. Thread: GUI; no call may wait.
class TrialObserver : public core::Interface {
public:
    /// A stimulus was requested. onset: time of its confirmed onset, 0 before it; may be called from any
    /// thread, but is destroyed on this one.
    virtual void stimulusRequested(const study::PlannedTrial& trial, std::function<std::int64_t()> onset) = 0;
    /// A trial has ended and its result will be kept; what the observer knows may be added. onset_ns: 0 when
    /// there was none; end_ns: now.
    virtual void trialEnded(study::TrialResult& result, std::int64_t onset_ns, std::int64_t end_ns) = 0;
};

} // namespace teleta::console
