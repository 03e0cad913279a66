// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/contacts/contact_reactions.h"

#include <algorithm>
#include <cmath>

namespace teleta::vision {

std::optional<BumpDetector::Bump> BumpDetector::update(std::span<const FollowedContact> contacts) {
    std::erase_if(m_bumped, [&](int id) {
        return std::ranges::none_of(contacts, [&](const FollowedContact& followed) {
            return followed.contact.id == id && followed.event != ContactEvent::ends;
        });
    });
    const FollowedContact* deepest = nullptr;
    for (const FollowedContact& followed : contacts) {
        if (!followed.seen || std::ranges::find(m_bumped, followed.contact.id) != m_bumped.end())
            continue;
        const bool bumps = followed.depthRate.atLeast_mPerS() > m_settings.speed_mPerS ||
                           followed.contact.depth_m > m_settings.depth_m;
        if (bumps && (deepest == nullptr || followed.contact.depth_m > deepest->contact.depth_m))
            deepest = &followed;
    }
    if (deepest == nullptr)
        return std::nullopt;
    m_bumped.push_back(deepest->contact.id);
    const Eigen::Vector3d& place_m = deepest->contact.p_Sensor_Centre_m;
    const double rho_m = std::hypot(place_m.x(), place_m.y());
    Bump bump{.contact = deepest->contact.id};
    if (rho_m > 0.0)
        bump.retreat = {-place_m.x() / rho_m, -place_m.y() / rho_m, 0.0};
    return bump;
}

FollowMotion followMotion(const Eigen::Vector3d& p_Sensor_Start_m, const Eigen::Vector3d& p_Sensor_Now_m) {
    const double cross =
        p_Sensor_Start_m.x() * p_Sensor_Now_m.y() - p_Sensor_Start_m.y() * p_Sensor_Now_m.x();
    const double dot = p_Sensor_Start_m.head<2>().dot(p_Sensor_Now_m.head<2>());
    return {.turn_rad = std::atan2(cross, dot), .along_m = p_Sensor_Now_m.z() - p_Sensor_Start_m.z()};
}

} // namespace teleta::vision
