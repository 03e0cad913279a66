// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene/robot_part.h"

#include <algorithm>
#include <utility>

namespace teleta::view3d {

namespace {

constexpr double kGhostOpacity = 0.25;

Eigen::AlignedBox3d boxOf(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3f& point_m : mesh.points_m)
        box.extend(point_m.cast<double>());
    return box;
}

} // namespace

void RobotPart::applyColours(const SceneColours& colours) {
    m_colours = colours;
    rebuild();
}

void RobotPart::setShape(std::shared_ptr<const RobotShape> shape) {
    for (const auto& link : m_links) {
        m_renderer->RemoveActor(link->mesh.actor);
        m_renderer->RemoveActor(link->ghost);
    }
    m_links.clear();
    m_shape = std::move(shape);
    m_shown = m_ghostShown = false;
    m_box_m.setEmpty();
    for (std::size_t i = 0; m_shape && i < m_shape->links.size(); ++i) {
        if (m_shape->links[i].corners.empty())
            continue;
        Link& link = *m_links.emplace_back(std::make_unique<Link>());
        link.index = i;
        link.box_m = boxOf(m_shape->links[i]);
        link.mesh.actor->SetUserMatrix(link.pose);
        link.mesh.actor->SetVisibility(false);
        link.ghost->SetMapper(link.mesh.mapper);
        link.ghost->SetUserMatrix(link.ghostPose);
        link.ghost->SetProperty(vtkNew<vtkProperty>());
        link.ghost->GetProperty()->SetOpacity(kGhostOpacity);
        link.ghost->SetVisibility(false);
        m_renderer->AddActor(link.mesh.actor);
        m_renderer->AddActor(link.ghost);
    }
    rebuild();
}

void RobotPart::rebuild() {
    for (const auto& link : m_links) {
        const TriangleMesh& shape = m_shape->links[link->index];
        link->mesh.clear();
        link->mesh.triangles(shape.points_m, shape.normals, shape.colours, shape.corners,
                             m_colours.arm.rgb());
        link->mesh.finish();
    }
}

bool RobotPart::fits(std::span<const Eigen::Isometry3d> X_World_Link) const {
    return hasShape() && X_World_Link.size() == m_shape->links.size() &&
           std::ranges::all_of(X_World_Link,
                               [](const Eigen::Isometry3d& pose) { return pose.matrix().allFinite(); });
}

void RobotPart::setPoses(std::span<const Eigen::Isometry3d> X_World_Link) {
    m_shown = fits(X_World_Link);
    m_box_m.setEmpty();
    for (const auto& link : m_links) {
        link->mesh.actor->SetVisibility(m_shown);
        if (!m_shown)
            continue;
        setMatrix(*link->pose, X_World_Link[link->index]);
        for (int corner = 0; corner < 8; ++corner)
            m_box_m.extend(X_World_Link[link->index] *
                           link->box_m.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
    }
}

void RobotPart::setGhost(std::span<const Eigen::Isometry3d> X_World_Link) {
    m_ghostShown = m_shown && fits(X_World_Link);
    for (const auto& link : m_links) {
        link->ghost->SetVisibility(m_ghostShown);
        if (m_ghostShown)
            setMatrix(*link->ghostPose, X_World_Link[link->index]);
    }
}

} // namespace teleta::view3d
