// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/summit.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace teleta::contact {

std::optional<Summit> summitOf(std::span<const float> load_N, const core::ArrayLayout& layout,
                               float threshold_N) {
    constexpr int kFewestTaxels = 5;
    int minRow = layout.rows, maxRow = -1, minColumn = layout.columns, maxColumn = -1, active = 0;
    float peak_N = 0.0F;
    for (int row = 0; row < layout.rows; ++row)
        for (int column = 0; column < layout.columns; ++column) {
            const float load = load_N[static_cast<std::size_t>(row * layout.columns + column)];
            if (!(load >= threshold_N))
                continue;
            minRow = std::min(minRow, row);
            maxRow = std::max(maxRow, row);
            minColumn = std::min(minColumn, column);
            maxColumn = std::max(maxColumn, column);
            peak_N = std::max(peak_N, load);
            ++active;
        }
    if (active < kFewestTaxels || minRow == maxRow || minColumn == maxColumn || !std::isfinite(peak_N))
        return std::nullopt;

    // In taxels from the middle of the active ones and in shares of the peak, so that all numbers are of
    // order one.
    const double middleRow = 0.5 * (minRow + maxRow);
    const double middleColumn = 0.5 * (minColumn + maxColumn);
    const double reach = 0.5 * std::max(maxRow - minRow, maxColumn - minColumn);
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (int row = minRow; row <= maxRow; ++row)
        for (int column = minColumn; column <= maxColumn; ++column) {
            const float load = load_N[static_cast<std::size_t>(row * layout.columns + column)];
            if (!(load >= threshold_N))
                continue;
            const double x = (column - middleColumn) / reach;
            const double y = (row - middleRow) / reach;
            const double share = static_cast<double>(load) / static_cast<double>(peak_N);
            const Eigen::Vector4d terms(1.0, x, y, x * x + y * y);
            normal += share * terms * terms.transpose();
            right += share * share * terms;
        }
    const Eigen::LDLT<Eigen::Matrix4d> solved(normal);
    constexpr double kDegenerate = 1e-9;
    if (solved.info() != Eigen::Success ||
        !(solved.vectorD().minCoeff() > kDegenerate * solved.vectorD().maxCoeff()))
        return std::nullopt;
    const Eigen::Vector4d fit = solved.solve(right);
    // A plateau has no summit.
    constexpr double kFlat = 1e-6;
    if (!(fit[3] < -kFlat))
        return std::nullopt;
    const double x = -fit[1] / (2.0 * fit[3]);
    const double y = -fit[2] / (2.0 * fit[3]);
    const double column = middleColumn + reach * x;
    const double row = middleRow + reach * y;
    if (!(column >= minColumn - 0.5 && column <= maxColumn + 0.5 && row >= minRow - 0.5 &&
          row <= maxRow + 0.5))
        return std::nullopt;
    return Summit{layout.x_m(column), layout.y_m(row),
                  static_cast<double>(peak_N) * (fit[0] - fit[3] * (x * x + y * y))};
}

} // namespace teleta::contact
