// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/calibration/camera_calibration.h"

#include "backend/core/quantile.h"
#include "backend/vision/calibration/calibration_checks.h"
#include "backend/vision/calibration/camera_refinement.h"
#include "backend/vision/calibration/camera_start.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace teleta::vision {

namespace {

using Refused = tl::unexpected<CalibrationRefusal>;
using Pairs = std::span<const CalibrationPair>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Median 1.1774 and 99.9 % quantile 3.717 of the length of a residual with standard normal components.
constexpr double kMedianOfLength = 1.1774100225154747;
constexpr double kGate = 3.716922188849838;
constexpr double kTukey = 4.685;
constexpr int kPoseAndFocus = 10;
constexpr double kSmallestNoise_px = 1e-7;
/// Larger pixels and metres are not plausible coordinates.
constexpr double kFarthest = 1e9;
constexpr std::size_t kFewestPairs = 6;

template <typename Vector>
std::size_t countDifferent(std::vector<Vector> vectors) {
    std::sort(vectors.begin(), vectors.end(), [](const Vector& a, const Vector& b) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    });
    return static_cast<std::size_t>(std::unique(vectors.begin(), vectors.end()) - vectors.begin());
}

/// Checks pairs before fitting; empty when they can determine a camera.
std::optional<CalibrationRefusal> degeneracy(std::span<const CalibrationPair> pairs) {
    std::vector<Eigen::Vector2d> pixels;
    std::vector<Eigen::Vector3d> points;
    for (const CalibrationPair& pair : pairs) {
        const auto usable = [](const auto& v) {
            return v.allFinite() && v.cwiseAbs().maxCoeff() < kFarthest;
        };
        if (!usable(pair.pixel) || !usable(pair.p_Sensor_m))
            return CalibrationRefusal::notFinite;
        pixels.push_back(pair.pixel);
        points.push_back(pair.p_Sensor_m);
    }
    if (pairs.size() < kFewestPairs)
        return CalibrationRefusal::tooFewPairs;
    if (countDifferent(points) < kFewestPairs || countDifferent(pixels) < kFewestPairs)
        return CalibrationRefusal::repeatedPoints;

    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : points)
        middle += p / static_cast<double>(points.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& p : points)
        scatter += (p - middle) * (p - middle).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
    const Eigen::Vector3d extents = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    constexpr double kFlat = 1e-6; // eigenvalues have a relative accuracy of 1e-16, their roots of 1e-8
    if (extents[1] <= kFlat * extents[2])
        return CalibrationRefusal::onOneLine;
    if (extents[0] <= kFlat * extents[2]) {
        const double acrossAxis = solver.eigenvectors().col(0).head<2>().norm();
        return acrossAxis <= kFlat ? CalibrationRefusal::onOneRing : CalibrationRefusal::inOnePlane;
    }
    return std::nullopt;
}

std::vector<CalibrationPair> chosen(Pairs pairs, const std::vector<bool>& kept) {
    std::vector<CalibrationPair> result;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (kept[i])
            result.push_back(pairs[i]);
    }
    return result;
}

std::vector<double> errors_px(Pairs pairs, const CameraParameters& camera) {
    std::vector<double> result;
    for (const CalibrationPair& pair : pairs) {
        const auto projection = projectFreely(camera, pair.p_Sensor_m);
        result.push_back(projection ? (projection->pixel - pair.pixel).norm() : kInfinity);
    }
    return result;
}

/// With few pairs fewer distortion parameters are fitted, so that four redundant equations remain to judge
/// the fit.
int freeDistortion(std::size_t pairs) {
    return std::clamp(2 * static_cast<int>(pairs) - kPoseAndFocus - 4, 0, 8);
}

int spareEquations(std::size_t pairs, int freeParameters) {
    return std::max(1, 2 * static_cast<int>(pairs) - freeParameters);
}

double noiseOf(Pairs pairs, const CameraParameters& camera, int freeParameters) {
    double squares = 0.0;
    for (const double error : errors_px(pairs, camera))
        squares += error * error;
    return std::max(kSmallestNoise_px, std::sqrt(squares / spareEquations(pairs.size(), freeParameters)));
}

