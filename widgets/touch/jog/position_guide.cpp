// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/jog/position_guide.h"

#include <algorithm>
#include <cmath>

namespace teleta::touch {

using Eigen::Vector3d;

Vector3d PositionGuide::velocity_mPerS(bool held, bool clutch, const Vector3d& hand_m, const Vector3d& tip_m,
                                       double fastest_mPerS, double age_s) {
    if (!held || clutch || !hand_m.allFinite() || !tip_m.allFinite() || !(fastest_mPerS > 0.0) ||
        !std::isfinite(age_s)) {
        letGo();
        return Vector3d::Zero();
    }
    if (!m_anchor_m)
        m_anchor_m = tip_m - hand_m;
    m_way_m = *m_anchor_m + hand_m - tip_m;
    const double distance_m = m_way_m.norm();
    if (distance_m < kArrived_m)
        return Vector3d::Zero();
    const double gain_perS =
        std::min(kGain_perS, kLargestTurn / (2.0 * std::max(age_s, 0.0) + kOtherDelay_s));
    return m_way_m / distance_m * std::min(gain_perS * distance_m, fastest_mPerS);
}

void PositionGuide::step(const Vector3d& by_m) {
    if (!m_anchor_m || !by_m.allFinite())
        return;
    const Vector3d wanted_m = m_way_m + by_m;
    const double lead_m = wanted_m.norm();
    const Vector3d way_m =
        lead_m > kLongestLead_m ? Vector3d(wanted_m * (kLongestLead_m / lead_m)) : wanted_m;
    *m_anchor_m += way_m - m_way_m;
    m_way_m = way_m;
}

} // namespace teleta::touch
