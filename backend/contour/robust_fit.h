// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <functional>

namespace teleta::contour {

/// Residuals (one a point) and their Jacobian (points x parameters) at the given parameters, in units of the
/// size of the contour. Both come in with the right number of rows or are resized by the callee.
using Residuals = std::function<void(const Eigen::VectorXd& parameters, Eigen::VectorXd& residuals,
                                     Eigen::MatrixXd& jacobian)>;

/// A model after fitting.
struct RobustFit {
    Eigen::VectorXd parameters;
    Eigen::VectorXd residuals;
    Eigen::MatrixXd jacobian;
};

/// Fits a model to points of which some are outliers: Levenberg-Marquardt on Tukey's biweight of the
/// residuals, first with a scale of a quarter of the size so that any sensible start converges, then
/// with 4.685 times the robust standard deviation (1.4826 MAD, corrected for the parameters), which is never
/// taken smaller than a hundredth. Without outliers and noise it converges to rounding. Thread: any (pure).
[[nodiscard]] RobustFit fitRobustly(const Residuals& residuals, Eigen::VectorXd start);

/// Scale of robustLoss at which starts are compared.
inline constexpr double kStartScale = 0.1;

/// Mean biweight loss, 0 (all residuals zero) .. 1 (all beyond the scale); compares starts before they are
/// fitted.
[[nodiscard]] double robustLoss(const Eigen::VectorXd& residuals, double scale);

} // namespace teleta::contour
