// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/arm/lwr_inverse.h"

#include <Eigen/Cholesky>

#include <algorithm>

namespace teleta::servo {

namespace {

/// J with its linear rows in units of the characteristic length and without the columns of held joints.
LwrJacobian scaled(const LwrJacobian& jacobian, const std::bitset<kLwrJoints>& held, double length_m) {
    LwrJacobian J = jacobian;
    J.topRows<3>() /= length_m;
    for (int joint = 0; joint < kLwrJoints; ++joint)
        if (held[static_cast<std::size_t>(joint)])
            J.col(joint).setZero();
    return J;
}

double manipulabilityOf(const Matrix6& JJt) {
    const Eigen::LLT<Matrix6> cholesky(JJt);
    if (cholesky.info() != Eigen::Success)
        return 0.0;
    return cholesky.matrixLLT().diagonal().prod();
}

double dampingOf(double manipulability, const InverseSettings& settings) {
    if (manipulability >= settings.fadeManipulability)
        return 0.0;
    return settings.highestDamping * (1.0 - manipulability / settings.fadeManipulability);
}

struct RateRange {
    LwrVector lowest;
    LwrVector highest;
};

RateRange rangeOf(const LwrVector& q_rad, const InverseSettings& settings) {
    const double perS = 1.0 / settings.brakingTime_s;
    return {((settings.limits.lowest_rad - q_rad) * perS).cwiseMin(0.0),
            ((settings.limits.highest_rad - q_rad) * perS).cwiseMax(0.0)};
}

} // namespace

JointMotion solveRates(const LwrVector& q_rad, const LwrJacobian& jacobian, const Twist& twist_Base,
                       const InverseSettings& settings) {
    JointMotion motion;
    if (!q_rad.array().isFinite().all() || !jacobian.array().isFinite().all() ||
        !twist_Base.array().isFinite().all())
        return motion;

    const RateRange range = rangeOf(q_rad, settings);
    for (int round = 0; round <= kLwrJoints; ++round) {
        const LwrJacobian J = scaled(jacobian, motion.atEnd, settings.length_m);
        Matrix6 JJt = J * J.transpose();
        const double manipulability = manipulabilityOf(JJt);
        motion.damping = dampingOf(manipulability, settings);
        if (round == 0)
            motion.manipulability = manipulability;
        // Rounding can make an exactly singular matrix slightly indefinite.
        JJt.diagonal().array() += std::max(motion.damping * motion.damping, 1e-14);

        const double fade = 1.0 - motion.damping / settings.highestDamping;
        LwrVector wish = (fade * settings.restGain_perS) * (settings.rest_rad - q_rad);
        LwrVector held = LwrVector::Zero();
        for (int joint = 0; joint < kLwrJoints; ++joint) {
            if (!motion.atEnd[static_cast<std::size_t>(joint)])
                continue;
            wish[joint] = 0.0;
            held[joint] = motion.rate_radPerS[joint];
        }
        Twist left = twist_Base - jacobian * held;
        left.head<3>() /= settings.length_m;
        motion.rate_radPerS = wish + J.transpose() * JJt.llt().solve(left - J * wish) + held;

        bool all = true;
        for (int joint = 0; joint < kLwrJoints; ++joint) {
            const auto bit = static_cast<std::size_t>(joint);
            double& rate = motion.rate_radPerS[joint];
            const double allowed = std::clamp(rate, range.lowest[joint], range.highest[joint]);
            if (motion.atEnd[bit] || allowed == rate)
                continue;
            rate = allowed;
            motion.atEnd.set(bit);
            all = false;
        }
        if (all)
            break;
    }

    const double load =
        motion.rate_radPerS.cwiseAbs().cwiseQuotient(settings.limits.fastest_radPerS).maxCoeff();
    if (load > 1.0) {
        motion.scale = 1.0 / load;
        motion.rate_radPerS *= motion.scale;
    }
    motion.achieved = jacobian * motion.rate_radPerS;
    return motion;
}

} // namespace teleta::servo
