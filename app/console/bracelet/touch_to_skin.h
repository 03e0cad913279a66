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
    void forget() { m_isKnown = false; }

    /// Its times are not all known yet.
    [[nodiscard]] bool isOpen() const;
    /// The newest event; null: it is not known any more, or there was none.
    [[nodiscard]] const TouchReceipt* last() const { return m_isKnown ? &m_receipts.back() : nullptr; }
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

    std::deque<TouchReceipt> m_receipts;
    bool m_isKnown = false; ///< the newest one still counts
    std::vector<Begun> m_begun;
};

} // namespace teleta::console
