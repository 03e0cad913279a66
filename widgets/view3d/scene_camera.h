// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/orbit.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vtkInteractorStyle.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <optional>
#include <vector>

class vtkRenderer;

namespace teleta::view3d {

/// The camera of the scene: an orbit around a focal point, with z up. It stays fitted to the scene, or to its
/// subject, until the user zooms or moves it: where that would leave the picture, the camera goes back so far
/// that all places at which it was since the last fit are seen. Or it stands on a hand: then orbit and focal
/// point are in the frame of the hand, and what the user turns and moves stays as the hand goes. Thread: GUI.
class SceneCamera {
public:
    explicit SceneCamera(vtkRenderer* renderer);

    /// Called after every change of what it sees.
    void onChange(std::function<void()> changed) { m_changed = std::move(changed); }

    /// Corners of the whole scene. refit: fits the camera again, unless the user moved it.
    void setScene(std::vector<Eigen::Vector3d> corners_m, bool refit);
    /// A box around what matters, to which the camera is fitted; empty: the whole scene.
    void setSubject(const Eigen::AlignedBox3d& box_m);
    /// width/height of the picture; keeps the fit.
    void setAspect(double aspect);
    /// Sets the direction of view and fits the scene.
    void look(CameraPreset preset);
    /// Fits the scene, and does so from now on; keeps the direction of view unless that was of a hand.
    void frame();
    void turn(double azimuthStep_rad, double elevationStep_rad);
    /// Moves the scene to the right and up, in shares of the picture's height.
    void pan(double right, double up);
    /// factor > 1: nearer.
    void zoom(double factor);
    void setParallel(bool parallel);
    /// Moves smoothly towards a point; call once per frame. Small deviations are ignored.
    void follow(const Eigen::Vector3d& target_m, double elapsed_s);

    /// Stands beside the hand, a little behind what it carries, and moves and turns with it until look(). The
    /// first call chooses the place, later ones move it with the hand. X_World_Sensor: z points away from the
    /// hand; radius_m: about that of what the hand carries, 0: not known. Poses that are not finite are
    /// ignored.
    void standOnHand(const Eigen::Isometry3d& X_World_Sensor, double radius_m);
    [[nodiscard]] bool isOnHand() const { return m_X_World_Hand.has_value(); }

    [[nodiscard]] const Orbit& orbit() const { return m_orbit; }
    /// From the focal point to the camera, upwards and to the right in the picture; unit vectors in the
    /// world.
    [[nodiscard]] Eigen::Vector3d direction() const { return toWorld() * m_orbit.direction(); }
    [[nodiscard]] Eigen::Vector3d up() const { return toWorld() * m_orbit.up(); }
    [[nodiscard]] Eigen::Vector3d right() const { return up().cross(direction()); }
    /// Visible height at the focal point.
    [[nodiscard]] double visibleHeight_m() const;

private:
    /// refit: fits the camera again, unless the user moved it.
    void update(bool refit);
    void fit();
    void fitTo(const std::vector<Eigen::Vector3d>& corners_m);
    /// Whether a corner is outside of the picture, or nearly.
    [[nodiscard]] bool leavesPicture() const;
    [[nodiscard]] const std::vector<Eigen::Vector3d>& subject_m() const {
        return m_subject_m.empty() ? m_corners_m : m_subject_m;
    }
    void apply();
    [[nodiscard]] Eigen::Matrix3d toWorld() const {
        return m_X_World_Hand ? m_X_World_Hand->linear() : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    }

    vtkRenderer* m_renderer;
    std::function<void()> m_changed;
    std::vector<Eigen::Vector3d> m_corners_m;
    std::vector<Eigen::Vector3d> m_subject_m;
    Eigen::AlignedBox3d m_seen_m; ///< all corners of the subject since the last fit
    /// Frame of orbit and focal point, its z towards the hand; empty: the world.
    std::optional<Eigen::Isometry3d> m_X_World_Hand;
    Orbit m_orbit = orbitOf(CameraPreset::isometric);
    Eigen::Vector3d m_focal_m = Eigen::Vector3d::Zero();
    double m_distance_m = 1.0;
    double m_aspect = 1.0;
    bool m_parallel = false;
    bool m_fitted = true;
};

/// Mouse: left turns, middle or Shift+left moves, right or wheel zooms.
class OrbitStyle : public vtkInteractorStyle {
public:
    static OrbitStyle* New();
    void setCamera(SceneCamera* camera) { m_camera = camera; }

    void OnMouseMove() override;
    void OnLeftButtonDown() override;
    void OnLeftButtonUp() override { end(); }
    void OnMiddleButtonDown() override { begin(VTKIS_PAN); }
    void OnMiddleButtonUp() override { end(); }
    void OnRightButtonDown() override { begin(VTKIS_DOLLY); }
    void OnRightButtonUp() override { end(); }
    void OnMouseWheelForward() override { zoom(kWheelStep); }
    void OnMouseWheelBackward() override { zoom(1.0 / kWheelStep); }

protected:
    OrbitStyle() = default;

private:
    static constexpr double kWheelStep = 1.21;

    /// A drag of the mouse; one ends where the next begins.
    void begin(int state);
    void end();
    void zoom(double factor);
    /// Movement of the mouse in shares of the picture's height.
    [[nodiscard]] std::optional<Eigen::Vector2d> movedShare() const;

    SceneCamera* m_camera = nullptr;
};

} // namespace teleta::view3d
