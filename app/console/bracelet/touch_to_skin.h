// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/touch_receipt.h"
#include "backend/pipeline/touch/tactile_feedback.h"
#include "backend/playback/player_types.h"

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

namespace teleta::console {

/// How long it takes from a completed touch to the first frame of its pattern. Thread: one.
class TouchToSkin {
public:
    static constexpr std::size_t kLatencies = 200;
    static constexpr std::size_t kReceipts = 10'000;
    /// Of the newest kLatencies touches.
    struct Latency {
        double median_s = 0.0;
        double p99_s = 0.0;
        double bound_s =
            0.0; ///< by which each may be off, since a site's clock is not known better; 0: one clock
    };

    /// Something was recognised and sent. clock: of the site where it was felt; empty: it was felt here.
    void begin(pipeline::FeedbackSent sent, const std::optional<site::ClockOffset>& clock = {});
    /// True when a time of the newest event became known.
    [[nodiscard]] bool update(const playback::PlayerCounters& counters);
    /// The newest event is not known any more; the times are.
    void forget() { m_last.reset(); }

    /// Its times are not all known yet.
    [[nodiscard]] bool isOpen() const;
    [[nodiscard]] const std::optional<TouchReceipt>& last() const { return m_last; }
    /// The newest kReceipts, the oldest first; forget() keeps them.
    [[nodiscard]] const std::deque<TouchReceipt>& receipts() const { return m_receipts; }
    [[nodiscard]] std::optional<double> newest_s() const;
    /// Empty before the first.
    [[nodiscard]] std::optional<Latency> latency() const;

private:
    /// A touch whose pattern has begun.
    struct Begun {
        double latency_s = 0.0;
        double bound_s = 0.0;
    };

    std::optional<TouchReceipt> m_last;
    std::deque<TouchReceipt> m_receipts;
    std::vector<Begun> m_begun;
};

} // namespace teleta::console
