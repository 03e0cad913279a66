// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/plane_fit.h"

#include "backend/core/failure.h"
#include "backend/core/quantile.h"

#include <QCoreApplication>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace teleta::vision {

namespace {

struct PlaneFitText {
    Q_DECLARE_TR_FUNCTIONS(PlaneFit)
};

constexpr std::size_t kFewestOfHomography = 6;
constexpr std::size_t kFewestOfScale = 4;
constexpr double kThinnest = 0.02; ///< smaller over larger extent of points that are not on one line
constexpr double kShortestRuler_px = 10.0;
/// The larger of both is how far a ruler may be from what all of them say.
constexpr double kMostRulerShare = 0.05;
constexpr double kMostRuler_px = 4.0 * kReading_px;
/// Distances in standard deviations of one axis, where both are 95 % efficient for normal noise in two
/// dimensions: (E[psi'(r) + psi(r) / r])^2 = 0.95 * 2 E[psi(r)^2], r as Rayleigh has it.
constexpr double kHuber = 1.501;
constexpr double kTukey = 5.123;
constexpr double kNormalMad = 1.4826;
constexpr double kLeastScatter_px = 1e-6; ///< so that exact pairs have weights
constexpr int kHuberSteps = 15;
constexpr int kTukeySteps = 30;

/// Middle and mean distance from it: points are brought to mean 0 and mean distance sqrt(2).
struct Frame {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    double size = 1.0;

    [[nodiscard]] Eigen::Vector2d to(const Eigen::Vector2d& point) const { return (point - middle) / size; }
    [[nodiscard]] Eigen::Matrix3d matrix() const {
        Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
        matrix(0, 0) = matrix(1, 1) = 1.0 / size;
        matrix.topRightCorner<2, 1>() = -middle / size;
        return matrix;
    }
};

template <typename Member>
Frame frameOf(std::span<const PlanePair> pairs, Member member) {
    Frame frame;
    for (const PlanePair& pair : pairs)
        frame.middle += pair.*member / static_cast<double>(pairs.size());
    double distance = 0.0;
    for (const PlanePair& pair : pairs)
        distance += (pair.*member - frame.middle).norm() / static_cast<double>(pairs.size());
    frame.size = distance / std::sqrt(2.0);
    return frame;
}

template <typename Member>
bool areOnOneLine(std::span<const PlanePair> pairs, Member member) {
    const Frame frame = frameOf(pairs, member);
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const PlanePair& pair : pairs) {
        const Eigen::Vector2d away = pair.*member - frame.middle;
        spread += away * away.transpose();
    }
    // Its eigenvalues: squares of the extents along and across.
    const double half = 0.5 * spread.trace();
    const double apart = std::hypot(0.5 * (spread(0, 0) - spread(1, 1)), spread(0, 1));
    const double larger = std::sqrt(half + apart);
    const double smaller = std::sqrt(std::max(0.0, half - apart));
    return !(smaller > kThinnest * larger);
}

core::Expected<void> checkPairs(std::span<const PlanePair> pairs, std::size_t fewest) {
    if (pairs.size() < fewest)
        return core::refused(
            PlaneFitText::tr("%n point(s) are too few", nullptr, static_cast<int>(pairs.size())),
            PlaneFitText::tr("at least %1 points").arg(fewest));
    if (areOnOneLine(pairs, &PlanePair::place_m) || areOnOneLine(pairs, &PlanePair::pixel))
        return core::refused(PlaneFitText::tr("all points lie on one line, which does not show a plane"),
                             PlaneFitText::tr("points in at least two rows"));
    return {};
}

/// The numbers of a model, 8 at most.
using PlaneNumbers = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 8, 1>;
using Covariance = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 8, 8>;
using Derivative = Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, 8>;

/// The pixel of a place by a model with these numbers.
using Model = std::function<Eigen::Vector2d(const PlaneNumbers& x, const Eigen::Vector2d& place)>;

struct Robust {
    PlaneNumbers x;
    Covariance covariance;
    double rms = 0.0;
    std::size_t kept = 0;
};

Derivative derivative(const Model& model, const PlaneNumbers& x, const Eigen::Vector2d& place) {
    constexpr double kStep = 1e-6;
    Derivative by(2, x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        PlaneNumbers up = x;
        PlaneNumbers down = x;
        up[i] += kStep;
        down[i] -= kStep;
        by.col(i) = (model(up, place) - model(down, place)) / (2.0 * kStep);
    }
    return by;
}

