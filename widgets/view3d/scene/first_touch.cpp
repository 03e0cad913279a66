// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene/first_touch.h"

namespace teleta::view3d {

void FirstTouch::update(std::span<const contact::Contact> contacts, double time_s) {
    if (time_s < m_time_s)
        m_touches.clear();
    m_time_s = time_s;
    for (const contact::Contact& contact : contacts)
        if (contact.id > 0) { // tracked
            const Touch now{{contact.x_m, contact.y_m}, time_s};
            m_touches.try_emplace(contact.id, now).first->second.lastSeen_s = time_s;
        }
    std::erase_if(m_touches, [&](const auto& touch) { return time_s - touch.second.lastSeen_s > kMemory_s; });
}

std::optional<Eigen::Vector2d> FirstTouch::startOf(int id) const {
    const auto touch = m_touches.find(id);
    return touch == m_touches.end() ? std::nullopt : std::optional(touch->second.start_m);
}

} // namespace teleta::view3d
