// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene/tube_part.h"

#include "widgets/base/colour_maps.h"
#include "widgets/base/theme.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::view3d {

namespace {

constexpr int kTubeSides = 64;
constexpr int kTubeRings = 5;
constexpr double kHolder_m = 0.075; ///< part held by the arm, on the lens's side
constexpr double kHolderShare = 0.86;
constexpr double kTubeOutline_px = 3.0;
constexpr double kVector_px = 2.2;
constexpr double kLift = 0.012; ///< of marks above the skin, in radii
constexpr double kMark = 0.045; ///< radius of the sphere at a centre, in radii
constexpr double kStartMoved_m = 0.0005;

Eigen::Vector3d onCircle(double radius_m, double angle_rad, double z_m) {
    return {radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad), z_m};
}

double turnOf(int side) {
    return 2.0 * std::numbers::pi * side / kTubeSides;
}

} // namespace

TubePart::TubePart() {
    for (Mesh* mesh : {&m_skin, &m_rings, &m_solids, &m_outlines, &m_vectors})
        mesh->actor->SetUserMatrix(m_pose);
    // The outlines of contacts on the far side stay visible.
    m_outlines.showThrough();
    setVisible();
}

void TubePart::addTo(vtkRenderer* renderer) {
    for (Mesh* mesh : {&m_skin, &m_rings, &m_start, &m_solids, &m_outlines, &m_vectors})
        renderer->AddActor(mesh->actor);
}

void TubePart::applyColours(const SceneColours& colours) {
    m_colours = colours;
    if (m_shown)
        rebuildBody();
}

void TubePart::applyPixelScale(double scale) {
    m_rings.setLineWidth(1.0, scale);
    m_start.setLineWidth(1.2, scale);
    m_outlines.setLineWidth(kTubeOutline_px, scale);
    m_vectors.setLineWidth(kVector_px, scale);
}

void TubePart::setDisplacementShown(bool shown) {
    m_displacementShown = shown;
    setVisible();
}

void TubePart::setVisible() {
    for (Mesh* mesh : {&m_skin, &m_rings, &m_solids, &m_outlines})
        mesh->actor->SetVisibility(m_shown);
    m_vectors.actor->SetVisibility(m_shown && m_displacementShown);
    m_start.actor->SetVisibility(m_shown && m_moved);
}

bool TubePart::set(const pipeline::CameraSnapshot& snapshot) {
    if (!snapshot.surface.isUsable()) {
        const bool was = m_shown;
        clear();
        return was;
    }
    const vision::CylinderSurface& surface = snapshot.surface;
    const bool other = !m_shown || surface.radius_m != m_surface.radius_m ||
                       surface.lowest_z_m != m_surface.lowest_z_m ||
                       surface.highest_z_m != m_surface.highest_z_m;
    m_shown = true;
    if (other) {
        m_surface = surface;
        rebuildBody();
    }
    m_X_World_Sensor =
        snapshot.carrier ? snapshot.carrier->X_Base_Sensor : Eigen::Isometry3d(Eigen::Isometry3d::Identity());
    m_moved = m_X_World_Sensor.translation().norm() > kStartMoved_m;
    setMatrix(*m_pose, m_X_World_Sensor);
    rebuildContacts(snapshot);
    setVisible();
    const Eigen::AlignedBox3d box = box_m();
    const bool left = other || !m_room.contains(box);
    if (left) {
        const Eigen::Vector3d room_m = Eigen::Vector3d::Constant(kRoom_m);
        m_room = {box.min() - room_m, box.max() + room_m};
    }
    return left;
}

void TubePart::clear() {
    m_shown = false;
    m_marks.clear();
    for (Mesh* mesh : {&m_skin, &m_rings, &m_start, &m_solids, &m_outlines, &m_vectors}) {
        mesh->clear();
        mesh->finish();
    }
    setVisible();
}

