// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bitset>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace teleta::servo {

/// Limits that can act on a command.
enum class Limit : std::size_t {
    toolSpeed,  ///< the sensor's speed was lowered
    turnRate,   ///< its turn was lowered
    force,      ///< the measured force is over the limit: the sensor only retreats
    saturation, ///< a taxel is saturated: the sensor pushes no further
    deviation,  ///< the command would have run away from the measured pose
    jointSpeed, ///< a joint would have been too fast
    jointEnd,   ///< a joint is at the end of its range
    singular,   ///< the arm is near a singularity, where the motion is damped
    gap,        ///< the step was longer than the task counts
    badInput,   ///< a number was not finite, or the step not > 0: nothing moves
};
inline constexpr std::size_t kLimits = 10;

/// "tool_speed", "turn_rate", "force", ...
[[nodiscard]] const char* toString(Limit limit);

/// Those limits that acted in one step.
class ActiveLimits {
public:
    void set(Limit limit) { m_bits.set(static_cast<std::size_t>(limit)); }
    [[nodiscard]] bool has(Limit limit) const { return m_bits[static_cast<std::size_t>(limit)]; }
    [[nodiscard]] bool any() const { return m_bits.any(); }
    /// The names of toString(), with + between them; empty: none.
    [[nodiscard]] std::string names() const;
    /// From such names. Nothing: one of them is no limit.
    [[nodiscard]] static std::optional<ActiveLimits> fromNames(std::string_view names);
    bool operator==(const ActiveLimits&) const = default;

private:
    std::bitset<kLimits> m_bits;
};

} // namespace teleta::servo
