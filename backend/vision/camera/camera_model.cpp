// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/camera/camera_model.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace teleta::vision {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
/// Larger pixels and metres are refused like NaN, so that no square overflows.
constexpr double kBeyondMeasure = 1e100;
/// Tolerance that includes the edge of the valid circle despite rounding.
constexpr double kEdge = 1.0 + 1e-12;

template <typename Vector>
bool isUsable(const Vector& vector) {
    return vector.allFinite() && vector.cwiseAbs().maxCoeff() < kBeyondMeasure;
}

Eigen::Matrix3d crossProductMatrix(const Eigen::Vector3d& v) {
    Eigen::Matrix3d result;
    result << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return result;
}

} // namespace

const char* toString(ProjectionFailure failure) {
    static constexpr std::array kNames{"notFinite", "behindCamera", "outsideValidRadius", "notConverged"};
    return kNames[static_cast<std::size_t>(failure)];
}

Eigen::Matrix3d CameraParameters::cameraMatrix_px() const {
    Eigen::Matrix3d k;
    k << fx_px, skew_px, cx_px, 0.0, fy_px, cy_px, 0.0, 0.0, 1.0;
    return k;
}

Eigen::Matrix3d CameraParameters::linearPart() const {
    Eigen::Matrix3d linear = R_Camera_Sensor;
    if (mirrored)
        linear.col(1) = -linear.col(1);
    return linear;
}

tl::expected<CameraModel, CameraModel::Refusal> CameraModel::create(const CameraParameters& parameters) {
    if (!isUsable(parameters.cameraMatrix_px()) || !isUsable(parameters.R_Camera_Sensor) ||
        !isUsable(parameters.p_Sensor_Camera_m) || !parameters.distortion.isFinite())
        return tl::unexpected(Refusal::notFinite);
    if (parameters.width_px < 1 || parameters.height_px < 1)
        return tl::unexpected(Refusal::noImage);
    if (!(parameters.fx_px > 0.0) || !(parameters.fy_px > 0.0))
        return tl::unexpected(Refusal::noFocus);
    const Eigen::Matrix3d& r = parameters.R_Camera_Sensor;
    constexpr double kRotationTolerance = 1e-6;
    if ((r.transpose() * r - Eigen::Matrix3d::Identity()).norm() > kRotationTolerance ||
        r.determinant() < 0.0)
        return tl::unexpected(Refusal::notRotation);
    CameraModel model;
    model.m_parameters = parameters;
    model.m_linear = parameters.linearPart();
    model.m_validRadius = monotoneRadius(parameters.distortion, kLargestRadius);
    if (!(model.m_validRadius > 0.0))
        return tl::unexpected(Refusal::folds);
    return model;
}

double CameraModel::validRadius_px() const {
    return m_parameters.distortion.radial(m_validRadius) * std::sqrt(m_parameters.fx_px * m_parameters.fy_px);
}

Eigen::Vector2d CameraModel::toPixel(const Eigen::Vector2d& distorted) const {
    return {m_parameters.fx_px * distorted.x() + m_parameters.skew_px * distorted.y() + m_parameters.cx_px,
            m_parameters.fy_px * distorted.y() + m_parameters.cy_px};
}

tl::expected<Eigen::Vector2d, ProjectionFailure>
CameraModel::project(const Eigen::Vector3d& p_Sensor_m) const {
    if (!isUsable(p_Sensor_m))
        return tl::unexpected(ProjectionFailure::notFinite);
    const Eigen::Vector3d p_Camera_m = m_linear * (p_Sensor_m - centre_m());
    if (!(p_Camera_m.z() > 0.0))
        return tl::unexpected(ProjectionFailure::behindCamera);
    // Multiplied instead of divided: for a point beside the camera the quotient would overflow.
    if (!(p_Camera_m.head<2>().norm() <= kEdge * m_validRadius * p_Camera_m.z()))
        return tl::unexpected(ProjectionFailure::outsideValidRadius);
    return toPixel(m_parameters.distortion.apply(p_Camera_m.head<2>() / p_Camera_m.z()));
}

tl::expected<Projection, ProjectionFailure>
CameraModel::projectWithDerivatives(const Eigen::Vector3d& p_Sensor_m) const {
    if (const auto pixel = project(p_Sensor_m); !pixel)
        return tl::unexpected(pixel.error());
    return projectFreely(m_parameters, p_Sensor_m);
}