/// One least squares fit, with the prior weighted by the noise that remains.
std::optional<CameraParameters> fitSquares(const CameraParameters& start, Pairs pairs,
                                           double monotoneUpTo = 0.0) {
    RefinementSettings settings;
    settings.freeDistortion = freeDistortion(pairs.size());
    settings.monotoneUpTo = monotoneUpTo;
    settings.noise_px = noiseOf(pairs, start, kPoseAndFocus + settings.freeDistortion);
    std::optional<CameraParameters> camera = start;
    constexpr int kMostRounds = 10;
    for (int round = 0; camera && round < kMostRounds; ++round) {
        camera = refineCamera(*camera, pairs, settings);
        if (!camera)
            break;
        const double noise_px = noiseOf(pairs, *camera, kPoseAndFocus + settings.freeDistortion);
        const bool isSame = std::abs(noise_px - settings.noise_px) <= 0.01 * settings.noise_px;
        if ((isSame && settings.isNear) || noise_px <= kSmallestNoise_px)
            break;
        settings.noise_px = noise_px;
        settings.isNear = true;
    }
    return camera;
}

struct RobustFit {
    CameraParameters camera;
    std::vector<bool> kept;
    double spread_px = kInfinity; ///< median of all residuals
};

/// Converges from a start to the camera that most pairs agree with. Gives up a start that remains far from
/// the spread of a better one.
std::optional<RobustFit> descend(const CameraParameters& start, Pairs pairs, double better_px) {
    CameraParameters camera = start;
    camera.skew_px = 0.0;
    double spread_px = core::upperMedianOf(errors_px(pairs, camera));
    if (!std::isfinite(spread_px))
        return std::nullopt;
    constexpr int kMostRounds = 15;
    constexpr int kPatience = 3;
    constexpr double kHopeless = 4.0;
    for (int round = 0; round < kMostRounds; ++round) {
        RefinementSettings settings;
        settings.noise_px = std::max(kSmallestNoise_px, spread_px / kMedianOfLength);
        settings.lossScale_px = kTukey * settings.noise_px;
        settings.freeDistortion = freeDistortion(pairs.size());
        // The next round has another scale, so this one need not converge.
        settings.tolerance = 1e-4;
        settings.mostSteps = 20;
        const std::optional<CameraParameters> better = refineCamera(camera, pairs, settings);
        if (!better)
            break;
        const double next_px = core::upperMedianOf(errors_px(pairs, *better));
        if (!(next_px < spread_px))
            break;
        camera = *better;
        const bool settled = next_px > 0.99 * spread_px;
        spread_px = next_px;
        if (round >= kPatience && spread_px > kHopeless * better_px)
            break;
        if (settled || spread_px <= kSmallestNoise_px)
            break;
    }
    return RobustFit{camera, {}, spread_px};
}

/// Repeats least squares over the pairs within the noise until these no longer change.
void settle(RobustFit& fit, Pairs pairs) {
    double noise_px = std::max(kSmallestNoise_px, fit.spread_px / kMedianOfLength);
    constexpr int kMostRounds = 15;
    for (int round = 0; round < kMostRounds; ++round) {
        std::vector<bool> kept;
        for (const double error : errors_px(pairs, fit.camera))
            kept.push_back(error <= kGate * noise_px);
        if (kept == fit.kept)
            break;
        const std::vector<CalibrationPair> inliers = chosen(pairs, kept);
        if (inliers.size() < 6)
            break;
        const std::optional<CameraParameters> camera = fitSquares(fit.camera, inliers);
        if (!camera)
            break;
        fit.camera = *camera;
        fit.kept = std::move(kept);
        noise_px = noiseOf(inliers, fit.camera, kPoseAndFocus + freeDistortion(inliers.size()));
    }
}

