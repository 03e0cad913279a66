// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/signal/series.h"

#include <cstddef>
#include <cstdint>

namespace teleta::signal {

/// The derivative of a series, in its unit per second: central differences on the times as they are, which
/// are exact for parabolas. The first and the last sample of an uninterrupted stretch have none; of samples
/// with the same time the first one counts. Thread: one.
class Derivative {
public:
    /// Takes samples that the series has got since the last call, this many at most, so that a long series
    /// is caught up with in steps. True: there are more.
    bool follow(const Series& series, std::size_t most);
    [[nodiscard]] const Series& series() const { return m_series; }
    void setCapacity(std::size_t samples) { m_series.setCapacity(samples); }

private:
    void take(const Sample& sample);

    Series m_series;
    std::uint64_t m_next = 0; ///< of all samples of the series
    Sample m_before, m_middle;
    int m_kept = 0; ///< of these two
};

} // namespace teleta::signal