tl::expected<Projection, ProjectionFailure> projectFreely(const CameraParameters& camera,
                                                          const Eigen::Vector3d& p_Sensor_m) {
    if (!isUsable(p_Sensor_m))
        return tl::unexpected(ProjectionFailure::notFinite);
    const Eigen::Matrix3d linear = camera.linearPart();
    const Eigen::Vector3d p_Camera_m = linear * (p_Sensor_m - camera.p_Sensor_Camera_m);
    if (!(p_Camera_m.z() > 0.0))
        return tl::unexpected(ProjectionFailure::behindCamera);
    const Eigen::Vector2d point = p_Camera_m.head<2>() / p_Camera_m.z();
    const RationalDistortion& lens = camera.distortion;
    if (!isUsable(point) || !(lens.denominator(point.squaredNorm()) > 0.0))
        return tl::unexpected(ProjectionFailure::outsideValidRadius);
    const Eigen::Vector2d distorted = lens.apply(point);

    Eigen::Matrix2d k;
    k << camera.fx_px, camera.skew_px, 0.0, camera.fy_px;
    Eigen::Matrix<double, 2, 3> perspective;
    perspective << 1.0, 0.0, -point.x(), 0.0, 1.0, -point.y();
    const Eigen::Matrix<double, 2, 3> byCameraPoint =
        k * lens.slope(point) * perspective * (1.0 / p_Camera_m.z());

    Projection result;
    result.pixel = k * distorted + Eigen::Vector2d(camera.cx_px, camera.cy_px);
    result.byPoint = byCameraPoint * linear;
    result.byParameters.setZero();
    result.byParameters(0, 0) = distorted.x();
    result.byParameters(1, 1) = distorted.y();
    result.byParameters(0, 2) = distorted.y();
    result.byParameters(0, 3) = 1.0;
    result.byParameters(1, 4) = 1.0;
    result.byParameters.middleCols<3>(5) = -byCameraPoint * crossProductMatrix(p_Camera_m);
    result.byParameters.middleCols<3>(8) = -result.byPoint;
    result.byParameters.rightCols<8>() = k * lens.byParameters(point);
    return result;
}

/// Inverts the radial part: undistorted radius of a distorted one, at most the valid radius.
double CameraModel::radiusOf(double distorted) const {
    const RationalDistortion& lens = m_parameters.distortion;
    double low = 0.0;
    double high = m_validRadius;
    if (lens.radial(high) <= distorted)
        return high;
    double r = std::min(distorted, 0.5 * high);
    constexpr int kMostSteps = 100;
    for (int i = 0; i < kMostSteps; ++i) {
        const double error = lens.radial(r) - distorted;
        (error > 0.0 ? high : low) = r;
        if (error == 0.0 || high - low <= kEpsilon * high)
            break;
        const double newton = r - error / lens.radialSlope(r);
        const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
        if (std::abs(next - r) <= kEpsilon * r)
            break;
        r = next;
    }
    return r;
}

tl::expected<Eigen::Vector2d, ProjectionFailure> CameraModel::undistort(const Eigen::Vector2d& pixel) const {
    if (!isUsable(pixel))
        return tl::unexpected(ProjectionFailure::notFinite);
    const RationalDistortion& lens = m_parameters.distortion;
    Eigen::Vector2d target;
    target.y() = (pixel.y() - m_parameters.cy_px) / m_parameters.fy_px;
    target.x() = (pixel.x() - m_parameters.cx_px - m_parameters.skew_px * target.y()) / m_parameters.fx_px;
    const double distance = target.norm();
    if (distance == 0.0)
        return Eigen::Vector2d(Eigen::Vector2d::Zero());

    const auto error_px = [&](const Eigen::Vector2d& point) {
        return (toPixel(lens.apply(point)) - pixel).norm();
    };
    const auto inCircle = [&](Eigen::Vector2d point) {
        const double r = point.norm();
        return r > m_validRadius ? Eigen::Vector2d(point * (m_validRadius / r)) : point;
    };
    Eigen::Vector2d point = target * (radiusOf(distance) / distance);
    double error = error_px(point);
    constexpr int kMostSteps = 50;
    constexpr int kMostHalvings = 40;
    for (int i = 0; i < kMostSteps && error > 0.0; ++i) {
        const Eigen::Vector2d step = lens.slope(point).inverse() * (target - lens.apply(point));
        const double length = step.norm();
        if (length == 0.0)
            break; // the rest is rounding of the pixels
        double share = std::min(1.0, 0.5 * (1.0 + point.norm()) / length);
        bool better = false;
        for (int halving = 0; halving < kMostHalvings && !better; ++halving, share *= 0.5) {
            const Eigen::Vector2d next = inCircle(point + share * step);
            const double nextError = error_px(next);
            if (nextError < error) {
                point = next;
                error = nextError;
                better = true;
            }
        }
        if (!better)
            break;
    }
    if (error <= kRoundTrip_px)
        return point;
    const bool atTheEdge = point.norm() >= m_validRadius * (1.0 - 1e-9);
    return tl::unexpected(atTheEdge ? ProjectionFailure::outsideValidRadius
                                    : ProjectionFailure::notConverged);
}

tl::expected<Eigen::Vector3d, ProjectionFailure> CameraModel::ray(const Eigen::Vector2d& pixel) const {
    const auto point = undistort(pixel);
    if (!point)
        return tl::unexpected(point.error());
    return Eigen::Vector3d(
        (m_linear.transpose() * Eigen::Vector3d(point->x(), point->y(), 1.0)).normalized());
}

bool CameraModel::sees(const Eigen::Vector2d& pixel) const {
    return pixel.x() >= -0.5 && pixel.x() < m_parameters.width_px - 0.5 && pixel.y() >= -0.5 &&
           pixel.y() < m_parameters.height_px - 0.5;
}

} // namespace teleta::vision
