// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/marks/limit_part.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::view3d {

namespace {

constexpr double kDial = 3.2;    ///< radius of the arc, in radii of what turns
constexpr double kBar = 0.5;     ///< half of the bar at an end, likewise
constexpr double kPointer = 1.0; ///< beyond the arc, likewise
constexpr double kAtEnd_rad = 0.01;
constexpr double kStep_rad = 0.06; ///< of the arc
constexpr double kDialLine_px = 3.0;
constexpr int kLeftAlpha = 90;

bool isDrawableDial(const JointDial& dial) {
    return dial.X_World_Joint.matrix().allFinite() && std::isfinite(dial.radius_m) && dial.radius_m > 0.0;
}

Eigen::Vector3d onDial(const JointDial& dial, double angle_rad, double radius_m) {
    return dial.X_World_Joint *
           Eigen::Vector3d(radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad), 0.0);
}

/// The same dial, as far as one can see.
bool looksLike(const LimitMark& a, const LimitMark& b) {
    constexpr double kSame = 1e-4;
    return a.isAtEnd == b.isAtEnd && a.dial.name == b.dial.name &&
           std::abs(a.dial.angle_rad - b.dial.angle_rad) < kSame && a.dial.lowest_rad == b.dial.lowest_rad &&
           a.dial.highest_rad == b.dial.highest_rad &&
           a.dial.X_World_Joint.isApprox(b.dial.X_World_Joint, kSame);
}

} // namespace

LimitPart::LimitPart() {
    m_lines.showThrough();
    m_left.showThrough();
}

void LimitPart::addTo(vtkRenderer* renderer) {
    renderer->AddActor(m_left.actor);
    renderer->AddActor(m_lines.actor);
}

void LimitPart::setVisible(bool visible) {
    m_left.actor->SetVisibility(visible);
    m_lines.actor->SetVisibility(visible);
}

void LimitPart::applyColours(const SceneColours& colours) {
    m_colours = colours;
    rebuild();
}

void LimitPart::applyPixelScale(double scale) {
    m_lines.setLineWidth(kDialLine_px, scale);
}

bool LimitPart::set(std::span<const JointDial> dials) {
    if (m_watches.size() != dials.size())
        m_watches.assign(dials.size(), {});
    std::vector<LimitMark> marks;
    for (std::size_t joint = 0; joint < dials.size(); ++joint) {
        const JointDial& dial = dials[joint];
        if (!m_watches[joint].update(dial.angle_rad, dial.lowest_rad, dial.highest_rad) ||
            !isDrawableDial(dial))
            continue;
        LimitMark& mark = marks.emplace_back();
        mark.dial = dial;
        mark.isAtEnd =
            std::min(dial.angle_rad - dial.lowest_rad, dial.highest_rad - dial.angle_rad) <= kAtEnd_rad;
        mark.p_World_Label = onDial(dial, dial.angle_rad, (kDial + 1.4 * kPointer) * dial.radius_m);
    }
    const bool isSame = std::ranges::equal(marks, m_marks, looksLike);
    if (isSame)
        return false;
    m_marks = std::move(marks);
    rebuild();
    return true;
}

void LimitPart::rebuild() {
    m_lines.clear();
    m_left.clear();
    for (LimitMark& mark : m_marks) {
        mark.colour = mark.isAtEnd ? m_colours.atLimit : m_colours.nearLimit;
        draw(mark);
    }
    m_lines.finish();
    m_left.finish();
}

void LimitPart::draw(const LimitMark& mark) {
    const JointDial& dial = mark.dial;
    const QRgb colour = mark.colour.rgb();
    const double radius_m = kDial * dial.radius_m;
    const double out_m = radius_m + kPointer * dial.radius_m;
    // A range of more than a turn is a full circle: its ends lie over each other.
    const double highest_rad =
        std::min(dial.highest_rad, dial.lowest_rad + 2.0 * std::numbers::pi - 0.5 * kStep_rad);
    std::vector<Eigen::Vector3d> arc;
    const int steps = std::max(2, static_cast<int>(std::ceil((highest_rad - dial.lowest_rad) / kStep_rad)));
    for (int i = 0; i <= steps; ++i)
        arc.push_back(onDial(dial, dial.lowest_rad + (highest_rad - dial.lowest_rad) * i / steps, radius_m));
    m_lines.polyline(arc, colour);
    for (const double end_rad : {dial.lowest_rad, dial.highest_rad})
        m_lines.segment(onDial(dial, end_rad, radius_m - kBar * dial.radius_m),
                        onDial(dial, end_rad, radius_m + kBar * dial.radius_m), colour);
    m_lines.segment(onDial(dial, dial.angle_rad, 0.0), onDial(dial, dial.angle_rad, out_m), colour);

    const bool isHigh = dial.highest_rad - dial.angle_rad < dial.angle_rad - dial.lowest_rad;
    const double end_rad = isHigh ? dial.highest_rad : dial.lowest_rad;
    const QRgb faint = qRgba(qRed(colour), qGreen(colour), qBlue(colour), kLeftAlpha);
    const int slices =
        std::max(1, static_cast<int>(std::ceil(std::abs(end_rad - dial.angle_rad) / kStep_rad)));
    const Eigen::Vector3d centre = onDial(dial, 0.0, 0.0);
    const auto at = [&](int slice) {
        return onDial(dial, dial.angle_rad + (end_rad - dial.angle_rad) * slice / slices, radius_m);
    };
    for (int slice = 0; slice < slices; ++slice)
        m_left.quad(centre, at(slice), 0.5 * (at(slice) + at(slice + 1)), at(slice + 1), faint);
}

} // namespace teleta::view3d
