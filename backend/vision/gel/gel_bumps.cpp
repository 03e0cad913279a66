// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/gel_bumps.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace teleta::vision {

double spreadOf_m(const GelContactState& contact) {
    const double around_m = 2.0 * std::sqrt(std::numbers::pi * contact.area_m2);
    return around_m > 0.0 ? contact.normalProxy_m2 / around_m : 0.0;
}

std::optional<BumpDetector::Bump> GelBumps::next(const std::vector<GelContactState>& contacts, double time_s,
                                                 double period_s, double noise_m) {
    std::vector<FollowedContact> followed;
    for (const GelContactState& contact : contacts) {
        const auto before = std::ranges::find(m_followed, contact.id,
                                              [](const FollowedContact& known) { return known.contact.id; });
        FollowedContact now;
        if (before != m_followed.end())
            now.depthRate = before->depthRate;
        now.contact.id = contact.id;
        now.contact.located = true;
        now.contact.p_Sensor_Centre_m = {contact.centre_m.x(), contact.centre_m.y(), 0.0};
        now.contact.depth_m = spreadOf_m(contact);
        now.contact.depthNoise_m = noise_m;
        now.seen_s = time_s;
        now.seen = true;
        now.depthRate.add(now.contact, time_s, period_s);
        followed.push_back(std::move(now));
    }
    m_followed = std::move(followed);
    std::optional<BumpDetector::Bump> bump = m_detector.update(m_followed);
    if (bump)
        bump->retreat = -Eigen::Vector3d::UnitZ();
    return bump;
}

} // namespace teleta::vision
