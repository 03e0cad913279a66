// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/link/frame_clock.h"
#include "devices/taxels/frames/frame_decoder.h"

#include <cstdint>
#include <optional>

namespace teleta::taxels {

/// Whether frames of this format tell how many were lost before them, by a counter or a whole-numbered time.
[[nodiscard]] bool countsLosses(const FrameFormat& format);

/// What counters and times of frames say of the stream: its time, which never goes back, lost frames,
/// repeated ones, and that the sensor started anew.
///   lost = counter - last - 1, modulo its range; half of the range and more is a restart
/// Without a counter, losses are the gaps of whole-numbered times, as link::FrameClock finds them; without
/// either there are none to be known. Thread: one (pure).
class StreamTime {
public:
    struct Step {
        double time_s = 0.0;
        std::uint64_t lost = 0; ///< frames between the one before and this one
        bool repeated = false;  ///< the same frame again
        bool restarted = false;
    };

    explicit StreamTime(const FrameFormat& format);

    /// hostTime_s: of its arrival since the stream began.
    [[nodiscard]] Step advance(const DecodedFrame& frame, double hostTime_s);
    /// The next frame is the first of a connection.
    void beginConnection();

private:
    [[nodiscard]] double timeOf(double time_s, double hostTime_s, Step& step);

    std::uint32_t m_counterMask = 0;
    bool m_hasCounter = false;
    link::FrameClock m_clock;
    std::optional<std::uint32_t> m_lastCounter;
    std::optional<double> m_lastTime_s; ///< as the sensor said it
    double m_time_s = 0.0;              ///< of the stream
};

} // namespace teleta::taxels
