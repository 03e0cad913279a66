// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene_camera.h"

#include <Eigen/Geometry>
#include <vtkCamera.h>
#include <vtkObjectFactory.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::view3d {

namespace {

constexpr double kViewAngle_rad = 30.0 * std::numbers::pi / 180.0;
constexpr double kFill = 0.86;
/// The camera goes back when the scene reaches this share of the picture.
constexpr double kLeave = 0.97;
constexpr double kLeastRadius_m = 1e-4;
constexpr double kFollowTime_s = 0.3;
/// Distance of the target from the middle, as a share of the visible height, at which the camera moves.
constexpr double kFollowRest = 0.04;
/// Of the camera of the hand: beside it, so that the contact is not hidden, at a distance in radii of what it
/// carries.
constexpr Orbit kOnHand{-0.5 * std::numbers::pi, 10.0 * std::numbers::pi / 180.0};
constexpr double kHandDistance = 16.0;
constexpr double kUsualHand_m = 0.03;
constexpr double kNearest = 1e-3; ///< near plane over far plane

} // namespace

SceneCamera::SceneCamera(vtkRenderer* renderer)
    : m_renderer(renderer) {
    apply();
}

void SceneCamera::setScene(std::vector<Eigen::Vector3d> corners_m, bool refit) {
    m_corners_m = std::move(corners_m);
    update(refit);
}

void SceneCamera::setSubject(const Eigen::AlignedBox3d& box_m) {
    const bool isOther = box_m.isEmpty() != m_subject_m.empty();
    m_subject_m = cornersOf(box_m);
    update(isOther);
}

void SceneCamera::setAspect(double aspect) {
    if (aspect > 0.0 && aspect != m_aspect) {
        m_aspect = aspect;
        update(true);
    }
}

void SceneCamera::look(CameraPreset preset) {
    m_X_World_Hand.reset();
    m_orbit = orbitOf(preset);
    fit();
    apply();
}

void SceneCamera::frame() {
    if (isOnHand())
        return look(CameraPreset::isometric);
    fit();
    apply();
}

void SceneCamera::standOnHand(const Eigen::Isometry3d& X_World_Sensor, double radius_m) {
    if (!X_World_Sensor.matrix().allFinite())
        return;
    if (!m_X_World_Hand) {
        m_orbit = kOnHand;
        m_focal_m.setZero();
        m_distance_m = kHandDistance * (radius_m > 0.0 ? radius_m : kUsualHand_m);
        m_fitted = false;
    }
    m_X_World_Hand = X_World_Sensor * Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX());
    apply();
}

void SceneCamera::turn(double azimuthStep_rad, double elevationStep_rad) {
    m_orbit = m_orbit.turned(azimuthStep_rad, elevationStep_rad);
    apply();
}

void SceneCamera::pan(double right, double up) {
    m_fitted = false;
    const Eigen::Vector3d upward = m_orbit.up();
    const Eigen::Vector3d rightward = upward.cross(m_orbit.direction());
    m_focal_m -= visibleHeight_m() * (right * rightward + up * upward);
    apply();
}

void SceneCamera::zoom(double factor) {
    if (!(factor > 0.0))
        return;
    m_fitted = false;
    m_distance_m = std::clamp(m_distance_m / factor, kLeastRadius_m, 1e4);
    apply();
}

void SceneCamera::setParallel(bool parallel) {
    m_parallel = parallel;
    update(true);
}

void SceneCamera::follow(const Eigen::Vector3d& target_m, double elapsed_s) {
    if (!target_m.allFinite() || isOnHand())
        return;
    const Eigen::Vector3d way_m = target_m - m_focal_m;
    const double rest_m = kFollowRest * visibleHeight_m();
    if (way_m.norm() <= rest_m)
        return;
    m_fitted = false;
    const double share = -std::expm1(-std::clamp(elapsed_s, 0.0, 1.0) / kFollowTime_s);
    m_focal_m += share * (1.0 - rest_m / way_m.norm()) * way_m;
    apply();
}

double SceneCamera::visibleHeight_m() const {
    return 2.0 * m_distance_m * std::tan(0.5 * kViewAngle_rad);
}

void SceneCamera::update(bool refit) {
    if (m_fitted && refit) {
        fit();
    } else if (m_fitted) {
        for (const Eigen::Vector3d& corner : subject_m())
            m_seen_m.extend(corner);
        if (leavesPicture()) {
            fitTo(cornersOf(m_seen_m));
        }
    }
    apply();
}

