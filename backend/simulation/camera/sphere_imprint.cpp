// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/sphere_imprint.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace teleta::simulation {

namespace {

constexpr double kAtRest_m = 1e-6;
constexpr std::size_t kTailEntries = 1024;

double bessel0(double x) {
    return std::cyl_bessel_k(0.0, x);
}

double bessel1(double x) {
    return std::cyl_bessel_k(1.0, x);
}

double depthOfContact_m(double contact_m, double radius_m, double reach_m) {
    const double x = contact_m / reach_m;
    return contact_m * contact_m / (2.0 * radius_m) +
           contact_m * reach_m / radius_m * bessel0(x) / bessel1(x);
}

} // namespace

SphereImprint::SphereImprint(double radius_m, double depth_m, double reach_m)
    : m_radius_m(radius_m)
    , m_depth_m(std::max(depth_m, 0.0)) {
    if (m_depth_m <= kAtRest_m) {
        m_depth_m = 0.0;
        return;
    }
    // The depth grows with the contact, and without the tail it would be a^2 / 2R.
    double low_m = 0.0;
    double high_m = std::sqrt(2.0 * radius_m * m_depth_m);
    for (int i = 0; i < 60; ++i) {
        const double middle_m = 0.5 * (low_m + high_m);
        if (middle_m > 0.0 && depthOfContact_m(middle_m, radius_m, reach_m) < m_depth_m)
            low_m = middle_m;
        else
            high_m = middle_m;
    }
    m_contactRadius_m = 0.5 * (low_m + high_m);
    m_edgeDepth_m = m_depth_m - m_contactRadius_m * m_contactRadius_m / (2.0 * radius_m);
    const double atEdge = bessel0(m_contactRadius_m / reach_m);
    m_influence_m = m_contactRadius_m;
    while (m_edgeDepth_m * bessel0(m_influence_m / reach_m) / atEdge > kAtRest_m)
        m_influence_m += 0.1 * reach_m;
    const double width_m = std::max(m_influence_m - m_contactRadius_m, 1e-3 * reach_m);
    m_influence_m = m_contactRadius_m + width_m;
    m_perMetre = static_cast<double>(kTailEntries - 1) / width_m;
    m_tail.resize(kTailEntries + 1, 0.0);
    for (std::size_t i = 0; i < kTailEntries; ++i)
        m_tail[i] = bessel0((m_contactRadius_m + static_cast<double>(i) / m_perMetre) / reach_m) / atEdge;
}

double SphereImprint::tail(double s_m) const {
    const double place = (s_m - m_contactRadius_m) * m_perMetre;
    if (place >= static_cast<double>(kTailEntries - 1))
        return 0.0;
    const auto i = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(i);
    return m_tail[i] + share * (m_tail[i + 1] - m_tail[i]);
}

double SphereImprint::depth_m(double s_m) const {
    if (m_depth_m == 0.0)
        return 0.0;
    if (s_m <= m_contactRadius_m)
        return m_depth_m - s_m * s_m / (2.0 * m_radius_m);
    return m_edgeDepth_m * tail(s_m);
}

double SphereImprint::dragShare(double s_m) const {
    if (m_depth_m == 0.0)
        return 0.0;
    return s_m <= m_contactRadius_m ? 1.0 : tail(s_m);
}

} // namespace teleta::simulation
