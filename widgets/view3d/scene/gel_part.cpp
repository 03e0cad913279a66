// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene/gel_part.h"

#include "widgets/base/colour_maps.h"
#include "widgets/base/theme.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace teleta::view3d {

namespace {

constexpr double kGelOutline_px = 3.0;
constexpr double kGelMargin = 0.05; ///< around the markers, where the lens shows no corner
// In diagonals of the plane.
constexpr double kGelThickness = 0.05;
constexpr double kGelLift = 0.002; ///< of what lies on the skin
constexpr double kGelLongestPress = 0.2;
// In pitches of the markers.
constexpr double kGelDot = 0.13;
constexpr double kGelCross = 0.2;
constexpr double kGelShaft = 0.045;
constexpr double kGelHead = 0.22;
constexpr double kGelMark = 0.32;
constexpr double kGelThickShaft = 0.11;
constexpr double kGelThickHead = 0.6;
constexpr double kGelTurn = 1.6;
/// Of a marker's own area: how much the skin spreads at least under the longest arrow.
constexpr double kGelLeastSpread = 0.1;
constexpr double kGelLeastShare = 0.02;
constexpr double kGelLeastTurn_rad = 2.0 * std::numbers::pi / 180.0;
constexpr double kGelMostTurn_rad = 300.0 * std::numbers::pi / 180.0;

Eigen::Vector3d raised(const Eigen::Vector2d& place_m, double height_m) {
    return {place_m.x(), place_m.y(), height_m};
}

bool areFinite(const std::array<Eigen::Vector2d, 4>& corners_m) {
    return std::ranges::all_of(corners_m, [](const Eigen::Vector2d& corner) { return corner.allFinite(); });
}

/// Twice the area within the corners.
double doubledArea_m2(const std::array<Eigen::Vector2d, 4>& corners_m) {
    double sum_m2 = 0.0;
    for (std::size_t i = 0; i < corners_m.size(); ++i) {
        const Eigen::Vector2d& a = corners_m[i];
        const Eigen::Vector2d& b = corners_m[(i + 1) % corners_m.size()];
        sum_m2 += a.x() * b.y() - a.y() * b.x();
    }
    return std::abs(sum_m2);
}

/// A box about the markers.
std::array<Eigen::Vector2d, 4> cornersAround(const std::vector<vision::GelMarker>& markers) {
    Eigen::AlignedBox2d box;
    for (const vision::GelMarker& marker : markers)
        box.extend(marker.rest_m);
    const Eigen::Vector2d margin = Eigen::Vector2d::Constant(kGelMargin * box.diagonal().norm());
    const Eigen::Vector2d low = box.min() - margin;
    const Eigen::Vector2d high = box.max() + margin;
    return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

} // namespace

GelPart::GelPart() {
    for (Mesh* mesh : meshes())
        mesh->actor->SetUserMatrix(m_pose);
    setVisible();
}

void GelPart::addTo(vtkRenderer* renderer) {
    for (Mesh* mesh : meshes())
        renderer->AddActor(mesh->actor);
}

void GelPart::applyColours(const SceneColours& colours) {
    m_colours = colours;
    if (!m_shown)
        return;
    rebuildBody();
    rebuild();
}

void GelPart::applyPixelScale(double scale) {
    m_lines.setLineWidth(kGelOutline_px, scale);
}

void GelPart::setDisplacementShown(bool shown) {
    m_displacementShown = shown;
    setVisible();
}

void GelPart::setForcesShown(bool shown) {
    m_forcesShown = shown;
    setVisible();
}

void GelPart::setTurnsShown(bool shown) {
    m_turnsShown = shown;
    setVisible();
}

void GelPart::setVisible() {
    for (Mesh* mesh : {&m_skin, &m_dots, &m_solids, &m_lines})
        mesh->actor->SetVisibility(m_shown);
    m_displacements.actor->SetVisibility(m_shown && m_displacementShown);
    m_presses.actor->SetVisibility(m_shown && m_forcesShown);
    m_turns.actor->SetVisibility(m_shown && m_turnsShown);
}

bool GelPart::set(const pipeline::GelSnapshot& snapshot, double enlargement,
                  std::span<const GelWords> words) {
    if (!snapshot.hasReference()) {
        const bool was = m_shown;
        clear();
        return was;
    }
    m_snapshot = snapshot;
    m_snapshot.image = {};
    m_words.assign(words.begin(), words.end());
    m_enlargement = enlargement;
    const auto corners_m =
        areFinite(snapshot.corners_m) ? snapshot.corners_m : cornersAround(snapshot.markers);
    const double pitch_m =
        std::sqrt(0.5 * doubledArea_m2(corners_m) / static_cast<double>(snapshot.markers.size()));
    const bool other = !m_shown || corners_m != m_corners_m || pitch_m != m_pitch_m;
    m_shown = true;
    if (other) {
        m_corners_m = corners_m;
        m_pitch_m = pitch_m;
        m_size_m = (corners_m[2] - corners_m[0]).norm();
        m_spreadRange = base::CalmRange(kGelLeastSpread * pitch_m * pitch_m);
        rebuildBody();
    }
    // An arm carries it from where it was at the start.
    m_X_World_Sensor.translation() = -raised(0.5 * (corners_m[0] + corners_m[2]), 0.0);
    if (snapshot.carrier)
        m_X_World_Sensor.translation() += snapshot.carrier->X_Base_Sensor.translation();
    setMatrix(*m_pose, m_X_World_Sensor);
    double most_m2 = 0.0;
    for (const vision::GelContactState& contact : snapshot.contacts)
        if (std::isfinite(contact.normalProxy_m2))
            most_m2 = std::max(most_m2, contact.normalProxy_m2);
    m_spreadRange.update(0.0, most_m2, snapshot.time_s);
    rebuild();
    setVisible();
    return other;
}

void GelPart::clear() {
    m_shown = false;
    m_marks.clear();
    for (Mesh* mesh : meshes()) {
        mesh->clear();
        mesh->finish();
    }
    setVisible();
}

void GelPart::rebuildBody() {
    m_skin.clear();
    std::array<Eigen::Vector3d, 4> top;
    std::array<Eigen::Vector3d, 4> bottom;
    for (std::size_t i = 0; i < top.size(); ++i) {
        top[i] = raised(m_corners_m[i], 0.0);
        bottom[i] = raised(m_corners_m[i], -kGelThickness * m_size_m);
    }
    m_skin.quad(top[0], top[1], top[2], top[3], m_colours.cylinder.rgb());
    m_skin.quad(bottom[3], bottom[2], bottom[1], bottom[0], m_colours.slab.rgb());
    for (std::size_t i = 0; i < top.size(); ++i) {
        const std::size_t next = (i + 1) % top.size();
        m_skin.quad(bottom[i], bottom[next], top[next], top[i], m_colours.slab.rgb());
    }
    m_skin.finish();
}

void GelPart::rebuild() {
    m_marks.clear();
    for (Mesh* mesh : {&m_dots, &m_solids, &m_displacements, &m_presses, &m_turns, &m_lines})
        mesh->clear();
    drawMarkers();
    for (std::size_t i = 0; i < m_snapshot.contacts.size(); ++i)
        if (m_snapshot.contacts[i].centre_m.allFinite())
            drawContact(m_snapshot.contacts[i], i < m_words.size() ? m_words[i] : GelWords());
    for (Mesh* mesh : {&m_dots, &m_solids, &m_displacements, &m_presses, &m_turns, &m_lines})
        mesh->finish();
}

void GelPart::drawMarkers() {
    const double lift_m = kGelLift * m_size_m;
    const QColor dot = base::mixed(m_colours.cylinder, m_colours.text, 0.7);
    double longest_m = 10.0 * kLeastArrow * m_snapshot.noise_m;
    for (const vision::GelMotion& motion : m_snapshot.motions)
        if (motion.found && motion.displacement_m.allFinite())
            longest_m = std::max(longest_m, motion.displacement_m.norm());
    const std::size_t count = std::min(m_snapshot.markers.size(), m_snapshot.motions.size());
    for (std::size_t i = 0; i < count; ++i) {
        const Eigen::Vector2d& rest_m = m_snapshot.markers[i].rest_m;
        const vision::GelMotion& motion = m_snapshot.motions[i];
        if (!rest_m.allFinite())
            continue;
        if (m_snapshot.usable && !motion.found) {
            // A cross where a marker was lost.
            const double arm_m = kGelCross * m_pitch_m;
            for (const double side : {1.0, -1.0})
                m_lines.segment(raised(rest_m + Eigen::Vector2d(-arm_m, -side * arm_m), 2.0 * lift_m),
                                raised(rest_m + Eigen::Vector2d(arm_m, side * arm_m), 2.0 * lift_m),
                                m_colours.deadCross.rgb());
            continue;
        }
        m_dots.cone(raised(rest_m, 0.0), raised(rest_m, 1.5 * lift_m), kGelDot * m_pitch_m,
                    kGelDot * m_pitch_m, dot.rgb());
        const double moved_m = motion.displacement_m.norm();
        if (!motion.found || !(moved_m >= kLeastArrow * m_snapshot.noise_m))
            continue;
        const double share = std::clamp(moved_m / longest_m, 0.0, 1.0);
        const double height_m = 2.0 * lift_m + kGelShaft * m_pitch_m;
        m_displacements.arrow(raised(rest_m, height_m),
                              raised(rest_m + m_enlargement * motion.displacement_m, height_m),
                              kGelShaft * m_pitch_m, kGelHead * m_pitch_m,
                              base::colourAt(base::cividis(), 0.45 + 0.55 * share));
    }
}

void GelPart::drawContact(const vision::GelContactState& contact, const GelWords& words) {
    const double lift_m = kGelLift * m_size_m;
    const double mark_m = kGelMark * m_pitch_m;
    GelMark mark;
    mark.id = contact.id;
    mark.colour = base::identityColour(std::max(1, contact.id), m_colours.dark);
    mark.words = words;
    mark.p_Sensor_Foot = raised(contact.centre_m, lift_m);
    mark.p_Sensor_Tail = mark.p_Sensor_Foot;

    const QColor fill = base::mixed(m_colours.cylinder, mark.colour, 0.35);
    const auto& outline = contact.outline;
    if (outline.size() >= 3) {
        Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();
        for (const Eigen::Vector2d& corner : outline)
            middle_m += corner / static_cast<double>(outline.size());
        m_line.clear();
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Eigen::Vector2d& a = outline[i];
            const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
            m_solids.quad(raised(middle_m, 0.5 * lift_m), raised(a, 0.5 * lift_m),
                          raised(0.5 * (a + b), 0.5 * lift_m), raised(b, 0.5 * lift_m), fill.rgb());
            m_line.push_back(raised(a, lift_m));
        }
        m_lines.polyline(m_line, mark.colour.rgb(), true);
    }
    const QColor& slip = words.slipColour[m_colours.dark ? 1 : 0];
    m_solids.sphere(mark.p_Sensor_Foot, mark_m, slip.isValid() ? slip.rgb() : mark.colour.rgb());

