// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/camera/cylinder_projection.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace teleta::vision {

namespace {

/// Squared sine of the angle to the axis, or to a tangent plane, below which the intersection is determined
/// by rounding.
constexpr double kParallel = 1e-24;

NoHit noHit(ProjectionFailure failure) {
    switch (failure) {
    case ProjectionFailure::notFinite:
        return NoHit::notFinite;
    case ProjectionFailure::behindCamera:
    case ProjectionFailure::outsideValidRadius:
        return NoHit::outsideValidRadius;
    case ProjectionFailure::notConverged:
        return NoHit::notConverged;
    }
    return NoHit::notConverged;
}

} // namespace

bool CylinderSurface::isUsable() const {
    return std::isfinite(radius_m) && radius_m > 0.0 && std::isfinite(lowest_z_m) &&
           std::isfinite(highest_z_m) && lowest_z_m < highest_z_m;
}

const char* toString(NoHit reason) {
    static constexpr std::array kNames{"notFinite", "outsideValidRadius", "notConverged", "alongAxis",
                                       "tangent",   "behindCamera",       "beyondEnds"};
    return kNames[static_cast<std::size_t>(reason)];
}

tl::expected<double, NoHit> distanceToSurface_m(const CylinderSurface& surface,
                                                const Eigen::Vector3d& origin_m,
                                                const Eigen::Vector3d& direction) {
    if (!origin_m.allFinite() || !direction.allFinite())
        return tl::unexpected(NoHit::notFinite);
    const Eigen::Vector2d o = origin_m.head<2>();
    const Eigen::Vector2d d = direction.head<2>();
    const double a = d.squaredNorm();
    if (!(a > kParallel * direction.squaredNorm()))
        return tl::unexpected(NoHit::alongAxis);
    const double across = o.x() * d.y() - o.y() * d.x();
    const double reach = std::sqrt(a) * surface.radius_m;
    // A ray that is tangent up to rounding has no stable intersection.
    constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();
    if (!(reach - std::abs(across) > kRounding * (reach + std::sqrt(a) * o.norm())))
        return tl::unexpected(NoHit::tangent);
    const double discriminant = (reach - across) * (reach + across);
    const double b = o.dot(d);
    const double c = (o.norm() - surface.radius_m) * (o.norm() + surface.radius_m);
    const double sum = -(b + std::copysign(std::sqrt(discriminant), b));
    const double one = sum / a;
    const double other = c / sum;
    bool inFront = false;
    for (const double t : {std::min(one, other), std::max(one, other)}) {
        if (!(t > 0.0))
            continue;
        inFront = true;
        const double z_m = origin_m.z() + t * direction.z();
        if (z_m >= surface.lowest_z_m && z_m <= surface.highest_z_m)
            return t;
    }
    return tl::unexpected(inFront ? NoHit::beyondEnds : NoHit::behindCamera);
}

CylinderCamera::CylinderCamera(const CameraModel& camera, const CylinderSurface& surface,
                               const CameraCovariance& covariance, double noise_px)
    : m_camera(camera)
    , m_surface(surface)
    , m_covariance(covariance)
    , m_noise_px(noise_px) {
}

tl::expected<Eigen::Vector3d, NoHit> CylinderCamera::ray(const Eigen::Vector2d& pixel) const {
    const auto direction = m_camera.ray(pixel);
    if (!direction)
        return tl::unexpected(noHit(direction.error()));
    return *direction;
}

tl::expected<Eigen::Vector3d, NoHit> CylinderCamera::locate_m(const Eigen::Vector2d& pixel) const {
    const auto direction = ray(pixel);
    if (!direction)
        return direction;
    const auto distance_m = distanceToSurface_m(m_surface, m_camera.centre_m(), *direction);
    if (!distance_m)
        return tl::unexpected(distance_m.error());
    return Eigen::Vector3d(m_camera.centre_m() + *distance_m * *direction);
}

tl::expected<Eigen::Vector3d, NoHit> CylinderCamera::tangentVector_m(const Eigen::Vector2d& from,
                                                                     const Eigen::Vector2d& to) const {
    const auto start_m = locate_m(from);
    if (!start_m)
        return start_m;
    const auto direction = ray(to);
    if (!direction)
        return direction;
    const Eigen::Vector2d normal = start_m->head<2>().normalized();
    const double towards = normal.dot(direction->head<2>());
    if (!(towards * towards > kParallel))
        return tl::unexpected(NoHit::tangent);
    const double distance_m = normal.dot(start_m->head<2>() - m_camera.centre_m().head<2>()) / towards;
    if (!(distance_m > 0.0))
        return tl::unexpected(NoHit::behindCamera);
    return Eigen::Vector3d(m_camera.centre_m() + distance_m * *direction - *start_m);
}

tl::expected<Eigen::Matrix3d, ProjectionFailure>
CylinderCamera::covariance_m2(const Eigen::Vector3d& p_Sensor_m) const {
    const auto projection = m_camera.projectWithDerivatives(p_Sensor_m);
    if (!projection)
        return tl::unexpected(projection.error());
    // A point of the surface can move only around and along the axis.
    Eigen::Matrix<double, 3, 2> tangents;
    tangents.col(0) = Eigen::Vector3d(-p_Sensor_m.y(), p_Sensor_m.x(), 0.0).normalized();
    tangents.col(1) = Eigen::Vector3d::UnitZ();
    const Eigen::Matrix2d pixelBySurface = projection->byPoint * tangents;
    if (!(std::abs(pixelBySurface.determinant()) > std::numeric_limits<double>::min()))
        return Eigen::Matrix3d(Eigen::Matrix3d::Constant(std::numeric_limits<double>::infinity()));
    const Eigen::Matrix<double, 3, 2> byPixel = tangents * pixelBySurface.inverse();
    const Eigen::Matrix2d covariance_px2 =
        projection->byParameters * m_covariance * projection->byParameters.transpose() +
        Eigen::Matrix2d::Identity() * (m_noise_px * m_noise_px);
    return Eigen::Matrix3d(byPixel * covariance_px2 * byPixel.transpose());
}

tl::expected<double, ProjectionFailure>
CylinderCamera::standardDeviation_m(const Eigen::Vector3d& p_Sensor_m) const {
    const auto covariance = covariance_m2(p_Sensor_m);
    if (!covariance)
        return tl::unexpected(covariance.error());
    return std::sqrt(std::max(0.0, covariance->trace()));
}

} // namespace teleta::vision
