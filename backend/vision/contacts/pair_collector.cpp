// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/contacts/pair_collector.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::vision {

bool PairCollector::wanders(const Sample& sample) const {
    return std::ranges::any_of(m_touch, [&](const Sample& earlier) {
        return (earlier.pixel - sample.pixel).norm() > m_settings.steady_px ||
               std::abs(earlier.depth_m - sample.depth_m) > m_settings.steadyDepth_m;
    });
}

std::optional<Eigen::Vector2d> PairCollector::next(std::span<const CameraContact> contacts, double time_s) {
    const CameraContact* probe = nullptr;
    const CameraContact* second = nullptr;
    for (const CameraContact& contact : contacts) {
        if (!contact.located || !(contact.depth_m >= 0.5 * m_settings.leastDepth_m))
            continue;
        if (probe == nullptr || contact.depth_m > probe->depth_m)
            second = std::exchange(probe, &contact);
        else if (second == nullptr || contact.depth_m > second->depth_m)
            second = &contact;
    }
    if (probe == nullptr) {
        m_touch.clear();
        m_phase = Phase::free;
        return std::nullopt;
    }
    if (m_phase == Phase::taken || m_phase == Phase::refused)
        return std::nullopt;
    if (second != nullptr && second->depth_m > m_settings.secondShare * probe->depth_m) {
        m_touch.clear();
        m_phase = Phase::several;
        return std::nullopt;
    }
    m_phase = Phase::touching;
    const Sample sample{time_s, probe->centre_px, probe->depth_m};
    if (sample.depth_m < m_settings.leastDepth_m || wanders(sample))
        m_touch.clear();
    if (sample.depth_m < m_settings.leastDepth_m)
        return std::nullopt;
    m_touch.push_back(sample);
    if (progress() < 1.0)
        return std::nullopt;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Sample& steady : m_touch)
        mean += steady.pixel / static_cast<double>(m_touch.size());
    m_phase = Phase::taken;
    m_touch.clear();
    return mean;
}

double PairCollector::progress() const {
    if (m_phase == Phase::taken)
        return 1.0;
    if (m_touch.empty())
        return 0.0;
    // The time of a frame may be rounded.
    return std::min(1.0, (m_touch.back().time_s - m_touch.front().time_s) / m_settings.steady_s + 1e-9);
}

} // namespace teleta::vision
