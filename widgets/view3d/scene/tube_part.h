// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/camera_snapshot.h"
#include "widgets/view3d/mesh/mesh_actor.h"
#include "widgets/view3d/scene/scene_colours.h"

#include <QColor>

#include <Eigen/Geometry>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <vector>

namespace teleta::view3d {

/// A drawn contact on the tactile tube, in the frame {s} of its sensor.
struct TubeMark {
    int id = 0;
    QColor colour;
    Eigen::Vector3d p_Sensor_Foot; ///< on the skin
    double sd_m = 0.0;             ///< NaN: unknown
    bool bumps = false;
    bool followed = false;
};

/// The tactile tube watched by a camera from inside: its skin, contact patches, the path of each contact, the
/// 95 % region of its centre, the displacement of the skin, and the tube's first place. Parts that no ray
/// meets are not drawn. Thread: one.
class TubePart {
public:
    /// Enlargement of the skin's displacement vectors.
    static constexpr double kEnlargement = 4.0;
    /// How far the tube may move before the camera is fitted again.
    static constexpr double kRoom_m = 0.02;
    /// Smaller displacements, and those below their standard deviation, are not drawn.
    static constexpr double kLeastVector_m = 0.0001;
    /// Radius of the 95 % ellipse of a bivariate normal distribution, in standard deviations.
    static constexpr double kRegion = 2.4477;

    TubePart();
    void addTo(vtkRenderer* renderer);
    void applyColours(const SceneColours& colours);
    void applyPixelScale(double scale);
    void setDisplacementShown(bool shown);

    /// Returns whether the tube is another one, or has left the room around the place where it was at the
    /// last such report. The arm's pose moves the tube in the world.
    bool set(const pipeline::CameraSnapshot& snapshot);
    void clear();

    [[nodiscard]] bool isShown() const { return m_shown; }
    [[nodiscard]] const vision::CylinderSurface& surface() const { return m_surface; }
    [[nodiscard]] const std::vector<TubeMark>& marks() const { return m_marks; }
    [[nodiscard]] const Eigen::Isometry3d& X_World_Sensor() const { return m_X_World_Sensor; }
    [[nodiscard]] bool hasVectors() const { return !m_vectors.isEmpty(); }
    /// Box around the tube's present and first place, world frame; empty when it is not shown.
    [[nodiscard]] Eigen::AlignedBox3d box_m() const;
    void appendMeshes(std::vector<vtkPolyData*>& meshes) const;
    [[nodiscard]] vtkMatrix4x4* pose() const { return m_pose; }

private:
    void rebuildBody();
    void rebuildContacts(const pipeline::CameraSnapshot& snapshot);
    void drawPatch(const vision::FollowedContact& followed, const TubeMark& mark);
    void drawWay(const vision::FollowedContact& followed, const TubeMark& mark);
    void drawRegion(const Eigen::Matrix3d& covariance_m2, const TubeMark& mark);
    void drawVectors(const std::vector<pipeline::SkinVector>& vectors);
    [[nodiscard]] Eigen::Vector3d onSkin(const Eigen::Vector3d& p_Sensor_m, double height_m) const;
    void setVisible();

    bool m_shown = false;
    bool m_displacementShown = true;
    bool m_moved = false;       ///< away from its first place
    Eigen::AlignedBox3d m_room; ///< where the tube may move before the camera is fitted again
    vision::CylinderSurface m_surface;
    Eigen::Isometry3d m_X_World_Sensor = Eigen::Isometry3d::Identity();
    std::vector<TubeMark> m_marks;
    std::vector<Eigen::Vector3d> m_line;
    SceneColours m_colours;

    vtkNew<vtkMatrix4x4> m_pose;
    Mesh m_skin{Mesh::Shading::flat};
    Mesh m_rings{Mesh::Shading::none};
    Mesh m_start{Mesh::Shading::none}; ///< in the world frame
    Mesh m_solids{Mesh::Shading::smooth};
    Mesh m_outlines{Mesh::Shading::none};
    Mesh m_vectors{Mesh::Shading::none};
};

} // namespace teleta::view3d
