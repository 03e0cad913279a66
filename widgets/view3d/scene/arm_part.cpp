// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene/arm_part.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <utility>

namespace teleta::view3d {

namespace {

// Lengths along a link, in its radii.
constexpr double kJoint = 1.18;
constexpr double kCollar = 0.35;
constexpr double kBevel = 0.18;
constexpr double kLeastShell = 1.0;

constexpr int kShadowBands = 12;        ///< from the middle to the rim
constexpr int kShadowSides = 12;        ///< of each half circle
constexpr double kDarkest = 0.235;      ///< opacity in the middle of one link's
constexpr double kLightest = 0.1;       ///< likewise of an arm of many links
constexpr double kDarkestOfArm = 0.415; ///< where all links stand above each other, if they are few
constexpr double kShadowReach = 1.8;    ///< of the rim beyond the link's axis, in its radii
constexpr double kBlurPerHeight = 0.24; ///< how much farther for each metre above the ground, m
constexpr double kShadowMiddle = 0.25;  ///< of the reach: as dark as can be
constexpr double kBelowGrid_m = 5e-4;   ///< the lines of the ground stay visible

/// The shadows of links above each other add up, so those of an arm with many are lighter.
double darknessOf(std::size_t links) {
    return std::clamp(1.0 - std::pow(1.0 - kDarkestOfArm, 1.0 / static_cast<double>(links)), kLightest,
                      kDarkest);
}

bool isDrawableLink(const ArmLink& link) {
    return link.X_World_Link.matrix().allFinite() && std::isfinite(link.length_m) &&
           std::isfinite(link.radius_m) && link.length_m >= 0.0 && link.radius_m > 0.0;
}

} // namespace

void ArmPart::addTo(vtkRenderer* renderer) {
    m_solids.hideInside();
    renderer->AddActor(m_solids.actor);
    renderer->AddActor(m_shadow.actor);
}

void ArmPart::applyColours(const SceneColours& colours) {
    m_colours = colours;
    rebuild();
}

void ArmPart::set(std::span<const ArmLink> links) {
    m_links.clear();
    std::copy_if(links.begin(), links.end(), std::back_inserter(m_links), isDrawableLink);
    rebuild();
}

void ArmPart::setShellsShown(bool shown) {
    if (std::exchange(m_shellsShown, shown) != shown)
        rebuild();
}

void ArmPart::setGround(double z_m) {
    const bool isSame = z_m == m_ground_m || (std::isnan(z_m) && std::isnan(m_ground_m));
    m_ground_m = z_m;
    if (!isSame)
        rebuild();
}

void ArmPart::rebuild() {
    m_solids.clear();
    m_shadow.clear();
    m_box_m.setEmpty();
    for (const ArmLink& link : m_links) {
        const Eigen::Vector3d from = link.X_World_Link.translation();
        const Eigen::Vector3d to = link.X_World_Link * Eigen::Vector3d(link.length_m, 0.0, 0.0);
        const Eigen::Vector3d around = Eigen::Vector3d::Constant(1.25 * link.radius_m);
        for (const Eigen::Vector3d& end : {from, to}) {
            m_box_m.extend(end - around);
            m_box_m.extend(end + around);
        }
        if (m_shellsShown)
            drawLink(from, to, link.radius_m);
        if (std::isfinite(m_ground_m))
            drawShadow(from, to, link.radius_m);
    }
    if (m_shellsShown && !m_links.empty() && std::isfinite(m_ground_m))
        drawBase(m_links.front().X_World_Link.translation(), m_links.front().radius_m);
    m_solids.finish();
    m_shadow.finish();
}

void ArmPart::drawLink(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius_m) {
    const QRgb shell = m_colours.arm.rgb();
    const QRgb joint = m_colours.armJoint.rgb();
    const double length_m = (to - from).norm();
    m_solids.sphere(from, kJoint * radius_m, joint);
    m_solids.sphere(to, 0.9 * radius_m, shell);
    const double before_m = (0.8 + kCollar) * radius_m;
    if (length_m < before_m + kLeastShell * radius_m) {
        m_solids.cone(from, to, radius_m, radius_m, shell);
        return;
    }
    const Eigen::Vector3d along = (to - from) / length_m;
    const auto at = [&](double way_m) { return Eigen::Vector3d(from + way_m * along); };
    const double bevel_m = kBevel * radius_m;
    m_solids.cone(at(0.8 * radius_m), at(before_m), 0.94 * radius_m, 0.94 * radius_m, joint);
    m_solids.cone(at(before_m), at(before_m + bevel_m), 0.9 * radius_m, radius_m, shell);
    m_solids.cone(at(before_m + bevel_m), at(length_m - bevel_m), radius_m, radius_m, shell);
    m_solids.cone(at(length_m - bevel_m), to, radius_m, 0.88 * radius_m, shell);
}

void ArmPart::drawBase(const Eigen::Vector3d& shoulder, double radius_m) {
    const double height_m = shoulder.z() - m_ground_m;
    if (height_m < -radius_m)
        return;
    const QRgb colour = m_colours.armJoint.rgb();
    const auto above = [&](double z_m) {
        return Eigen::Vector3d(shoulder.x(), shoulder.y(), m_ground_m + z_m);
    };
    // An arm that begins on the ground stands on its foot alone.
    const bool hasColumn = height_m >= 1.5 * radius_m;
    const double foot_m = hasColumn ? std::min(0.3 * radius_m, 0.3 * height_m) : 0.3 * radius_m;
    m_solids.cone(above(0.0), above(0.7 * foot_m), 2.1 * radius_m, 2.1 * radius_m, colour);
    m_solids.cone(above(0.7 * foot_m), above(foot_m), 2.1 * radius_m, 1.9 * radius_m, colour);
    if (hasColumn)
        m_solids.cone(above(foot_m), above(height_m), 0.95 * radius_m, 0.7 * radius_m, colour);
}

/// Bands around the link's projection, from dark to clear: the darkness falls without a kink at either end.
void ArmPart::drawShadow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius_m) {
    const double darkest = darknessOf(m_links.size());
    const double z_m = m_ground_m - kBelowGrid_m;
    const double height_m = std::max(0.0, 0.5 * (from.z() + to.z()) - m_ground_m);
    const double reach_m = kShadowReach * radius_m + kBlurPerHeight * height_m;
    const Eigen::Vector2d way = (to - from).head<2>();
    const double heading_rad = way.norm() > 0.0 ? std::atan2(way.y(), way.x()) : 0.0;
    const auto rim = [&](int side, double wide_m) {
        // The first half circle lies around `to`, the second one around `from`.
        const bool isEnd = side <= kShadowSides;
        const double turn =
            (isEnd ? side : side - 1) * std::numbers::pi / kShadowSides - 0.5 * std::numbers::pi;
        const Eigen::Vector3d& centre = isEnd ? to : from;
        return Eigen::Vector3d(centre.x() + wide_m * std::cos(heading_rad + turn),
                               centre.y() + wide_m * std::sin(heading_rad + turn), z_m);
    };
    const auto black = [darkest](double share) {
        const double fallen = std::clamp((share - kShadowMiddle) / (1.0 - kShadowMiddle), 0.0, 1.0);
        const double dark = 1.0 - fallen * fallen * (3.0 - 2.0 * fallen);
        return qRgba(0, 0, 0, static_cast<int>(std::lround(255.0 * darkest * dark)));
    };
    constexpr int kCorners = 2 * (kShadowSides + 1);
    for (int band = 0; band < kShadowBands; ++band) {
        const double inner = static_cast<double>(band) / kShadowBands;
        const double outer = static_cast<double>(band + 1) / kShadowBands;
        for (int side = 0; side < kCorners; ++side) {
            const int next = (side + 1) % kCorners;
            m_shadow.quad({rim(side, inner * reach_m), rim(side, outer * reach_m), rim(next, outer * reach_m),
                           rim(next, inner * reach_m)},
                          {black(inner), black(outer), black(outer), black(inner)});
        }
    }
}

} // namespace teleta::view3d
