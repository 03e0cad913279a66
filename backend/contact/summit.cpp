// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/summit.h"

#include "backend/contact/pressed_patch.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace teleta::contact {

namespace {

/// Rows and columns, inclusive.
struct Box {
    int minRow = 0, maxRow = 0, minColumn = 0, maxColumn = 0;
};

bool isStrip(const core::ArrayLayout& layout) {
    return layout.rows == 1 || layout.columns == 1;
}

/// isActive(index): for taxels inside of the box.
template <typename IsActive>
std::optional<Summit> paraboloidSummit(std::span<const float> load_N, const core::ArrayLayout& layout,
                                       const Box& box, IsActive isActive, std::optional<double> noise_N) {
    constexpr int kFewestTaxels = 5;
    const auto index = [&](int row, int column) {
        return static_cast<std::size_t>(row * layout.columns + column);
    };
    int minRow = layout.rows, maxRow = -1, minColumn = layout.columns, maxColumn = -1, active = 0;
    float peak_N = 0.0F;
    for (int row = box.minRow; row <= box.maxRow; ++row)
        for (int column = box.minColumn; column <= box.maxColumn; ++column) {
            if (!isActive(index(row, column)))
                continue;
            minRow = std::min(minRow, row);
            maxRow = std::max(maxRow, row);
            minColumn = std::min(minColumn, column);
            maxColumn = std::max(maxColumn, column);
            peak_N = std::max(peak_N, load_N[index(row, column)]);
            ++active;
        }
    if (active < kFewestTaxels || minRow == maxRow || minColumn == maxColumn || !std::isfinite(peak_N))
        return std::nullopt;

    // In widths of a taxel from the middle of the active ones and in shares of the peak, so that all numbers
    // are of order one.
    const double middleRow = 0.5 * (minRow + maxRow);
    const double middleColumn = 0.5 * (minColumn + maxColumn);
    const double aspect = layout.aspect();
    const double reach = 0.5 * std::max(aspect * (maxRow - minRow), 1.0 * (maxColumn - minColumn));
    const auto visit = [&](const auto& take) {
        for (int row = minRow; row <= maxRow; ++row)
            for (int column = minColumn; column <= maxColumn; ++column) {
                if (!isActive(index(row, column)))
                    continue;
                const double x = (column - middleColumn) / reach;
                const double y = aspect * (row - middleRow) / reach;
                const double share =
                    static_cast<double>(load_N[index(row, column)]) / static_cast<double>(peak_N);
                take(share, Eigen::Vector4d(1.0, x, y, x * x + y * y));
            }
    };
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    visit([&](double share, const Eigen::Vector4d& terms) {
        normal += share * terms * terms.transpose();
        right += share * share * terms;
    });
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
    const double row = middleRow + reach * y / aspect;
    if (!(column >= minColumn - 0.5 && column <= maxColumn + 0.5 && row >= minRow - 0.5 &&
          row <= maxRow + 0.5))
        return std::nullopt;
    Summit summit{.x_m = layout.x_m(column),
                  .y_m = layout.y_m(row),
                  .peak_N = static_cast<double>(peak_N) * (fit[0] - fit[3] * (x * x + y * y)),
                  .xSe_m = {},
                  .ySe_m = {}};
    if (!noise_N)
        return summit;

    // Weights are no variances here, so the covariance is the one of a weighted sum.
    Eigen::Matrix4d spread = Eigen::Matrix4d::Zero();
    double weights = 0.0;
    double squares = 0.0;
    visit([&](double share, const Eigen::Vector4d& terms) {
        const double off = share - terms.dot(fit);
        spread += share * share * terms * terms.transpose();
        weights += share;
        squares += share * off * off;
    });
    const double noise = *noise_N / static_cast<double>(peak_N);
    const double variance =
        std::max(noise * noise, squares / weights * active / std::max(1, active - kFewestTaxels + 1));
    const Eigen::Matrix4d covariance = variance * solved.solve(solved.solve(spread).transpose());
    const double scale_m = reach * layout.pitchX_m / (-2.0 * fit[3]);
    const Eigen::Vector4d towardsX(0.0, 1.0, 0.0, 2.0 * x);
    const Eigen::Vector4d towardsY(0.0, 0.0, 1.0, 2.0 * y);
    summit.xSe_m = scale_m * std::sqrt(towardsX.dot(covariance * towardsX));
    summit.ySe_m = scale_m * std::sqrt(towardsY.dot(covariance * towardsY));
    return summit;
}

/// first, last: the active taxels of the contact. before, after: the taxel beyond takes part in the patch.
std::optional<Summit> stripSummit(std::span<const float> load_N, const core::ArrayLayout& layout, int first,
                                  int last, bool before, bool after, std::span<const std::uint8_t> dead,
                                  std::optional<double> noise_N) {
    const int end = static_cast<int>(layout.taxels()) - 1;
    const auto isDead = [&](int taxel) {
        return !dead.empty() && taxel >= 0 && taxel <= end && dead[static_cast<std::size_t>(taxel)] != 0;
    };
    if (isDead(first - 1) || isDead(last + 1))
        return std::nullopt;
    const int start = before ? first - 1 : first;
    const int stop = after ? last + 1 : last;
    const auto patch = pressedPatch(
        load_N.subspan(static_cast<std::size_t>(start), static_cast<std::size_t>(stop - start + 1)));
    if (!patch || start + patch->first == 0 || start + patch->last == end)
        return std::nullopt;
    const bool isRow = layout.rows == 1;
    const double centre = start + patch->centre;
    Summit summit{.x_m = layout.x_m(isRow ? centre : 0.0),
                  .y_m = layout.y_m(isRow ? 0.0 : centre),
                  .peak_N = patch->load_N,
                  .xSe_m = {},
                  .ySe_m = {}};
    if (noise_N)
        (isRow ? summit.xSe_m : summit.ySe_m) =
            (isRow ? layout.pitchX_m : layout.pitchY_m) * patch->centreSe(*noise_N);
    return summit;
}

} // namespace

