// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>

namespace teleta::studyview {

/// Tells when an input event happened, on the steady clock, although a busy event loop handles it later. The
/// system stamps events in ms on a clock of its own:
///   time = timestamp + smallest difference between handling and timestamp of the last two minutes
/// so that an event counts from when it would have been handled at once, and clocks may drift. Until some
/// events agree on the difference, and for events without a timestamp or one of another clock, it is the time
/// of the handling. Thread: one.
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

} // namespace teleta::studyview
