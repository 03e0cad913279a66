// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace teleta::simulation {

/// How a thin soft skin on a rigid tube gives way to a rigid ball: a membrane on springs (Pasternak
/// foundation), so that the surface goes on smoothly beside the contact.
///   s <= a: w = d - s^2 / (2 R)         s > a: w = C K0(s / l)
///   value and slope continuous at a:    d = a^2 / (2 R) + (a l / R) K0(a / l) / K1(a / l)
/// R: radius of the ball; d: depth; a: radius of the contact; l: reach of the skin beside it; K0, K1:
/// modified Bessel functions. Drag in the contact goes over into the skin beside it like w does. Thread: any
/// (const). Source: A. D. Kerr, Elastic and viscoelastic foundation models (1964).
class SphereImprint {
public:
    /// radius_m, reach_m: > 0. depth_m <= 0: no contact, the skin is flat.
    SphereImprint(double radius_m, double depth_m, double reach_m);

    /// Radius of the contact, 0 without any; what the imprint is needed for where nothing is drawn.
    [[nodiscard]] static double contactRadius_m(double radius_m, double depth_m, double reach_m);

    /// Depth of the surface at a distance from the centre, s_m >= 0.
    [[nodiscard]] double depth_m(double s_m) const {
        if (m_depth_m == 0.0)
            return 0.0;
        if (s_m <= m_contactRadius_m)
            return m_depth_m - s_m * s_m * m_half_perM;
        return m_edgeDepth_m * tail(s_m);
    }
    /// Share of the contact's tangential displacement that the skin has at a distance; 1 in the contact.
    [[nodiscard]] double dragShare(double s_m) const {
        if (m_depth_m == 0.0)
            return 0.0;
        return s_m <= m_contactRadius_m ? 1.0 : tail(s_m);
    }

    [[nodiscard]] double contactRadius_m() const { return m_contactRadius_m; }
    /// Distance beyond which the skin is taken to be at rest: less than 1 um deep.
    [[nodiscard]] double influence_m() const { return m_influence_m; }
    [[nodiscard]] double deepest_m() const { return m_depth_m; }

private:
    [[nodiscard]] double tail(double s_m) const {
        const double place = (s_m - m_contactRadius_m) * m_perMetre;
        if (!(place < m_lastEntry))
            return 0.0;
        const int i = static_cast<int>(place);
        const double* entry = m_tail.data() + i;
        return entry[0] + (place - i) * (entry[1] - entry[0]);
    }

    double m_depth_m;
    double m_half_perM; ///< 1 / 2 R
    double m_contactRadius_m = 0.0;
    double m_influence_m = 0.0;
    double m_edgeDepth_m = 0.0;
    std::vector<double> m_tail; ///< K0(s/l) / K0(a/l) from the edge to the influence, evenly spaced
    double m_perMetre = 0.0;    ///< entries of m_tail a metre
    double m_lastEntry = 0.0;
};

} // namespace teleta::simulation
