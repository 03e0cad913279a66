// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/study_transfer.h"
#include "tests/backend/study/paper_tables.h"

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace teleta::study {

using Shares = std::vector<std::vector<double>>;

inline Shares sharesOf(const PaperTable& table) {
    Shares shares;
    for (const auto& row : table.counts) {
        shares.emplace_back();
        for (const int count : row)
            shares.back().push_back(count / 30.0);
    }
    return shares;
}

/// sum_ij p_ij / k log2(p_ij / mean_i p_ij)
inline double trueTransfer_bit(const Shares& shares) {
    const auto k = static_cast<double>(shares.size());
    double transfer_bit = 0.0;
    for (std::size_t j = 0; j < shares.size(); ++j) {
        double answered = 0.0;
        for (const auto& row : shares)
            answered += row[j] / k;
        for (const auto& row : shares)
            if (row[j] > 0.0)
                transfer_bit += row[j] / k * std::log2(row[j] / answered);
    }
    return transfer_bit;
}

struct Design {
    int people;
    int presentations;
    double alike; ///< concentration of the people's shares around the common ones; 0: all are the same
};

/// People whose rows are drawn from Dirichlet distributions around the common shares.
inline std::vector<ConfusionMatrix> simulate(const Design& design, const Shares& shares,
                                             std::mt19937_64& random) {
    std::vector<ConfusionMatrix> people(static_cast<std::size_t>(design.people),
                                        ConfusionMatrix(shares.size()));
    for (ConfusionMatrix& person : people)
        for (std::size_t i = 0; i < shares.size(); ++i) {
            std::vector<double> own = shares[i];
            if (design.alike > 0.0)
                for (double& share : own)
                    share = share > 0.0 ? std::gamma_distribution(design.alike * share)(random) : 0.0;
            std::discrete_distribution<std::size_t> answer(own.begin(), own.end());
            for (int trial = 0; trial < design.presentations; ++trial)
                person.add(i, answer(random));
        }
    return people;
}

/// The interval, or the bound, holds the truth.
inline bool holds(const TransferEstimate& transfer, double truth_bit) {
    constexpr double kRounding = 1e-12;
    if (transfer.interval)
        return transfer.interval->low <= truth_bit + kRounding &&
               truth_bit <= transfer.interval->high + kRounding;
    return transfer.atLeast_bit.value_or(0.0) <= truth_bit + kRounding &&
           truth_bit <= transfer.atMost_bit.value_or(100.0) + kRounding;
}

} // namespace teleta::study
