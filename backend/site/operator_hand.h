// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>

namespace teleta::site {

/// The operator's dead-man switch at the console's end: what to send for the commands that a view gives while
/// the switch is held. A view that hangs gives none, and then the switch counts as let go. Pure: time is an
/// argument, in ns of the console's steady clock. Thread: one.
class OperatorHand {
public:
    /// A command counts for so long.
    static constexpr std::int64_t kLifetime_ns = 100'000'000;
    static constexpr std::int64_t kPeriod_ns = 20'000'000;
    /// How often it is said that the switch was let go: over a link that loses packets.
    static constexpr int kHolds = 5;

    enum class Send {
        nothing,
        move, ///< the newest command
        hold,
    };

    /// moves: a rate other than zero, that is the switch is held. given_ns: when the view gave it.
    void post(bool moves, std::int64_t given_ns);

    /// STOP is engaged, or was since the last call: the switch counts as let go, and one that is held through
    /// it moves nothing until the view says that it was let go.
    void stop();

    /// What to send now, every kPeriod_ns.
    [[nodiscard]] Send step(std::int64_t now_ns);

    /// A view asks for a motion, and has not fallen silent since.
    [[nodiscard]] bool isHeld() const { return m_held; }
    /// It was held through STOP, and still is.
    [[nodiscard]] bool isBlocked() const { return m_blocked; }
    /// How often the switch was pressed. Only one that was let go can be pressed again: a view that goes on
    /// after it has hung, with the switch still held, makes no new press, and the site does not move by it.
    [[nodiscard]] std::uint32_t press() const { return m_press; }

private:
    bool m_held = false;    ///< and not silent for too long
    bool m_letGo = true;    ///< the next command that moves is another press
    bool m_blocked = false; ///< by STOP, until the switch is let go
    std::int64_t m_given_ns = std::numeric_limits<std::int64_t>::min();
    std::uint32_t m_press = 0;
    int m_holdsLeft = 0;
};

} // namespace teleta::site
