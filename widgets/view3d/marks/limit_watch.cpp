// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/marks/limit_watch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::view3d {

double LimitWatch::nearness_rad(double lowest_rad, double highest_rad) {
    return std::min(kNear_deg * std::numbers::pi / 180.0, kNearShare * (highest_rad - lowest_rad));
}

bool LimitWatch::update(double angle_rad, double lowest_rad, double highest_rad) {
    if (!std::isfinite(angle_rad) || !std::isfinite(lowest_rad) || !std::isfinite(highest_rad) ||
        !(lowest_rad < highest_rad)) {
        m_near = false;
        return m_near;
    }
    const double left_rad = std::min(angle_rad - lowest_rad, highest_rad - angle_rad);
    const double near_rad = nearness_rad(lowest_rad, highest_rad);
    m_near = left_rad <= (m_near ? kLeave * near_rad : near_rad);
    return m_near;
}

} // namespace teleta::view3d