std::optional<Summit> summitOf(std::span<const float> load_N, const core::ArrayLayout& layout,
                               double threshold_N, std::span<const std::uint8_t> dead,
                               std::optional<double> noise_N) {
    const auto threshold = static_cast<float>(threshold_N);
    const auto isActive = [&](std::size_t taxel) {
        return load_N[taxel] > 0.0F && load_N[taxel] >= threshold;
    };
    if (!isStrip(layout))
        return paraboloidSummit(load_N, layout, {0, layout.rows - 1, 0, layout.columns - 1}, isActive,
                                noise_N);
    const auto top = static_cast<std::size_t>(std::ranges::max_element(load_N) - load_N.begin());
    if (!isActive(top))
        return std::nullopt;
    std::size_t first = top;
    std::size_t last = top;
    while (first > 0 && isActive(first - 1))
        --first;
    while (last + 1 < load_N.size() && isActive(last + 1))
        ++last;
    return stripSummit(load_N, layout, static_cast<int>(first), static_cast<int>(last), first > 0,
                       last + 1 < load_N.size(), dead, noise_N);
}

std::optional<Summit> summitOf(std::span<const float> load_N, const core::ArrayLayout& layout,
                               const ContactSegmenter& segmenter, const Contact& contact,
                               std::span<const std::uint8_t> dead, std::optional<double> noise_N) {
    const std::span<const std::int32_t> labels = segmenter.labels();
    if (!isStrip(layout)) {
        const auto isActive = [&](std::size_t taxel) { return labels[taxel] == contact.region; };
        return paraboloidSummit(load_N, layout,
                                {contact.minRow, contact.maxRow, contact.minColumn, contact.maxColumn},
                                isActive, noise_N);
    }
    const bool isRow = layout.rows == 1;
    const int first = isRow ? contact.minColumn : contact.minRow;
    const int last = isRow ? contact.maxColumn : contact.maxRow;
    // The load of a taxel in another contact is not this one's.
    const auto isFree = [&](int taxel) {
        return taxel >= 0 && static_cast<std::size_t>(taxel) < labels.size() &&
               labels[static_cast<std::size_t>(taxel)] == 0;
    };
    return stripSummit(load_N, layout, first, last, isFree(first - 1), isFree(last + 1), dead, noise_N);
}

} // namespace teleta::contact
