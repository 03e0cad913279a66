// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/camera/camera_model.h"

namespace teleta::vision {

/// The sensitive part of the elastomer: x^2 + y^2 = radius^2, lowest_z <= z <= highest_z in the sensor frame.
struct CylinderSurface {
    double radius_m = 0.025;
    double lowest_z_m = 0.0;
    double highest_z_m = 0.1;

    [[nodiscard]] bool isUsable() const;
    [[nodiscard]] bool operator==(const CylinderSurface&) const = default;
};

/// Why a pixel shows no point of the sensitive surface.
enum class NoHit {
    notFinite,          ///< a coordinate of the pixel is NaN or infinite
    outsideValidRadius, ///< the pixel has no ray (CameraModel::validRadius())
    notConverged,       ///< the ray of the pixel cannot be computed
    alongAxis,          ///< the ray runs along the axis and never meets the surface
    tangent,            ///< the ray is tangent to the cylinder or misses it
    behindCamera,       ///< the cylinder is behind the origin of the ray
    beyondEnds,         ///< the ray meets the cylinder beyond the ends of the sensitive part
};
[[nodiscard]] const char* toString(NoHit reason);

/// Distance along a ray to the sensitive surface, m: the nearest root in front of the origin within the
/// sensitive length. With the components of the unit direction d and the origin o across the axis:
///   (d.d) t^2 + 2 (o.d) t + (o.o - rho^2) = 0,  discriminant (d.d) rho^2 - (o x d)^2,
/// The root that adds numbers of equal sign is computed directly, the other one from the product of both.
/// Thread: any (pure).
[[nodiscard]] tl::expected<double, NoHit> distanceToSurface_m(const CylinderSurface& surface,
                                                              const Eigen::Vector3d& origin_m,
                                                              const Eigen::Vector3d& direction);

/// A calibrated camera with the surface that it looks at and its uncertainty. Thread: any (immutable).
class CylinderCamera {
public:
    /// covariance: of the camera parameters in their order (kCameraParameters); zero: exact. noise_px:
    /// standard deviation of each pixel coordinate; >= 0. surface: isUsable().
    CylinderCamera(const CameraModel& camera, const CylinderSurface& surface,
                   const CameraCovariance& covariance = CameraCovariance::Zero(), double noise_px = 0.0);

    [[nodiscard]] const CameraModel& camera() const { return m_camera; }
    [[nodiscard]] const CylinderSurface& surface() const { return m_surface; }
    [[nodiscard]] const CameraCovariance& covariance() const { return m_covariance; }
    [[nodiscard]] double noise_px() const { return m_noise_px; }

    /// Point of the surface that a pixel shows, in the sensor frame, m. Source: VTacArm, section III-B.
    [[nodiscard]] tl::expected<Eigen::Vector3d, NoHit> locate_m(const Eigen::Vector2d& pixel) const;

    /// Vector in the tangent plane of the cylinder at the point that `from` shows, p_x x + p_y y = p_x^2 +
    /// p_y^2, from that point to where the ray of `to` meets the plane, m. Error: tangent when the ray is
    /// parallel to the plane; behindCamera. Source: VTacArm, section III-B.
    [[nodiscard]] tl::expected<Eigen::Vector3d, NoHit> tangentVector_m(const Eigen::Vector2d& from,
                                                                       const Eigen::Vector2d& to) const;

    /// Covariance of a located point of the surface, m^2 (rank two, in the tangent plane), by linear
    /// propagation of the pixel noise and of the camera's covariance. Error: the point has no pixel.
    [[nodiscard]] tl::expected<Eigen::Matrix3d, ProjectionFailure>
    covariance_m2(const Eigen::Vector3d& p_Sensor_m) const;
    /// Root of the trace of covariance_m2(): the root mean square distance from the true point, m. Infinite
    /// where the surface is seen edge-on.
    [[nodiscard]] tl::expected<double, ProjectionFailure>
    standardDeviation_m(const Eigen::Vector3d& p_Sensor_m) const;

private:
    [[nodiscard]] tl::expected<Eigen::Vector3d, NoHit> ray(const Eigen::Vector2d& pixel) const;

    CameraModel m_camera;
    CylinderSurface m_surface;
    CameraCovariance m_covariance;
    double m_noise_px;
};

} // namespace teleta::vision