/// Steps of Gauss and Newton whose pairs are weighted by their distances.
/// unit: pixels in a unit of the model's picture.
Robust fitRobustly(const Model& model, PlaneNumbers x, const std::vector<Eigen::Vector2d>& places,
                   const std::vector<Eigen::Vector2d>& pixels, double unit) {
    const std::size_t n = places.size();
    std::vector<double> weights(n, 1.0);
    Covariance normal;
    Robust found;
    for (int step = 0; step <= kHuberSteps + kTukeySteps; ++step) {
        std::vector<double> distances(n);
        std::vector<double> sizes;
        for (std::size_t i = 0; i < n; ++i) {
            const Eigen::Vector2d away = pixels[i] - model(x, places[i]);
            distances[i] = away.norm();
            sizes.push_back(std::abs(away.x()));
            sizes.push_back(std::abs(away.y()));
        }
        const double noise = std::max(kNormalMad * core::medianOf(sizes), kLeastScatter_px / unit);
        for (std::size_t i = 0; i < n; ++i) {
            const double r = distances[i] / noise;
            const double share = r / kTukey;
            weights[i] = step < kHuberSteps ? std::min(1.0, kHuber / std::max(r, 1e-12))
                         : share < 1.0      ? (1.0 - share * share) * (1.0 - share * share)
                                            : 0.0;
        }
        normal = Covariance::Zero(x.size(), x.size());
        PlaneNumbers right = PlaneNumbers::Zero(x.size());
        double sum = 0.0;
        double weight = 0.0;
        found.kept = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const auto by = derivative(model, x, places[i]);
            normal += weights[i] * by.transpose() * by;
            right += weights[i] * by.transpose() * (pixels[i] - model(x, places[i]));
            sum += weights[i] * distances[i] * distances[i];
            weight += weights[i];
            found.kept += weights[i] >= 0.5 ? 1 : 0;
        }
        const double freedom = std::max(1.0, 2.0 * weight - static_cast<double>(x.size()));
        found.rms = std::sqrt(sum / std::max(weight, 1e-12));
        found.covariance = (sum / freedom) * normal.inverse();
        if (step < kHuberSteps + kTukeySteps)
            x += normal.ldlt().solve(right);
    }
    found.x = x;
    return found;
}

/// The homography from place to pixel by the linear method; both normalised.
Eigen::Matrix3d linearHomography(const std::vector<Eigen::Vector2d>& places,
                                 const std::vector<Eigen::Vector2d>& pixels) {
    // The smallest eigenvector of A'A, where each point gives two rows of A h = 0.
    Eigen::Matrix<double, 9, 9> squared = Eigen::Matrix<double, 9, 9>::Zero();
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Eigen::RowVector3d place = places[i].homogeneous().transpose();
        Eigen::Matrix<double, 2, 9> rows = Eigen::Matrix<double, 2, 9>::Zero();
        rows.block<1, 3>(0, 0) = place;
        rows.block<1, 3>(0, 6) = -pixels[i].x() * place;
        rows.block<1, 3>(1, 3) = place;
        rows.block<1, 3>(1, 6) = -pixels[i].y() * place;
        squared += rows.transpose() * rows;
    }
    const Eigen::Matrix<double, 9, 1> h =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 9, 9>>(squared).eigenvectors().col(0);
    Eigen::Matrix3d homography;
    homography << h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], h[8];
    return homography;
}

/// Derivative of what a homography makes of a point.
Eigen::Matrix2d slopeOf(const Eigen::Matrix3d& homography, const Eigen::Vector2d& point) {
    const Eigen::Vector3d image = homography * point.homogeneous();
    Eigen::Matrix2d slope;
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 2; ++column)
            slope(row, column) = (homography(row, column) * image.z() - homography(2, column) * image[row]) /
                                 (image.z() * image.z());
    return slope;
}

/// x along u and y along v at a pixel, whose place is that which the scale alone gives it.
Eigen::Matrix3d settled(const Eigen::Matrix3d& toPlace, const Eigen::Vector2d& pixel, double scale) {
    const Eigen::Matrix2d slope = slopeOf(toPlace, pixel);
    const Eigen::Rotation2Dd turn(-std::atan2(slope(1, 0) - slope(0, 1), slope(0, 0) + slope(1, 1)));
    Eigen::Matrix3d motion = Eigen::Matrix3d::Identity();
    motion.topLeftCorner<2, 2>() = turn.toRotationMatrix();
    const Eigen::Vector2d place = (toPlace * pixel.homogeneous()).hnormalized();
    motion.topRightCorner<2, 1>() = scale * pixel - turn * place;
    const Eigen::Matrix3d result = motion * toPlace;
    return result / result(2, 2);
}

