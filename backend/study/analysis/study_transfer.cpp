// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/study_transfer.h"

#include "backend/study/analysis/information_transfer.h"

#include <QCoreApplication>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace teleta::study {

namespace {

struct TransferText {
    Q_DECLARE_TR_FUNCTIONS(TransferText)
};

constexpr std::size_t kFewestParticipants = 4;
constexpr double kFewestPerPattern = 20.0;
constexpr double kFewestPerCell = 4.0;
constexpr std::int64_t kFewestDifferent = 10;
constexpr double kTail = 0.05;
constexpr double kNormalOfTail = 1.6448536269514722; // its quantile

double xLog2x(double x) {
    return x > 0.0 ? x * std::log2(x) : 0.0;
}

/// Counts of answers, from which those of a participant can be taken.
class PooledAnswers {
public:
    explicit PooledAnswers(std::span<const ConfusionMatrix> people)
        : m_sum(people.front().patterns()) {
        for (const ConfusionMatrix& person : people)
            m_sum.add(person);
    }

    [[nodiscard]] const ConfusionMatrix& matrix() const { return m_sum; }

    /// Transfer without one of the participants; without trials: 0.
    [[nodiscard]] double without_bit(const ConfusionMatrix& person) const {
        const std::size_t rows = m_sum.patterns();
        const std::size_t columns = m_sum.columns();
        std::vector<double> inRow(rows);
        std::vector<double> inColumn(columns);
        double n = 0.0;
        double sum = 0.0;
        for (std::size_t i = 0; i < rows; ++i)
            for (std::size_t j = 0; j < columns; ++j) {
                const auto count = static_cast<double>(m_sum.count(i, j) - person.count(i, j));
                inRow[i] += count;
                inColumn[j] += count;
                n += count;
                sum += xLog2x(count);
            }
        for (const double total : inRow)
            sum -= xLog2x(total);
        for (const double total : inColumn)
            sum -= xLog2x(total);
        return n > 0.0 ? std::max(0.0, (sum + xLog2x(n)) / n) : 0.0;
    }

private:
    ConfusionMatrix m_sum;
};

/// Entropy of the patterns as they were presented: no transfer is higher.
double presentedEntropy_bit(const ConfusionMatrix& matrix) {
    const auto n = static_cast<double>(matrix.total());
    double sum = xLog2x(n);
    for (std::size_t i = 0; i < matrix.patterns(); ++i)
        sum -= xLog2x(static_cast<double>(matrix.rowTotal(i)));
    return std::max(0.0, sum / n);
}

/// Answers that differ from the most frequent answer to their pattern.
std::int64_t differentAnswers(const ConfusionMatrix& matrix) {
    std::int64_t different = 0;
    for (std::size_t i = 0; i < matrix.patterns(); ++i) {
        std::int64_t most = 0;
        for (std::size_t j = 0; j < matrix.columns(); ++j)
            most = std::max(most, matrix.count(i, j));
        different += matrix.rowTotal(i) - most;
    }
    return different;
}

/// Variance of the transfer if trials are independent: that of log2(p_ij / q_j) within each pattern.
double varianceOfTrials(const ConfusionMatrix& matrix) {
    const auto n = static_cast<double>(matrix.total());
    double variance = 0.0;
    for (std::size_t i = 0; i < matrix.patterns(); ++i) {
        const auto row = static_cast<double>(matrix.rowTotal(i));
        if (row < 2.0)
            continue;
        double mean = 0.0;
        double square = 0.0;
        for (std::size_t j = 0; j < matrix.columns(); ++j) {
            const auto count = static_cast<double>(matrix.count(i, j));
            if (count <= 0.0)
                continue;
            const double bits = std::log2(count * n / row / static_cast<double>(matrix.columnTotal(j)));
            mean += count / row * bits;
            square += count / row * bits * bits;
        }
        variance += std::max(0.0, square - mean * mean) * row / (row - 1.0) * row / n / n;
    }
    return variance;
}

struct Jackknife {
    double corrected_bit = 0.0;
    double variance = 0.0;
};

/// people: at least two, each with trials.
Jackknife jackknife(const PooledAnswers& pooled, std::span<const ConfusionMatrix> people,
                    double measured_bit) {
    const auto n = static_cast<double>(pooled.matrix().total());
    const auto m = static_cast<double>(people.size());
    std::vector<double> weights;
    std::vector<double> pseudo_bit;
    Jackknife result{m * measured_bit, 0.0};
    for (const ConfusionMatrix& person : people) {
        const double left_bit = pooled.without_bit(person);
        const double h = n / static_cast<double>(person.total());
        result.corrected_bit -= (1.0 - 1.0 / h) * left_bit;
        weights.push_back(h - 1.0);
        pseudo_bit.push_back(measured_bit + (h - 1.0) * (measured_bit - left_bit));
    }
    for (std::size_t j = 0; j < people.size(); ++j) {
        const double off_bit = pseudo_bit[j] - result.corrected_bit;
        result.variance += off_bit * off_bit / weights[j] / m;
    }
    return result;
}

/// The test of independence: G = 2 n ln 2 T against chi-squared.
struct IndependenceTest {
    double g = 0.0;
    double freedom = 0.0;
    [[nodiscard]] bool seesNothing() const {
        return freedom < 1.0 || g <= boost::math::quantile(boost::math::chi_squared(freedom), 1.0 - kTail);
    }
};

IndependenceTest independence(const ConfusionMatrix& matrix, double measured_bit) {
    double rows = 0.0;
    double columns = 0.0;
    for (std::size_t i = 0; i < matrix.patterns(); ++i)
        rows += matrix.rowTotal(i) > 0 ? 1.0 : 0.0;
    for (std::size_t j = 0; j < matrix.columns(); ++j)
        columns += matrix.columnTotal(j) > 0 ? 1.0 : 0.0;
    return {2.0 * static_cast<double>(matrix.total()) * std::numbers::ln2 * measured_bit,
            (rows - 1.0) * (columns - 1.0)};
}

/// Noncentrality with which G is as small as this in one of twenty cases. A G below its mean under guessing
/// tells no more than the mean.
double highestNoncentrality(const IndependenceTest& test) {
    const double g = std::max(test.g, test.freedom);
    const auto probability = [&](double noncentrality) {
        return boost::math::cdf(
            boost::math::non_central_chi_squared(std::max(1.0, test.freedom), noncentrality), g);
    };
    double low = 0.0;
    double high = 4.0 * (g + 10.0);
    constexpr int kHalvings = 60;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        (probability(middle) > kTail ? low : high) = middle;
    }
    return high;
}

