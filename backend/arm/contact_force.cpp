// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm/contact_force.h"

#include "backend/arm/largest_input.h"

#include <Eigen/SVD>

#include <cmath>
#include <limits>

namespace teleta::arm {

tl::expected<ContactForce, ForceRefusal> solveContactForce(const AnyPointJacobian& jacobian,
                                                           const AnyJointVector& torque_Nm,
                                                           const ForceSettings& settings) {
    if (jacobian.cols() == 0 || jacobian.cols() != torque_Nm.size())
        return tl::unexpected(ForceRefusal::badSetting);
    // Not allFinite(), which subtracts infinities and raises "invalid".
    if (!jacobian.array().isFinite().all() || !torque_Nm.array().isFinite().all() ||
        !std::isfinite(settings.torqueNoise_Nm) || !std::isfinite(settings.leastLever_m))
        return tl::unexpected(ForceRefusal::notFinite);
    if (jacobian.cwiseAbs().maxCoeff() > kLargestInput || torque_Nm.cwiseAbs().maxCoeff() > kLargestInput ||
        std::abs(settings.torqueNoise_Nm) > kLargestInput || std::abs(settings.leastLever_m) > kLargestInput)
        return tl::unexpected(ForceRefusal::outOfRange);
    if (settings.leastLever_m < 1.0 / kLargestInput || settings.torqueNoise_Nm < 0.0)
        return tl::unexpected(ForceRefusal::badSetting);

    const Eigen::JacobiSVD<AnyPointJacobian> svd(jacobian, Eigen::ComputeFullU | Eigen::ComputeFullV);
    ContactForce contact;
    // Fewer than three joints leave directions without a lever.
    const Eigen::Index levers = svd.singularValues().size();
    contact.levers_m.head(levers) = svd.singularValues();
    contact.directions = svd.matrixU();
    Eigen::Vector3d variance_N2 = Eigen::Vector3d::Zero();
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d direction = contact.directions.col(i);
        // In units of the least lever nothing overflows or underflows for an arm of any size.
        const double lever = contact.levers_m[i] / settings.leastLever_m;
        const double damping2 = lever < 1.0 ? 0.25 * (1.0 - lever * lever) : 0.0;
        const double gain_perM = lever / (lever * lever + damping2) / settings.leastLever_m;
        if (i < levers)
            contact.force_N += direction * (gain_perM * svd.matrixV().col(i).dot(torque_Nm));
        if (lever < 1.0) {
            contact.hidden += direction * direction.transpose();
        } else {
            ++contact.observedDirections;
            variance_N2 += (gain_perM * settings.torqueNoise_Nm * direction).cwiseAbs2();
        }
    }
    contact.forceSd_N = variance_N2.cwiseSqrt();
    for (int axis = 0; axis < 3; ++axis)
        contact.observable[static_cast<std::size_t>(axis)] = contact.hidden.col(axis).norm() <= kHiddenShare;
    contact.conditionNumber = contact.levers_m[2] > 0.0 ? contact.levers_m[0] / contact.levers_m[2]
                                                        : std::numeric_limits<double>::infinity();
    contact.residual_Nm = (torque_Nm - jacobian.transpose() * contact.force_N).norm();
    return contact;
}

} // namespace teleta::arm
