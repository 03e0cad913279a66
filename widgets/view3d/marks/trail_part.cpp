// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/marks/trail_part.h"

#include <cmath>

namespace teleta::view3d {

void TrailPart::applyColours(const SceneColours& colours) {
    m_colours = colours;
    rebuild();
}

bool TrailPart::add(const Eigen::Vector3d& p_World_m, double time_s) {
    const bool wasEmpty = m_line.isEmpty();
    m_trail.add(p_World_m, time_s);
    rebuild();
    return !wasEmpty || !m_line.isEmpty();
}

void TrailPart::clear() {
    m_trail.clear();
    rebuild();
}

void TrailPart::rebuild() {
    m_line.clear();
    const auto& places = m_trail.places();
    const QRgb plain = m_colours.trail.rgb();
    const auto colourOf = [&](const Trail::Place& place) {
        const double alpha = 255.0 * m_trail.shareLeft(place);
        return qRgba(qRed(plain), qGreen(plain), qBlue(plain), static_cast<int>(std::lround(alpha)));
    };
    // Of an arm that stands still nothing is seen.
    const bool moved =
        places.size() > 2 || (places.size() == 2 && (places[1].p_m - places[0].p_m).norm() >= Trail::kStep_m);
    for (std::size_t i = 1; moved && i < places.size(); ++i)
        m_line.segment(places[i - 1].p_m, colourOf(places[i - 1]), places[i].p_m, colourOf(places[i]));
    m_line.finish();
}

} // namespace teleta::view3d
