// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/mesh/mesh_actor.h"
#include "widgets/view3d/robot/robot_shape.h"
#include "widgets/view3d/scene/scene_colours.h"

#include <Eigen/Geometry>
#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace teleta::view3d {

/// A robot by the shapes of its links in the world frame, and as a ghost where it is told to be. Its meshes
/// are handed to the driver once; a new pose moves them. Thread: one.
class RobotPart {
public:
    explicit RobotPart(vtkRenderer* renderer)
        : m_renderer(renderer) {}

    void applyColours(const SceneColours& colours);
    /// Null, or without triangles: none.
    void setShape(std::shared_ptr<const RobotShape> shape);
    [[nodiscard]] bool hasShape() const { return !m_links.empty(); }
    /// Of all links, in the order of the shape; another number, or numbers that are not finite: it is not
    /// shown.
    void setPoses(std::span<const Eigen::Isometry3d> X_World_Link);
    /// The same of the ghost; empty: none.
    void setGhost(std::span<const Eigen::Isometry3d> X_World_Link);
    [[nodiscard]] bool isShown() const { return m_shown; }
    [[nodiscard]] bool ghostShown() const { return m_ghostShown; }
    /// Around all shapes but the ghost; empty when it is not shown.
    [[nodiscard]] const Eigen::AlignedBox3d& box_m() const { return m_box_m; }
    /// Calls it with each mesh and its pose in the world.
    template <typename Take>
    void forEachMesh(const Take& take) const {
        for (const auto& link : m_links)
            if (m_shown)
                take(link->mesh.data(), link->pose.Get());
    }

    /// Calls it with the pose of each link that has a mesh, and with those of the ghost.
    template <typename Take>
    void forEachPose(const Take& take) const {
        for (const auto& link : m_links) {
            if (m_shown)
                take(isometryOf(*link->pose));
            if (m_ghostShown)
                take(isometryOf(*link->ghostPose));
        }
    }

private:
    /// A link with triangles.
    struct Link {
        std::size_t index = 0;     ///< in the shape
        Eigen::AlignedBox3d box_m; ///< in the frame of the link
        Mesh mesh{Mesh::Shading::smooth};
        vtkNew<vtkMatrix4x4> pose;
        vtkNew<vtkActor> ghost;
        vtkNew<vtkMatrix4x4> ghostPose;
    };

    void rebuild();
    [[nodiscard]] bool fits(std::span<const Eigen::Isometry3d> X_World_Link) const;

    vtkRenderer* m_renderer;
    SceneColours m_colours;
    std::shared_ptr<const RobotShape> m_shape;
    std::vector<std::unique_ptr<Link>> m_links;
    bool m_shown = false;
    bool m_ghostShown = false;
    Eigen::AlignedBox3d m_box_m;
};

} // namespace teleta::view3d