Eigen::Vector3d TubePart::onSkin(const Eigen::Vector3d& p_Sensor_m, double height_m) const {
    const double rho_m = p_Sensor_m.head<2>().norm();
    if (!(rho_m > 0.0))
        return p_Sensor_m;
    const double scale = (m_surface.radius_m + height_m) / rho_m;
    return {scale * p_Sensor_m.x(), scale * p_Sensor_m.y(), p_Sensor_m.z()};
}

void TubePart::rebuildBody() {
    m_skin.clear();
    m_rings.clear();
    m_start.clear();
    const double radius_m = m_surface.radius_m;
    const double low_m = m_surface.lowest_z_m;
    const double high_m = m_surface.highest_z_m;
    const auto wall = [&](double share, double from_m, double to_m, const QColor& colour) {
        for (int side = 0; side < kTubeSides; ++side) {
            const double a = turnOf(side);
            const double b = turnOf(side + 1);
            m_skin.quad(onCircle(share * radius_m, a, from_m), onCircle(share * radius_m, b, from_m),
                        onCircle(share * radius_m, b, to_m), onCircle(share * radius_m, a, to_m),
                        colour.rgb());
        }
    };
    wall(1.0, low_m, high_m, m_colours.cylinder);
    wall(kHolderShare, low_m - kHolder_m, low_m, m_colours.arm);
    const auto lid = [&](double share, double z_m, const QColor& colour) {
        const Eigen::Vector3d middle(0.0, 0.0, z_m);
        for (int side = 0; side < kTubeSides; side += 2)
            m_skin.quad(middle, onCircle(share * radius_m, turnOf(side), z_m),
                        onCircle(share * radius_m, turnOf(side + 1), z_m),
                        onCircle(share * radius_m, turnOf(side + 2), z_m), colour.rgb());
    };
    lid(1.0, high_m, m_colours.cylinder);
    lid(1.0, low_m, m_colours.cylinder);
    lid(kHolderShare, low_m - kHolder_m, m_colours.arm);
    const QColor faint = base::mixed(m_colours.cylinder, m_colours.backgroundTop, 0.6);
    const auto ring = [&](MeshBuilder& mesh, double r_m, double z_m, const QColor& colour) {
        m_line.clear();
        for (int side = 0; side < kTubeSides; ++side)
            m_line.push_back(onCircle(r_m, turnOf(side), z_m));
        mesh.polyline(m_line, colour.rgb(), true);
    };
    for (int i = 0; i <= kTubeRings; ++i)
        ring(m_rings, (1.0 + 0.3 * kLift) * radius_m, low_m + (high_m - low_m) * i / kTubeRings, faint);
    // A line along x makes rotations of the tube visible.
    m_rings.segment(onCircle((1.0 + 0.3 * kLift) * radius_m, 0.0, low_m),
                    onCircle((1.0 + 0.3 * kLift) * radius_m, 0.0, high_m), m_colours.text.rgb());
    for (const double z_m : {low_m, high_m})
        ring(m_start, radius_m, z_m, faint);
    for (int side = 0; side < kTubeSides; side += kTubeSides / 8)
        m_start.segment(onCircle(radius_m, turnOf(side), low_m), onCircle(radius_m, turnOf(side), high_m),
                        faint.rgb());
    m_skin.finish();
    m_rings.finish();
    m_start.finish();
}

