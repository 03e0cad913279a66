// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace teleta::simulation {

/// A move from rest to rest: share of the way over time, with the least jerk.
///   s = 10 u^3 - 15 u^4 + 6 u^5,  u = t / T
/// Its highest speed is 15/8 of the mean one.
/// Source: Flash, Hogan, J. Neurosci. 5 (1985) 1688.
class SmoothMove {
public:
    SmoothMove() = default;
    /// Over a way of so many metres or radians at a highest speed.
    static SmoothMove at(double way, double highestSpeed) {
        SmoothMove move;
        move.m_duration_s = 1.875 * way / highestSpeed;
        return move;
    }

    /// Moves on; true when the end is reached.
    bool advance(double step_s) {
        m_time_s += step_s;
        return m_time_s >= m_duration_s;
    }
    [[nodiscard]] double share() const { return shareAt(m_time_s, m_duration_s); }
    [[nodiscard]] static double shareAt(double time_s, double duration_s) {
        const double u = duration_s > 0.0 ? std::clamp(time_s / duration_s, 0.0, 1.0) : 1.0;
        return u * u * u * (10.0 - u * (15.0 - 6.0 * u));
    }

private:
    double m_duration_s = 0.0;
    double m_time_s = 0.0;
};

} // namespace teleta::simulation
