// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_snapshot.h"
#include "widgets/base/numbers/calm_range.h"
#include "widgets/view3d/mesh/blending_renderer.h"
#include "widgets/view3d/scene/arm_part.h"
#include "widgets/view3d/scene/contact_part.h"
#include "widgets/view3d/scene/contour_part.h"
#include "widgets/view3d/scene/frame_part.h"
#include "widgets/view3d/scene/gel_part.h"
#include "widgets/view3d/scene/objects_part.h"
#include "widgets/view3d/scene/place_raster.h"
#include "widgets/view3d/scene/robot_part.h"
#include "widgets/view3d/scene/scene_colours.h"
#include "widgets/view3d/scene/sensor_part.h"
#include "widgets/view3d/scene/tube_part.h"

#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace teleta::view3d {

/// The content of the 3-D view as VTK actors in a renderer, independent of widgets. Actors are created once:
/// a snapshot changes arrays in place. Thread: GUI.
class TouchScene {
public:
    explicit TouchScene(const SceneColours& colours);

    [[nodiscard]] vtkRenderer* renderer() const { return m_renderer; }

    enum class Taken {
        fresh,
        same,    ///< the frame is already there
        refused, ///< cannot be drawn: a layout or an array of the wrong size
    };
    /// Stores the newest frame; draw() shows it.
    Taken take(const pipeline::TouchSnapshot& snapshot);
    /// Discards the frame: no sensor is shown.
    void clear();
    /// Updates the actors. Returns whether the outer shape of the scene changed, so that the camera may have
    /// to be fitted again.
    bool draw();

    void setSurface(Surface surface);
    void setCylinder(const CylinderSize& cylinder);
    void setSensorPose(const Eigen::Isometry3d& X_World_Sensor);
    void setContour(std::span<const Eigen::Vector3d> points_m, std::span<const Eigen::Vector3d> curve_m,
                    std::span<const Eigen::Vector3d> vertices_m);
    /// The objects that were found before.
    void setObjects(std::span<const DrawnObject> objects);
    /// Drawn unless a robot is.
    void setArmLinks(std::span<const ArmLink> links);
    /// What the arm's links look like; null: nobody says, and tubes are drawn between its joints.
    void setRobot(std::shared_ptr<const RobotShape> shape);
    /// Where its links are, and where they are told to be (empty: there).
    void setRobotPoses(std::span<const Eigen::Isometry3d> X_World_Link,
                       std::span<const Eigen::Isometry3d> commanded);
    [[nodiscard]] std::span<const ArmLink> armLinks() const { return m_arm.links(); }
    [[nodiscard]] const RobotPart& robot() const { return m_robot; }
    void setGridShown(bool shown) { m_ground.setVisible(shown); }
    void setAxesShown(bool shown);
    void setDisplacementShown(bool shown) {
        m_contacts.setDisplacementShown(shown);
        m_tube.setDisplacementShown(shown);
        m_gel.setDisplacementShown(shown);
    }
    void setForcesShown(bool shown) {
        m_contacts.setForcesShown(shown);
        m_gel.setForcesShown(shown);
    }
    void setTurnsShown(bool shown) { m_gel.setTurnsShown(shown); }
    /// A force on the arm: one that is drawn beside the contacts' has their scale, and the longest arrow of
    /// one with a scale of its own fits into corners(). Empty: there is none.
    void setForce(const std::optional<DrawnForce>& force);
    /// Length of the longest arrow of the latter.
    [[nodiscard]] double armArrow_m() const;
    /// The tube watched by a camera; null: none. Returns whether the outer shape of the scene changed.
    bool setTube(const pipeline::CameraSnapshot* snapshot);
    [[nodiscard]] const TubePart& tube() const { return m_tube; }
    /// The flat gel watched by a camera; null: none. Otherwise as GelPart::set(). Returns whether the outer
    /// shape of the scene changed.
    bool setGel(const pipeline::GelSnapshot* snapshot, double enlargement, std::span<const GelWords> words);
    [[nodiscard]] const GelPart& gel() const { return m_gel; }
    void applyColours(const SceneColours& colours);
    void applyPixelScale(double scale);