void TubePart::rebuildContacts(const pipeline::CameraSnapshot& snapshot) {
    m_marks.clear();
    m_solids.clear();
    m_outlines.clear();
    m_vectors.clear();
    for (std::size_t i = 0; i < snapshot.contacts.size(); ++i) {
        const vision::FollowedContact& followed = snapshot.contacts[i];
        const vision::CameraContact& contact = followed.contact;
        if (!contact.located || followed.event == vision::ContactEvent::ends ||
            !contact.p_Sensor_Centre_m.allFinite())
            continue;
        TubeMark mark;
        mark.id = contact.id;
        mark.colour = base::identityColour(std::max(1, contact.id), m_colours.dark);
        mark.p_Sensor_Foot = onSkin(contact.p_Sensor_Centre_m, kLift * m_surface.radius_m);
        mark.sd_m = contact.sd_m;
        mark.bumps = snapshot.bump && snapshot.bump->contact == contact.id;
        if (snapshot.carrier && snapshot.carrier->contact == contact.id) {
            mark.bumps = mark.bumps || snapshot.carrier->doing == pipeline::CarrierReport::Doing::retreats;
            mark.followed = snapshot.carrier->doing == pipeline::CarrierReport::Doing::follows;
        }
        drawPatch(followed, mark);
        drawWay(followed, mark);
        if (i < snapshot.covariances_m2.size())
            drawRegion(snapshot.covariances_m2[i], mark);
        m_marks.push_back(std::move(mark));
    }
    drawVectors(snapshot.vectors);
    m_solids.finish();
    m_outlines.finish();
    m_vectors.finish();
}

void TubePart::drawPatch(const vision::FollowedContact& followed, const TubeMark& mark) {
    const double lift_m = kLift * m_surface.radius_m;
    const auto& contour = followed.contact.contour_m;
    m_line.clear();
    for (const Eigen::Vector3d& p : contour)
        if (p.allFinite())
            m_line.push_back(onSkin(p, 0.6 * lift_m));
    const Eigen::Vector3d centre = onSkin(followed.contact.p_Sensor_Centre_m, 0.6 * lift_m);
    const QColor fill = base::mixed(m_colours.cylinder, mark.colour, 0.55);
    // Each sector in strips from its middle, so that the patch follows the tube.
    constexpr int kStrips = 4;
    for (std::size_t i = 0; m_line.size() >= 3 && i < m_line.size(); ++i) {
        const Eigen::Vector3d& a = m_line[i];
        const Eigen::Vector3d& b = m_line[(i + 1) % m_line.size()];
        for (int strip = 0; strip < kStrips; ++strip) {
            const double from = static_cast<double>(strip) / kStrips;
            const double to = static_cast<double>(strip + 1) / kStrips;
            const auto between = [&](const Eigen::Vector3d& end, double share) {
                return onSkin(centre + share * (end - centre), 0.6 * lift_m);
            };
            m_solids.quad(between(a, from), between(b, from), between(b, to), between(a, to), fill.rgb());
        }
    }
    if (m_line.size() >= 3) {
        for (Eigen::Vector3d& p : m_line)
            p = onSkin(p, lift_m);
        m_outlines.polyline(m_line, mark.colour.rgb(), true);
    }
    m_solids.sphere(mark.p_Sensor_Foot, kMark * m_surface.radius_m, mark.colour.rgb());
    if (mark.bumps) {
        // Direction in which the arm retreats, through the axis.
        const Eigen::Vector3d out =
            Eigen::Vector3d(mark.p_Sensor_Foot.x(), mark.p_Sensor_Foot.y(), 0.0).normalized();
        const double length_m = 0.8 * m_surface.radius_m;
        const Eigen::Vector3d tip = mark.p_Sensor_Foot + kMark * m_surface.radius_m * out;
        m_solids.arrow(tip + length_m * out, tip, 0.05 * m_surface.radius_m, 0.25 * m_surface.radius_m,
                       mark.colour.rgb());
    }
}

