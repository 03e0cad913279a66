// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace teleta::study {

/// The function h that makes a share of the linear predictor.
enum class Link {
    logit,  ///< 1 / (1 + exp(-x))
    probit, ///< Phi(x), the normal distribution
};

/// Trials of one participant that share their predictors.
struct BinomialRow {
    std::size_t participant = 0;
    std::vector<double> x; ///< predictors; the first is 1 where there is an intercept
    std::int64_t correct = 0;
    std::int64_t trials = 0;
};

/// k ~ Bin(n, g + (1 - g - l) h(sum b_j x_j + s z_i)), z_i ~ N(0, 1) for participant i.
struct BinomialModel {
    std::vector<BinomialRow> rows;
    Link link = Link::logit;
    double guess = 0.0; ///< g, 0 .. 1
    double lapse = 0.0; ///< l, 0 .. 1 - g
    /// A coefficient beyond this has run away: the data are separable.
    double largestCoefficient = 15.0;
};

/// Log likelihood of a binomial model without the terms that depend on the data alone, the z integrated out:
/// by adaptive Gauss-Hermite quadrature with 25 nodes, or with guesses or lapses by the trapezoidal rule.
/// These make the integrand wide or two-peaked for a participant whom no function fits, far from a normal
/// curve. Thread: one.
class MarginalLikelihood {
public:
    /// Rows have the same number of predictors, at least one.
    explicit MarginalLikelihood(const BinomialModel& model);

    struct Value {
        double logLikelihood = 0.0;
        Eigen::VectorXd gradient; ///< with respect to b and s
    };
    /// parameters: b, then s, which may have either sign.
    [[nodiscard]] Value at(const Eigen::VectorXd& parameters) const;
    /// Central differences of the gradient; symmetric.
    [[nodiscard]] Eigen::MatrixXd hessian(const Eigen::VectorXd& parameters) const;

    [[nodiscard]] Eigen::Index predictors() const { return m_predictors; }

private:
    struct Row {
        Eigen::VectorXd x;
        double correct = 0.0;
        double wrong = 0.0;
    };
    /// Log likelihood of a row at a linear predictor, its derivative, and its expected information.
    struct Point {
        double value = 0.0;
        double slope = 0.0;
        double information = 0.0;
    };
    [[nodiscard]] Point point(const Row& row, double predictor) const;
    void addPerson(const std::vector<Row>& rows, const Eigen::VectorXd& parameters, Value& sum) const;

    Link m_link;
    double m_guess;
    double m_lapse;
    double m_mostInformation = 0.0; ///< of a trial, about the predictor
    Eigen::Index m_predictors;
    std::vector<std::vector<Row>> m_people;
};

} // namespace teleta::study