Eigen::Matrix3d homographyOf(const PlaneNumbers& x) {
    Eigen::Matrix3d homography;
    homography << x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], 1.0;
    return homography;
}

} // namespace

core::Expected<PlaneFit> fitHomography(std::span<const PlanePair> pairs, double shared_px) {
    TELETA_CHECK(checkPairs(pairs, kFewestOfHomography));
    const Frame placeFrame = frameOf(pairs, &PlanePair::place_m);
    const Frame pixelFrame = frameOf(pairs, &PlanePair::pixel);
    std::vector<Eigen::Vector2d> places;
    std::vector<Eigen::Vector2d> pixels;
    for (const PlanePair& pair : pairs) {
        places.push_back(placeFrame.to(pair.place_m));
        pixels.push_back(pixelFrame.to(pair.pixel));
    }
    const Eigen::Matrix3d start = linearHomography(places, pixels);
    const auto noPlane = [] {
        return core::refused(PlaneFitText::tr("the points show no plane in front of the camera"),
                             PlaneFitText::tr("points of one flat pattern, each with its own place"));
    };
    if (!(std::abs(start(2, 2)) > 1e-9))
        return noPlane();
    PlaneNumbers x(8);
    for (Eigen::Index i = 0; i < 8; ++i)
        x[i] = start(i / 3, i % 3) / start(2, 2);
    const Model model = [](const PlaneNumbers& numbers, const Eigen::Vector2d& place) -> Eigen::Vector2d {
        return (homographyOf(numbers) * place.homogeneous()).hnormalized();
    };
    const Robust found = fitRobustly(model, x, places, pixels, pixelFrame.size);
    // In the middle of the pattern, which is the origin of the normalised places.
    const double unit = placeFrame.size / pixelFrame.size;
    const auto scaleOf = [&](const PlaneNumbers& numbers) {
        return unit /
               std::sqrt(std::abs(slopeOf(homographyOf(numbers), Eigen::Vector2d::Zero()).determinant()));
    };
    const Eigen::Matrix3d toPixel =
        pixelFrame.matrix().inverse() * homographyOf(found.x) * placeFrame.matrix();
    const double side = toPixel.row(2) * pairs.front().place_m.homogeneous();
    const double turns = slopeOf(toPixel, placeFrame.middle).determinant(); // below 0: mirrored
    const bool isInFront = turns > 0.0 && std::ranges::all_of(pairs, [&](const PlanePair& pair) {
                               return side * toPixel.row(2).dot(pair.place_m.homogeneous()) > 0.0;
                           });
    PlaneFit fit;
    fit.scale_mPerPx = scaleOf(found.x);
    if (!found.x.allFinite() || !found.covariance.allFinite() || !isInFront ||
        !std::isfinite(fit.scale_mPerPx))
        return noPlane();
    constexpr double kStep = 1e-6;
    PlaneNumbers slope(8);
    for (Eigen::Index i = 0; i < 8; ++i) {
        PlaneNumbers up = found.x;
        PlaneNumbers down = found.x;
        up[i] += kStep;
        down[i] -= kStep;
        slope[i] = (scaleOf(up) - scaleOf(down)) / (2.0 * kStep);
    }
    const double radius_px = std::sqrt(2.0) * pixelFrame.size;
    fit.scaleError_mPerPx = std::hypot(std::sqrt(std::max(0.0, slope.dot(found.covariance * slope))),
                                       fit.scale_mPerPx * shared_px / radius_px);
    const Eigen::Vector2d middle = (toPixel * placeFrame.middle.homogeneous()).hnormalized();
    fit.homography = settled(toPixel.inverse(), middle, fit.scale_mPerPx);
    fit.rms_px = found.rms * pixelFrame.size;
    fit.pairs = pairs.size();
    fit.kept = found.kept;
    return fit;
}

