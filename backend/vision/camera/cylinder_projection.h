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
    outsideValidRadius, ///< the pixel has no ray (CameraModel::validRadius)
    notConverged,       ///< the pixel's ray cannot be computed
    alongAxis,          ///< the ray runs along the axis and never meets the surface
    tangent,            ///< the ray touches the cylinder or passes beside it
    behindCamera,       ///< the ray has left the cylinder behind it
    beyondEnds,         ///< the ray meets the cylinder beyond the ends of the sensitive part
};
[[nodiscard]] const char* toString(NoHit reason);

/// Distance along a ray to the sensitive surface, m: the nearest root in front of the origin within the
/// sensitive length. Of a (unit) direction d and origin o in the sensor frame, across the axis:
///   (d.d) t^2 + 2 (o.d) t + (o.o - rho^2) = 0,  discriminant (d.d) rho^2 - (o x d)^2,
/// by the root that adds numbers of the same sign; the other one by the product of both.
/// Thread: any (pure).
[[nodiscard]] tl::expected<double, NoHit> distanceToSurface_m(const CylinderSurface& surface,
                                                              const Eigen::Vector3d& origin_m,
                                                              const Eigen::Vector3d& direction);

/// A camera with the surface that it looks at and how well both are known.
/// Thread: any (immutable).
class CylinderCamera {
public:
    /// covariance: of the camera's parameters, in their order; zero: exact. noise_px: standard deviation
    /// of either coordinate of a pixel; >= 0. surface: usable.
    CylinderCamera(const CameraModel& camera, const CylinderSurface& surface,
                   const CameraCovariance& covariance = CameraCovariance::Zero(), double noise_px = 0.0);

    [[nodiscard]] const CameraModel& camera() const { return m_camera; }
    [[nodiscard]] const CylinderSurface& surface() const { return m_surface; }
    [[nodiscard]] const CameraCovariance& covariance() const { return m_covariance; }
    [[nodiscard]] double noise_px() const { return m_noise_px; }

    /// Point of the surface that a pixel shows, in the sensor frame, m. Source: VTacArm, section III-B.
    [[nodiscard]] tl::expected<Eigen::Vector3d, NoHit> locate_m(const Eigen::Vector2d& pixel) const;

    /// Vector on the plane that touches the cylinder at the point which `from` shows,
    /// p_x x + p_y y = p_x^2 + p_y^2, from that point to where the ray of `to` meets the plane, m. The ray
    /// along the plane has no such point (tangent), one that meets it behind the camera neither.
    /// Source: VTacArm, section III-B.
    [[nodiscard]] tl::expected<Eigen::Vector3d, NoHit> tangentVector_m(const Eigen::Vector2d& from,
                                                                       const Eigen::Vector2d& to) const;

    /// Covariance of a located point of the surface, m^2 (of rank two, on the tangent plane), by linear
    /// propagation of the noise of its pixel and of the camera's covariance. Empty when the point has no
    /// pixel.
    [[nodiscard]] tl::expected<Eigen::Matrix3d, ProjectionFailure>
    covariance_m2(const Eigen::Vector3d& p_Sensor_m) const;
    /// Root of its trace: the root mean square distance from the true point, m. Infinite when the surface
    /// is seen edge-on.
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
