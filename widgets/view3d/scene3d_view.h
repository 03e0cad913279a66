// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pipeline/touch/touch_snapshot.h"
#include "widgets/base/controls/badge.h"
#include "widgets/view3d/mesh/surface_map.h"
#include "widgets/view3d/orbit.h"
#include "widgets/view3d/scene/scene_types.h"

#include <QVariantMap>
#include <QWidget>

#include <memory>
#include <optional>
#include <span>

class QAction;
class QMenu;

namespace teleta::pipeline {
struct CameraSnapshot;
}

namespace teleta::view3d {

class VtkWidget;

/// The touch in space: the tactile array, flat or wrapped on a cylinder, with loads as heights and colours,
/// contacts with force arrows and displacements; and, in the world frame, the arm and the contour explored by
/// touch. Shows what it was given last and owns no other truth. While hidden, or without OpenGL, it only
/// remembers.
///
/// Mouse: left turns, middle or Shift+left moves, right or wheel zooms, right click opens the menu; hover
/// names a contact. Keys: 1 front, 2 top, 3 side, 4 isometric, R or Home the start, 5 projection, F follow,
/// arrows turn, Shift+arrows move, + - zoom, Ctrl+C copies the picture. Thread: GUI.
class Scene3dView : public QWidget {
    Q_OBJECT
public:
    enum class Layer { grid, axes, displacement, contactLabels };
    static constexpr int kLayers = 4;

    explicit Scene3dView(QWidget* parent = nullptr);
    ~Scene3dView() override;

    /// Takes over the newest snapshot. One that cannot be drawn (layout, sizes) clears the view.
    void setSnapshot(const pipeline::TouchSnapshot& snapshot);
    /// No data: the empty text is shown.
    void clear();
    void setEmptyText(const QString& text);
    /// Marks data that are not live with a violet label.
    void setProvenance(base::Provenance provenance);
    /// Load at the upper end of heights and colours, in the snapshot's unit; empty: follows the data. > 0 and
    /// finite, others are ignored.
    void setFixedRange(std::optional<double> top);

    void setSurface(Surface surface);
    [[nodiscard]] Surface surface() const;
    /// Finite and > 0, others are ignored. Drawn larger when the array does not fit on it.
    void setCylinder(const CylinderSize& cylinder);
    /// Where the array's frame is in the world; identity at first. Not finite: ignored.
    void setSensorPose(const Eigen::Isometry3d& X_World_Sensor);
    [[nodiscard]] const Eigen::Isometry3d& sensorPose() const;
    /// Explored contact points, the spline through them, vertices, and the name of the recognised shape;
    /// world frame, m. Points that are not finite are left out. All empty: nothing is shown.
    void setContour(std::span<const Eigen::Vector3d> points_m, std::span<const Eigen::Vector3d> curve_m,
                    std::span<const Eigen::Vector3d> vertices_m, const QString& label);
    /// The arm, from its base on; empty: none is shown.
    void setArmLinks(std::span<const ArmLink> links);
    /// The box around the arm that is shown; empty: none. World frame, m.
    [[nodiscard]] const Eigen::AlignedBox3d& armBox_m() const;
    /// The tube that a camera watches from inside, with what touches it; null: none.
    void setTube(const pipeline::CameraSnapshot* snapshot);

    void look(CameraPreset preset);
    [[nodiscard]] const Orbit& orbit() const;
    /// The isometric view of everything.
    void resetView();
    void setFollowing(bool following);
    [[nodiscard]] bool isFollowing() const;
    /// Orthographic instead of perspective.
    void setParallel(bool parallel);
    [[nodiscard]] bool isParallel() const;
    /// Checkable; for menus and for remembering.
    [[nodiscard]] QAction* layerAction(Layer layer) const;

    /// Surface, projection, layers: what is remembered between runs. Unknown and missing entries are ignored.
    [[nodiscard]] QVariantMap viewState() const;
    void restoreViewState(const QVariantMap& state);

    /// Everything that can be done here; also the context menu.
    void fillMenu(QMenu& menu);
    /// Writes what is drawn as .vtp, .ply or .stl, in mm. Errors: see exportGeometry().
    [[nodiscard]] core::Expected<void> saveGeometry(const QString& path) const;

    [[nodiscard]] VtkWidget& vtkWidget() const;

signals:
    void surfaceChanged(Surface surface);
    /// A picture, its data or the geometry was written.
    void saved(const QString& path);
    void failed(const QString& message);

protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
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
    void sceneMoved(bool refit);
    void askForGeometryFile();
    [[nodiscard]] QString contactTextAt(const QPoint& position) const;

    std::unique_ptr<Parts> m_parts;
};

} // namespace teleta::view3d
