// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/model/pattern.h"

#include <QString>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

namespace teleta::console {

/// Progress of a stimulus. Times are on the steady clock.
struct StimulusState {
    /// The frame that is the onset; 0: not yet, or not yet confirmed by the device.
    std::int64_t onset_ns = 0;
    std::int64_t due_ns = 0;                      ///< when it ends by itself; 0: unknown
    std::int64_t end_ns = 0;                      ///< when it ended; 0: not yet
    std::optional<double> frameWrite_ms = {};     ///< longest write of a frame; empty: nothing was written
    std::optional<std::size_t> framesMissed = {}; ///< deadlines without a frame, and frames that were lost
    std::optional<double> latencySpread_ms = {};  ///< of the device's latency; empty: not measured
    QString failure = {};                         ///< why it was not shown properly; empty: no problem
};

/// Which frame of a stimulus is its onset.
enum class OnsetFrame {
    notZero, ///< the first one that is felt
    any,     ///< the first one: of trials that may begin with nothing, or have nothing at all
};

/// Shows one stimulus at a time to a participant. Thread: GUI; no call waits for a device.
class StimulusOutput {
public:
    StimulusOutput() = default;
    virtual ~StimulusOutput() = default;
    StimulusOutput(const StimulusOutput&) = delete;
    StimulusOutput& operator=(const StimulusOutput&) = delete;

    /// Why no stimulus can be shown now; empty: one can.
    [[nodiscard]] virtual QString obstacle() const = 0;
    /// Name and state of the device, in one line.
    [[nodiscard]] virtual QString description() const = 0;
    [[nodiscard]] virtual bool isSimulated() const = 0;

    /// now_ns: time of the request. The pattern is cut off at atMost_s.
    virtual void begin(const pattern::Pattern& pattern, double atMost_s, OnsetFrame onset,
                       std::int64_t now_ns) = 0;
    virtual void stop() = 0;
    /// Of the last stimulus.
    [[nodiscard]] virtual StimulusState state(std::int64_t now_ns) const = 0;
    /// Time of the last stimulus' onset, as in state(), 0 before it: a function that any thread may call
    /// while it plays, to be destroyed on this thread, and soon, since it keeps the device.
    [[nodiscard]] virtual std::function<std::int64_t()> onset() const = 0;
};

} // namespace teleta::console
