// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/tactile_jacobian.h"

#include <cmath>
#include <numbers>

namespace teleta::servo {

MeasuredFeatures featureVector(const contact::TactileFeatures& features, double compliance_mPerN) {
    MeasuredFeatures measured;
    const auto take = [&](int row, const std::optional<double>& value) {
        measured.defined[static_cast<std::size_t>(row)] = value.has_value();
        measured.s[row] = value.value_or(0.0);
    };
    take(kX, features.copX_m);
    take(kY, features.copY_m);
    take(kZ, compliance_mPerN * features.force_N);
    take(kWx, features.cocY_m);
    take(kWy, features.cocX_m);
    take(kWz, features.alphaZ_rad);
    return measured;
}

Matrix6 inverseTactileJacobian(bool edge) {
    const double beta = edge ? 1.0 : 0.0;
    Matrix6 J = Matrix6::Identity();
    J(kWx, kY) = -beta;
    J(kWy, kX) = -beta;
    J(kWz, kWz) = beta;
    return J;
}

Matrix6 projectionMatrix(const Projection& projection) {
    Matrix6 P = Matrix6::Zero();
    P(kX, kX) = projection.x ? 1.0 : 0.0;
    P(kX, kWy) = projection.com ? 1.0 : 0.0;
    P(kY, kY) = projection.y ? 1.0 : 0.0;
    P(kZ, kZ) = projection.z ? 1.0 : 0.0;
    P(kWx, kWx) = projection.wx ? 1.0 : 0.0;
    P(kWy, kWy) = projection.wy ? 1.0 : 0.0;
    P(kWz, kWz) = projection.wz ? 1.0 : 0.0;
    return P;
}

double EdgeDirection::follow(double alpha_rad, double desired_rad) {
    constexpr double kPi = std::numbers::pi;
    const double near_rad = m_known ? m_alpha_rad : desired_rad;
    double branch_rad = near_rad + std::remainder(alpha_rad - near_rad, kPi);
    const double error_rad = desired_rad - branch_rad;
    if (std::abs(error_rad) > 0.5 * kPi + kMargin_rad)
        branch_rad = desired_rad - std::remainder(error_rad, kPi);
    m_alpha_rad = branch_rad;
    m_known = true;
    return branch_rad;
}

} // namespace teleta::servo
