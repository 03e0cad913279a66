// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/contacts/contact_identities.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace teleta::vision {

const std::vector<FollowedContact>& ContactIdentities::update(std::vector<CameraContact> contacts,
                                                              double time_s, double framePeriod_s) {
    std::erase_if(m_followed,
                  [](const FollowedContact& followed) { return followed.event == ContactEvent::ends; });
    for (FollowedContact& followed : m_followed) {
        followed.seen = false;
        followed.event = ContactEvent::none;
    }
    const bool endAll = std::exchange(m_endAll, false);
    const std::size_t followedBefore = m_followed.size();
    std::vector<std::tuple<double, std::size_t, std::size_t>> pairs; // distance, contact, followed
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        for (std::size_t k = 0; contacts[i].located && !endAll && k < followedBefore; ++k) {
            const double distance_m =
                (contacts[i].p_Sensor_Centre_m - m_followed[k].contact.p_Sensor_Centre_m).norm();
            if (distance_m <= m_settings.gate_m)
                pairs.emplace_back(distance_m, i, k);
        }
    }
    std::ranges::sort(pairs);
    std::vector<bool> taken(contacts.size(), false);
    for (const auto& [distance_m, i, k] : pairs) {
        FollowedContact& followed = m_followed[k];
        if (taken[i] || followed.seen)
            continue;
        taken[i] = true;
        followed.depthRate.add(contacts[i], time_s, framePeriod_s);
        contacts[i].id = followed.contact.id;
        followed.contact = std::move(contacts[i]);
        followed.seen_s = time_s;
        followed.seen = true;
    }
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        if (taken[i] || !contacts[i].located)
            continue;
        FollowedContact followed;
        followed.contact = std::move(contacts[i]);
        followed.contact.id = m_nextId++;
        followed.p_Sensor_Start_m = followed.contact.p_Sensor_Centre_m;
        followed.begin_s = followed.seen_s = time_s;
        followed.event = ContactEvent::begins;
        followed.seen = true;
        followed.depthRate.add(followed.contact, time_s, framePeriod_s);
        m_followed.push_back(std::move(followed));
    }
    for (std::size_t k = 0; k < followedBefore; ++k) {
        FollowedContact& followed = m_followed[k];
        if (!followed.seen && (endAll || time_s - followed.seen_s > m_settings.memory_s))
            followed.event = ContactEvent::ends;
    }
    return m_followed;
}

} // namespace teleta::vision
