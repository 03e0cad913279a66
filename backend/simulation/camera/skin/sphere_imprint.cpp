// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/skin/sphere_imprint.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace teleta::simulation {

namespace {

constexpr double kAtRest_m = 1e-6;
constexpr std::size_t kExactEvery = 8;
constexpr std::size_t kTailEntries = 1024 + 1;

double bessel0(double x) {
    return std::cyl_bessel_k(0.0, x);
}

double bessel1(double x) {
    return std::cyl_bessel_k(1.0, x);
}

/// Of a function at an end of a piece.
struct Knot {
    double value = 0.0;
    double slope = 0.0; ///< a piece
};

/// Hermite's cubic, t = 0 .. 1.
double cubic(const Knot& before, const Knot& after, double t) {
    const double rest = 1.0 - t;
    return rest * rest * ((1.0 + 2.0 * t) * before.value + t * before.slope) +
           t * t * ((1.0 + 2.0 * rest) * after.value - rest * after.slope);
}

double depthOfContact_m(double contact_m, double radius_m, double reach_m) {
    const double x = contact_m / reach_m;
    return contact_m * contact_m / (2.0 * radius_m) +
           contact_m * reach_m / radius_m * bessel0(x) / bessel1(x);
}

} // namespace

double SphereImprint::contactRadius_m(double radius_m, double depth_m, double reach_m) {
    if (depth_m <= kAtRest_m)
        return 0.0;
    // The depth grows with the contact, and without the tail it would be a^2 / 2R.
    double low_m = 0.0;
    double high_m = std::sqrt(2.0 * radius_m * depth_m);
    for (int i = 0; i < 60; ++i) {
        const double middle_m = 0.5 * (low_m + high_m);
        if (middle_m > 0.0 && depthOfContact_m(middle_m, radius_m, reach_m) < depth_m)
            low_m = middle_m;
        else
            high_m = middle_m;
    }
    return 0.5 * (low_m + high_m);
}

SphereImprint::SphereImprint(double radius_m, double depth_m, double reach_m)
    : m_depth_m(depth_m > kAtRest_m ? depth_m : 0.0)
    , m_half_perM(0.5 / radius_m)
    , m_contactRadius_m(contactRadius_m(radius_m, depth_m, reach_m)) {
    if (m_depth_m == 0.0)
        return;
    m_edgeDepth_m = m_depth_m - m_contactRadius_m * m_contactRadius_m / (2.0 * radius_m);
    const double atEdge = bessel0(m_contactRadius_m / reach_m);
    m_influence_m = m_contactRadius_m;
    while (m_edgeDepth_m * bessel0(m_influence_m / reach_m) / atEdge > kAtRest_m)
        m_influence_m += 0.1 * reach_m;
    const double width_m = std::max(m_influence_m - m_contactRadius_m, 1e-3 * reach_m);
    m_influence_m = m_contactRadius_m + width_m;
    m_lastEntry = static_cast<double>(kTailEntries - 1);
    m_perMetre = m_lastEntry / width_m;
    m_tail.resize(kTailEntries + 1, 0.0);
    // Bessel functions are dear: every kExactEvery-th entry has its own, cubics through their values and
    // slopes (K0' = -K1) are in between.
    const auto tailAt = [&](std::size_t i) {
        const double x = (m_contactRadius_m + static_cast<double>(i) / m_perMetre) / reach_m;
        return Knot{bessel0(x) / atEdge,
                    -bessel1(x) / atEdge * static_cast<double>(kExactEvery) / (m_perMetre * reach_m)};
    };
    Knot before = tailAt(0);
    for (std::size_t i = 0; i + 1 < kTailEntries; i += kExactEvery) {
        const Knot after = tailAt(i + kExactEvery);
        for (std::size_t k = 0; k < kExactEvery; ++k)
            m_tail[i + k] = cubic(before, after, static_cast<double>(k) / kExactEvery);
        before = after;
    }
    m_tail[kTailEntries - 1] = before.value;
}

} // namespace teleta::simulation
