// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/robust_fit.h"

#include "backend/contour/lanes.h"
#include "backend/core/quantile.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace teleta::contour {

namespace {

using At = RobustModel::At;

constexpr double kWideScale = 0.25;
constexpr double kSmallestDeviation = 0.01;
constexpr double kBiweight = 4.685; // 95 % efficient for a normal distribution
constexpr double kMadToDeviation = 1.4826;
constexpr int kIterations = 40;
constexpr double kWideTolerance = 1e-2; ///< relative decrease of the loss at which the stage ends
constexpr double kRoughTolerance = 1e-2;
constexpr double kTolerance = 1e-4;
constexpr double kFineTolerance = 1e-9;
constexpr double kLargestStep = 0.5;
constexpr double kLeastStrength = 1e-200; ///< of a direction in the normal matrix

double robustDeviation(std::span<const double> residuals, Eigen::Index parameters) {
    std::vector<double> sizes(residuals.size());
    std::transform(residuals.begin(), residuals.end(), sizes.begin(), [](double r) { return std::abs(r); });
    const auto n = static_cast<double>(residuals.size());
    const double freedom = std::max(1.0, n - static_cast<double>(parameters));
    return kMadToDeviation * core::upperMedianOf(sizes) * std::sqrt(n / freedom);
}

std::span<const double> residualsOf(const RobustModel& model, const At& at) {
    return std::span(at.residuals).first(model.points().count);
}

/// Solves the equations with this added to their diagonal, by L D L^T within the profile. step: negative.
bool solve(const StepEquations& equations, double damping, double strength, RobustModel::Parameters& step) {
    const int n = equations.count;
    std::array<double, kMostParameters * kMostParameters> lower; // (row, column < row), each row contiguous
    std::array<double, kMostParameters> inverse;
    std::array<double, kMostParameters> x;
    for (int i = 0; i < n; ++i) {
        double* row = lower.data() + i * kMostParameters;
        const double* given = equations.normal.data() + i * kMostParameters;
        const int from = equations.first[static_cast<std::size_t>(i)];
        double rest = given[i] + damping * given[i] + 1e-9 * damping * strength +
                      1e-12 * strength; // undetermined directions stay put
        double value = -equations.gradient[static_cast<std::size_t>(i)];
        for (int k = from; k < i; ++k) {
            const double* other = lower.data() + k * kMostParameters;
            double sum = given[k];
            for (int l = std::max(from, equations.first[static_cast<std::size_t>(k)]); l < k; ++l)
                sum -= row[l] * other[l];
            row[k] = sum; // L D
        }
        for (int k = from; k < i; ++k) {
            const double scaled = row[k] * inverse[static_cast<std::size_t>(k)];
            rest -= scaled * row[k];
            row[k] = scaled;
            value -= scaled * x[static_cast<std::size_t>(k)];
        }
        if (!(rest > 0.0))
            return false;
        inverse[static_cast<std::size_t>(i)] = 1.0 / rest;
        x[static_cast<std::size_t>(i)] = value;
    }
    for (int i = 0; i < n; ++i)
        x[static_cast<std::size_t>(i)] *= inverse[static_cast<std::size_t>(i)];
    for (int i = n - 1; i >= 0; --i) {
        const double* row = lower.data() + i * kMostParameters;
        for (int k = equations.first[static_cast<std::size_t>(i)]; k < i; ++k)
            x[static_cast<std::size_t>(k)] -= row[k] * x[static_cast<std::size_t>(i)];
        step[i] = x[static_cast<std::size_t>(i)];
    }
    return true;
}

/// Weights of the biweight, and weights times residuals; 0 beyond the points.
void weigh(const double* residuals, std::size_t count, double inverse2, double* weights,
           double* weightedResiduals) {
    doInLanes([&]() __attribute__((always_inline)) {
        for (std::size_t i = 0; i < count; i += kLanes) {
            const Lanes zero{};
            Lanes residual;
            load(residual, residuals + i);
            Lanes kept = 1.0 - residual * residual * inverse2;
            kept = kept > zero ? kept : zero;
            kept *= kept;
            store(weights + i, kept);
            store(weightedResiduals + i, kept * residual);
        }
    });
    for (std::size_t i = count; i % kLanes != 0; ++i)
        weights[i] = weightedResiduals[i] = 0.0;
}

/// Minimises the loss at a fixed scale, in place.
void descend(const RobustModel& model, At& at, double scale, double tolerance) {
    const std::size_t count = model.points().count;
    const std::size_t filled = model.points().filled();
    double damping = 1e-3;
    double cost = robustLoss(residualsOf(model, at), scale);
    At trial;
    trial.parameters.resize(at.parameters.size());
    RobustModel::Parameters step(at.parameters.size());
    StepEquations equations;
    std::vector<double> weights(2 * filled, 0.0);
    double* weightedResiduals = weights.data() + filled;
    const double inverse2 = 1.0 / (scale * scale);
    for (int iteration = 0; iteration < kIterations; ++iteration) {
        weigh(at.residuals.data(), count, inverse2, weights.data(), weightedResiduals);
        model.equations(at, weights.data(), weightedResiduals, equations);
        double strength = 0.0;
        for (int k = 0; k < equations.count; ++k)
            strength = std::max(strength, equations.at(k, k));
        if (strength < kLeastStrength)
            return; // no point is near

        bool improved = false;
        for (int attempt = 0; attempt < 8 && !improved; ++attempt) {
            if (!solve(equations, damping, strength, step)) {
                damping *= 10.0;
                continue;
            }
            const double length = step.norm();
            if (!std::isfinite(length))
                return;
            if (length > kLargestStep)
                step *= kLargestStep / length;
            trial.parameters = at.parameters + step;
            model.evaluate(trial);
            const double trialCost = robustLoss(residualsOf(model, trial), scale);
            if (trialCost < cost) {
                improved = true;
                if (attempt == 0)
                    damping = std::max(1e-12, damping * 0.1);
                std::swap(at, trial);
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

/// A row of the normal matrix of P columns, from the diagonal on, and of the gradient. Each sum has a name of
/// its own, so that all stay in registers, where an array goes through memory.
template <int P, int row>
[[gnu::always_inline]] inline void addRow(const double* derivatives, std::size_t filled,
                                          const double* weights, const double* weightedResiduals,
                                          StepEquations& equations) {
    constexpr int kColumns = P - row;
    const double* own = derivatives + static_cast<std::size_t>(row) * filled;
    Lanes onRow{}, sum0{}, sum1{}, sum2{}, sum3{}, sum4{};
    for (std::size_t i = 0; i < filled; i += kLanes) {
        Lanes number, weight, weighted, other;
        load(number, own + i);
        load(weight, weights + i);
        load(weighted, weightedResiduals + i);
        onRow += weighted * number;
        weight *= number;
        sum0 += weight * number;
        if constexpr (kColumns > 1) {
            load(other, own + filled + i);
            sum1 += weight * other;
        }
        if constexpr (kColumns > 2) {
            load(other, own + 2 * filled + i);
            sum2 += weight * other;
        }
        if constexpr (kColumns > 3) {
            load(other, own + 3 * filled + i);
            sum3 += weight * other;
        }
        if constexpr (kColumns > 4) {
            load(other, own + 4 * filled + i);
            sum4 += weight * other;
        }
    }
    equations.gradient[static_cast<std::size_t>(row)] = sumOf(onRow);
    const std::array<double, 5> sums{sumOf(sum0), sumOf(sum1), sumOf(sum2), sumOf(sum3), sumOf(sum4)};
    for (int column = row; column < P; ++column)
        equations.at(row, column) = sums[static_cast<std::size_t>(column - row)];
}

RobustFit toFit(const RobustModel& model, const At& at, double scale) {
    const auto count = static_cast<Eigen::Index>(model.points().count);
    return {at.parameters, Eigen::Map<const Eigen::VectorXd>(at.residuals.data(), count), model.jacobian(at),
            scale};
}

RobustFit fitTo(const RobustModel& model, const RobustModel::Parameters& start, double tolerance) {
    At at;
    at.parameters = start;
    model.evaluate(at);
    double scale = kWideScale;
    if (model.points().count > 0) {
        descend(model, at, kWideScale, kWideTolerance);
        const double deviation =
            std::max(kSmallestDeviation, robustDeviation(residualsOf(model, at), at.parameters.size()));
        scale = std::min(kWideScale, kBiweight * deviation);
        descend(model, at, scale, tolerance);
    }
    return toFit(model, at, scale);
}

RobustFit continued(const RobustModel& model, const RobustFit& fit, double tolerance) {
    At at;
    at.parameters = fit.parameters;
    model.evaluate(at);
    descend(model, at, fit.scale, tolerance);
    return toFit(model, at, fit.scale);
}

} // namespace

NormalMatrix normalMatrix(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& weights) {
    const Eigen::Index count = jacobian.cols();
    const auto rows = static_cast<std::size_t>(jacobian.rows());
    const std::size_t whole = rows - rows % kLanes;
    NormalMatrix normal(count, count);
    std::vector<double> weighted(rows);
    doInLanes([&]() __attribute__((always_inline)) {
        for (Eigen::Index k = 0; k < count; ++k) {
            const double* own = jacobian.data() + static_cast<std::size_t>(k) * rows;
            for (std::size_t i = 0; i < rows; ++i)
                weighted[i] = weights.data()[i] * own[i];
            for (Eigen::Index l = 0; l <= k; ++l) {
                const double* other = jacobian.data() + static_cast<std::size_t>(l) * rows;
                Lanes sums{};
                for (std::size_t i = 0; i < whole; i += kLanes) {
                    Lanes a, b;
                    load(a, weighted.data() + i);
                    load(b, other + i);
                    sums += a * b;
                }
                double sum = sumOf(sums);
                for (std::size_t i = whole; i < rows; ++i)
                    sum += weighted[i] * other[i];
                normal.data()[l * count + k] = normal.data()[k * count + l] = sum;
            }
        }
    });
    return normal;
}

PointColumns::PointColumns(std::span<const Point> points)
    : count(points.size())
    , x((count + kLanes - 1) / kLanes * kLanes)
    , y(x.size()) {
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Point& p = points[i < count ? i : 0];
        x[i] = p.x();
        y[i] = p.y();
    }
}

template <int P>
void ColumnModel<P>::equations(const At& at, const double* weights, const double* weightedResiduals,
                               StepEquations& equations) const {
    equations.count = P;
    const double* derivatives = at.derivatives.data();
    const std::size_t filled = m_points.filled();
    doInLanes([&]() __attribute__((always_inline)) {
        addRow<P, 0>(derivatives, filled, weights, weightedResiduals, equations);
        addRow<P, 1>(derivatives, filled, weights, weightedResiduals, equations);
        if constexpr (P > 2)
            addRow<P, 2>(derivatives, filled, weights, weightedResiduals, equations);
        if constexpr (P > 3)
            addRow<P, 3>(derivatives, filled, weights, weightedResiduals, equations);
        if constexpr (P > 4)
            addRow<P, 4>(derivatives, filled, weights, weightedResiduals, equations);
    });
}

template <int P>
std::array<double*, P> ColumnModel<P>::columns(At& at) const {
    at.residuals.resize(m_points.filled());
    at.derivatives.resize(P * m_points.filled());
    std::array<double*, P> columns;
    for (std::size_t k = 0; k < P; ++k)
        columns[k] = at.derivatives.data() + k * m_points.filled();
    return columns;
}

template <int P>
Eigen::MatrixXd ColumnModel<P>::jacobian(const At& at) const {
    return Eigen::Map<const Eigen::MatrixXd>(at.derivatives.data(),
                                             static_cast<Eigen::Index>(m_points.filled()), P)
        .topRows(static_cast<Eigen::Index>(m_points.count));
}

template class ColumnModel<2>;
template class ColumnModel<3>;
template class ColumnModel<4>;
template class ColumnModel<5>;

double robustLoss(std::span<const double> residuals, double scale) {
    if (residuals.empty())
        return 0.0;
    const double inverse2 = 1.0 / (scale * scale);
    double sum = 0.0;
    const auto loss = [&](double q) {
        return q * (3.0 - 3.0 * q + q * q);
    }; // 1 - (1 - q)^3 without cancellation
    const std::size_t whole = residuals.size() - residuals.size() % kLanes;
    doInLanes([&]() __attribute__((always_inline)) {
        Lanes sums{};
        for (std::size_t i = 0; i < whole; i += kLanes) {
            Lanes q;
            load(q, residuals.data() + i);
            q *= q * inverse2;
            q = q < 1.0 ? q : 1.0 - Lanes{};
            sums += q * (3.0 - 3.0 * q + q * q);
        }
        sum = sumOf(sums);
    });
    for (std::size_t i = whole; i < residuals.size(); ++i)
        sum += loss(std::min(1.0, residuals[i] * residuals[i] * inverse2));
    return sum / static_cast<double>(residuals.size());
}

double robustLoss(const RobustFit& fit) {
    return robustLoss({fit.residuals.data(), static_cast<std::size_t>(fit.residuals.size())}, kStartScale);
}

double lossOfStart(const RobustModel& model, const RobustModel::Parameters& start) {
    At at;
    at.parameters = start;
    model.evaluate(at);
    return robustLoss(residualsOf(model, at), kStartScale);
}

RobustFit fitRoughly(const RobustModel& model, const RobustModel::Parameters& start) {
    return fitTo(model, start, kRoughTolerance);
}

RobustFit refined(const RobustModel& model, const RobustFit& fit) {
    return continued(model, fit, kTolerance);
}

RobustFit polished(const RobustModel& model, const RobustFit& fit) {
    return continued(model, fit, kFineTolerance);
}

RobustFit fitRobustly(const RobustModel& model, const RobustModel::Parameters& start) {
    return fitTo(model, start, kTolerance);
}

} // namespace teleta::contour
