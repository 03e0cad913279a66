// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/model/marginal_likelihood.h"

#include "backend/study/model/gauss_hermite.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace teleta::study {

namespace {

constexpr std::size_t kNodes = 25;
constexpr double kSmallestOutcome = 1e-300;
/// Of the trapezoidal rule, in the standard deviations of z. The step is a share of the spread that the
/// integrand would have if each trial told as much as a trial can.
constexpr int kFarthest = 9;
constexpr double kStepOverSpread = 0.6;
constexpr double kFinestStep = 0.002;
constexpr double kCoarsestStep = 0.25;
/// A part whose ends are lower than the highest point by this, as logarithms, is left out.
constexpr double kNegligible = 35.0;

const std::vector<QuadratureNode>& nodes() {
    static const std::vector<QuadratureNode> all = gaussHermite(kNodes);
    return all;
}

/// h, 1 - h without cancellation, and h'.
struct LinkShares {
    double below = 0.0;
    double above = 0.0;
    double slope = 0.0;
};

LinkShares shareAt(Link link, double x) {
    if (link == Link::logit) {
        const double e = std::exp(-std::abs(x));
        const double small = e / (1.0 + e);
        const double large = 1.0 / (1.0 + e);
        return x >= 0.0 ? LinkShares{large, small, large * small} : LinkShares{small, large, large * small};
    }
    const double root = std::numbers::sqrt2;
    return {0.5 * std::erfc(-x / root), 0.5 * std::erfc(x / root),
            std::exp(-0.5 * x * x) * std::numbers::inv_sqrtpi / root};
}

} // namespace

MarginalLikelihood::MarginalLikelihood(const BinomialModel& model)
    : m_link(model.link)
    , m_guess(model.guess)
    , m_lapse(model.lapse)
    , m_predictors(static_cast<Eigen::Index>(model.rows.front().x.size())) {
    constexpr double kFarPredictor = 6.0;
    for (double predictor = -kFarPredictor; predictor <= kFarPredictor; predictor += 0.05)
        m_mostInformation = std::max(m_mostInformation, point({{}, 1.0, 0.0}, predictor).information);
    std::map<std::size_t, std::vector<Row>> people;
    for (const BinomialRow& row : model.rows)
        people[row.participant].push_back({Eigen::Map<const Eigen::VectorXd>(row.x.data(), m_predictors),
                                           static_cast<double>(row.correct),
                                           static_cast<double>(row.trials - row.correct)});
    for (auto& [id, rows] : people)
        m_people.push_back(std::move(rows));
}

MarginalLikelihood::Point MarginalLikelihood::point(const Row& row, double predictor) const {
    const LinkShares share = shareAt(m_link, predictor);
    const double range = 1.0 - m_guess - m_lapse;
    const double right = std::max(kSmallestOutcome, m_guess + range * share.below);
    const double wrong = std::max(kSmallestOutcome, m_lapse + range * share.above);
    const double slope = range * share.slope;
    Point point;
    // A count of 0 adds nothing, however small its share.
    if (row.correct > 0.0) {
        point.value += row.correct * std::log(right);
        point.slope += row.correct * (slope / right);
    }
    if (row.wrong > 0.0) {
        point.value += row.wrong * std::log(wrong);
        point.slope -= row.wrong * (slope / wrong);
    }
    point.information = (row.correct + row.wrong) * (slope / right) * (slope / wrong);
    return point;
}