/// Recovers a ring of correct pairs that the descent has lost: fits once more from the same camera, with a
/// loss that initially reaches further, and accepts the result if it keeps more pairs at the same noise.
void takeBack(RobustFit& fit, Pairs pairs) {
    constexpr double kReach = 64.0; // in standard deviations of the noise
    constexpr double kLeastNear =
        0.02; // share of the pairs; gross outliers are spread everywhere, so few are this near
    constexpr double kSameNoise = 1.1;
    const auto noiseOfKept_px = [&](const RobustFit& one) {
        const std::vector<CalibrationPair> inliers = chosen(pairs, one.kept);
        return noiseOf(inliers, one.camera, kPoseAndFocus + freeDistortion(inliers.size()));
    };
    const double noise_px = noiseOfKept_px(fit);
    const std::vector<double> errors = errors_px(pairs, fit.camera);
    std::size_t near = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        near += !fit.kept[i] && errors[i] < kReach * noise_px ? 1 : 0;
    if (static_cast<double>(near) < std::max(3.0, kLeastNear * static_cast<double>(pairs.size())))
        return;
    RobustFit other = fit;
    // A lens with a pole in front of the ring cannot converge back.
    other.camera.distortion = equidistantLens();
    for (double reach = kReach; reach >= 1.0; reach *= 0.5) {
        RefinementSettings settings;
        settings.noise_px = noise_px;
        settings.lossScale_px = kTukey * reach * noise_px;
        settings.freeDistortion = freeDistortion(pairs.size());
        const std::optional<CameraParameters> camera = refineCamera(other.camera, pairs, settings);
        if (!camera)
            return;
        other.camera = *camera;
    }
    other.spread_px = core::upperMedianOf(errors_px(pairs, other.camera));
    other.kept.clear();
    settle(other, pairs);
    if (other.kept.size() == pairs.size() &&
        std::ranges::count(other.kept, true) > std::ranges::count(fit.kept, true) &&
        noiseOfKept_px(other) <= kSameNoise * noise_px)
        fit = std::move(other);
}

tl::expected<RobustFit, CalibrationRefusal> fitRobust(Pairs pairs, const CalibrationSettings& settings) {
    std::optional<RobustFit> best;
    bool isConfirmed = false; // two starts have come to the same camera
    const auto tryStart = [&](const CameraParameters& start) {
        constexpr double kSameSpread = 0.01;
        const std::optional<RobustFit> fit = descend(start, pairs, best ? best->spread_px : kInfinity);
        if (!fit)
            return;
        if (best && std::abs(fit->spread_px - best->spread_px) <= kSameSpread * best->spread_px)
            isConfirmed = true;
        else if (best && fit->spread_px < best->spread_px)
            isConfirmed = false;
        if (!best || fit->spread_px < best->spread_px)
            best = fit;
    };
    for (const CameraParameters& start : alignedCameras(pairs, settings.width_px, settings.height_px))
        tryStart(start);
    // Wrong pairs, from which this start is far from the camera, make it slow.
    if (const std::optional<CameraParameters> linear = directLinearCamera(pairs); linear && !isConfirmed)
        tryStart(*linear);
    if (!best)
        return Refused(CalibrationRefusal::noAgreement);
    // With fewer pairs a wrong one cannot be recognised: the remaining ones fit some camera by chance.
    if (pairs.size() < kFewestAgreeing) {
        const std::optional<CameraParameters> all = fitSquares(best->camera, pairs);
        if (!all)
            return Refused(CalibrationRefusal::noAgreement);
        return RobustFit{*all, std::vector<bool>(pairs.size(), true), best->spread_px};
    }
    settle(*best, pairs);
    if (best->kept.size() == pairs.size())
        takeBack(*best, pairs);
    const auto kept = static_cast<std::size_t>(std::count(best->kept.begin(), best->kept.end(), true));
    if (2 * kept < pairs.size() || kept < kFewestAgreeing)
        return Refused(CalibrationRefusal::noAgreement);
    if (const auto refusal = degeneracy(chosen(pairs, best->kept)))
        return Refused(*refusal);
    return *best;
}

/// Largest tangent of the angle to the axis among the points and the ends of the surface.
double widestRadius(Pairs pairs, const CylinderSurface& surface, const CameraParameters& camera) {
    const Eigen::Matrix3d linear = camera.linearPart();
    double widest = 0.0;
    const auto include = [&](const Eigen::Vector3d& p_Sensor_m) {
        const Eigen::Vector3d p = linear * (p_Sensor_m - camera.p_Sensor_Camera_m);
        if (p.z() > 0.0)
            widest = std::max(widest, p.head<2>().norm() / p.z());
    };
    for (const CalibrationPair& pair : pairs)
        include(pair.p_Sensor_m);
    constexpr int kAround = 36;
    for (int i = 0; i < kAround; ++i) {
        const double angle_rad = 2.0 * std::numbers::pi * i / kAround;
        for (const double z_m : {surface.lowest_z_m, surface.highest_z_m})
            include({surface.radius_m * std::cos(angle_rad), surface.radius_m * std::sin(angle_rad), z_m});
    }
    return std::min(widest, CameraModel::kLargestRadius);
}

