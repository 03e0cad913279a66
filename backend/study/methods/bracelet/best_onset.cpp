// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/bracelet/best_onset.h"

#include "backend/core/quantile.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace teleta::study {

namespace {

constexpr int kMostTurns = 100;
constexpr double kSettled = 1e-12;
constexpr double kSmallestShare = 1e-12;

double clampedNormalShare(double z) {
    return std::clamp(core::normalShare(z), kSmallestShare, 1.0 - kSmallestShare);
}

double normalDensity(double z) {
    return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
}

/// k ln(k / m), with 0 ln 0 = 0.
double term(double k, double m) {
    return k > 0.0 ? k * std::log(k / m) : 0.0;
}

} // namespace

BestOnset bestOnset(std::span<const OnsetCount> counts) {
    BestOnset best;
    std::set<double> times;
    for (const OnsetCount& count : counts)
        times.insert(count.onset_s);
    if (times.size() < 3) {
        best.doubt = OnsetDoubt::tooFewTimes;
        return best;
    }
    // In units of the longest time the columns have about the same size.
    const double unit_s = *times.rbegin();
    const auto rows = static_cast<Eigen::Index>(counts.size());
    Eigen::MatrixX3d design(rows, 3);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const double x = counts[static_cast<std::size_t>(i)].onset_s / unit_s;
        design.row(i) << 1.0, x, x * x;
    }
    Eigen::Vector3d slope = Eigen::Vector3d::Zero();
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    bool settled = false;
    for (int turn = 0; turn < kMostTurns && !settled; ++turn) {
        information.setZero();
        Eigen::Vector3d score = Eigen::Vector3d::Zero();
        for (Eigen::Index i = 0; i < rows; ++i) {
            const OnsetCount& count = counts[static_cast<std::size_t>(i)];
            const double z = design.row(i).dot(slope);
            const double share = clampedNormalShare(z);
            const double density = normalDensity(z);
            const double weight = density / (share * (1.0 - share));
            information += count.trials * weight * density * design.row(i).transpose() * design.row(i);
            score += weight * (count.yes - count.trials * share) * design.row(i).transpose();
        }
        const Eigen::LDLT<Eigen::Matrix3d> solver(information);
        const Eigen::Vector3d step = solver.solve(score);
        if (solver.info() != Eigen::Success || !step.allFinite())
            break;
        slope += step;
        settled = step.norm() <= kSettled * (1.0 + slope.norm());
    }
    if (!settled || !(slope[2] < 0.0)) {
        best.doubt = OnsetDoubt::noTop;
        return best;
    }
    const double top = -slope[1] / (2.0 * slope[2]);
    if (top * unit_s < *times.begin() || top > 1.0) {
        best.doubt = OnsetDoubt::outside;
        return best;
    }
    const Eigen::Vector3d gradient(0.0, -0.5 / slope[2], 0.5 * slope[1] / (slope[2] * slope[2]));
    const Eigen::Matrix3d covariance = information.inverse();
    const double se_s = unit_s * std::sqrt(gradient.dot(covariance * gradient));
    // All shares alike determine no top.
    if (!(se_s < *times.rbegin() - *times.begin())) {
        best.doubt = OnsetDoubt::noTop;
        return best;
    }
    best.onset_s = top * unit_s;
    best.se_s = se_s;
    best.low_s = best.onset_s - core::kNormalQuantile95 * best.se_s;
    best.high_s = best.onset_s + core::kNormalQuantile95 * best.se_s;
    for (Eigen::Index i = 0; i < rows; ++i) {
        const OnsetCount& count = counts[static_cast<std::size_t>(i)];
        const double expected = count.trials * clampedNormalShare(design.row(i).dot(slope));
        best.deviance +=
            2.0 * (term(count.yes, expected) + term(count.trials - count.yes, count.trials - expected));
    }
    return best;
}

} // namespace teleta::study
