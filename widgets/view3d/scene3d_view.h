// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pipeline/touch/touch_snapshot.h"
#include "widgets/base/controls/badge.h"
#include "widgets/view3d/mesh/surface_map.h"
#include "widgets/view3d/orbit.h"
#include "widgets/view3d/scene/scene_types.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <span>

class QMenu;

namespace teleta::view3d {
struct GelWords;
struct RobotShape;
} // namespace teleta::view3d

namespace teleta::pipeline {
struct CameraSnapshot;
struct GelSnapshot;
} // namespace teleta::pipeline

namespace teleta::view3d {

/// The touch in space: the tactile array, flat or wrapped around a cylinder, with loads as heights and
/// colours, contacts with force arrows and displacements; and, in the world frame, the arm with the trail of
/// its tip and the joints that are near a limit, and the contour explored by touch. While hidden, or without
/// OpenGL, it only stores what it is given.
///
/// Mouse: left turns, middle or Shift+left moves, right or wheel zooms, right click opens the menu; hover
/// names a contact, a left click picks an object. Keys: 1 front, 2 top, 3 side, 4 isometric, R or Home the
/// initial view, 5 projection, 6 from the hand, F follow, arrows
/// turn, Shift+arrows move, + - zoom, Ctrl+C copies the picture.
/// Thread: GUI.
class Scene3dView : public QWidget {
    Q_OBJECT
public:
    explicit Scene3dView(QWidget* parent = nullptr);
    ~Scene3dView() override;

    /// Shows a new snapshot. One that cannot be drawn (layout, sizes) clears the view.
    void setSnapshot(const pipeline::TouchSnapshot& snapshot);
    void clear();
    void setProvenance(base::Provenance provenance);

    void setSurface(Surface surface);
    [[nodiscard]] Surface surface() const;
    /// Ignored unless finite and > 0. Enlarged if the array does not fit.
    void setCylinder(const CylinderSize& cylinder);
    /// Pose of the array's frame in the world; identity at first. Ignored unless finite.
    void setSensorPose(const Eigen::Isometry3d& X_World_Sensor);
    [[nodiscard]] const Eigen::Isometry3d& sensorPose() const;
    /// Explored contact points, the spline through them, vertices, and the name of the recognised shape;
    /// world frame, m. Points that are not finite are left out. All empty: nothing is shown.
    void setContour(std::span<const Eigen::Vector3d> points_m, std::span<const Eigen::Vector3d> curve_m,
                    std::span<const Eigen::Vector3d> vertices_m, const QString& label);
    /// The objects that were found before the one whose contour is shown, each with its outline and label.
    void setObjects(std::span<const DrawnObject> objects);
    /// The arm, starting at its base; empty: none.
    void setArmLinks(std::span<const ArmLink> links);
    /// What the arm's links look like, in the world frame at poses of their own; null: as setArmLinks() has
    /// them.
    void setRobot(std::shared_ptr<const RobotShape> shape);
    /// Of all links of the robot, and where it is told to be, which is drawn as a ghost; empty: no ghost.
    void setRobotPoses(std::span<const Eigen::Isometry3d> X_World_Link,
                       std::span<const Eigen::Isometry3d> commanded);
    /// Where the arm's tip is at a time of the arm's own: it draws a trail that fades over 5 s. The trail
    /// begins anew when the time goes back or jumps.
    void setTip(const Eigen::Vector3d& p_World_m, double time_s);
    /// All joints of the arm that turn, always in the same order; one that is near the end of its range is
    /// marked. Empty: none.
    void setJoints(std::span<const JointDial> dials);
    /// The force that the arm's joints tell; empty: they tell none. Shown while the array's loads are in N.
    void setForce(const std::optional<DrawnForce>& force);
    [[nodiscard]] const std::optional<DrawnForce>& force() const;
    /// The array is bent in truth, however it is drawn: the moment of its loads is not known.
    void setArrayBent(bool bent);
    /// What a simulated world has around the arm.
    void setScenery(std::span<const SceneryItem> items);
    [[nodiscard]] const std::vector<SceneryItem>& scenery() const;
    /// No robot, no trail, no joints, no force.
    void forgetArm();
    /// Bounding box of the arm shown; empty: none. World frame, m.
    [[nodiscard]] const Eigen::AlignedBox3d& armBox_m() const;
    /// The tube watched by a camera from inside, with its contacts; null: none.
    void setTube(const pipeline::CameraSnapshot* snapshot);
    /// The flat gel with markers watched by a camera; null: none. enlargement: of its displacements. words:
    /// one a contact, see GelPart.
    void setGel(const pipeline::GelSnapshot* snapshot, double enlargement, std::span<const GelWords> words);

    /// A box in the world frame: the view begins with it, and Home goes back to it. Empty: the whole scene.
    void setSubject(const Eigen::AlignedBox3d& box_m);
    void look(CameraPreset preset);
    [[nodiscard]] const Orbit& orbit() const;
    /// The isometric view of everything, or of the subject.
    void resetView();
    /// Shows all of another source: nothing of the last one is followed any more.
    void frame();

    /// Names of the layers that are switched off, for the settings.
    [[nodiscard]] QStringList hiddenLayers() const;
    void setHiddenLayers(const QStringList& names);

    /// All actions of the view; also the context menu.
    void fillMenu(QMenu& menu);
    /// Writes the drawn geometry as .vtp, .ply or .stl, in mm. Errors: see exportGeometry().
    [[nodiscard]] core::Expected<void> saveGeometry(const QString& path) const;

signals:
    /// A picture, its data or the geometry was written.
    void saved(const QString& path);
    void failed(const QString& message);
    /// An object of setObjects() was clicked.
    void objectPicked(quint64 number);
    /// A layer was switched on or off.
    void layersChanged();

protected:
    bool event(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Parts;

    void makeActions();
    void makeToolBar();
    void retranslate();
    void applyPalette();
    void refresh();
    void showLayers();
    void sceneMoved(bool refit);
    void askForGeometryFile();

    std::unique_ptr<Parts> m_parts;
};

} // namespace teleta::view3d