/// Makes the lens model monotone as far as the fit allows.
std::optional<CameraParameters> unfold(const CameraParameters& camera, Pairs kept,
                                       const CylinderSurface& surface) {
    constexpr double kFieldOfView = 5.671281819617709; // tan of 80 degrees
    constexpr double kMargin = 1.05;
    const double needed = kMargin * widestRadius(kept, surface, camera);
    const double valid = monotoneRadius(camera.distortion, CameraModel::kLargestRadius);
    if (valid >= kFieldOfView)
        return camera;
    const double before_px = noiseOf(kept, camera, kPoseAndFocus);
    // Starts from a lens that does not fold, because the solver cannot cross a pole.
    CameraParameters start = camera;
    start.distortion = equidistantLens();
    const auto unfolded = [&](double upTo, double dearest) -> std::optional<CameraParameters> {
        const std::optional<CameraParameters> found = fitSquares(start, kept, upTo);
        if (found && monotoneRadius(found->distortion, upTo) >= 0.99 * upTo &&
            noiseOf(kept, *found, kPoseAndFocus) <= dearest * before_px + kSmallestNoise_px)
            return found;
        return std::nullopt;
    };
    // The improvement that the six radial parameters together bring by chance with a probability of 1 %: a
    // pole beyond the last points uses all of them.
    constexpr double kByChance = 16.81;
    const double forNothing = std::sqrt(1.0 + kByChance / spareEquations(kept.size(), kPoseAndFocus));
    for (const double upTo : {kFieldOfView, 3.0, 2.0, 1.2 * needed}) {
        // The last radius may be larger than the previous ones.
        if (upTo <= std::max(valid, needed))
            continue;
        if (const std::optional<CameraParameters> found = unfolded(upTo, forNothing))
            return found;
    }
    constexpr double kForTheSurface = 1.1;
    return valid >= needed ? std::optional(camera) : unfolded(needed, kForTheSurface);
}

/// Computes the covariance of the fitted parameters. The prior is an assumption, and lenses differ from it by
/// more than it says: with the information J of the pairs and P of the prior, the covariance is
/// (J + P)^-1 (J + kLensSpread^2 P) (J + P)^-1. Where the pairs decide, this changes nothing.
CameraCovariance covarianceOf(Pairs kept, const CameraParameters& camera, bool linear, double noise_px) {
    const int freed = linear ? 0 : freeDistortion(kept.size());
    CameraCovariance information = CameraCovariance::Zero();
    for (const CalibrationPair& pair : kept) {
        const auto projection = projectFreely(camera, pair.p_Sensor_m);
        if (projection)
            information += projection->byParameters.transpose() * projection->byParameters;
    }
    information /= noise_px * noise_px;
    std::vector<int> free;
    for (int i = 0; i < kCameraParameters; ++i) {
        const bool isSkew = i == 2;
        const bool isFree = i < 11 ? !isSkew || linear : isFreeDistortion(i - 11, freed);
        if (isFree)
            free.push_back(i);
        if (i >= 11)
            information(i, i) += 1.0 / (distortionPrior(i - 11) * distortionPrior(i - 11));
    }
    const auto count = static_cast<Eigen::Index>(free.size());
    Eigen::MatrixXd reduced(count, count);
    Eigen::VectorXd scale(count);
    for (Eigen::Index i = 0; i < count; ++i)
        scale[i] = 1.0 / std::sqrt(std::max(information(free[i], free[i]), 1e-300));
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index j = 0; j < count; ++j)
            reduced(i, j) = scale[i] * information(free[i], free[j]) * scale[j];
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(reduced);
    // Smaller eigenvalues are lost in rounding; their directions are at least this uncertain.
    const double least = 1e-15 * static_cast<double>(count);
    const Eigen::VectorXd inverse = solver.eigenvalues().cwiseMax(least).cwiseInverse();
    const Eigen::MatrixXd spread =
        solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
    const double spare = spareEquations(kept.size(), static_cast<int>(count));
    const double widening = spare / std::max(spare - 2.0, 0.1);
    CameraCovariance covariance = CameraCovariance::Zero();
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index j = 0; j < count; ++j)
            covariance(free[i], free[j]) = widening * scale[i] * spread(i, j) * scale[j];
    }
    constexpr double kLensSpread = 2.0;
    const CameraCovariance byPrior = covariance;
    for (const int i : free) {
        if (i >= 11)
            covariance += (kLensSpread * kLensSpread - 1.0) /
                          (distortionPrior(i - 11) * distortionPrior(i - 11)) * byPrior.col(i) *
                          byPrior.col(i).transpose();
    }
    return covariance;
}

