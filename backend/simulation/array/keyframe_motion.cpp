// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/array/keyframe_motion.h"

#include <algorithm>
#include <cmath>

namespace teleta::simulation {

namespace {

/// Slope between two secants over h0 and h1: their weighted harmonic mean, 0 where the motion turns back.
double monotoneSlope(double secant0, double secant1, double h0, double h1) {
    if (secant0 * secant1 <= 0.0)
        return 0.0;
    const double w0 = 2.0 * h1 + h0;
    const double w1 = h1 + 2.0 * h0;
    return (w0 + w1) / (w0 / secant0 + w1 / secant1);
}

} // namespace

KeyframeMotion::KeyframeMotion(std::vector<scene::Keyframe> keyframes, bool loop)
    : m_loop(loop) {
    for (const scene::Keyframe& frame : keyframes) {
        m_time_s.push_back(frame.time_s);
        m_value.push_back({frame.x_m, frame.y_m, frame.depth_m, frame.angle_rad});
    }
    const std::size_t count = m_value.size();
    m_slope.resize(count, Coordinates{});
    const auto step = [&](std::size_t i) { return m_time_s[i + 1] - m_time_s[i]; };
    const auto secant = [&](std::size_t i, std::size_t c) {
        return (m_value[i + 1][c] - m_value[i][c]) / step(i);
    };
    for (std::size_t c = 0; c < Coordinates().size(); ++c) {
        for (std::size_t i = 1; i + 1 < count; ++i)
            m_slope[i][c] = monotoneSlope(secant(i - 1, c), secant(i, c), step(i - 1), step(i));
        if (m_loop && count > 2)
            m_slope.front()[c] = m_slope.back()[c] =
                monotoneSlope(secant(count - 2, c), secant(0, c), step(count - 2), step(0));
    }
}

Pose KeyframeMotion::at(double time_s) const {
    const double first_s = m_time_s.front();
    const double last_s = m_time_s.back();
    double t_s = time_s;
    if (m_loop && t_s > last_s && last_s > first_s)
        t_s = first_s + std::fmod(t_s - first_s, last_s - first_s);
    const auto next = std::ranges::upper_bound(m_time_s, t_s);
    Coordinates value;
    if (next == m_time_s.begin()) {
        value = m_value.front();
    } else if (next == m_time_s.end()) {
        value = m_value.back();
    } else {
        const auto i = static_cast<std::size_t>(next - m_time_s.begin()) - 1;
        const double h_s = m_time_s[i + 1] - m_time_s[i];
        const double s = (t_s - m_time_s[i]) / h_s;
        const double rise = s * s * (3.0 - 2.0 * s);
        for (std::size_t c = 0; c < value.size(); ++c)
            value[c] = m_value[i][c] + rise * (m_value[i + 1][c] - m_value[i][c]) +
                       h_s * s * (1.0 - s) * ((1.0 - s) * m_slope[i][c] - s * m_slope[i + 1][c]);
    }
    return {value[0], value[1], value[2], value[3]};
}

} // namespace teleta::simulation
