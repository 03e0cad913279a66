// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_model/tip_motion.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace teleta::arm_model {

TipRates tipRates(const SerialChain& chain, const core::JointVector& q, const TipTwist& twist) {
    TipRates result;
    result.rate = core::JointVector::zeros(chain.joints());
    Eigen::Vector<double, 6> wanted;
    wanted << twist.velocity_mPerS, kTurnLength_m * twist.turn_radPerS;
    const bool finite = std::ranges::all_of(q, [](double value) { return std::isfinite(value); });
    if (q.size() != chain.joints() || !finite || !wanted.allFinite()) {
        result.followed = 0.0;
        return result;
    }
    if (wanted.isZero(0.0))
        return result;

    // Of size 1, so that no square over- or underflows.
    const double size = wanted.cwiseAbs().maxCoeff();
    wanted /= size;
    ChainJacobian jacobian = chain.jacobian(q);
    jacobian.bottomRows<3>() *= kTurnLength_m;
    // J J^T = U S^2 U^T; the damped inverse needs no V.
    const Eigen::Matrix<double, 6, 6> squared = jacobian * jacobian.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(squared);
    // Of fewer than six joints so many directions are moved by none in any pose; they come first.
    const Eigen::Index neverMoved = 6 - std::min<Eigen::Index>(6, jacobian.cols());
    Eigen::Vector<double, 6> weighted = Eigen::Vector<double, 6>::Zero();
    Eigen::Vector<double, 6> done = Eigen::Vector<double, 6>::Zero();
    for (Eigen::Index i = 0; i < 6; ++i) {
        const Eigen::Vector<double, 6> direction = solver.eigenvectors().col(i);
        const double lever2_m2 = std::max(0.0, solver.eigenvalues()[i]);
        const double along = direction.dot(wanted);
        double damping_m2 = 0.0;
        if (constexpr double kLeast_m2 = kLeastLever_m * kLeastLever_m; lever2_m2 < kLeast_m2) {
            damping_m2 = 0.25 * (kLeast_m2 - lever2_m2);
            result.singular = result.singular || (i >= neverMoved && std::abs(along) > 1e-3 * wanted.norm());
        }
        weighted += along / (lever2_m2 + damping_m2) * direction;
        done += along * lever2_m2 / (lever2_m2 + damping_m2) * direction;
    }
    Eigen::Map<Eigen::VectorXd> rates(result.rate.data(), static_cast<Eigen::Index>(chain.joints()));
    rates.noalias() = jacobian.transpose() * weighted;
    rates *= size;
    result.followed = std::clamp(done.norm() / wanted.norm(), 0.0, 1.0);
    return result;
}

} // namespace teleta::arm_model
