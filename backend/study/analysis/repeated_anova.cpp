// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/repeated_anova.h"

#include "backend/core/words.h"

#include <Eigen/Core>

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <limits>

namespace teleta::study {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr core::Words<Refusal, 7> kRefusals{{"no data", "not finite", "bad shape", "fewer than two levels",
                                             "fewer than two complete participants", "no variance",
                                             "no error variance"}};

/// Helmert's contrasts: (levels-1) x levels, orthonormal rows that sum to zero.
MatrixXd contrasts(std::size_t levels) {
    const auto k = static_cast<Eigen::Index>(levels);
    MatrixXd rows = MatrixXd::Zero(k - 1, k);
    for (Eigen::Index i = 1; i < k; ++i) {
        const auto before = static_cast<double>(i);
        const double length = std::sqrt(before * (before + 1.0));
        rows.row(i - 1).head(i).setConstant(1.0 / length);
        rows(i - 1, i) = -before / length;
    }
    return rows;
}

MatrixXd average(std::size_t levels) {
    const auto k = static_cast<Eigen::Index>(levels);
    return MatrixXd::Constant(1, k, 1.0 / std::sqrt(static_cast<double>(k)));
}

MatrixXd kronecker(const MatrixXd& a, const MatrixXd& b) {
    MatrixXd product(a.rows() * b.rows(), a.cols() * b.cols());
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
        for (Eigen::Index j = 0; j < a.cols(); ++j)
            product.block(i * b.rows(), j * b.cols(), b.rows(), b.cols()) = a(i, j) * b;
    }
    return product;
}

bool hasMissing(const std::vector<double>& values) {
    return std::ranges::any_of(values, [](double v) { return std::isnan(v); });
}

/// Complete participants, less their mean, scaled by the largest remaining value.
struct Sample {
    MatrixXd values;
    double scale = 1.0;         ///< true value = centred value times scale
    double roundingError = 0.0; ///< bound of what rounding the given numbers alone may have made of a value
    std::vector<std::size_t> dropped;
};

tl::expected<Sample, Refusal> completeSample(const ParticipantCells& cells, std::size_t columns) {
    if (cells.empty())
        return tl::unexpected(Refusal::noData);
    Sample sample;
    std::vector<std::size_t> kept;
    double largest = 0.0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i].size() != columns)
            return tl::unexpected(Refusal::badShape);
        if (std::any_of(cells[i].begin(), cells[i].end(), [](double v) { return std::isinf(v); }))
            return tl::unexpected(Refusal::notFinite);
        if (hasMissing(cells[i])) {
            sample.dropped.push_back(i);
            continue;
        }
        kept.push_back(i);
        for (const double v : cells[i])
            largest = std::max(largest, std::abs(v));
    }
    if (kept.size() < 2)
        return tl::unexpected(Refusal::oneParticipant);

    const auto n = static_cast<Eigen::Index>(kept.size());
    sample.values.resize(n, static_cast<Eigen::Index>(columns));
    if (largest == 0.0) {
        sample.values.setZero();
        return sample;
    }
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < sample.values.cols(); ++j)
            sample.values(i, j) =
                cells[kept[static_cast<std::size_t>(i)]][static_cast<std::size_t>(j)] / largest;
    }
    sample.values.array() -= sample.values.mean();
    const double spread = sample.values.cwiseAbs().maxCoeff();
    sample.scale = largest;
    sample.roundingError = 16.0 * std::numeric_limits<double>::epsilon();
    if (spread > sample.roundingError) {
        sample.values /= spread;
        sample.scale *= spread;
        sample.roundingError /= spread;
    }
    return sample;
}

/// Effect of some contrasts, before all error sums of squares are known.
struct ContrastSums {
    double effect = 0.0;
    double error = 0.0;
    double epsilon = 1.0;
    double noise = 0.0; ///< a sum of squares up to this may be nothing but rounding
};

ContrastSums contrastSums(const Sample& sample, const MatrixXd& rows) {
    const MatrixXd z = sample.values * rows.transpose();
    const Eigen::RowVectorXd mean = z.colwise().mean();
    const MatrixXd centred = z.rowwise() - mean;
    ContrastSums sums;
    sums.effect = static_cast<double>(z.rows()) * mean.squaredNorm();
    sums.error = centred.squaredNorm();
    sums.noise = static_cast<double>(sample.values.size()) * sample.roundingError * sample.roundingError;
    if (sums.error > sums.noise && rows.rows() > 1) {
        const MatrixXd covariance = centred.transpose() * centred / sums.error;
        sums.epsilon = std::clamp(1.0 / (static_cast<double>(rows.rows()) * covariance.squaredNorm()),
                                  1.0 / static_cast<double>(rows.rows()), 1.0);
    }
    return sums;
}

