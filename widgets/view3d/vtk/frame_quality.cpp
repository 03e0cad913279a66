// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/vtk/frame_quality.h"

#include <algorithm>

namespace teleta::view3d {

bool FrameQuality::drawn(std::int64_t duration_ns) {
    m_durations_ns.push_back(duration_ns);
    if (m_durations_ns.size() < kFrames)
        return false;
    const auto slow = m_durations_ns.begin() + kFrames * 19 / 20;
    std::nth_element(m_durations_ns.begin(), slow, m_durations_ns.end());
    const std::int64_t slow_ns = *slow;
    m_durations_ns.clear();
    const auto step = [this](int by) { m_level = static_cast<Level>(static_cast<int>(m_level) + by); };
    if (slow_ns > kBudget_ns && m_level != Level::plain) {
        step(-1);
        m_highest = m_level;
        return true;
    }
    if (slow_ns < kQuick_ns && m_level < m_highest) {
        step(+1);
        return true;
    }
    return false;
}

void FrameQuality::restart() {
    *this = {};
}

} // namespace teleta::view3d