/// Root mean square over the surface of the standard deviation due to the camera alone; points that the
/// camera cannot see count as infinitely uncertain.
double uncertaintyOf_m(const CameraModel& model, const CylinderSurface& surface,
                       const CameraCovariance& covariance) {
    const CylinderCamera camera(model, surface, covariance, 0.0);
    constexpr int kAround = 12;
    constexpr int kAlong = 11;
    double squares = 0.0;
    for (int i = 0; i < kAround; ++i) {
        for (int j = 0; j < kAlong; ++j) {
            const double angle_rad = 2.0 * std::numbers::pi * i / kAround;
            const double z_m =
                surface.lowest_z_m + (surface.highest_z_m - surface.lowest_z_m) * j / (kAlong - 1.0);
            const auto deviation_m = camera.standardDeviation_m(
                {surface.radius_m * std::cos(angle_rad), surface.radius_m * std::sin(angle_rad), z_m});
            if (!deviation_m)
                return kInfinity;
            squares += *deviation_m * *deviation_m;
        }
    }
    return std::sqrt(squares / (kAround * kAlong));
}

tl::expected<Calibration, CalibrationRefusal> conclude(Pairs pairs, const CalibrationSettings& settings,
                                                       CalibrationMethod method, CameraParameters camera,
                                                       const std::vector<bool>& kept) {
    const bool linear = method == CalibrationMethod::dlt || method == CalibrationMethod::paper;
    const std::vector<CalibrationPair> inliers = chosen(pairs, kept);
    camera.width_px = settings.width_px;
    camera.height_px = settings.height_px;
    if (!linear) {
        const std::optional<CameraParameters> unfolded = unfold(camera, inliers, settings.surface);
        if (!unfolded)
            return Refused(CalibrationRefusal::folds);
        camera = *unfolded;
    }
    const auto model = CameraModel::create(camera);
    if (!model)
        return Refused(model.error() == CameraModel::Refusal::folds ? CalibrationRefusal::folds
                                                                    : CalibrationRefusal::noAgreement);
    const int freeParameters = linear ? 11 : kPoseAndFocus + freeDistortion(inliers.size());
    double noise_px = noiseOf(inliers, camera, freeParameters);
    if (!std::isfinite(noise_px))
        return Refused(CalibrationRefusal::noAgreement);
    const CameraCovariance covariance = covarianceOf(inliers, camera, linear, noise_px);

    Calibration result{CylinderCamera(*model, settings.surface, covariance, noise_px)};
    result.method = method;
    double squares = 0.0;
    std::size_t located = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        PairResidual residual = residualOf(result.camera, pairs[i]);
        residual.kept = kept[i];
        if (residual.kept && !residual.error_px)
            return Refused(linear ? CalibrationRefusal::noAgreement : CalibrationRefusal::folds);
        if (residual.kept) {
            ++result.kept;
            squares += residual.error_px->squaredNorm();
            result.mean_px += residual.error_px->norm();
            if (residual.error_m) {
                ++located;
                result.mean_error_m += *residual.error_m;
            }
        }
        result.residuals.push_back(residual);
    }
    if (located == 0)
        return Refused(CalibrationRefusal::noAgreement);
    const auto count = static_cast<double>(result.kept);
    result.rms_px = std::sqrt(squares / count);
    result.mean_px /= count;
    result.mean_error_m /= static_cast<double>(located);
    result.structure = structureOf(pairs, result.residuals);
    result.uncertainty_m = uncertaintyOf_m(*model, settings.surface, covariance);
    result.surfaceFactor = surfaceFactorOf(inliers, settings.surface);
    // The linear methods exist for comparison and are not refused: their errors show what they neglect.
    const bool exact = !linear;
    if (exact && !(result.mean_error_m <= kLargestMeanError * settings.surface.radius_m))
        return Refused(CalibrationRefusal::noAgreement);
    if (exact && !(result.uncertainty_m <= kLargestUncertainty_m))
        return Refused(CalibrationRefusal::notDetermined);
    result.warnings = warningsOf(inliers, result);
    return result;
}

