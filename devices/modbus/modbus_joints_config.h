// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/pacing_clock.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace teleta::modbus {

struct ModbusJointsConfig {
    std::size_t queueSamples = 1024;
    int failuresUntilLost = 3; ///< readings in a row without an answer, or with an exception
    std::int64_t firstRetry_ns = 100'000'000;
    std::int64_t longestRetry_ns = 5'000'000'000;
    std::shared_ptr<core::PacingClock> clock = std::make_shared<core::PacingClock>();
};

} // namespace teleta::modbus
