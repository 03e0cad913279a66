// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace teleta::core {

/// A source of which it may be unknown how many frames it lost on the way: the sensor neither counts them nor
/// tells their times. Sources without this interface know it. Thread: any.
class LossCounting {
public:
    virtual ~LossCounting() = default;
    /// False: DeviceStatus::framesLost counts only what was lost after it had arrived.
    [[nodiscard]] virtual bool countsLosses() const = 0;
    /// Of DeviceStatus::framesLost, those that were lost at the site from which the frames come.
    [[nodiscard]] virtual std::uint64_t lostAtSite() const { return 0; }
};

} // namespace teleta::core