bool SceneCamera::leavesPicture() const {
    const Eigen::Vector3d up = m_orbit.up();
    const Eigen::Vector3d right = up.cross(m_orbit.direction());
    return std::ranges::any_of(subject_m(), [&](const Eigen::Vector3d& corner) {
        const Eigen::Vector3d from_m = corner - m_focal_m;
        const double depth_m = m_parallel ? m_distance_m : m_distance_m - from_m.dot(m_orbit.direction());
        const double half_m = kLeave * depth_m * std::tan(0.5 * kViewAngle_rad);
        return std::abs(from_m.dot(up)) > half_m || std::abs(from_m.dot(right)) > half_m * m_aspect;
    });
}

void SceneCamera::fit() {
    m_fitted = true;
    m_seen_m.setEmpty();
    for (const Eigen::Vector3d& corner : subject_m())
        m_seen_m.extend(corner);
    fitTo(subject_m());
}

void SceneCamera::fitTo(const std::vector<Eigen::Vector3d>& corners_m) {
    m_focal_m =
        m_seen_m.isEmpty() ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : Eigen::Vector3d(m_seen_m.center());
    const CameraFit fitted =
        fitCamera(m_orbit, m_focal_m, corners_m, kViewAngle_rad, m_aspect, kFill, kLeastRadius_m);
    // One distance serves both projections, so that switching keeps the size at the focal point.
    m_distance_m =
        m_parallel ? fitted.parallelHalfHeight_m / std::tan(0.5 * kViewAngle_rad) : fitted.distance_m;
}

void SceneCamera::apply() {
    const Eigen::Vector3d focal_m = m_X_World_Hand ? Eigen::Vector3d(*m_X_World_Hand * m_focal_m) : m_focal_m;
    const Eigen::Vector3d position_m = focal_m + m_distance_m * direction();
    const Eigen::Vector3d up = this->up();
    vtkCamera* camera = m_renderer->GetActiveCamera();
    const vtkMTimeType before = camera->GetMTime();
    camera->SetViewAngle(kViewAngle_rad * 180.0 / std::numbers::pi);
    camera->SetFocalPoint(focal_m.x(), focal_m.y(), focal_m.z());
    camera->SetPosition(position_m.x(), position_m.y(), position_m.z());
    camera->SetViewUp(up.x(), up.y(), up.z());
    camera->SetParallelProjection(m_parallel);
    camera->SetParallelScale(0.5 * visibleHeight_m());
    const bool hasChanged = camera->GetMTime() != before;
    // Planes around the scene and its ground, which is larger; loads and arrows stay inside.
    double radius_m = kLeastRadius_m;
    for (const Eigen::Vector3d& corner : m_corners_m)
        radius_m = std::max(radius_m, (corner - focal_m).norm());
    const double far_m = m_distance_m + 4.0 * radius_m;
    camera->SetClippingRange(std::max(m_distance_m - 4.0 * radius_m, kNearest * far_m), far_m);
    if (hasChanged && m_changed)
        m_changed();
}

vtkStandardNewMacro(OrbitStyle);

std::optional<Eigen::Vector2d> OrbitStyle::movedShare() const {
    vtkRenderWindowInteractor* interactor = this->Interactor;
    const int* size = interactor->GetRenderWindow()->GetSize();
    if (m_camera == nullptr || size[1] <= 0)
        return {};
    return Eigen::Vector2d(interactor->GetEventPosition()[0] - interactor->GetLastEventPosition()[0],
                           interactor->GetEventPosition()[1] - interactor->GetLastEventPosition()[1]) /
           size[1];
}

void OrbitStyle::begin(int state) {
    end();
    StartState(state);
}

void OrbitStyle::end() {
    if (State != VTKIS_NONE)
        StopState();
}

void OrbitStyle::OnLeftButtonDown() {
    const bool shift = Interactor->GetShiftKey() != 0;
    const bool control = Interactor->GetControlKey() != 0;
    begin(!shift ? VTKIS_ROTATE : control ? VTKIS_DOLLY : VTKIS_PAN);
}

void OrbitStyle::OnMouseMove() {
    const auto moved = movedShare();
    if (!moved)
        return;
    switch (State) {
    case VTKIS_ROTATE:
        // Dragging over the height of the picture is half a turn.
        m_camera->turn(-std::numbers::pi * moved->x(), -std::numbers::pi * moved->y());
        break;
    case VTKIS_PAN:
        m_camera->pan(moved->x(), moved->y());
        break;
    case VTKIS_DOLLY:
        m_camera->zoom(std::exp(3.0 * moved->y()));
        break;
    default:
        break;
    }
}

void OrbitStyle::zoom(double factor) {
    if (m_camera != nullptr)
        m_camera->zoom(factor);
}

} // namespace teleta::view3d
