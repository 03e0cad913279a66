// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <Eigen/Core>

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::equilibration {

/// What signals may be calibrated to: names of columns.
inline constexpr std::array<std::string_view, 4> kLoadColumns{"force_n", "shear_x_n", "shear_y_n",
                                                              "moment_nm"};

/// Loads that follow from signals of a sensor:  load = M (signal - rest).
struct LoadCalibration {
    std::vector<std::string> loads;    ///< of kLoadColumns
    std::vector<std::string> channels; ///< of the signals: names of columns
    Eigen::MatrixXd gain{};  ///< M: a row a load, a column a signal; N or N m per unit of the signal
    Eigen::MatrixXd error{}; ///< standard errors of M
    Eigen::VectorXd rest{};  ///< signals without load
    Eigen::VectorXd least{}, greatest{}; ///< of each signal in the presses
    Eigen::VectorXd scatter{};           ///< standard deviation of each load about the fit
    double condition = 1.0;              ///< of the presses, signals brought to the same size; of a file 1

    struct Loads {
        Eigen::VectorXd loads;
        /// Standard errors of these loads, at most:  sqrt(scatter^2 + (sum |error (signal - rest)|)^2), as if
        /// the errors of all gains went together. The rest counts as exact. Of noise as in the presses,
        /// within their range.
        Eigen::VectorXd errors;
        /// A signal lies outside of what the presses had. Loads that are not defined lie nowhere.
        bool extrapolated = false;
    };
    /// values: one number a channel. Thread: any (pure).
    [[nodiscard]] Loads at(const Eigen::VectorXd& values) const;
};

/// Presses with known loads, one row each.
struct KnownPresses {
    std::vector<std::string> loads;
    std::vector<std::string> channels; ///< names of the signals
    Eigen::MatrixXd load;              ///< a column a load, N or N m
    Eigen::MatrixXd signal;            ///< a column a signal
};

/// Presses that are needed beyond the number of signals.
inline constexpr int kSparePresses = 3;
/// Largest ratio of singular values at which presses tell signals apart.
inline constexpr double kMostCondition = 1000.0;

/// Finds the matrix by least squares over the rows under load. The rest is the mean of the rows in which all
/// loads are 0; without one it is 0, and the fit goes through the origin. Standard errors: s
/// sqrt(diag((X'X)^-1)) with s^2 = RSS / (n - k), n: rows under load, k: signals; for noise that is
/// independent and equal in all presses. Error: refused: fewer presses under load than signals +
/// kSparePresses; a load that is the same in all presses; a signal that never leaves its rest; signals that
/// the presses do not tell apart. Thread: any (pure).
[[nodiscard]] core::Expected<LoadCalibration> findLoadCalibration(const KnownPresses& presses);

} // namespace teleta::equilibration
