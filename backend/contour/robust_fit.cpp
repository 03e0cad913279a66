// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/robust_fit.h"

#include "backend/core/quantile.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <vector>

namespace teleta::contour {

namespace {

constexpr double kWideScale = 0.25;
constexpr double kSmallestDeviation = 0.01;
constexpr double kBiweight = 4.685; // 95 % efficient for a normal distribution
constexpr double kMadToDeviation = 1.4826;
constexpr int kIterations = 40;
constexpr double kWideTolerance = 1e-3; ///< relative decrease of the loss at which the stage ends
constexpr double kTolerance = 1e-9;
constexpr double kLargestStep = 0.5;

double robustDeviation(const Eigen::VectorXd& residuals, Eigen::Index parameters) {
    std::vector<double> sizes(static_cast<std::size_t>(residuals.size()));
    std::transform(residuals.begin(), residuals.end(), sizes.begin(), [](double r) { return std::abs(r); });
    const auto n = static_cast<double>(residuals.size());
    const double freedom = std::max(1.0, n - static_cast<double>(parameters));
    return kMadToDeviation * core::upperMedianOf(sizes) * std::sqrt(n / freedom);
}

/// Minimises the loss at a fixed scale, in place.
void descend(const Residuals& evaluate, RobustFit& fit, double scale, double tolerance) {
    double damping = 1e-3;
    double cost = robustLoss(fit.residuals, scale);
    RobustFit trial;
    NormalMatrix damped;
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostParameters, 1> gradient(fit.parameters.size());
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostParameters, 1> step(fit.parameters.size());
    Eigen::LDLT<NormalMatrix> solver(fit.parameters.size());
    Eigen::VectorXd weights;
    for (int iteration = 0; iteration < kIterations; ++iteration) {
        weights = (1.0 - (fit.residuals.array() * (1.0 / scale)).square()).max(0.0).square();
        const NormalMatrix normal = normalMatrix(fit.jacobian, weights);
        weights.array() *= fit.residuals.array();
        for (Eigen::Index k = 0; k < gradient.size(); ++k)
            gradient[k] = fit.jacobian.col(k).dot(weights);
        const double strength = std::max(normal.diagonal().maxCoeff(), 1e-300);

        bool improved = false;
        for (int attempt = 0; attempt < 8 && !improved; ++attempt) {
            damped = normal;
            damped.diagonal().array() += damping * normal.diagonal().array() + 1e-9 * damping * strength;
            damped.diagonal().array() += 1e-14 * strength; // undetermined directions stay put
            step = -solver.compute(damped).solve(gradient);
            const double length = step.norm();
            if (!std::isfinite(length))
                return;
            if (length > kLargestStep)
                step *= kLargestStep / length;
            trial.parameters = fit.parameters + step;
            evaluate(trial.parameters, trial.residuals, trial.jacobian);
            const double trialCost = robustLoss(trial.residuals, scale);
            if (trialCost < cost) {
                improved = true;
                damping = std::max(1e-12, damping * 0.1);
                std::swap(fit.parameters, trial.parameters);
                std::swap(fit.residuals, trial.residuals);
                std::swap(fit.jacobian, trial.jacobian);
                const bool settled = cost - trialCost <= tolerance * cost || length < 1e-15;
                cost = trialCost;
                if (settled)
                    return;
            } else {
                damping *= 10.0;
            }
        }
        if (!improved)
            return;
    }
}

} // namespace

NormalMatrix normalMatrix(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& weights) {
    const Eigen::Index count = jacobian.cols();
    NormalMatrix normal(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index k = 0; k <= i; ++k)
            normal(i, k) = normal(k, i) =
                (jacobian.col(i).array() * jacobian.col(k).array() * weights.array()).sum();
    }
    return normal;
}

double robustLoss(const Eigen::VectorXd& residuals, double scale) {
    if (residuals.size() == 0)
        return 0.0;
    const double inverse = 1.0 / scale;
    const auto q = (residuals.array() * inverse).square().min(1.0);
    // 1 - (1 - q)^3 without cancellation
    return (q * (3.0 - 3.0 * q + q * q)).sum() / static_cast<double>(residuals.size());
}

RobustFit fitRobustly(const Residuals& residuals, Eigen::VectorXd start) {
    RobustFit fit;
    fit.parameters = std::move(start);
    residuals(fit.parameters, fit.residuals, fit.jacobian);
    if (fit.residuals.size() == 0)
        return fit;
    descend(residuals, fit, kWideScale, kWideTolerance);
    const double deviation =
        std::max(kSmallestDeviation, robustDeviation(fit.residuals, fit.parameters.size()));
    descend(residuals, fit, std::min(kWideScale, kBiweight * deviation), kTolerance);
    return fit;
}

} // namespace teleta::contour