/// The paper's procedure: the error after back projection onto the cylinder decides which pairs are kept.
tl::expected<Calibration, CalibrationRefusal> calibrateAsPaper(Pairs pairs,
                                                               const CalibrationSettings& settings) {
    const std::optional<CameraParameters> first = directLinearCamera(pairs);
    if (!first)
        return Refused(CalibrationRefusal::notDetermined);
    const auto model = CameraModel::create(*first);
    if (!model)
        return Refused(CalibrationRefusal::noAgreement);
    // A point near the end may be located slightly beyond it.
    CylinderSurface longer = settings.surface;
    longer.lowest_z_m -= settings.surface.radius_m;
    longer.highest_z_m += settings.surface.radius_m;
    const CylinderCamera camera(*model, longer);
    std::vector<bool> kept;
    for (const CalibrationPair& pair : pairs) {
        const auto point_m = camera.locate_m(pair.pixel);
        kept.push_back(point_m && (*point_m - pair.p_Sensor_m).norm() <= kPaperLimit_m);
    }
    const std::vector<CalibrationPair> inliers = chosen(pairs, kept);
    if (const auto refusal = degeneracy(inliers))
        return Refused(inliers.size() < 6 ? CalibrationRefusal::noAgreement : *refusal);
    const std::optional<CameraParameters> second = directLinearCamera(inliers);
    if (!second)
        return Refused(CalibrationRefusal::notDetermined);
    return conclude(pairs, settings, CalibrationMethod::paper, *second, kept);
}

} // namespace

const char* toString(CalibrationMethod method) {
    static constexpr std::array kNames{"dlt", "paper", "least_squares", "robust"};
    return kNames[static_cast<std::size_t>(method)];
}

std::optional<CalibrationMethod> calibrationMethod(std::string_view name) {
    for (const CalibrationMethod method : kCalibrationMethods) {
        if (name == toString(method))
            return method;
    }
    return std::nullopt;
}

const char* toString(CalibrationRefusal refusal) {
    static constexpr std::array kNames{"notFinite",     "badSettings", "tooFewPairs", "repeatedPoints",
                                       "onOneLine",     "onOneRing",   "inOnePlane",  "noAgreement",
                                       "notDetermined", "folds"};
    return kNames[static_cast<std::size_t>(refusal)];
}

PairResidual residualOf(const CylinderCamera& camera, const CalibrationPair& pair) {
    PairResidual residual;
    if (const auto pixel = camera.camera().project(pair.p_Sensor_m))
        residual.error_px = *pixel - pair.pixel;
    if (const auto point_m = camera.locate_m(pair.pixel)) {
        residual.located_m = *point_m;
        residual.error_m = (*point_m - pair.p_Sensor_m).norm();
    }
    return residual;
}

tl::expected<Calibration, CalibrationRefusal> calibrate(Pairs pairs, const CalibrationSettings& settings,
                                                        CalibrationMethod method) {
    const auto isSide = [](int pixels) { return pixels >= 1 && pixels <= kLargestSide_px; };
    if (!isSide(settings.width_px) || !isSide(settings.height_px) || !settings.surface.isUsable())
        return Refused(CalibrationRefusal::badSettings);
    if (const auto refusal = degeneracy(pairs))
        return Refused(*refusal);
    if (method == CalibrationMethod::paper)
        return calibrateAsPaper(pairs, settings);
    if (method == CalibrationMethod::robust) {
        const auto fit = fitRobust(pairs, settings);
        if (!fit)
            return Refused(fit.error());
        return conclude(pairs, settings, method, fit->camera, fit->kept);
    }
    const std::vector<bool> all(pairs.size(), true);
    std::optional<CameraParameters> camera = directLinearCamera(pairs);
    if (!camera)
        return Refused(CalibrationRefusal::notDetermined);
    if (method == CalibrationMethod::leastSquares) {
        camera->skew_px = 0.0;
        camera = fitSquares(*camera, pairs);
        if (!camera)
            return Refused(CalibrationRefusal::noAgreement);
    }
    return conclude(pairs, settings, method, *camera, all);
}

} // namespace teleta::vision
