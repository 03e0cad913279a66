// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/covariance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::contact {

namespace {

/// a d - b c with a single rounding of the result (Kahan), so that it is 0 for a perfect line.
double differenceOfProducts(double a, double d, double b, double c) {
    const double bc = b * c;
    const double rest = std::fma(-b, c, bc);
    return std::fma(a, d, -bc) + rest;
}

} // namespace

Covariance binarisedCovariance(const FrameMoments& moments) {
    const std::int64_t n = moments.active;
    const std::int64_t xx = n * moments.xx - moments.x * moments.x;
    const std::int64_t xy = n * moments.xy - moments.x * moments.y;
    const std::int64_t yy = n * moments.yy - moments.y * moments.y;
    const auto count = static_cast<double>(n);
    return {static_cast<double>(xx), static_cast<double>(xy), static_cast<double>(yy),
            1.0 / (count * (count - 1.0))};
}

// Coordinates are relative to the taxel with the largest load, and the denominator is summed without it: a
// taxel that outweighs all others then causes no cancellation.
Covariance weightedCovariance(std::span<const float> loads, const FrameShape& shape, float threshold) {
    const auto peak = static_cast<int>(std::max_element(loads.begin(), loads.end()) - loads.begin());
    const int peakRow = peak / shape.stride;
    const int peakColumn = peak % shape.stride;
    const auto peakWeight = static_cast<double>(loads[static_cast<std::size_t>(peak)]);

    double w = 0.0, ww = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
    for (int row = 0; row < shape.rows; ++row) {
        for (int column = 0; column < shape.columns; ++column) {
            const int index = row * shape.stride + column;
            const float load = loads[static_cast<std::size_t>(index)];
            if (load < threshold || index == peak)
                continue;
            const double weight = static_cast<double>(load) / peakWeight;
            const double dx = column - peakColumn;
            const double dy = row - peakRow;
            w += weight;
            ww += weight * weight;
            x += weight * dx;
            y += weight * dy;
            xx += weight * dx * dx;
            xy += weight * dx * dy;
            yy += weight * dy * dy;
        }
    }
    const double total = 1.0 + w;
    // Equals total^2 - sum w^2 over all taxels; each term is >= 0.
    const double freedom = 2.0 * w + std::max(0.0, w * w - ww);
    return {xx - x * x / total, xy - x * y / total, yy - y * y / total, total / freedom};
}

double axisAngle_rad(double xy, double difference) {
    // Adding 0 turns -0 into 0, so that the angle is pi and not -pi; the smallest negative angles round to
    // -pi, too.
    const double angle_rad = 0.5 * std::atan2(2.0 * xy + 0.0, difference);
    constexpr double kQuarterTurn_rad = 0.5 * std::numbers::pi;
    return angle_rad > -kQuarterTurn_rad ? angle_rad : kQuarterTurn_rad;
}

PrincipalAxis principalAxis(const Covariance& covariance) {
    const auto& [xx, xy, yy, scale] = covariance;
    const double trace = xx + yy;
    const double difference = xx - yy;
    const double root = std::sqrt(difference * difference + 4.0 * xy * xy);
    const double larger = 0.5 * (trace + root);
    // Not (trace - root) / 2, which cancels for a slender blob.
    const double smaller = std::max(0.0, differenceOfProducts(xx, yy, xy, xy)) / larger;

    PrincipalAxis axis{.lambda1 = larger * scale, .lambda2 = smaller * scale, .angle_rad = {}};
    if (root > kIsotropy * trace)
        axis.angle_rad = axisAngle_rad(xy, difference);
    return axis;
}

} // namespace teleta::contact
