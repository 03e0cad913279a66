// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/tactile_feedback.h"
#include "backend/playback/player_types.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace teleta::console {

/// What was recognised, what was sent for it, and how long after the completed touch the bracelet began.
struct FeedbackEvent {
    pipeline::FeedbackSent sent;
    std::optional<double> begin_s; ///< to the first frame of its pattern; empty: not yet, or never
    std::optional<double> onset_s; ///< to the first frame that is not off, the first one to be felt
};

/// How long it takes from a completed touch to the first frame of its pattern. Thread: one.
class TouchToSkin {
public:
    static constexpr std::size_t kLatencies = 200;
    /// Of the newest kLatencies touches.
    struct Latency {
        double median_s = 0.0;
        double p99_s = 0.0;
    };

    /// Something was recognised and sent.
    void begin(pipeline::FeedbackSent sent);
    /// True when a time of the newest event became known.
    [[nodiscard]] bool update(const playback::PlayerCounters& counters);
    /// The newest event is not known any more; the times are.
    void forget() { m_last.reset(); }

    /// Its times are not all known yet.
    [[nodiscard]] bool isOpen() const;
    [[nodiscard]] const std::optional<FeedbackEvent>& last() const { return m_last; }
    [[nodiscard]] std::optional<double> newest_s() const;
    /// Empty before the first.
    [[nodiscard]] std::optional<Latency> latency() const;

private:
    std::optional<FeedbackEvent> m_last;
    std::vector<double> m_latencies_s;
};

} // namespace teleta::console
