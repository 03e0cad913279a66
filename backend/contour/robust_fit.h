// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <functional>

namespace teleta::contour {

/// Computes the residuals (one per point) and their Jacobian (points x parameters) at the given parameters,
/// in units of the size of the contour. The callee resizes both where needed.
using Residuals = std::function<void(const Eigen::VectorXd& parameters, Eigen::VectorXd& residuals,
                                     Eigen::MatrixXd& jacobian)>;

/// A model after fitting. At most kMostParameters parameters.
struct RobustFit {
    Eigen::VectorXd parameters;
    Eigen::VectorXd residuals;
    Eigen::MatrixXd jacobian;
};

/// Most parameters of a model: two coordinates of each vertex of the longest chain of edges.
inline constexpr int kMostParameters = 34;
using NormalMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostParameters, kMostParameters>;

/// J^T W J, of a Jacobian with at most kMostParameters columns and a weight of each point. Thread: any
/// (pure).
[[nodiscard]] NormalMatrix normalMatrix(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& weights);

/// Fits a model to points that contain outliers: Levenberg-Marquardt on Tukey's biweight of the residuals.
/// The scale is first a quarter of the size, so that any sensible start converges, then 4.685 times the
/// robust standard deviation (1.4826 MAD, corrected for the number of parameters), but never less than a
/// hundredth of the size. Without outliers and noise it converges to rounding error. Thread: any (pure).
[[nodiscard]] RobustFit fitRobustly(const Residuals& residuals, Eigen::VectorXd start);

/// Scale of robustLoss() for comparing starts.
inline constexpr double kStartScale = 0.1;

/// Mean biweight loss, from 0 (all residuals zero) to 1 (all beyond the scale); for comparing starts before
/// they are fitted.
[[nodiscard]] double robustLoss(const Eigen::VectorXd& residuals, double scale);

} // namespace teleta::contour
