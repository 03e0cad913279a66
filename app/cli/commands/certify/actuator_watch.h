// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/interface.h"

#include <cstdint>
#include <optional>

namespace teleta::cli {

/// Looks, past the program under test, whether the motors are on or the arm moves. Thread: any; it has a
/// thread of its own.
class ActuatorWatch : public core::Interface {
public:
    /// One look. The state held at some time between the two.
    struct Look {
        std::int64_t asked_ns = 0;
        std::int64_t answered_ns = 0;
        bool on = false;
    };

    /// The newest one.
    [[nodiscard]] virtual Look newest() const = 0;
    /// Of the looks that were asked for after from_ns until now: the first one from which it stayed off.
    /// Empty: it is on, or there was no look.
    [[nodiscard]] virtual std::optional<Look> offSince(std::int64_t from_ns) const = 0;
    /// Whether it was seen on by a look that was asked for after from_ns.
    [[nodiscard]] virtual bool wasOnAfter(std::int64_t from_ns) const = 0;
    /// Longest time between the answers to two looks that were asked for after from_ns.
    [[nodiscard]] virtual std::int64_t longestGap_ns(std::int64_t from_ns) const = 0;
    /// There are no answers any more.
    [[nodiscard]] virtual bool failed() const = 0;
};

} // namespace teleta::cli