void MarginalLikelihood::addPerson(const std::vector<Row>& rows, const Eigen::VectorXd& parameters,
                                   Value& sum) const {
    const double s = parameters(m_predictors);
    std::vector<double> predictors;
    for (const Row& row : rows)
        predictors.push_back(row.x.dot(parameters.head(m_predictors)));
    const auto height = [&](double z) {
        double value = -0.5 * z * z;
        for (std::size_t i = 0; i < rows.size(); ++i)
            value += point(rows[i], predictors[i] + s * z).value;
        return value;
    };
    // The highest point of the integrand, where the nodes are placed, by Fisher scoring.
    double centre = 0.0;
    double curvature = 1.0;
    double now = height(centre);
    for (int step = 0; step < 50; ++step) {
        double slope = -centre;
        curvature = 1.0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Point at = point(rows[i], predictors[i] + s * centre);
            slope += s * at.slope;
            curvature += s * s * at.information;
        }
        double move = slope / curvature;
        double next = height(centre + move);
        while (next < now && std::abs(move) > 1e-12) {
            move *= 0.5;
            next = height(centre + move);
        }
        if (next < now)
            break;
        centre += move;
        now = next;
        if (std::abs(move) < 1e-10)
            break;
    }
    double total = 0.0;
    double spreadSlope = 0.0;
    std::vector<double> slopes(rows.size(), 0.0);
    std::vector<double> here(rows.size());
    double top = now;
    const auto add = [&](double z, double factor, double logFactor) {
        double value = -0.5 * z * z;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Point at = point(rows[i], predictors[i] + s * z);
            value += at.value;
            here[i] = at.slope;
        }
        const double weight = factor * std::exp(value - top + logFactor);
        total += weight;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            slopes[i] += weight * here[i];
            spreadSlope += weight * here[i] * z;
        }
    };
    if (m_guess > 0.0 || m_lapse > 0.0) {
        double trials = 0.0;
        for (const Row& row : rows)
            trials += row.correct + row.wrong;
        // Most of the range adds nothing: only parts whose ends, or whose highest point, are high enough do.
        std::array<double, 2 * kFarthest + 1> heights{};
        for (int part = -kFarthest; part <= kFarthest; ++part)
            heights[static_cast<std::size_t>(part + kFarthest)] = height(part);
        top = std::max(top, *std::ranges::max_element(heights));
        const double spread = 1.0 / std::sqrt(1.0 + s * s * trials * m_mostInformation);
        const int steps = static_cast<int>(
            std::ceil(1.0 / std::clamp(kStepOverSpread * spread, kFinestStep, kCoarsestStep)));
        const double step = 1.0 / steps;
        for (int part = -kFarthest; part < kFarthest; ++part) {
            const std::size_t i = static_cast<std::size_t>(part + kFarthest);
            if (std::max(heights[i], heights[i + 1]) < top - kNegligible && std::floor(centre) != part)
                continue;
            for (int k = 0; k < steps; ++k)
                add(part + step * k, step, 0.0);
        }
    } else {
        const double width = std::numbers::sqrt2 / std::sqrt(curvature);
        for (const QuadratureNode& node : nodes())
            add(centre + width * node.at, width * node.weight, node.at * node.at);
    }
    sum.logLikelihood += top + std::log(total / std::sqrt(2.0 * std::numbers::pi));
    for (std::size_t i = 0; i < rows.size(); ++i)
        sum.gradient.head(m_predictors) += slopes[i] / total * rows[i].x;
    sum.gradient(m_predictors) += spreadSlope / total;
}

MarginalLikelihood::Value MarginalLikelihood::at(const Eigen::VectorXd& parameters) const {
    Value sum{0.0, Eigen::VectorXd::Zero(m_predictors + 1)};
    for (const std::vector<Row>& rows : m_people)
        addPerson(rows, parameters, sum);
    return sum;
}

Eigen::MatrixXd MarginalLikelihood::hessian(const Eigen::VectorXd& parameters) const {
    const Eigen::Index size = parameters.size();
    Eigen::MatrixXd matrix(size, size);
    for (Eigen::Index i = 0; i < size; ++i) {
        const double step = 1e-5 * std::max(1.0, std::abs(parameters(i)));
        Eigen::VectorXd moved = parameters;
        moved(i) = parameters(i) + step;
        const Eigen::VectorXd above = at(moved).gradient;
        moved(i) = parameters(i) - step;
        matrix.col(i) = (above - at(moved).gradient) / (2.0 * step);
    }
    return 0.5 * (matrix + matrix.transpose());
}

} // namespace teleta::study
