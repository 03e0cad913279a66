// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/orbit.h"

#include <Eigen/Core>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <optional>
#include <span>
#include <vector>

class vtkCamera;
class vtkRenderer;

namespace teleta::view3d {

/// The camera of the scene: an orbit around a focal point, with z up.
/// As long as nobody zoomed or moved it, it stays fitted to the scene.
/// Thread: GUI.
class SceneCamera {
public:
    explicit SceneCamera(vtkRenderer* renderer);

    /// Called after every change.
    void onChange(std::function<void()> changed) { m_changed = std::move(changed); }

    /// What must be visible. refit: fits the camera anew, if it is still fitted.
    void setScene(std::vector<Eigen::Vector3d> corners_m, bool refit);
    /// width/height of the picture; keeps the fit.
    void setAspect(double aspect);
    /// Looks from there and fits the scene.
    void look(CameraPreset preset);
    void turn(double azimuthStep_rad, double elevationStep_rad);
    /// Moves what is seen by shares of the picture's height, to the right and up.
    void pan(double right, double up);
    /// factor > 1: nearer.
    void zoom(double factor);
    void setParallel(bool parallel);
    /// Glides toward a point; call once per frame. Small deviations are left alone.
    void follow(const Eigen::Vector3d& target_m, double elapsed_s);

    [[nodiscard]] const Orbit& orbit() const { return m_orbit; }
    [[nodiscard]] const Eigen::Vector3d& focal_m() const { return m_focal_m; }
    [[nodiscard]] bool isParallel() const { return m_parallel; }
    [[nodiscard]] bool isFitted() const { return m_fitted; }
    /// Height of what is seen at the focal point.
    [[nodiscard]] double visibleHeight_m() const;

private:
    void fit();
    void apply();

    vtkRenderer* m_renderer;
    std::function<void()> m_changed;
    std::vector<Eigen::Vector3d> m_corners_m;
    Orbit m_orbit = orbitOf(CameraPreset::isometric);
    Eigen::Vector3d m_focal_m = Eigen::Vector3d::Zero();
    double m_distance_m = 1.0;
    double m_aspect = 1.0;
    bool m_parallel = false;
    bool m_fitted = true;
};

/// Mouse: left turns, middle or Shift+left moves, right or wheel zooms. No keys: the view has its own.
class OrbitStyle : public vtkInteractorStyleTrackballCamera {
public:
    static OrbitStyle* New();
    void setCamera(SceneCamera* camera) { m_camera = camera; }

    void Rotate() override;
    void Pan() override;
    void Dolly() override;
    void Spin() override { Rotate(); }
    void OnChar() override {}
    void OnKeyPress() override {}
    void OnKeyRelease() override {}

protected:
    OrbitStyle() = default;
    void Dolly(double factor) override;

private:
    /// Pixels that the mouse moved, over the height of the picture.
    [[nodiscard]] std::optional<Eigen::Vector2d> movedShare() const;

    SceneCamera* m_camera = nullptr;
};

} // namespace teleta::view3d
