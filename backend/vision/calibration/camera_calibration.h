// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/calibration_pair.h"
#include "backend/vision/calibration/calibration_warning.h"
#include "backend/vision/camera/cylinder_projection.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace teleta::vision {

/// Methods to find a camera from pairs, from cheap to exact.
enum class CalibrationMethod {
    dlt,   ///< direct linear transformation (DLT) of all pairs, without distortion
    paper, ///< the paper's method: DLT, drop pairs that are off by more than 2 mm on the surface, DLT again
    leastSquares, ///< all parameters, least squares over all pairs
    robust,       ///< all parameters; wrong pairs are detected and left out
};
inline constexpr std::array kCalibrationMethods{CalibrationMethod::dlt, CalibrationMethod::paper,
                                                CalibrationMethod::leastSquares, CalibrationMethod::robust};
/// Name in files and on the command line: "dlt", "paper", "least_squares", "robust".
[[nodiscard]] const char* toString(CalibrationMethod method);
[[nodiscard]] std::optional<CalibrationMethod> calibrationMethod(std::string_view name);

/// Why no camera can be found from pairs.
enum class CalibrationRefusal {
    notFinite,      ///< a coordinate is NaN, infinite or implausibly large
    badSettings,    ///< the image or the surface has zero size
    tooFewPairs,    ///< fewer than six
    repeatedPoints, ///< fewer than six different points or pixels
    onOneLine,      ///< all points are on one line of the cylinder
    onOneRing,      ///< all points are on one ring of the cylinder
    inOnePlane,     ///< all points are in one plane
    noAgreement,    ///< no camera fits half of the pairs or at least kFewestAgreeing of them
    notDetermined,  ///< the pairs do not determine the camera: kLargestUncertainty_m is exceeded
    folds,          ///< the lens model folds where the pairs are
};
[[nodiscard]] const char* toString(CalibrationRefusal refusal);

/// Calibrations that locate points on the surface with a larger mean uncertainty are refused.
inline constexpr double kLargestUncertainty_m = 0.002;
/// Calibrations whose kept pairs are off by more than this share of the radius on average are refused.
inline constexpr double kLargestMeanError = 0.1;
/// With fewer pairs none is left out as wrong, and at least this many must be kept.
inline constexpr std::size_t kFewestAgreeing = 12;
/// Distance on the surface within which the paper keeps a pair.
inline constexpr double kPaperLimit_m = 0.002;

struct CalibrationSettings {
    int width_px = 1640;
    int height_px = 1232;
    CylinderSurface surface;

    [[nodiscard]] bool operator==(const CalibrationSettings&) const = default;
};

/// Errors of the camera for one pair.
struct PairResidual {
    bool kept = false;
    std::optional<Eigen::Vector2d>
        error_px; ///< projected point minus pixel; empty: the point is not in front of the lens
    std::optional<Eigen::Vector3d> located_m; ///< the point of the surface that the pixel shows; empty: none
    std::optional<double> error_m;            ///< distance of located_m from the point
};

/// Errors of a camera for one pair, with kept = false. Thread: any (pure).
[[nodiscard]] PairResidual residualOf(const CylinderCamera& camera, const CalibrationPair& pair);

struct Calibration {
    CylinderCamera camera;
    CalibrationMethod method = CalibrationMethod::robust;
    std::vector<PairResidual> residuals{}; ///< one entry per pair
    std::size_t kept = 0;
    double rms_px = 0.0;       ///< 3D -> 2D, kept pairs
    double mean_px = 0.0;      ///< 3D -> 2D, kept pairs
    double mean_error_m = 0.0; ///< 2D -> 3D, kept pairs that hit the surface
    /// Standard deviation of a located point due to the camera alone; root mean square over the surface.
    double uncertainty_m = 0.0;
    /// Correlation of the residuals of neighbouring kept pairs: their mean cosine divided by its standard
    /// deviation for independent residuals. Above kStructured the pairs contain something that the camera
    /// model does not describe.
    double structure = 0.0;
    static constexpr double kStructured = 5.0;
    [[nodiscard]] bool isStructured() const { return structure > kStructured; }
    /// Brings x and y of the kept pairs' points onto the surface; empty when most of them are on the axis.
    std::optional<SurfaceFactor> surfaceFactor{};
    std::vector<CalibrationWarning> warnings{}; ///< in the order of kCalibrationWarnings
    /// Whether nothing was seen in the pairs that makes the camera or its uncertainty doubtful.
    [[nodiscard]] bool isReliable() const { return warnings.empty(); }
};

/// Finds camera pose, lens and handedness from pairs. The robust method starts from radial alignment
/// (camera_start.h) and from DLT, fits with Tukey's biweight whose scale decreases with the median residual,
/// then alternates between keeping the pairs within the 99.9 % circle of the noise and least squares over
/// these until the kept pairs no longer change; nearby pairs that were lost are tried once more. The lens
/// model is made monotone up to 80 degrees, or as far as the image reaches, if this does not worsen the fit,
/// and at least over all kept pairs. The covariance is that of the fitted parameters for the noise of the
/// kept pairs (wider when there are few redundant equations, and where only the prior for the lens decides).
/// The order of the pairs changes the result only by rounding. Thread: any (pure); takes about 5 ms for 250
/// pairs. Source: VTacArm, sections III-B and IV-A; erratum of eq. (3).
[[nodiscard]] tl::expected<Calibration, CalibrationRefusal> calibrate(std::span<const CalibrationPair> pairs,
                                                                      const CalibrationSettings& settings,
                                                                      CalibrationMethod method);

} // namespace teleta::vision