void TubePart::drawWay(const vision::FollowedContact& followed, const TubeMark& mark) {
    const Eigen::Vector3d& start = followed.p_Sensor_Start_m;
    const Eigen::Vector3d& now = followed.contact.p_Sensor_Centre_m;
    if (!start.allFinite() || (now - start).norm() < 1.5 * kMark * m_surface.radius_m)
        return;
    constexpr int kSteps = 24;
    const double from_rad = std::atan2(start.y(), start.x());
    const double way_rad = std::remainder(std::atan2(now.y(), now.x()) - from_rad, 2.0 * std::numbers::pi);
    const double radius_m = (1.0 + 1.5 * kLift) * m_surface.radius_m;
    m_line.clear();
    for (int i = 0; i <= kSteps; ++i) {
        const double share = static_cast<double>(i) / kSteps;
        m_line.push_back(
            onCircle(radius_m, from_rad + share * way_rad, start.z() + share * (now.z() - start.z())));
    }
    m_outlines.polyline(m_line, mark.colour.rgb());
    m_solids.octahedron(m_line.front(), 0.8 * kMark * m_surface.radius_m, mark.colour.rgb());
}

void TubePart::drawRegion(const Eigen::Matrix3d& covariance_m2, const TubeMark& mark) {
    if (!covariance_m2.allFinite())
        return;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance_m2);
    if (solver.info() != Eigen::Success || !(solver.eigenvalues()[2] > 0.0))
        return;
    const Eigen::Vector3d major = kRegion * std::sqrt(solver.eigenvalues()[2]) * solver.eigenvectors().col(2);
    const Eigen::Vector3d minor =
        kRegion * std::sqrt(std::max(solver.eigenvalues()[1], 0.0)) * solver.eigenvectors().col(1);
    m_line.clear();
    for (int side = 0; side < kTubeSides; ++side)
        m_line.push_back(
            onSkin(mark.p_Sensor_Foot + std::cos(turnOf(side)) * major + std::sin(turnOf(side)) * minor,
                   2.0 * kLift * m_surface.radius_m));
    m_outlines.polyline(m_line, m_colours.text.rgb(), true);
}

void TubePart::drawVectors(const std::vector<pipeline::SkinVector>& vectors) {
    double longest_m = 0.0005;
    for (const pipeline::SkinVector& vector : vectors)
        longest_m = std::max(longest_m, vector.displacement_m.norm());
    for (const pipeline::SkinVector& vector : vectors) {
        const double length_m = vector.displacement_m.norm();
        if (!(length_m >= std::max(kLeastVector_m, vector.sd_m)) || !vector.p_Sensor_m.allFinite())
            continue;
        // Displacements close to their uncertainty fade into the skin.
        const double certain = std::clamp(1.0 - vector.sd_m / length_m, 0.0, 1.0);
        const QColor full =
            QColor::fromRgb(base::colourAt(base::cividis(), 0.45 + 0.55 * length_m / longest_m));
        const QColor colour = base::mixed(m_colours.cylinder, full, 0.25 + 0.75 * certain);
        const Eigen::Vector3d from = onSkin(vector.p_Sensor_m, 1.2 * kLift * m_surface.radius_m);
        const Eigen::Vector3d to = onSkin(vector.p_Sensor_m + kEnlargement * vector.displacement_m,
                                          1.2 * kLift * m_surface.radius_m);
        m_vectors.segment(from, to, colour.rgb());
    }
}

Eigen::AlignedBox3d TubePart::box_m() const {
    Eigen::AlignedBox3d box;
    if (!m_shown)
        return box;
    const double reach_m = 1.1 * m_surface.radius_m;
    const Eigen::AlignedBox3d tube(Eigen::Vector3d(-reach_m, -reach_m, m_surface.lowest_z_m - kHolder_m),
                                   Eigen::Vector3d(reach_m, reach_m, m_surface.highest_z_m));
    box.extend(tube);
    for (int i = 0; i < 8; ++i)
        box.extend(m_X_World_Sensor * tube.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
    return box;
}

void TubePart::appendMeshes(std::vector<vtkPolyData*>& meshes) const {
    if (!m_shown)
        return;
    for (const Mesh* mesh : {&m_skin, &m_solids, &m_outlines})
        meshes.push_back(mesh->data());
    if (m_displacementShown)
        meshes.push_back(m_vectors.data());
}

} // namespace teleta::view3d