    const double spread_m2 = std::isfinite(contact.normalProxy_m2) ? contact.normalProxy_m2 : 0.0;
    const double share = std::min(1.0, spread_m2 / m_spreadRange.high());
    if (share > kGelLeastShare) {
        const Eigen::Vector3d head = mark.p_Sensor_Foot + mark_m * Eigen::Vector3d::UnitZ();
        mark.p_Sensor_Tail = head + share * kGelLongestPress * m_size_m * Eigen::Vector3d::UnitZ();
        m_presses.arrow(mark.p_Sensor_Tail, head, kGelThickShaft * m_pitch_m, kGelThickHead * m_pitch_m,
                        mark.colour.rgb());
    }
    const Eigen::Vector2d shear_m = m_enlargement * contact.shearProxy_m;
    if (shear_m.allFinite() && shear_m.norm() > mark_m)
        m_presses.arrow(mark.p_Sensor_Foot, mark.p_Sensor_Foot + raised(shear_m, 0.0),
                        kGelThickShaft * m_pitch_m, kGelThickHead * m_pitch_m, mark.colour.rgb());
    const double turn_rad =
        std::clamp(m_enlargement * contact.torsion_rad, -kGelMostTurn_rad, kGelMostTurn_rad);
    if (std::abs(turn_rad) > kGelLeastTurn_rad) {
        const Eigen::Vector3d centre = mark.p_Sensor_Foot + 0.5 * mark_m * Eigen::Vector3d::UnitZ();
        m_turns.turn(centre, Eigen::Vector3d::UnitZ(),
                     centre + kGelTurn * m_pitch_m * Eigen::Vector3d::UnitX(), turn_rad,
                     kGelThickShaft * m_pitch_m, kGelThickHead * m_pitch_m, mark.colour.rgb());
    }
    m_marks.push_back(std::move(mark));
}

Eigen::AlignedBox3d GelPart::box_m() const {
    Eigen::AlignedBox3d box;
    if (!m_shown)
        return box;
    for (const Eigen::Vector2d& corner : m_corners_m) {
        box.extend(m_X_World_Sensor * raised(corner, -kGelThickness * m_size_m));
        box.extend(m_X_World_Sensor *
                   raised(corner, kGelMark * m_pitch_m + 0.4 * kGelLongestPress * m_size_m));
    }
    return box;
}

void GelPart::appendMeshes(std::vector<vtkPolyData*>& meshes) const {
    if (!m_shown)
        return;
    for (const Mesh* mesh : {&m_skin, &m_dots, &m_solids, &m_lines})
        meshes.push_back(mesh->data());
    if (m_displacementShown)
        meshes.push_back(m_displacements.data());
    if (m_forcesShown)
        meshes.push_back(m_presses.data());
    if (m_turnsShown)
        meshes.push_back(m_turns.data());
}

} // namespace teleta::view3d
