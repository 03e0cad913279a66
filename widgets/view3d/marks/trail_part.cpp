// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/marks/trail_part.h"

#include <cmath>
#include <utility>

namespace teleta::view3d {

void TrailPart::applyColours(const SceneColours& colours) {
    m_colours = colours;
    m_changed = true;
}

bool TrailPart::add(const Eigen::Vector3d& p_World_m, double time_s) {
    const bool wasSeen = m_trail.isSeen();
    m_trail.add(p_World_m, time_s);
    m_changed = true;
    return (wasSeen || m_trail.isSeen()) && m_line.actor->GetVisibility() != 0;
}

void TrailPart::clear() {
    m_trail.clear();
    m_changed = true;
}

void TrailPart::draw() {
    if (m_line.actor->GetVisibility() == 0 || !std::exchange(m_changed, false))
        return;
    m_line.clear();
    const auto& places = m_trail.places();
    const QRgb plain = m_colours.trail.rgb();
    const auto colourOf = [&](const Trail::Place& place) {
        const double alpha = 255.0 * m_trail.shareLeft(place);
        return qRgba(qRed(plain), qGreen(plain), qBlue(plain), static_cast<int>(std::lround(alpha)));
    };
    const bool isSeen = m_trail.isSeen();
    for (std::size_t i = 1; isSeen && i < places.size(); ++i)
        m_line.segment(places[i - 1].p_m, colourOf(places[i - 1]), places[i].p_m, colourOf(places[i]));
    m_line.finish();
}

} // namespace teleta::view3d
