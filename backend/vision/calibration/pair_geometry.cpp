// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/calibration/pair_geometry.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace teleta::vision {

namespace {

/// Larger pixels and metres are not plausible coordinates.
constexpr double kFarthest = 1e9;
constexpr std::size_t kFewest = 6;

template <typename Vector>
std::size_t countDifferent(std::vector<Vector> vectors) {
    std::sort(vectors.begin(), vectors.end(), [](const Vector& a, const Vector& b) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    });
    return static_cast<std::size_t>(std::unique(vectors.begin(), vectors.end()) - vectors.begin());
}

} // namespace

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
    if (pairs.size() < kFewest)
        return CalibrationRefusal::tooFewPairs;
    if (countDifferent(points) < kFewest || countDifferent(pixels) < kFewest)
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

} // namespace teleta::vision