    [[nodiscard]] bool hasSensor() const { return m_hasSensor; }
    /// The frame as it is drawn: taxels that stand on no grid are on one that covers them.
    [[nodiscard]] const pipeline::TouchSnapshot& snapshot() const { return m_snapshot; }
    [[nodiscard]] const SceneColours& colours() const { return m_colours; }
    [[nodiscard]] Surface surface() const { return m_surface; }
    /// The drawn cylinder: enlarged if the array would not fit.
    [[nodiscard]] CylinderSize cylinder() const;
    [[nodiscard]] bool cylinderWasEnlarged() const {
        return m_hasSensor && !(cylinder() == m_wantedCylinder);
    }
    [[nodiscard]] const DrawnGrid& grid() const { return m_sensor.grid(); }
    [[nodiscard]] const SensorSize& sensorSize() const { return m_sensor.size(); }
    /// By decreasing force.
    [[nodiscard]] const std::vector<ContactMark>& marks() const { return m_contacts.marks(); }
    [[nodiscard]] const AxesPart& axes() const { return m_axes; }
    [[nodiscard]] bool axesShown() const { return m_axesShown && m_hasSensor; }
    [[nodiscard]] Eigen::Vector3d toWorld(const Eigen::Vector3d& p_Sensor) const {
        return m_X_World_Sensor * p_Sensor;
    }
    /// Of loadRange_N(), of each cell as it was drawn last; NaN: dead.
    [[nodiscard]] std::span<const float> loadShares() const { return m_cell_N; }
    /// Load of the full height and the last colour, in the snapshot's unit.
    [[nodiscard]] double loadRange_N() const { return m_loadRange.high(); }
    /// Force of the longest arrow.
    [[nodiscard]] double forceRange_N() const { return m_forceRange.high(); }
    [[nodiscard]] double gridSpacing_m() const { return m_ground.spacing_m(); }
    [[nodiscard]] const Eigen::AlignedBox3d& contourBox_m() const { return m_contour.box_m(); }
    [[nodiscard]] const ObjectsPart& objects() const { return m_objects; }
    [[nodiscard]] const Eigen::AlignedBox3d& armBox_m() const {
        return m_robot.isShown() ? m_robot.box_m() : m_arm.box_m();
    }
    [[nodiscard]] const Eigen::Isometry3d& X_World_Sensor() const { return m_X_World_Sensor; }
    [[nodiscard]] bool isEmpty() const {
        return !m_hasSensor && !m_tube.isShown() && !m_gel.isShown() && contourBox_m().isEmpty() &&
               armBox_m().isEmpty() && m_objects.objects().empty();
    }

    /// Corners of everything the camera should show, in the world frame. Independent of the loads. Never
    /// empty.
    [[nodiscard]] std::vector<Eigen::Vector3d> corners() const;
    /// The data as meshes in the world frame (m): sensor, contacts, contour, arm. Each call copies.
    [[nodiscard]] std::vector<vtkSmartPointer<vtkPolyData>> worldMeshes() const;

private:
    void rebuildSensor();
    void coverGround(bool always);
    [[nodiscard]] Eigen::AlignedBox3d sensorBox_m() const;

    SceneColours m_colours;
    pipeline::TouchSnapshot m_snapshot; ///< on a grid
    core::TaxelLayout m_layout;         ///< as the snapshots have it
    std::optional<PlaceRaster> m_raster;
    FirstTouch m_touches;
    base::CalmRange m_loadRange{1.0};
    base::CalmRange m_forceRange{1.0};
    double m_rangeThreshold_N = 0.0;
    double m_otherForce_N = 0.0;
    std::optional<Eigen::Vector3d> m_armForceAt_m;
    Surface m_surface = Surface::plate;
    CylinderSize m_wantedCylinder;
    Eigen::Isometry3d m_X_World_Sensor = Eigen::Isometry3d::Identity();
    bool m_hasSensor = false;
    bool m_axesShown = true;
    bool m_bodyStale = false;
    bool m_frameStale = false;
    std::vector<float> m_cell_N;

    vtkNew<BlendingRenderer> m_renderer;
    vtkNew<vtkMatrix4x4> m_poseMatrix;
    SensorPart m_sensor;
    ContactPart m_contacts;
    GridPart m_ground;
    AxesPart m_axes;
    ContourPart m_contour;
    ObjectsPart m_objects;
    ArmPart m_arm;
    RobotPart m_robot{m_renderer};
    TubePart m_tube;
    GelPart m_gel;
};

} // namespace teleta::view3d
