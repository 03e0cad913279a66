// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/marks/wrench_part.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace teleta::view3d {

namespace {

constexpr double kMomentRangeInThresholds = 5.0;
constexpr double kSmallestRange_Nm = 1e-30;
constexpr double kLeastShare = 0.02; ///< of the range; what is smaller is not drawn
// In radii of a contact's sphere.
constexpr double kForceShaft = 0.22;
constexpr double kForceHead = 1.8;
constexpr double kTurnShaft = 0.22;
constexpr double kTurnHead = 1.6;
constexpr double kTurn = 0.75; ///< radius of the turn, in longest arrows
constexpr double kMarkOfArrow = 0.15;
constexpr double kMostTurn_rad = 150.0 * std::numbers::pi / 180.0; ///< at the full range

bool isInNewton(const TouchScene& scene) {
    return scene.hasSensor() && scene.snapshot().loadUnit == "N";
}

} // namespace

std::optional<Eigen::Vector3d> momentOf_Nm(const contact::TactileFeatures& features) {
    if (!features.dzmpX_m || !features.dzmpY_m || !features.cocX_m || !features.cocY_m)
        return std::nullopt;
    const Eigen::Vector3d moment_Nm(-features.force_N * *features.dzmpX_m,
                                    features.force_N * *features.dzmpY_m, 0.0);
    return moment_Nm.allFinite() ? std::optional(moment_Nm) : std::nullopt;
}

void WrenchPart::addTo(vtkRenderer* renderer) {
    renderer->AddActor(m_force.actor);
    renderer->AddActor(m_moment.actor);
}

void WrenchPart::take(const pipeline::TouchSnapshot& snapshot) {
    // A load at the threshold, one taxel from the centre.
    const double least_Nm = std::max(
        kMomentRangeInThresholds * snapshot.threshold_N * snapshot.layout.pitch_m(), kSmallestRange_Nm);
    if (std::exchange(m_leastRange_Nm, least_Nm) != least_Nm)
        m_momentRange = base::CalmRange(least_Nm);
    const auto moment_Nm = momentOf_Nm(snapshot.features);
    m_momentRange.update(0.0, moment_Nm ? moment_Nm->norm() : 0.0, snapshot.sourceTime_s);
}

void WrenchPart::setForce(const std::optional<DrawnForce>& force) {
    m_drawnForce = force;
    if (force && force->measured && force->force_N.allFinite())
        m_measuredRange.update(0.0, force->force_N.norm(), force->time_s);
}

double WrenchPart::forceRange_N(const TouchScene& scene) const {
    return isInNewton(scene) ? scene.forceRange_N() : m_measuredRange.high();
}

void WrenchPart::draw(const TouchScene& scene) {
    m_force.clear();
    m_moment.clear();
    m_forceTail.reset();
    m_momentHead.reset();
    if (isInNewton(scene)) {
        drawForce(scene, scene.sensorSize().arrow_m, scene.sensorSize().mark_m);
        drawMoment(scene);
    } else if (m_drawnForce && m_drawnForce->measured && !scene.armBox_m().isEmpty()) {
        const double arrow_m = scene.armArrow_m();
        drawForce(scene, arrow_m, kMarkOfArrow * arrow_m);
    }
    m_force.finish();
    m_moment.finish();
}

void WrenchPart::drawForce(const TouchScene& scene, double arrow_m, double mark_m) {
    if (!m_drawnForce || !m_drawnForce->p_World_m.allFinite() || !m_drawnForce->force_N.allFinite())
        return;
    const double share = m_drawnForce->force_N.norm() / forceRange_N(scene);
    if (!(share > kLeastShare))
        return;
    const Eigen::Vector3d& head = m_drawnForce->p_World_m;
    m_forceTail = head - std::min(1.0, share) * arrow_m * m_drawnForce->force_N.normalized();
    m_force.arrow(*m_forceTail, head, kForceShaft * mark_m, kForceHead * mark_m, m_colours.jointForce.rgb());
}

void WrenchPart::drawMoment(const TouchScene& scene) {
    const contact::TactileFeatures& features = scene.snapshot().features;
    const auto moment_Nm = momentOf_Nm(features);
    if (!moment_Nm || m_bent || scene.surface() != Surface::plate)
        return;
    m_moment_Nm = moment_Nm->norm();
    const double share = std::min(1.0, m_moment_Nm / momentRange_Nm());
    if (!(share > kLeastShare))
        return;
    const SensorSize& size = scene.sensorSize();
    const Eigen::Vector3d axis = moment_Nm->normalized();
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d centre(*features.cocX_m, *features.cocY_m, size.tile_m);
    const double radius_m = kTurn * size.arrow_m;
    // Around the normal, so that the array hides nothing of it.
    const double half_rad = 0.5 * share * kMostTurn_rad;
    const Eigen::Vector3d tail = centre + radius_m * (Eigen::AngleAxisd(-half_rad, axis) * up);
    const Eigen::Vector3d head = centre + radius_m * (Eigen::AngleAxisd(half_rad, axis) * up);
    m_momentHead = scene.toWorld(head);
    m_moment.turn(scene.toWorld(centre), scene.X_World_Sensor().linear() * axis, scene.toWorld(tail),
                  2.0 * half_rad, kTurnShaft * size.mark_m, kTurnHead * size.mark_m, m_colours.moment.rgb());
}

} // namespace teleta::view3d