core::Expected<PlaneFit> fitScale(std::span<const PlanePair> pairs) {
    TELETA_CHECK(checkPairs(pairs, kFewestOfScale));
    const Frame placeFrame = frameOf(pairs, &PlanePair::place_m);
    const Frame pixelFrame = frameOf(pairs, &PlanePair::pixel);
    std::vector<Eigen::Vector2d> places;
    std::vector<Eigen::Vector2d> pixels;
    double along = 0.0;
    double across = 0.0;
    double size = 0.0;
    for (const PlanePair& pair : pairs) {
        places.push_back(placeFrame.to(pair.place_m));
        pixels.push_back(pixelFrame.to(pair.pixel));
        const Eigen::Vector2d& place = places.back();
        along += place.dot(pixels.back());
        across += place.x() * pixels.back().y() - place.y() * pixels.back().x();
        size += place.squaredNorm();
    }
    PlaneNumbers x(4);
    x << along / size, across / size, 0.0, 0.0;
    const Model model = [](const PlaneNumbers& n, const Eigen::Vector2d& place) -> Eigen::Vector2d {
        return {n[0] * place.x() - n[1] * place.y() + n[2], n[1] * place.x() + n[0] * place.y() + n[3]};
    };
    const Robust found = fitRobustly(model, x, places, pixels, pixelFrame.size);
    const double larger = std::hypot(found.x[0], found.x[1]);
    if (!(larger > 0.0) || !found.covariance.allFinite())
        return core::refused(PlaneFitText::tr("the points show no plane in front of the camera"),
                             PlaneFitText::tr("points of one flat pattern, each with its own place"));
    PlaneFit fit;
    fit.isScale = true;
    fit.scale_mPerPx = placeFrame.size / pixelFrame.size / larger;
    const Eigen::Vector2d slope = found.x.head<2>() / larger;
    const double error = std::sqrt(std::max(0.0, slope.dot(found.covariance.topLeftCorner<2, 2>() * slope)));
    fit.scaleError_mPerPx = fit.scale_mPerPx * error / larger;
    fit.homography(0, 0) = fit.homography(1, 1) = fit.scale_mPerPx;
    fit.rms_px = found.rms * pixelFrame.size;
    fit.pairs = pairs.size();
    fit.kept = found.kept;
    return fit;
}

core::Expected<PlaneFit> fitRuler(std::span<const RulerReading> readings) {
    double crossed = 0.0;
    double squared = 0.0;
    for (const RulerReading& reading : readings) {
        const double length_px = (reading.to_px - reading.from_px).norm();
        if (!(reading.length_m > 0.0))
            return core::refused(PlaneFitText::tr("the length of the ruler is not above 0"), {});
        if (!(length_px >= kShortestRuler_px))
            return core::refused(
                PlaneFitText::tr("the two points of the ruler are too close to each other"),
                PlaneFitText::tr("points that are at least %1 px apart").arg(kShortestRuler_px));
        crossed += length_px * reading.length_m;
        squared += reading.length_m * reading.length_m;
    }
    if (readings.empty())
        return core::refused(PlaneFitText::tr("no ruler was read"), {});
    const double pxPerM = crossed / squared;
    double residual = 0.0;
    for (const RulerReading& reading : readings) {
        const double expected_px = pxPerM * reading.length_m;
        const double away_px = (reading.to_px - reading.from_px).norm() - expected_px;
        if (std::abs(away_px) > std::max(kMostRulerShare * expected_px, kMostRuler_px))
            return core::refused(
                PlaneFitText::tr("the rulers contradict each other: %1 mm is %2 px off")
                    .arg(QString::number(1e3 * reading.length_m, 'g', 4), QString::number(away_px, 'f', 1)),
                PlaneFitText::tr("lengths that agree within 5 %; a picture seen askew needs a chessboard"));
        residual += away_px * away_px;
    }
    const auto n = static_cast<double>(readings.size());
    // Both ends of a length are read.
    const double scatter_px =
        std::max(std::sqrt(2.0) * kReading_px, n > 1.0 ? std::sqrt(residual / (n - 1.0)) : 0.0);
    PlaneFit fit;
    fit.isScale = true;
    fit.scale_mPerPx = 1.0 / pxPerM;
    fit.scaleError_mPerPx = scatter_px / std::sqrt(squared) / (pxPerM * pxPerM);
    fit.homography(0, 0) = fit.homography(1, 1) = fit.scale_mPerPx;
    fit.rms_px = n > 1.0 ? std::sqrt(residual / n) : std::numeric_limits<double>::quiet_NaN();
    fit.pairs = fit.kept = readings.size();
    return fit;
}

} // namespace teleta::vision
