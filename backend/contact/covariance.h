// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/frame_moments.h"

#include <optional>
#include <span>

namespace teleta::contact {

/// A 2 x 2 covariance of taxel coordinates: (xx, xy, yy) divided by scale > 0, in taxels^2.
struct Covariance {
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    double scale = 0.0;
};

/// Covariance of the coordinates of the active taxels, with n - 1 in the denominator. The coordinates are
/// integers, so xx, xy and yy are exact, and so are a perfect line and a perfect symmetry. Needs two active
/// taxels. Thread: any (pure). Source: servoing paper, (B.4) with n = number of taxels in contact (erratum
/// 1).
[[nodiscard]] Covariance binarisedCovariance(const FrameMoments& moments);

/// Covariance of the coordinates of the active taxels, weighted with their loads f:
///   sum f (x - mean)(y - mean) / (F - sum f^2 / F),   F = sum f,
/// Equals binarisedCovariance() when all loads are equal. Needs two active taxels. Thread: any (pure).
[[nodiscard]] Covariance weightedCovariance(std::span<const float> loads, const FrameShape& shape,
                                            float threshold);

struct PrincipalAxis {
    double lambda1 = 0.0; ///< taxels^2
    double lambda2 = 0.0; ///< <= lambda1; 0 for a perfect line
    std::optional<double>
        angle_rad; ///< (-pi/2, pi/2]; empty when the eigenvalues differ by less than kIsotropy
};

/// A contact whose eigenvalues differ by less than this share of their sum has no axis.
constexpr double kIsotropy = 1e-9;

/// Direction of the first principal axis of a covariance with xx - yy = difference, in (-pi/2, pi/2]:
///   atan2(2 xy, difference) / 2
[[nodiscard]] double axisAngle_rad(double xy, double difference);

/// Eigenvalues and first principal axis in closed form:
///   lambda_1 = (xx + yy + hypot(xx - yy, 2 xy)) / 2,  lambda_2 = (xx yy - xy^2) / lambda_1,
///   angle = atan2(2 xy, xx - yy) / 2
[[nodiscard]] PrincipalAxis principalAxis(const Covariance& covariance);

} // namespace teleta::contact
