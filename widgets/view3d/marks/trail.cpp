// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/marks/trail.h"

#include <algorithm>
#include <cmath>

namespace teleta::view3d {

void Trail::add(const Eigen::Vector3d& p_m, double time_s) {
    if (!p_m.allFinite() || !std::isfinite(time_s))
        return;
    if (!m_places.empty()) {
        const double since_s = time_s - m_places.back().time_s;
        if (since_s < 0.0 || since_s > kGap_s)
            m_places.clear();
    }
    const std::size_t count = m_places.size();
    const bool isHeadNear =
        count >= 2 && (m_places[count - 1].p_m - m_places[count - 2].p_m).norm() < kStep_m;
    if (isHeadNear)
        m_places.back() = {p_m, time_s};
    else
        m_places.push_back({p_m, time_s});
    // The newest stays: it is where the point is.
    while (m_places.size() > 1 && (m_places.size() > kMost || !(shareLeft(m_places.front()) > 0.0)))
        m_places.pop_front();
}

double Trail::shareLeft(const Place& place) const {
    return m_places.empty() ? 0.0
                            : std::clamp(1.0 - (m_places.back().time_s - place.time_s) / kMemory_s, 0.0, 1.0);
}

} // namespace teleta::view3d
