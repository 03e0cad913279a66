// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/bounded_queue.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace teleta::core {

/// How warm the chips of an array were when one of its frames was read, in degrees Celsius, one a chip.
struct TemperatureSample {
    std::int64_t time_ns = 0;  ///< steady clock at the read
    double sourceTime_s = 0.0; ///< of the frame
    std::vector<float> values_degC;
    bool discontinuity = false; ///< after an outage, a restart of the sensor, or samples that were dropped
};

/// The temperatures of an array's chips, which it sends with its frames. Thread: chips() by any;
/// temperatures() is drained by the consumer of the frames, which is not notified of temperatures alone.
class ChipThermometers {
public:
    virtual ~ChipThermometers() = default;
    /// Temperatures of a sample; 0: this array has none.
    [[nodiscard]] virtual std::size_t chips() const = 0;
    /// Its overflow() counts the samples that were dropped because the consumer was late.
    [[nodiscard]] virtual BoundedQueue<TemperatureSample>& temperatures() = 0;
};

} // namespace teleta::core