/// How much more the participants' numbers of wrong answers vary than chance lets them; at least 1.
double designEffect(std::span<const ConfusionMatrix> people, double wrongShare) {
    if (people.size() < 2 || wrongShare <= 0.0 || wrongShare >= 1.0)
        return 1.0;
    double sum = 0.0;
    for (const ConfusionMatrix& person : people) {
        const auto n = static_cast<double>(person.total());
        const double off = n - static_cast<double>(person.correct()) - n * wrongShare;
        sum += off * off / (n * wrongShare * (1.0 - wrongShare));
    }
    return std::max(1.0, sum / (static_cast<double>(people.size()) - 1.0));
}

/// H(X) - h(e) - e log2(R - 1), e the highest share of wrong answers, R the patterns presented.
double fanoBound_bit(const ConfusionMatrix& matrix, std::span<const ConfusionMatrix> people) {
    const auto n = static_cast<double>(matrix.total());
    const double wrong = n - static_cast<double>(matrix.correct());
    const double effect = designEffect(people, wrong / n);
    double patterns = 0.0;
    for (std::size_t i = 0; i < matrix.patterns(); ++i)
        patterns += matrix.rowTotal(i) > 0 ? 1.0 : 0.0;
    const double right = (n - wrong) / effect;
    const double share = right > 0.0 ? boost::math::ibeta_inv(wrong / effect + 1.0, right, 1.0 - kTail) : 1.0;
    if (patterns < 2.0 || share >= (patterns - 1.0) / patterns)
        return 0.0;
    return std::max(0.0, presentedEntropy_bit(matrix) + xLog2x(share) + xLog2x(1.0 - share) -
                             share * std::log2(patterns - 1.0));
}

