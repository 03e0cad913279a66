// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace teleta::link {

/// Turns a sensor's wrapping timestamps into a time of the stream that never goes back, and finds
/// the frames that were lost on the way:
///   lost = round(interval / period) - 1   where interval >= 1.5 period + 1 tick
/// The period is the running mean of the intervals without a loss, so that a loss is only seen once there
/// were two frames; the tick allows for the rounding of the timestamps, below which (a period under two
/// ticks) single losses cannot be told. Thread: one (pure).
class FrameClock {
public:
    struct Step {
        double time_s = 0.0;
        std::uint64_t lost = 0; ///< frames between the one before and this one
        bool restarted = false; ///< the timestamp jumped back: the sensor started anew
    };

    /// tick_s: of a timestamp; > 0. bits: after which the timestamps wrap; 8 .. 32.
    explicit FrameClock(double tick_s, int bits = 32)
        : m_tick_s(tick_s)
        , m_bits(bits) {}

    /// The next frame. hostTime_s: time of its arrival since the stream began, from which the stream's time
    /// goes on after a restart.
    [[nodiscard]] Step advance(std::uint32_t timestamp, double hostTime_s);

    /// The next frame is the first of a connection.
    void restart();

private:
    double m_tick_s;
    int m_bits;
    double m_time_s = 0.0;
    double m_period = 0.0; ///< ticks; 0: unknown
    std::uint32_t m_last = 0;
    bool m_running = false;
};

} // namespace teleta::link
