// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/camera/rational_distortion.h"

#include <tl/expected.hpp>

namespace teleta::vision {

/// Of an image's width and height: work on a camera keeps some maps of its image's size.
inline constexpr int kLargestSide_px = 16'384;

/// What makes a camera. Pixels count from the centre of the upper left one, u to the right and v down.
/// The camera looks along its z, x to the right and y down in the image.
struct CameraParameters {
    int width_px = 1640;
    int height_px = 1232;
    double fx_px = 700.0;
    double fy_px = 700.0;
    double skew_px = 0.0;
    double cx_px = 819.5;
    double cy_px = 615.5;
    RationalDistortion distortion;
    Eigen::Matrix3d R_Camera_Sensor = Eigen::Matrix3d::Identity(); ///< of the flipped frame when mirrored
    Eigen::Vector3d p_Sensor_Camera_m = Eigen::Vector3d::Zero();   ///< centre of the camera
    /// The sensor frame is left-handed as seen by the camera: its y is flipped before the rotation.
    bool mirrored = false;

    /// K, upper triangular.
    [[nodiscard]] Eigen::Matrix3d cameraMatrix_px() const;
    /// Sensor frame to camera frame without the translation: R, times diag(1, -1, 1) when mirrored.
    [[nodiscard]] Eigen::Matrix3d linearPart() const;
};

/// The order of parameters in derivatives and covariances: fx, fy, skew, cx, cy; a small rotation vector w
/// in the camera's frame, exp(w) R; the camera's centre in the sensor frame; k1..k6, p1, p2.
inline constexpr int kCameraParameters = 19;
using CameraCovariance = Eigen::Matrix<double, kCameraParameters, kCameraParameters>;

/// Why there is no pixel of a point, or no ray of a pixel.
enum class ProjectionFailure {
    notFinite,          ///< a coordinate is NaN, infinite or beyond all measure
    behindCamera,       ///< the point is not before the camera
    outsideValidRadius, ///< where the lens model folds or was never meant to hold
    notConverged,       ///< the pixel is so far out that its ray cannot be computed to kRoundTrip_px
};
[[nodiscard]] const char* toString(ProjectionFailure failure);

/// Pixel of a point with its derivatives.
struct Projection {
    Eigen::Vector2d pixel;
    Eigen::Matrix<double, 2, 3> byPoint;                      ///< px/m, point in the sensor frame
    Eigen::Matrix<double, 2, kCameraParameters> byParameters; ///< px per unit of the parameter
};

/// The pixel of a point by the formulas of CameraModel alone, also where the lens model folds, as a fit needs
/// it. Failure: notFinite, behindCamera, outsideValidRadius where the distortion's denominator is not
/// positive.
[[nodiscard]] tl::expected<Projection, ProjectionFailure> projectFreely(const CameraParameters& camera,
                                                                        const Eigen::Vector3d& p_Sensor_m);

/// Perspective camera with rational lens distortion:
///   x_Camera = R F (p_Sensor - C), F = diag(1, -1, 1) when mirrored, otherwise the identity
///   (x, y) = (x_Camera / z_Camera, y_Camera / z_Camera), distorted (RationalDistortion)
///   u = fx x'' + skew y'' + cx,  v = fy y'' + cy
/// An object is always a camera that can be used: of parameters that are none, create() makes none.
/// Thread: any (immutable). Source: VTacArm, eq. (3)-(5), with R (p - C) where the paper prints R p - C.
class CameraModel {
public:
    /// Largest tangent of the angle to the axis for which a camera is used: 85 degrees.
    static constexpr double kLargestRadius = 11.43;
    /// A pixel's ray projects back to it within this.
    static constexpr double kRoundTrip_px = 5e-10;

    /// What is wrong with parameters.
    enum class Refusal {
        notFinite,   ///< a parameter is NaN or infinite
        noImage,     ///< width or height is not at least 1
        noFocus,     ///< a focal length is not positive
        notRotation, ///< R is no rotation
        folds,       ///< the lens model folds already on the axis
    };
    [[nodiscard]] static tl::expected<CameraModel, Refusal> create(const CameraParameters& parameters);

    [[nodiscard]] const CameraParameters& parameters() const { return m_parameters; }
    /// Centre of the camera in the sensor frame, m.
    [[nodiscard]] const Eigen::Vector3d& centre_m() const { return m_parameters.p_Sensor_Camera_m; }
    /// Tangent of the largest angle to the axis at which a point has a pixel: monotoneRadius(), at most
    /// kLargestRadius.
    [[nodiscard]] double validRadius() const { return m_validRadius; }
    /// The same in the image, around (cx, cy): geometric mean of both axes.
    [[nodiscard]] double validRadius_px() const;

    /// Pixel of a point of the sensor frame, which may lie outside the image.
    [[nodiscard]] tl::expected<Eigen::Vector2d, ProjectionFailure>
    project(const Eigen::Vector3d& p_Sensor_m) const;
    [[nodiscard]] tl::expected<Projection, ProjectionFailure>
    projectWithDerivatives(const Eigen::Vector3d& p_Sensor_m) const;

    /// Point before the lens, at unit distance from the camera along its axis, of a pixel: inverse of the
    /// distortion by Newton's method with bounded steps, started from the bracketed root of the radial part.
    [[nodiscard]] tl::expected<Eigen::Vector2d, ProjectionFailure>
    undistort(const Eigen::Vector2d& pixel) const;
    /// Unit direction in the sensor frame in which a pixel looks from centre_m().
    [[nodiscard]] tl::expected<Eigen::Vector3d, ProjectionFailure> ray(const Eigen::Vector2d& pixel) const;

    /// Whether a pixel is on the image.
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