TransferDoubt doubtOf(const ConfusionMatrix& matrix, std::size_t people, double patterns,
                      const IndependenceTest& test) {
    if (people < kFewestParticipants)
        return TransferDoubt::fewParticipants;
    if (static_cast<double>(matrix.total()) <
        patterns * std::max(kFewestPerPattern, kFewestPerCell * patterns))
        return TransferDoubt::fewTrials;
    // Before fewDifferent: always the same answer says nothing about the patterns.
    if (test.seesNothing())
        return TransferDoubt::likeGuessing;
    return differentAnswers(matrix) < kFewestDifferent ? TransferDoubt::fewDifferent : TransferDoubt::none;
}

} // namespace

const char* toString(TransferDoubt doubt) {
    switch (doubt) {
    case TransferDoubt::none:
        break;
    case TransferDoubt::fewParticipants:
        return "few participants";
    case TransferDoubt::fewTrials:
        return "few trials";
    case TransferDoubt::fewDifferent:
        return "few different answers";
    case TransferDoubt::likeGuessing:
        return "like guessing";
    }
    return "";
}

std::string explain(TransferDoubt doubt) {
    switch (doubt) {
    case TransferDoubt::none:
        break;
    case TransferDoubt::fewParticipants:
        return TransferText::tr("Fewer than 4 participants do not show how much people differ, so there is "
                                "only a bound.")
            .toStdString();
    case TransferDoubt::fewTrials:
        return TransferText::tr("With fewer than 20 trials a pattern, or 4 k² for k patterns, there is only "
                                "a bound.")
            .toStdString();
    case TransferDoubt::fewDifferent:
        return TransferText::tr("Nearly all answers to each pattern are the same; fewer than 10 differ, so "
                                "there is only a bound.")
            .toStdString();
    case TransferDoubt::likeGuessing:
        return TransferText::tr("The answers do not differ from guesses (G test, p ≥ 0.05), so there is "
                                "only a bound.")
            .toStdString();
    }
    return {};
}

std::optional<TransferEstimate> studyTransfer(std::span<const ConfusionMatrix> participants,
                                              std::size_t alternatives) {
    std::vector<ConfusionMatrix> people;
    std::copy_if(participants.begin(), participants.end(), std::back_inserter(people),
                 [](const ConfusionMatrix& person) { return person.total() > 0; });
    if (people.empty())
        return std::nullopt;
    const PooledAnswers pooled(people);
    const ConfusionMatrix& matrix = pooled.matrix();
    const std::optional<InformationTransfer> transfer = informationTransfer(matrix, alternatives);
    TransferEstimate estimate;
    estimate.measured_bit = transfer->measured_bit;
    estimate.corrected_bit = transfer->corrected_bit;
    estimate.fewTrials = transfer->fewTrials;
    double variance = 0.0;
    if (people.size() > 1) {
        const Jackknife result = jackknife(pooled, people, estimate.measured_bit);
        estimate.corrected_bit = result.corrected_bit;
        variance = result.variance;
    }
    const IndependenceTest test = independence(matrix, estimate.measured_bit);
    const double highest_bit = presentedEntropy_bit(matrix);
    estimate.doubt =
        doubtOf(matrix, people.size(), static_cast<double>(std::max(matrix.patterns(), alternatives)), test);
    const auto within = [&](double bits) { return std::clamp(bits, 0.0, highest_bit); };
    if (estimate.doubt == TransferDoubt::none) {
        const boost::math::students_t t(static_cast<double>(people.size()) - 1.0);
        const double half_bit = boost::math::quantile(t, 1.0 - kTail / 2.0) * std::sqrt(variance);
        estimate.interval =
            Interval{within(estimate.corrected_bit - half_bit), within(estimate.corrected_bit + half_bit)};
    } else if (estimate.doubt == TransferDoubt::fewDifferent) {
        estimate.atLeast_bit = fanoBound_bit(matrix, people);
    } else {
        double most_bit =
            estimate.measured_bit + kNormalOfTail * std::sqrt(std::max(variance, varianceOfTrials(matrix)));
        if (test.seesNothing())
            most_bit = std::max(most_bit, highestNoncentrality(test) / 2.0 / std::numbers::ln2 /
                                              static_cast<double>(matrix.total()));
        estimate.atMost_bit = within(most_bit);
    }
    return estimate;
}

} // namespace teleta::study
