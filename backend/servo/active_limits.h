// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bitset>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace teleta::servo {

/// Limits that can change a command.
enum class Limit : std::size_t {
    toolSpeed,  ///< the speed of the sensor was reduced
    turnRate,   ///< the turn rate of the sensor was reduced
    force,      ///< the measured force exceeds the limit: the sensor may only retreat
    saturation, ///< a taxel is saturated: the sensor must not push further
    deviation,  ///< the command would have moved too far from the measured pose
    jointSpeed, ///< a joint would have exceeded its speed
    jointEnd,   ///< a joint is at the end of its range
    singular,   ///< the arm is near a singularity, where its motion is damped
    gap,        ///< the step was longer than the task allows and was shortened
    badInput,   ///< a number was not finite or the step not > 0: the arm does not move
};
inline constexpr std::size_t kLimits = 10;

/// Name in files: "tool_speed", "turn_rate", "force", ...
[[nodiscard]] const char* toString(Limit limit);

/// The limits that acted in one step.
class ActiveLimits {
public:
    void set(Limit limit) { m_bits.set(static_cast<std::size_t>(limit)); }
    [[nodiscard]] bool has(Limit limit) const { return m_bits[static_cast<std::size_t>(limit)]; }
    [[nodiscard]] bool any() const { return m_bits.any(); }
    /// Names as toString() gives them, joined by "+"; empty: none acted.
    [[nodiscard]] std::string names() const;
    /// Inverse of names(). Empty when one of the names is unknown.
    [[nodiscard]] static std::optional<ActiveLimits> fromNames(std::string_view names);
    bool operator==(const ActiveLimits&) const = default;

private:
    std::bitset<kLimits> m_bits;
};

} // namespace teleta::servo
