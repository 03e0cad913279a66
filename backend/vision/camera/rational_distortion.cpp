// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/camera/rational_distortion.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace teleta::vision {

namespace {

/// Coefficients in order of rising power.
using Polynomial = std::vector<double>;

Polynomial product(const Polynomial& a, const Polynomial& b) {
    Polynomial result(a.size() + b.size() - 1, 0.0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j)
            result[i + j] += a[i] * b[j];
    }
    return result;
}

Polynomial sum(const Polynomial& a, const Polynomial& b, double factorOfB = 1.0) {
    Polynomial result(std::max(a.size(), b.size()), 0.0);
    for (std::size_t i = 0; i < a.size(); ++i)
        result[i] += a[i];
    for (std::size_t i = 0; i < b.size(); ++i)
        result[i] += factorOfB * b[i];
    return result;
}

/// The polynomial of r on 0..upTo in the Bernstein basis, where positive coefficients prove that it is
/// positive.
Polynomial bernstein(const Polynomial& a, double upTo) {
    const std::size_t n = a.size() - 1;
    Polynomial scaled(a);
    double power = 1.0;
    for (double& coefficient : scaled) {
        coefficient *= power;
        power *= upTo;
    }
    Polynomial result(n + 1, 0.0);
    for (std::size_t i = 0; i <= n; ++i) {
        double share = 1.0; // C(i, j) / C(n, j)
        result[i] = scaled[0];
        for (std::size_t j = 1; j <= i; ++j) {
            share *= static_cast<double>(i - j + 1) / static_cast<double>(n - j + 1);
            result[i] += share * scaled[j];
        }
    }
    return result;
}

constexpr int kDeepestDivision = 50;

/// Where the polynomial may first cease to be positive, as a share of its interval; 1 when it is positive
/// everywhere.
double positiveShare(Polynomial coefficients, int depth = 0) {
    const double least = *std::min_element(coefficients.begin(), coefficients.end());
    if (least > 0.0)
        return 1.0;
    if (coefficients.front() <= 0.0 || depth == kDeepestDivision)
        return 0.0;
    // de Casteljau: both halves of the interval.
    Polynomial left(coefficients.size());
    for (std::size_t level = 0; level < left.size(); ++level) {
        left[level] = coefficients.front();
        for (std::size_t i = 0; i + 1 < coefficients.size() - level; ++i)
            coefficients[i] = 0.5 * (coefficients[i] + coefficients[i + 1]);
    }
    const double share = positiveShare(left, depth + 1);
    return share < 1.0 ? 0.5 * share : 0.5 + 0.5 * positiveShare(std::move(coefficients), depth + 1);
}

} // namespace

double RationalDistortion::radialSlope(double r) const {
    const double s = r * r;
    const double n = numerator(s);
    const double d = denominator(s);
    const double nSlope = k1 + s * (2.0 * k2 + s * 3.0 * k3);
    const double dSlope = k4 + s * (2.0 * k5 + s * 3.0 * k6);
    return n / d + 2.0 * s * (nSlope * d - n * dSlope) / (d * d);
}

Eigen::Vector2d RationalDistortion::apply(const Eigen::Vector2d& point) const {
    const double x = point.x();
    const double y = point.y();
    const double s = x * x + y * y;
    const double q = numerator(s) / denominator(s);
    return {q * x + 2.0 * p1 * x * y + p2 * (s + 2.0 * x * x),
            q * y + p1 * (s + 2.0 * y * y) + 2.0 * p2 * x * y};
}

Eigen::Matrix2d RationalDistortion::slope(const Eigen::Vector2d& point) const {
    const double x = point.x();
    const double y = point.y();
    const double s = x * x + y * y;
    const double n = numerator(s);
    const double d = denominator(s);
    const double nSlope = k1 + s * (2.0 * k2 + s * 3.0 * k3);
    const double dSlope = k4 + s * (2.0 * k5 + s * 3.0 * k6);
    const double q = n / d;
    const double qSlope = 2.0 * (nSlope * d - n * dSlope) / (d * d);
    const double mixed = qSlope * x * y + 2.0 * (p1 * x + p2 * y);
    Eigen::Matrix2d result;
    result << q + qSlope * x * x + 2.0 * p1 * y + 6.0 * p2 * x, mixed, mixed,
        q + qSlope * y * y + 6.0 * p1 * y + 2.0 * p2 * x;
    return result;
}

Eigen::Matrix<double, 2, 8> RationalDistortion::byParameters(const Eigen::Vector2d& point) const {
    const double x = point.x();
    const double y = point.y();
    const double s = x * x + y * y;
    const double n = numerator(s);
    const double d = denominator(s);
    Eigen::Matrix<double, 2, 8> result;
    double power = 1.0;
    for (int i = 0; i < 3; ++i) {
        power *= s;
        result.col(i) = point * (power / d);
        result.col(3 + i) = point * (-n * power / (d * d));
    }
    result.col(6) << 2.0 * x * y, s + 2.0 * y * y;
    result.col(7) << s + 2.0 * x * x, 2.0 * x * y;
    return result;
}

bool RationalDistortion::isFinite() const {
    return std::isfinite(k1) && std::isfinite(k2) && std::isfinite(k3) && std::isfinite(k4) &&
           std::isfinite(k5) && std::isfinite(k6) && std::isfinite(p1) && std::isfinite(p2);
}

double monotoneRadius(const RationalDistortion& distortion, double upTo) {
    if (!distortion.isFinite() || !(upTo > 0.0))
        return 0.0;
    const auto& [k1, k2, k3, k4, k5, k6, p1, p2] = distortion;
    const Polynomial n{1.0, 0.0, k1, 0.0, k2, 0.0, k3};
    const Polynomial d{1.0, 0.0, k4, 0.0, k5, 0.0, k6};
    // r times the derivatives with respect to r.
    const Polynomial nSlope{0.0, 0.0, 2.0 * k1, 0.0, 4.0 * k2, 0.0, 6.0 * k3};
    const Polynomial dSlope{0.0, 0.0, 2.0 * k4, 0.0, 4.0 * k5, 0.0, 6.0 * k6};
    const Polynomial nd = product(n, d);
    // The derivative of the decentring part is symmetric with eigenvalues of at most 6 |p| r.
    const Polynomial asked = product({kLeastSlope, 6.0 * std::hypot(p1, p2)}, product(d, d));
    const Polynomial across = sum(nd, asked, -1.0);
    const Polynomial along = sum(sum(across, product(nSlope, d)), product(n, dSlope), -1.0);
    double share = 1.0;
    for (const Polynomial& condition : {d, across, along})
        share = std::min(share, positiveShare(bernstein(condition, upTo)));
    return share * upTo;
}

} // namespace teleta::vision
