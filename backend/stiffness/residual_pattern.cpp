// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/residual_pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace teleta::stiffness {

namespace {

constexpr double kInflated_se = 3.7; ///< 99.99 %, one-sided

/// 99.99 % quantile of chi-square over its degrees of freedom (Wilson and Hilferty).
double highChiSquare(double degreesOfFreedom) {
    const double v = 2.0 / (9.0 * degreesOfFreedom);
    const double root = 1.0 - v + kInflated_se * std::sqrt(v);
    return root * root * root;
}

double ofBlocks(std::span<const double> residuals, int parameters, std::size_t blocks, double variance) {
    const std::size_t length = residuals.size() / blocks;
    const double degreesOfFreedom = static_cast<double>(blocks) - parameters;
    if (length < 2 || degreesOfFreedom < 2.0)
        return 1.0;
    double squares = 0.0;
    for (std::size_t block = 0; block < blocks; ++block) {
        double sum = 0.0;
        for (const double residual : residuals.subspan(block * length, length))
            sum += residual;
        squares += sum * sum / static_cast<double>(length);
    }
    const double ratio = squares / degreesOfFreedom / variance;
    return ratio > highChiSquare(degreesOfFreedom) ? ratio : 1.0;
}

} // namespace

double varianceInflation(std::span<const double> residuals, int parameters) {
    constexpr std::size_t kLeast = 16;
    constexpr double kHighestCorrelation = 0.999;
    const std::size_t n = residuals.size();
    if (n < kLeast)
        return 1.0;
    double largest = 0.0;
    for (const double residual : residuals)
        largest = std::max(largest, std::abs(residual));
    if (!std::isnormal(largest))
        return 1.0;
    std::vector<double> scaled(n);
    std::transform(residuals.begin(), residuals.end(), scaled.begin(),
                   [largest](double residual) { return residual / largest; });
    double squares = 0.0;
    double neighbours = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        squares += scaled[i] * scaled[i];
        neighbours += i > 0 ? scaled[i] * scaled[i - 1] : 0.0;
    }
    const auto count = static_cast<double>(n);
    double inflation = 1.0;
    const double correlation = neighbours / squares;
    if (correlation > kInflated_se / std::sqrt(count)) {
        const double unbiased =
            std::min(correlation + (1.0 + 4.0 * correlation) / count, kHighestCorrelation);
        inflation = (1.0 + unbiased) / (1.0 - unbiased);
    }
    const double variance = squares / (count - parameters);
    for (const std::size_t blocks : {8U, 16U, 32U})
        inflation = std::max(inflation, ofBlocks(scaled, parameters, blocks, variance));
    return inflation;
}

std::optional<Bend> fitBend(std::span<const double> x, std::span<const double> y,
                            std::span<double> residuals) {
    constexpr std::size_t kLeast = 8;
    const std::size_t n = x.size();
    if (n < kLeast || y.size() != n)
        return std::nullopt;
    const auto [lowX, highX] = std::minmax_element(x.begin(), x.end());
    const auto [lowY, highY] = std::minmax_element(y.begin(), y.end());
    const double middleX = *lowX + 0.5 * (*highX - *lowX);
    const double halfX = 0.5 * (*highX - *lowX);
    const double scaleY = *highY - *lowY;
    if (!std::isnormal(halfX) || !std::isnormal(scaleY))
        return std::nullopt;
    // Orthogonal polynomials of u, x scaled to -1 .. 1.
    const auto u = [&](std::size_t i) { return (x[i] - middleX) / halfX; };
    const auto v = [&](std::size_t i) { return (y[i] - *lowY) / scaleY; };
    const auto count = static_cast<double>(n);
    double meanU = 0.0;
    double meanV = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        meanU += u(i) / count;
        meanV += v(i) / count;
    }
    double squares = 0.0;
    double cubes = 0.0;
    double products = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        const double d = u(i) - meanU;
        squares += d * d;
        cubes += d * d * d;
        products += d * (v(i) - meanV);
    }
    if (squares <= count * std::numeric_limits<double>::epsilon())
        return std::nullopt;
    const double slope = products / squares;
    const auto quadratic = [&](std::size_t i) {
        const double d = u(i) - meanU;
        return d * d - cubes / squares * d - squares / count;
    };
    double quadraticSquares = 0.0;
    double quadraticProducts = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        const double q = quadratic(i);
        quadraticSquares += q * q;
        quadraticProducts += q * (v(i) - meanV);
    }
    if (quadraticSquares <= count * std::numeric_limits<double>::epsilon())
        return std::nullopt;
    const double bend = quadraticProducts / quadraticSquares;
    double unexplained = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        const double residual = v(i) - meanV - slope * (u(i) - meanU) - bend * quadratic(i);
        unexplained += residual * residual;
        if (!residuals.empty())
            residuals[i] = residual * scaleY;
    }
    const double sd = std::sqrt(unexplained / (count - 3.0));
    // y'(u) = slope + bend (2 (u - meanU) - cubes / squares); its mean over -1 .. 1.
    const double mean = slope - bend * (2.0 * meanU + cubes / squares);
    if (!std::isnormal(mean))
        return std::nullopt;
    Bend result;
    result.change = 4.0 * bend / mean;
    result.se = 4.0 / std::abs(mean) * sd / std::sqrt(quadraticSquares);
    result.firstSlope = (mean - 2.0 * bend) * scaleY / halfX;
    result.lastSlope = (mean + 2.0 * bend) * scaleY / halfX;
    result.residualSd = sd * scaleY;
    if (!std::isfinite(result.change) || !std::isfinite(result.se))
        return std::nullopt;
    return result;
}

std::optional<double> readingStep(std::span<const double> values) {
    constexpr double kRounding = 0.01;
    std::vector<double> different(values.begin(), values.end());
    std::ranges::sort(different);
    different.erase(std::unique(different.begin(), different.end()), different.end());
    if (different.size() < 2 || 2 * different.size() > values.size())
        return std::nullopt;
    // Steps that were computed, such as 1e-3 round(t / 1e-3), differ in their last digits.
    const double rounding = 64.0 * std::numeric_limits<double>::epsilon() *
                            std::max(std::abs(different.front()), std::abs(different.back()));
    double step = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < different.size(); ++i)
        if (different[i] - different[i - 1] > rounding)
            step = std::min(step, different[i] - different[i - 1]);
    if (!std::isfinite(step))
        return std::nullopt;
    for (std::size_t i = 1; i < different.size(); ++i) {
        const double steps = (different[i] - different[i - 1]) / step;
        if (steps < 1e9 && std::abs(steps - std::round(steps)) > kRounding &&
            different[i] - different[i - 1] > rounding)
            return std::nullopt;
    }
    return step;
}

} // namespace teleta::stiffness
