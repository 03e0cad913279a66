// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/contacts/depth_rate.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace teleta::vision {

namespace {

constexpr double kMemory_s = 0.05;
constexpr std::size_t kLeastKept = 3; ///< at low frame rates these are longer ago
constexpr double kShortest_s = 0.012; ///< that a slope goes over
constexpr double kMargin = 3.0;       ///< standard deviations
constexpr double kSameFrame = 0.5;    ///< share of a frame's period

} // namespace

void DepthRate::add(const CameraContact& contact, double time_s, double framePeriod_s) {
    const bool deepenedKnown = framePeriod_s > 0.0 && std::isfinite(contact.deepened_m);
    const bool followsOn =
        !m_sightings.empty() && time_s - m_sightings.back().time_s < framePeriod_s * (1.0 + kSameFrame);
    if (!followsOn) {
        m_sightings.clear();
        if (deepenedKnown)
            m_sightings.push_back({time_s - framePeriod_s, 0.0});
    }
    double depth_m = 0.0;
    if (!m_sightings.empty())
        depth_m = m_sightings.back().depth_m +
                  (deepenedKnown ? contact.deepened_m : contact.depth_m - m_lastDepth_m);
    m_sightings.push_back({time_s, depth_m});
    m_lastDepth_m = contact.depth_m;
    m_noise_m = contact.depthNoise_m;
    while (m_sightings.size() > kLeastKept && time_s - m_sightings.front().time_s > kMemory_s)
        m_sightings.erase(m_sightings.begin());
}

DepthRate::Slope DepthRate::slope(std::size_t sightings) const {
    const auto begin = m_sightings.end() - static_cast<std::ptrdiff_t>(sightings);
    double mean_s = 0.0;
    for (auto sighting = begin; sighting != m_sightings.end(); ++sighting)
        mean_s += sighting->time_s / static_cast<double>(sightings);
    double spread_s2 = 0.0;
    double together = 0.0;
    for (auto sighting = begin; sighting != m_sightings.end(); ++sighting) {
        const double apart_s = sighting->time_s - mean_s;
        spread_s2 += apart_s * apart_s;
        together += apart_s * sighting->depth_m;
    }
    if (!(spread_s2 > 0.0))
        return {};
    return {together / spread_s2, m_noise_m / std::sqrt(spread_s2)};
}

double DepthRate::atLeast_mPerS() const {
    std::optional<double> best_mPerS;
    for (std::size_t count = 2; count <= m_sightings.size(); ++count) {
        // A place that was measured wrongly once is not noise: over two frames of a fast camera it would give
        // any speed.
        const double span_s =
            m_sightings.back().time_s - (m_sightings.end() - static_cast<std::ptrdiff_t>(count))->time_s;
        if (span_s < kShortest_s)
            continue;
        const Slope through = slope(count);
        const double surely_mPerS = through.rate_mPerS - kMargin * through.sd_mPerS;
        best_mPerS = std::max(best_mPerS.value_or(surely_mPerS), surely_mPerS);
    }
    return best_mPerS.value_or(0.0);
}

} // namespace teleta::vision
