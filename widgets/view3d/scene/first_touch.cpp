// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene/first_touch.h"

#include <algorithm>

namespace teleta::view3d {

void FirstTouch::update(std::span<const contact::Contact> contacts, double time_s) {
    if (time_s < m_time_s)
        m_touches.clear();
    m_time_s = time_s;
    for (const contact::Contact& contact : contacts) {
        if (contact.id <= 0)
            continue; // not tracked
        const auto known = std::find_if(m_touches.begin(), m_touches.end(),
                                        [&](const Touch& touch) { return touch.id == contact.id; });
        if (known != m_touches.end())
            known->lastSeen_s = time_s;
        else
            m_touches.push_back({contact.id, {contact.x_m, contact.y_m}, time_s});
    }
    std::erase_if(m_touches, [&](const Touch& touch) { return time_s - touch.lastSeen_s > kMemory_s; });
}

std::optional<Eigen::Vector2d> FirstTouch::startOf(int id) const {
    for (const Touch& touch : m_touches)
        if (touch.id == id)
            return touch.start_m;
    return {};
}

} // namespace teleta::view3d
