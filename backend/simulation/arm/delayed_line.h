// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/simulation/effects/link_delay.h"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <optional>
#include <utility>

namespace teleta::simulation {

/// How the receiver treats messages that overtake each other.
enum class LineOrder {
    inOrder,    ///< waits for those that were sent before; lost ones are not waited for
    newestWins, ///< takes the newest that has arrived; those sent before it are of no use any more
};

/// One direction of a link: messages come out after its delay, or never. Without a delay they come
/// out at once. Times of all calls are the sender's and never run back. Thread: one.
template <typename Message>
class DelayedLine {
public:
    DelayedLine(LineOrder order, std::optional<LinkDelay> delay)
        : m_order(order)
        , m_delay(std::move(delay)) {}

    /// False: the message is lost.
    bool send(double now_s, Message message) {
        const std::optional<double> delay_s = m_delay ? m_delay->next_s(now_s) : std::optional(0.0);
        if (!delay_s) {
            ++m_lost;
            return false;
        }
        double arrival_s = now_s + *delay_s;
        if (m_order == LineOrder::inOrder && !m_onTheirWay.empty())
            arrival_s = std::max(arrival_s, m_onTheirWay.back().arrival_s);
        m_onTheirWay.push_back({arrival_s, std::move(message)});
        return true;
    }

    /// Takes the next message that has arrived by now; false: none.
    bool receive(double now_s, Message& message) {
        const auto hasArrived = [now_s](const Entry& entry) { return entry.arrival_s <= now_s; };
        if (m_order == LineOrder::inOrder) {
            if (m_onTheirWay.empty() || !hasArrived(m_onTheirWay.front()))
                return false;
            message = std::move(m_onTheirWay.front().message);
            m_onTheirWay.pop_front();
            return true;
        }
        const auto newest = std::find_if(m_onTheirWay.rbegin(), m_onTheirWay.rend(), hasArrived);
        if (newest == m_onTheirWay.rend())
            return false;
        message = std::move(newest->message);
        const auto end = newest.base(); // behind the newest
        m_overtaken += static_cast<std::uint64_t>(end - m_onTheirWay.begin()) - 1;
        m_onTheirWay.erase(m_onTheirWay.begin(), end);
        return true;
    }

    void restart() {
        m_onTheirWay.clear();
        m_lost = m_overtaken = 0;
        if (m_delay)
            m_delay->restart();
    }

    [[nodiscard]] std::uint64_t lost() const { return m_lost; }
    /// Given up for a newer one.
    [[nodiscard]] std::uint64_t overtaken() const { return m_overtaken; }

private:
    struct Entry {
        double arrival_s;
        Message message;
    };

    LineOrder m_order;
    std::optional<LinkDelay> m_delay;
    std::deque<Entry> m_onTheirWay; ///< in the order in which they were sent
    std::uint64_t m_lost = 0;
    std::uint64_t m_overtaken = 0;
};

} // namespace teleta::simulation
