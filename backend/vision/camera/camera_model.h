// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/camera/rational_distortion.h"

#include <tl/expected.hpp>

namespace teleta::vision {

/// Largest width and height of an image; some maps in memory have the size of the image.
inline constexpr int kLargestSide_px = 16'384;

/// Parameters of a camera. Pixel coordinates are relative to the centre of the upper left pixel, u to the
/// right and v down. The camera looks along its z axis, with x to the right and y down in the image.
struct CameraParameters {
    int width_px = 1640;
    int height_px = 1232;
    double fx_px = 700.0;
    double fy_px = 700.0;
    double skew_px = 0.0;
    double cx_px = 819.5;
    double cy_px = 615.5;
    RationalDistortion distortion;
    Eigen::Matrix3d R_Camera_Sensor =
        Eigen::Matrix3d::Identity(); ///< when mirrored, that of the flipped sensor frame
    Eigen::Vector3d p_Sensor_Camera_m = Eigen::Vector3d::Zero(); ///< centre of the camera
    /// The camera sees the sensor frame as left-handed: its y is flipped before the rotation.
    bool mirrored = false;

    /// K, upper triangular.
    [[nodiscard]] Eigen::Matrix3d cameraMatrix_px() const;
    /// Linear part of the map from sensor to camera frame: R, times diag(1, -1, 1) when mirrored.
    [[nodiscard]] Eigen::Matrix3d linearPart() const;
};

/// Number and order of the parameters in derivatives and covariances: fx, fy, skew, cx, cy; a small rotation
/// vector w in the camera frame, exp(w) R; the centre of the camera in the sensor frame; k1..k6, p1, p2.
inline constexpr int kCameraParameters = 19;
using CameraCovariance = Eigen::Matrix<double, kCameraParameters, kCameraParameters>;

/// Why a point has no pixel, or a pixel no ray.
enum class ProjectionFailure {
    notFinite,          ///< a coordinate is NaN, infinite or implausibly large
    behindCamera,       ///< the point is not in front of the camera
    outsideValidRadius, ///< the lens model folds there or is not valid
    notConverged,       ///< the pixel is so far out that its ray cannot be computed to within kRoundTrip_px
};
[[nodiscard]] const char* toString(ProjectionFailure failure);

/// The pixel of a point with its derivatives.
struct Projection {
    Eigen::Vector2d pixel;
    Eigen::Matrix<double, 2, 3> byPoint; ///< by the point in the sensor frame, px/m
    Eigen::Matrix<double, 2, kCameraParameters>
        byParameters; ///< by the parameters, px per unit of the parameter
};

/// The pixel of a point by the formulas of CameraModel, even where the lens model folds; for fitting. Error:
/// notFinite, behindCamera, outsideValidRadius where the denominator of the distortion is not positive.
/// Thread: any (pure).
[[nodiscard]] tl::expected<Projection, ProjectionFailure> projectFreely(const CameraParameters& camera,
                                                                        const Eigen::Vector3d& p_Sensor_m);

/// Perspective camera with rational lens distortion.
///   x_Camera = R F (p_Sensor - C), F = diag(1, -1, 1) when mirrored, otherwise the identity
///   (x, y) = (x_Camera / z_Camera, y_Camera / z_Camera), distorted (RationalDistortion)
///   u = fx x'' + skew y'' + cx,  v = fy y'' + cy
/// Every object is a usable camera: create() refuses invalid parameters. Thread: any (immutable). Source:
/// VTacArm, eq. (3)-(5), with R (p - C) where the paper prints R p - C.
class CameraModel {
public:
    /// Largest tangent of the angle to the axis at which a camera is used: 85 degrees.
    static constexpr double kLargestRadius = 11.43;
    /// The ray of a pixel projects back to it within this distance.
    static constexpr double kRoundTrip_px = 5e-10;

    /// Why parameters are invalid.
    enum class Refusal {
        notFinite,   ///< a parameter is NaN or infinite
        noImage,     ///< width or height is less than 1
        noFocus,     ///< a focal length is not positive
        notRotation, ///< R is no rotation
        folds,       ///< the lens model folds on the axis
    };
    [[nodiscard]] static tl::expected<CameraModel, Refusal> create(const CameraParameters& parameters);

    [[nodiscard]] const CameraParameters& parameters() const { return m_parameters; }
    /// Centre of the camera in the sensor frame, m.
    [[nodiscard]] const Eigen::Vector3d& centre_m() const { return m_parameters.p_Sensor_Camera_m; }
    /// Tangent of the largest angle to the axis at which a point has a pixel: monotoneRadius(), limited to
    /// kLargestRadius.
    [[nodiscard]] double validRadius() const { return m_validRadius; }
    /// The same in the image around (cx, cy), as geometric mean of both axes.
    [[nodiscard]] double validRadius_px() const;

    /// Pixel of a point in the sensor frame; it may lie outside the image.
    [[nodiscard]] tl::expected<Eigen::Vector2d, ProjectionFailure>
    project(const Eigen::Vector3d& p_Sensor_m) const;
    [[nodiscard]] tl::expected<Projection, ProjectionFailure>
    projectWithDerivatives(const Eigen::Vector3d& p_Sensor_m) const;

    /// Undistorted point of a pixel, on the plane at unit distance along the axis. The distortion is inverted
    /// by Newton's method with bounded steps, started from the bracketed root of the radial part.
    [[nodiscard]] tl::expected<Eigen::Vector2d, ProjectionFailure>
    undistort(const Eigen::Vector2d& pixel) const;
    /// Unit direction in the sensor frame of the ray of a pixel from centre_m().
    [[nodiscard]] tl::expected<Eigen::Vector3d, ProjectionFailure> ray(const Eigen::Vector2d& pixel) const;

    /// Whether a pixel is inside the image.
    [[nodiscard]] bool sees(const Eigen::Vector2d& pixel) const;

private:
    CameraModel() = default;
    [[nodiscard]] double radiusOf(double distorted) const;
    [[nodiscard]] Eigen::Vector2d toPixel(const Eigen::Vector2d& distorted) const;

    CameraParameters m_parameters;
    Eigen::Matrix3d m_linear = Eigen::Matrix3d::Identity();
    double m_validRadius = 0.0;
};

} // namespace teleta::vision
