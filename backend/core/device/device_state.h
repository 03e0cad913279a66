// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"

#include <cstdint>

namespace teleta::core {

/// State of a device as seen by a reader: a device that reports live but whose newest frame is older than
/// staleAfter_ns is stale, even if its worker is stuck and cannot say so. Thread: any.
[[nodiscard]] constexpr DeviceState observedState(DeviceState reported, std::int64_t lastData_ns,
                                                  std::int64_t now_ns, std::int64_t staleAfter_ns) {
    if (reported == DeviceState::live && now_ns - lastData_ns > staleAfter_ns)
        return DeviceState::stale;
    return reported;
}

/// Time after which the data of a stream counts as stale: five sample periods, at least 100 ms, and 1 s for a
/// stream without a nominal rate.
[[nodiscard]] constexpr std::int64_t staleAfter_ns(double nominalRate_Hz) {
    constexpr std::int64_t kShortest_ns = 100'000'000;
    constexpr std::int64_t kUnknownRate_ns = 1'000'000'000;
    if (!(nominalRate_Hz > 0.0))
        return kUnknownRate_ns;
    const double periods_ns = 5e9 / nominalRate_Hz;
    if (!(periods_ns < 60e9))
        return 60'000'000'000;
    return periods_ns > static_cast<double>(kShortest_ns) ? static_cast<std::int64_t>(periods_ns)
                                                          : kShortest_ns;
}

} // namespace teleta::core
