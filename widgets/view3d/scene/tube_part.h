// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/camera_snapshot.h"
#include "widgets/view3d/mesh/mesh_actor.h"
#include "widgets/view3d/mesh/mesh_builder.h"
#include "widgets/view3d/scene/scene_colours.h"

#include <QColor>

#include <Eigen/Geometry>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <vector>

namespace teleta::view3d {

/// A contact on the tactile tube as it is drawn, in the frame {s} of its sensor.
struct TubeMark {
    int id = 0;
    QColor colour;
    Eigen::Vector3d p_Sensor_Foot; ///< on the skin
    double sd_m = 0.0;             ///< NaN: not known
    bool bumps = false;
    bool followed = false;
};

/// The tactile tube that a camera watches from inside: its skin, contact patches, the way that each contact
/// has moved, the region that holds its centre with 95 %, how the skin is displaced, and where the tube was
/// at the start. What no ray meets is not drawn. Thread: one.
class TubePart {
public:
    /// Vectors of the skin are drawn so many times longer than they are.
    static constexpr double kEnlargement = 4.0;
    /// How far the tube may move before the camera is fitted anew.
    static constexpr double kRoom_m = 0.02;
    /// Displacements of less than this, or than their standard deviation, are not drawn.
    static constexpr double kLeastVector_m = 0.0001;
    /// Radius of the ellipse that holds 95 % of a normal distribution of the plane, in standard deviations.
    static constexpr double kRegion = 2.4477;

    TubePart();
    void addTo(vtkRenderer* renderer);
    void applyColours(const SceneColours& colours);
    void applyPixelScale(double scale);
    void setDisplacementShown(bool shown);

    /// Returns whether the tube is another one or has left the room around where it was when this last said
    /// so. An arm's pose moves the tube in the world.
    bool set(const pipeline::CameraSnapshot& snapshot);
    void clear();

    [[nodiscard]] bool isShown() const { return m_shown; }
    [[nodiscard]] const vision::CylinderSurface& surface() const { return m_surface; }
    [[nodiscard]] const std::vector<TubeMark>& marks() const { return m_marks; }
    [[nodiscard]] const Eigen::Isometry3d& X_World_Sensor() const { return m_X_World_Sensor; }
    [[nodiscard]] bool hasVectors() const { return !m_vectors.isEmpty(); }
    /// Around the tube where it is and where it started, world frame; empty when it is not shown.
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
    bool m_moved = false;       ///< away from the start
    Eigen::AlignedBox3d m_room; ///< in which the tube may move without the camera being fitted anew
    vision::CylinderSurface m_surface;
    Eigen::Isometry3d m_X_World_Sensor = Eigen::Isometry3d::Identity();
    std::vector<TubeMark> m_marks;
    std::vector<Eigen::Vector3d> m_line;
    bool m_dark = false;
    QColor m_skinColour;
    QColor m_ringColour;
    QColor m_holderColour;
    QColor m_textColour;

    vtkNew<vtkMatrix4x4> m_pose;
    MeshBuilder m_skin;
    MeshBuilder m_rings{false};
    MeshBuilder m_start{false}; ///< in the world frame
    MeshBuilder m_solids;
    MeshBuilder m_outlines{false};
    MeshBuilder m_vectors{false};
    MeshActor m_skinActor;
    MeshActor m_ringActor;
    MeshActor m_startActor;
    MeshActor m_solidActor;
    MeshActor m_outlineActor;
    MeshActor m_vectorActor;
};

} // namespace teleta::view3d
