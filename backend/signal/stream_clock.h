// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace teleta::signal {

/// Puts the frames of a stream on the time axis that all signals share. The axis is the steady clock; between
/// two frames it takes the step of the stream's own time, which is free of the jitter of reading. A stream
/// that jumps, or that stood still while the clock ran on, is put on the clock anew. Thread: one.
class StreamClock {
public:
    /// origin_ns: steady clock at the zero of the axis. nominalRate_Hz: 0: frames come when they please.
    StreamClock(std::int64_t origin_ns, double nominalRate_Hz);

    struct Step {
        double time_s = 0.0;
        bool gap = false; ///< not joined to the frame before: it jumped, or frames between them are missing
    };
    /// Frames are missing where two are more than five periods and 0.1 s apart, as in all charts.
    Step next(std::int64_t time_ns, double sourceTime_s, bool discontinuity);

private:
    std::int64_t m_origin_ns;
    double m_longestStep_s;
    bool m_begun = false;
    std::int64_t m_time_ns = 0;
    double m_sourceTime_s = 0.0;
    double m_time_s = 0.0;
    double m_offset_s = 0.0; ///< from the stream's own time to that of the axis
};

} // namespace teleta::signal
