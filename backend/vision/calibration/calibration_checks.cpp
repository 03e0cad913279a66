// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/calibration/calibration_checks.h"

#include "backend/core/quantile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace teleta::vision {

namespace {

using KeptPairs = std::span<const CalibrationPair>;

bool isMany(std::size_t pairs, std::size_t kept) {
    return 20 * pairs > kept;
}

bool isOffSurface(KeptPairs kept, const Calibration& calibration) {
    if (!calibration.surfaceFactor)
        return true;
    const auto [factor, error] = *calibration.surfaceFactor;
    const double off = std::abs(factor - 1.0);
    constexpr double kRounding = 1e-4; // 2.5 um of 25 mm
    if (off <= std::max(kRounding, 4.0 * error))
        return false;
    // A ray through a point that is off by a share of the radius meets the surface off by that share of the
    // distance along the axis.
    double squares_m2 = 0.0;
    for (const CalibrationPair& pair : kept) {
        const double along_m = pair.p_Sensor_m.z() - calibration.camera.camera().centre_m().z();
        squares_m2 += along_m * along_m;
    }
    return off * std::sqrt(squares_m2 / static_cast<double>(kept.size())) > calibration.uncertainty_m;
}

bool reachesBeyondEnds(KeptPairs kept, const CylinderSurface& surface) {
    const double margin_m = 0.01 * (surface.highest_z_m - surface.lowest_z_m);
    const auto beyond = std::ranges::count_if(kept, [&](const CalibrationPair& pair) {
        return pair.p_Sensor_m.z() < surface.lowest_z_m - margin_m ||
               pair.p_Sensor_m.z() > surface.highest_z_m + margin_m;
    });
    return isMany(static_cast<std::size_t>(beyond), kept.size());
}

bool isSwapped(const Calibration& calibration) {
    if (calibration.method == CalibrationMethod::dlt || calibration.method == CalibrationMethod::paper)
        return false;
    constexpr double kUsualOffset = 0.03;               // of the longer side, one standard deviation
    constexpr double kThousandfold = 6.907755278982137; // ln 1000
    const CameraParameters& camera = calibration.camera.camera().parameters();
    const double usual_px = kUsualOffset * std::max(camera.width_px, camera.height_px);
    const auto& covariance = calibration.camera.covariance();
    const double variance_px2 = usual_px * usual_px + std::max(covariance(3, 3), covariance(4, 4));
    const OffMiddle off = offMiddle(camera);
    return off.fitted_px * off.fitted_px - off.swapped_px * off.swapped_px >
           2.0 * kThousandfold * variance_px2;
}

bool isOutsideImage(KeptPairs kept, const Calibration& calibration) {
    const CameraModel& camera = calibration.camera.camera();
    const double margin_px = 4.0 * calibration.camera.noise_px();
    const auto outside = std::ranges::count_if(kept, [&](const CalibrationPair& pair) {
        const Eigen::Vector2d last_px(camera.parameters().width_px - 1, camera.parameters().height_px - 1);
        const Eigen::Vector2d inside = pair.pixel.cwiseMax(0.0).cwiseMin(last_px);
        return (pair.pixel - inside).cwiseAbs().maxCoeff() > 0.5 + margin_px;
    });
    return isMany(static_cast<std::size_t>(outside), kept.size());
}

} // namespace

const char* toString(CalibrationWarning warning) {
    static constexpr std::array kNames{"off_surface", "beyond_ends", "swapped_pixels", "outside_image",
                                       "structured"};
    return kNames[static_cast<std::size_t>(warning)];
}

std::optional<SurfaceFactor> surfaceFactorOf(std::span<const CalibrationPair> kept,
                                             const CylinderSurface& surface) {
    if (kept.empty())
        return std::nullopt;
    std::vector<double> radii_m;
    for (const CalibrationPair& pair : kept)
        radii_m.push_back(pair.p_Sensor_m.head<2>().norm());
    const double median_m = core::upperMedianOf(radii_m);
    constexpr double kOnAxis = 1e-6; // of the radius
    if (!(median_m > kOnAxis * surface.radius_m))
        return std::nullopt;
    for (double& radius_m : radii_m)
        radius_m = std::abs(radius_m - median_m);
    // Standard deviation over median deviation, and standard error of a median over that of a mean, for
    // normal errors.
    constexpr double kOverMedianDeviation = 1.482602218505602;
    constexpr double kOverMean = 1.2533141373155001;
    const double error_m = kOverMean * kOverMedianDeviation * core::upperMedianOf(radii_m) /
                           std::sqrt(static_cast<double>(kept.size()));
    const double factor = surface.radius_m / median_m;
    return SurfaceFactor{factor, factor * error_m / median_m};
}

OffMiddle offMiddle(const CameraParameters& camera) {
    const Eigen::Vector2d middle_px(0.5 * (camera.width_px - 1), 0.5 * (camera.height_px - 1));
    return {(Eigen::Vector2d(camera.cx_px, camera.cy_px) - middle_px).norm(),
            (Eigen::Vector2d(camera.cy_px, camera.cx_px) - middle_px).norm()};
}

double structureOf(std::span<const CalibrationPair> pairs, const std::vector<PairResidual>& residuals) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (!residuals[i].kept || !residuals[i].error_px)
            continue;
        std::size_t nearest = i;
        double distance = std::numeric_limits<double>::infinity();
        for (std::size_t j = 0; j < pairs.size(); ++j) {
            if (j == i || !residuals[j].kept || !residuals[j].error_px)
                continue;
            const double d = (pairs[i].p_Sensor_m - pairs[j].p_Sensor_m).squaredNorm();
            if (d > 0.0 && d < distance) {
                distance = d;
                nearest = j;
            }
        }
        const double lengths = residuals[i].error_px->norm() * residuals[nearest].error_px->norm();
        if (nearest == i || !(lengths > 0.0))
            continue;
        sum += residuals[i].error_px->dot(*residuals[nearest].error_px) / lengths;
        ++count;
    }
    // The cosine between independent directions in the plane has the variance 1/2; most pairs of neighbours
    // are counted twice.
    return count > 0 ? sum / std::sqrt(static_cast<double>(count)) : 0.0;
}

std::vector<CalibrationWarning> warningsOf(std::span<const CalibrationPair> kept,
                                           const Calibration& calibration) {
    std::vector<CalibrationWarning> warnings;
    if (isOffSurface(kept, calibration))
        warnings.push_back(CalibrationWarning::offSurface);
    if (reachesBeyondEnds(kept, calibration.camera.surface()))
        warnings.push_back(CalibrationWarning::beyondEnds);
    // Swapped pixels are outside the image as well.
    if (isSwapped(calibration))
        warnings.push_back(CalibrationWarning::swappedPixels);
    else if (isOutsideImage(kept, calibration))
        warnings.push_back(CalibrationWarning::outsideImage);
    if (calibration.isStructured())
        warnings.push_back(CalibrationWarning::structured);
    return warnings;
}

} // namespace teleta::vision