double probability(double f, double df1, double df2) {
    return boost::math::cdf(boost::math::complement(boost::math::fisher_f(df1, df2), f));
}

AnovaRow effectOf(const ContrastSums& sums, double contrastCount, double participants, double scale,
                  double allErrors) {
    if (sums.error <= sums.noise)
        return tl::unexpected(sums.effect <= sums.noise ? Refusal::noVariance : Refusal::noErrorVariance);
    AnovaEffect row;
    row.df1 = contrastCount;
    row.df2 = contrastCount * (participants - 1.0);
    row.sumOfSquares = sums.effect * scale * scale;
    row.errorSumOfSquares = sums.error * scale * scale;
    // Equal means differ by rounding alone.
    row.f = sums.effect <= sums.noise ? 0.0 : (sums.effect / row.df1) / (sums.error / row.df2);
    row.p = probability(row.f, row.df1, row.df2);
    row.epsilonGg = sums.epsilon;
    row.pGg = probability(row.f, row.df1 * sums.epsilon, row.df2 * sums.epsilon);
    if (contrastCount == 1.0) {
        row.epsilonHf = 1.0;
        row.pHf = row.p;
    } else {
        const double sphericity = contrastCount * sums.epsilon;
        const double numerator = participants * sphericity - 2.0;
        const double denominator = contrastCount * (participants - 1.0 - sphericity);
        // Rounding would decide whether the quotient is infinite or 0/0.
        constexpr double kNothing = 1e-12;
        if (denominator > kNothing)
            row.epsilonHf = numerator / denominator;
        if (row.epsilonHf || numerator > kNothing) {
            const double capped = std::min(1.0, row.epsilonHf.value_or(1.0));
            row.pHf = probability(row.f, row.df1 * capped, row.df2 * capped);
        }
    }
    row.partialEta2 = sums.effect / (sums.effect + sums.error);
    row.generalizedEta2 = sums.effect / (sums.effect + allErrors);
    return row;
}

} // namespace

const char* toString(Refusal refusal) {
    return kRefusals.of(refusal);
}

std::vector<std::size_t> incompleteParticipants(const ParticipantCells& cells) {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (hasMissing(cells[i]))
            rows.push_back(i);
    }
    return rows;
}

tl::expected<TwoWayAnova, Refusal> twoWayAnova(const ParticipantCells& cells, std::size_t firstLevels,
                                               std::size_t secondLevels) {
    if (firstLevels < 2 || secondLevels < 2)
        return tl::unexpected(Refusal::tooFewLevels);
    tl::expected<Sample, Refusal> sample = completeSample(cells, firstLevels * secondLevels);
    if (!sample)
        return tl::unexpected(sample.error());
    const MatrixXd firstRows = kronecker(contrasts(firstLevels), average(secondLevels));
    const MatrixXd secondRows = kronecker(average(firstLevels), contrasts(secondLevels));
    const MatrixXd interactionRows = kronecker(contrasts(firstLevels), contrasts(secondLevels));
    const ContrastSums first = contrastSums(*sample, firstRows);
    const ContrastSums second = contrastSums(*sample, secondRows);
    const ContrastSums interaction = contrastSums(*sample, interactionRows);
    const double betweenParticipants =
        contrastSums(*sample, kronecker(average(firstLevels), average(secondLevels))).error;
    const double allErrors = betweenParticipants + first.error + second.error + interaction.error;

    const auto n = static_cast<double>(sample->values.rows());
    const auto row = [&](const ContrastSums& sums, const MatrixXd& rows) {
        return effectOf(sums, static_cast<double>(rows.rows()), n, sample->scale, allErrors);
    };
    return TwoWayAnova{row(first, firstRows), row(second, secondRows), row(interaction, interactionRows),
                       static_cast<std::size_t>(sample->values.rows()), std::move(sample->dropped)};
}

tl::expected<OneWayAnova, Refusal> oneWayAnova(const ParticipantCells& cells) {
    if (cells.empty())
        return tl::unexpected(Refusal::noData);
    const std::size_t levels = cells.front().size();
    if (levels < 2)
        return tl::unexpected(Refusal::tooFewLevels);
    tl::expected<Sample, Refusal> sample = completeSample(cells, levels);
    if (!sample)
        return tl::unexpected(sample.error());
    const MatrixXd rows = contrasts(levels);
    const ContrastSums sums = contrastSums(*sample, rows);
    const double betweenParticipants = contrastSums(*sample, average(levels)).error;
    return OneWayAnova{effectOf(sums, static_cast<double>(rows.rows()),
                                static_cast<double>(sample->values.rows()), sample->scale,
                                betweenParticipants + sums.error),
                       static_cast<std::size_t>(sample->values.rows()), std::move(sample->dropped)};
}

} // namespace teleta::study
