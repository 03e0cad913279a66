// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/participant/event_clock.h"

#include <algorithm>

namespace teleta::study {

namespace {

constexpr std::int64_t kRemembered_ns = 120'000'000'000;
constexpr std::size_t kMostRemembered = 64;
/// Differences of events that were not delayed agree within this.
constexpr std::int64_t kAgreement_ns = 10'000'000;
constexpr std::ptrdiff_t kWitnesses = 3;
/// No event loop is blocked for so long: the timestamp is of another clock.
constexpr std::int64_t kLongestDelay_ns = 5'000'000'000;

} // namespace

std::int64_t EventClock::time_ns(std::uint64_t timestamp_ms, std::int64_t now_ns) {
    if (timestamp_ms == 0)
        return now_ns;
    while (!m_seen.empty() &&
           (m_seen.size() >= kMostRemembered || now_ns - m_seen.front().handled_ns > kRemembered_ns))
        m_seen.pop_front();
    // Unsigned arithmetic wraps; a meaningless timestamp merely disagrees with the others.
    const auto difference_ns =
        static_cast<std::int64_t>(static_cast<std::uint64_t>(now_ns) - timestamp_ms * 1'000'000U);
    m_seen.push_back({now_ns, difference_ns});
    const auto smallest =
        std::min_element(m_seen.begin(), m_seen.end(), [](const Seen& one, const Seen& other) {
            return one.difference_ns < other.difference_ns;
        });
    const auto later_ns = [&](const Seen& seen) {
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(seen.difference_ns) -
                                         static_cast<std::uint64_t>(smallest->difference_ns));
    };
    const auto witnesses = std::count_if(m_seen.begin(), m_seen.end(), [&](const Seen& seen) {
        return later_ns(seen) >= 0 && later_ns(seen) <= kAgreement_ns;
    });
    const std::int64_t delay_ns = later_ns(m_seen.back());
    const bool isKnown = witnesses >= kWitnesses && delay_ns >= 0 && delay_ns <= kLongestDelay_ns;
    return isKnown ? now_ns - delay_ns : now_ns;
}

} // namespace teleta::study
