// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>

namespace teleta::study {

/// Time of an input event on the steady clock, even if a busy event loop handles it late. The system stamps
/// events in ms on its own clock:
///   time = timestamp + smallest difference between handling and timestamp of the last two minutes
/// that is, when it would have been handled without delay; clocks may drift. Until some events agree on the
/// difference, and for events without a usable timestamp, it is the time of handling. Thread: one.
class EventClock {
public:
    /// timestamp_ms: of the event, 0: none. now_ns: steady time of its handling. Returns steady time, at most
    /// now_ns.
    [[nodiscard]] std::int64_t time_ns(std::uint64_t timestamp_ms, std::int64_t now_ns);

private:
    struct Seen {
        std::int64_t handled_ns = 0;
        std::int64_t difference_ns = 0;
    };
    std::deque<Seen> m_seen;
};

} // namespace teleta::study
