// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/model/binomial_model.h"

#include "backend/core/words.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <set>

namespace teleta::study {

namespace {

constexpr core::Words<ModelRefusal, 5> kModelRefusals{
    {"no data", "fewer than 5 participants", "separable", "not converged", "falls"}};

constexpr std::array<double, 3> kStartSpreads{0.2, 0.6, 1.5};
constexpr int kMostNewtonSteps = 200;
/// A direction is flat whose curvature is this part of the largest.
constexpr double kFlatCurvature = 1e-7;
/// A higher likelihood than that of s = 0 by no more than this is rounding.
constexpr double kNoGain = 1e-8;

struct Peak {
    Eigen::VectorXd parameters;
    double logLikelihood = 0.0;
    bool ranAway = false;
    bool converged = false;
};

/// Newton's method with a Hessian made negative definite and steps halved until they climb. spread false: s
/// stays 0. limit: a larger parameter has run away.
Peak climb(const MarginalLikelihood& likelihood, Eigen::VectorXd parameters, bool spread, double limit) {
    const Eigen::Index free = parameters.size() - (spread ? 0 : 1);
    Peak peak{std::move(parameters), 0.0, false, false};
    MarginalLikelihood::Value now = likelihood.at(peak.parameters);
    for (int step = 0; step < kMostNewtonSteps && !peak.converged; ++step) {
        const Eigen::MatrixXd hessian = likelihood.hessian(peak.parameters).topLeftCorner(free, free);
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(hessian);
        const Eigen::VectorXd sizes = solver.eigenvalues().cwiseAbs();
        const double least = kFlatCurvature * (1.0 + sizes.maxCoeff());
        // Without any curvature the likelihood rises for ever, or is at its end.
        peak.ranAway = sizes.minCoeff() < least;
        const Eigen::VectorXd curvature = sizes.cwiseMax(least);
        Eigen::VectorXd move = Eigen::VectorXd::Zero(peak.parameters.size());
        move.head(free) =
            solver.eigenvectors() *
            (solver.eigenvectors().transpose() * now.gradient.head(free)).cwiseQuotient(curvature);
        const double length = move.norm();
        if (length > 3.0)
            move *= 3.0 / length;
        MarginalLikelihood::Value next = likelihood.at(peak.parameters + move);
        for (int half = 0; half < 60 && !(next.logLikelihood >= now.logLikelihood); ++half) {
            move *= 0.5;
            next = likelihood.at(peak.parameters + move);
        }
        if (!(next.logLikelihood >= now.logLikelihood)) {
            peak.converged = length < 1e-5;
            break;
        }
        peak.parameters += move;
        now = std::move(next);
        if (peak.parameters.cwiseAbs().maxCoeff() > limit) {
            peak.ranAway = true;
            return peak;
        }
        peak.converged = move.norm() < 1e-10 * (1.0 + peak.parameters.norm()) || length < 1e-10;
    }
    peak.logLikelihood = now.logLikelihood;
    return peak;
}

} // namespace

const char* toString(ModelRefusal refusal) {
    return kModelRefusals.of(refusal);
}

double BinomialFit::standardError(std::size_t coefficient) const {
    const auto i = static_cast<Eigen::Index>(coefficient);
    return std::sqrt(covariance(i, i));
}

Interval BinomialFit::interval(std::size_t coefficient, double confidence) const {
    const double z = -boost::math::quantile(boost::math::normal(), (1.0 - confidence) / 2.0);
    const double half = z * standardError(coefficient);
    return {b[coefficient] - half, b[coefficient] + half};
}

tl::expected<BinomialFit, ModelRefusal> fitBinomial(const BinomialModel& model, const BinomialFit* near) {
    std::set<std::size_t> people;
    BinomialModel used = model;
    std::erase_if(used.rows, [](const BinomialRow& row) { return row.trials <= 0; });
    for (const BinomialRow& row : used.rows)
        people.insert(row.participant);
    if (used.rows.empty() || used.rows.front().x.empty())
        return tl::unexpected(ModelRefusal::noData);
    if (people.size() < kFewestModelParticipants)
        return tl::unexpected(ModelRefusal::tooFewParticipants);
    const MarginalLikelihood likelihood(used);
    const Eigen::Index predictors = likelihood.predictors();
    const auto start = [&](const std::vector<double>& b, double s) {
        Eigen::VectorXd parameters(predictors + 1);
        std::ranges::copy(b, parameters.begin());
        parameters(predictors) = s;
        return parameters;
    };
    const Peak plain =
        climb(likelihood, Eigen::VectorXd::Zero(predictors + 1), false, model.largestCoefficient);
    if (plain.ranAway)
        return tl::unexpected(ModelRefusal::separable);
    if (!plain.converged)
        return tl::unexpected(ModelRefusal::notConverged);
    Peak best = plain;
    std::vector<Eigen::VectorXd> starts;
    if (near != nullptr && near->s > 0.0) {
        starts.push_back(start(near->b, near->s));
    } else if (near == nullptr) {
        for (const double spread : kStartSpreads) {
            starts.push_back(plain.parameters);
            starts.back()(predictors) = spread;
        }
    }
    for (const Eigen::VectorXd& from : starts) {
        const Peak peak = climb(likelihood, from, true, model.largestCoefficient);
        if (peak.ranAway)
            return tl::unexpected(ModelRefusal::separable);
        if (peak.converged && peak.logLikelihood > best.logLikelihood + kNoGain)
            best = peak;
    }
    const bool hasSpread = best.parameters(predictors) != 0.0;
    const Eigen::Index free = predictors + (hasSpread ? 1 : 0);
    const Eigen::MatrixXd covariance =
        (-likelihood.hessian(best.parameters).topLeftCorner(free, free)).inverse();
    if (!(covariance.diagonal().array() > 0.0).all())
        return tl::unexpected(ModelRefusal::notConverged);
    BinomialFit fit;
    fit.b.assign(best.parameters.begin(), best.parameters.begin() + predictors);
    fit.covariance = covariance.topLeftCorner(predictors, predictors);
    fit.s = std::abs(best.parameters(predictors));
    fit.logLikelihood = best.logLikelihood;
    fit.participants = people.size();
    return fit;
}

RatioTest ratioTest(const BinomialFit& whole, const BinomialFit& part, std::size_t difference) {
    RatioTest test;
    test.chi2 = std::max(0.0, 2.0 * (whole.logLikelihood - part.logLikelihood));
    test.df = static_cast<double>(difference);
    test.p = boost::math::cdf(boost::math::complement(boost::math::chi_squared(test.df), test.chi2));
    return test;
}

} // namespace teleta::study
