// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/calibration_pair.h"
#include "backend/vision/camera/cylinder_projection.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace teleta::vision {

/// Ways to find a camera from pairs, from cheap to exact.
enum class CalibrationMethod {
    dlt,          ///< direct linear transformation of all pairs: no distortion
    paper,        ///< the paper's: DLT, drop pairs that are off by more than 2 mm on the surface, DLT again
    leastSquares, ///< all parameters, squares of all pairs
    robust,       ///< all parameters; wrong pairs are found and left out
};
inline constexpr std::array kCalibrationMethods{CalibrationMethod::dlt, CalibrationMethod::paper,
                                                CalibrationMethod::leastSquares, CalibrationMethod::robust};
/// "dlt", "paper", "least_squares", "robust".
[[nodiscard]] const char* toString(CalibrationMethod method);
[[nodiscard]] std::optional<CalibrationMethod> calibrationMethod(std::string_view name);

/// Why pairs make no camera.
enum class CalibrationRefusal {
    notFinite,      ///< a coordinate is NaN, infinite or beyond all measure
    badSettings,    ///< the image or the surface has no extent
    tooFewPairs,    ///< fewer than six
    repeatedPoints, ///< fewer than six different points or pixels
    onOneLine,      ///< all points on one line of the cylinder
    onOneRing,      ///< all points on one ring of the cylinder
    inOnePlane,     ///< all points in a plane
    noAgreement,    ///< no camera fits half of the pairs, or kFewestAgreeing of them
    notDetermined,  ///< the pairs leave the camera open: kLargestUncertainty_m is exceeded
    folds,          ///< the lens model folds where the pairs are
};
[[nodiscard]] const char* toString(CalibrationRefusal refusal);

/// A camera that leaves points on the surface more uncertain than this on average is no calibration.
inline constexpr double kLargestUncertainty_m = 0.002;
/// Pairs that are kept and yet off by more than this share of the radius do not show a camera.
inline constexpr double kLargestMeanError = 0.1;
/// With fewer pairs none is left out as wrong, and no fewer may be left.
inline constexpr std::size_t kFewestAgreeing = 12;
/// The paper keeps pairs within this distance on the surface.
inline constexpr double kPaperLimit_m = 0.002;

struct CalibrationSettings {
    int width_px = 1640;
    int height_px = 1232;
    CylinderSurface surface;

    [[nodiscard]] bool operator==(const CalibrationSettings&) const = default;
};

/// What the camera makes of one pair.
struct PairResidual {
    bool kept = false;
    std::optional<Eigen::Vector2d> error_px;  ///< projected point minus pixel; empty: not before the lens
    std::optional<Eigen::Vector3d> located_m; ///< where the pixel is on the surface; empty: no hit
    std::optional<double> error_m;            ///< distance of that from the point
};

/// Not kept. Thread: any (pure).
[[nodiscard]] PairResidual residualOf(const CylinderCamera& camera, const CalibrationPair& pair);

struct Calibration {
    CylinderCamera camera;
    CalibrationMethod method = CalibrationMethod::robust;
    std::vector<PairResidual> residuals{}; ///< one a pair
    std::size_t kept = 0;
    double rms_px = 0.0;       ///< 3D -> 2D, kept pairs
    double mean_px = 0.0;      ///< 3D -> 2D, kept pairs
    double mean_error_m = 0.0; ///< 2D -> 3D, kept pairs that hit the surface
    /// Standard deviation of a point on the surface by the camera alone, quadratic mean over the surface.
    double uncertainty_m = 0.0;
    /// How alike the residuals of neighbouring kept pairs are: mean cosine over its standard deviation for
    /// independent ones. Beyond kStructured the pairs hold something that the camera model does not.
    double structure = 0.0;
    static constexpr double kStructured = 5.0;
    [[nodiscard]] bool isStructured() const { return structure > kStructured; }
};

/// Finds camera, lens and handedness from pairs.
/// robust: starts by radial alignment (camera_start.h) and by DLT; fits with Tukey's biweight, whose scale
/// follows the residuals' median down; then keeps the pairs within the 99.9 % circle of the noise and fits
/// those by squares, until the same pairs are kept; pairs near by that were lost are tried once more. The
/// lens model is made increasing up to 80 degrees, or as far as the image reaches, when that costs the fit
/// nothing, at least over all kept pairs. The covariance is that of the fitted parameters for the noise that
/// the kept pairs show (with fewer spare equations it is wider). Pairs in any order give the same answer up
/// to rounding. Thread: any (pure); some 0.1 s for 250 pairs. Source: VTacArm, sections III-B and IV-A; the
/// erratum of eq. (3).
[[nodiscard]] tl::expected<Calibration, CalibrationRefusal> calibrate(std::span<const CalibrationPair> pairs,
                                                                      const CalibrationSettings& settings,
                                                                      CalibrationMethod method);

} // namespace teleta::vision
