// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_servo/pad_arm.h"

#include "backend/arm_model/tip_motion.h"
#include "backend/core/failure.h"
#include "backend/pipeline/touch/skin_kinematics.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::arm_servo {

using core::JointVector;

namespace {

struct PadArmText {
    Q_DECLARE_TR_FUNCTIONS(PadArm)
};

} // namespace

core::Expected<std::shared_ptr<const PadArm>>
PadArm::create(const std::shared_ptr<const arm_model::SerialChain>& chain, const core::ArmDescription& arm,
               const core::PadPlacement& pad) {
    const std::shared_ptr<const arm_model::ArmModel> model(chain, &chain->model());
    TELETA_TRY(auto toLink, arm_model::SerialChain::create(model, chain->baseLink(), pad.link));
    if (arm.joints() != chain->joints() || arm.fastest_radPerS.size() != chain->joints() ||
        toLink.joints() > chain->joints())
        return core::failed(core::ErrorKind::badInput,
                            PadArmText::tr("the arm has %1 joints, its description %2")
                                .arg(arm.joints())
                                .arg(chain->joints()));
    return std::shared_ptr<const PadArm>(new PadArm(std::move(toLink), arm, pad));
}

PadArm::PadArm(arm_model::SerialChain toLink, const core::ArmDescription& arm, const core::PadPlacement& pad)
    : m_toLink(std::move(toLink))
    , m_X_Link_Sensor(pipeline::X_Link_Sensor(pad))
    , m_lowest(arm.lowest_rad)
    , m_highest(arm.highest_rad)
    , m_fastest(arm.fastest_radPerS) {
}

JointVector PadArm::toLink(const JointVector& q_rad) const {
    JointVector first = JointVector::zeros(m_toLink.joints());
    std::copy_n(q_rad.begin(), first.size(), first.begin());
    return first;
}

Eigen::Isometry3d PadArm::X_Base_Sensor(const JointVector& q_rad) const {
    return m_toLink.X_Base_Tip(toLink(q_rad)) * m_X_Link_Sensor;
}

servo::SensorMotion PadArm::carryOut(const JointVector& q_rad, const servo::Twist& twist_Base) const {
    servo::SensorMotion motion;
    motion.rate = JointVector::zeros(joints());
    const JointVector first_rad = toLink(q_rad);
    const Eigen::Vector3d p_Link_Sensor = m_X_Link_Sensor.translation();
    const Eigen::Vector3d arm_m = m_toLink.X_Base_Tip(first_rad).linear() * p_Link_Sensor;
    const Eigen::Vector3d turn_radPerS = twist_Base.tail<3>();
    const Eigen::Vector3d ofLink_mPerS = twist_Base.head<3>() - turn_radPerS.cross(arm_m);
    const arm_model::TipRates rates = arm_model::tipRates(m_toLink, first_rad, {ofLink_mPerS, turn_radPerS});
    motion.singular = rates.singular;

    double share = 1.0;
    for (std::size_t i = 0; i < rates.rate.size(); ++i) {
        const double rate = rates.rate[i];
        motion.atEnd = motion.atEnd || (rate < 0.0 && q_rad[i] <= m_lowest[i] + kMargin_rad) ||
                       (rate > 0.0 && q_rad[i] >= m_highest[i] - kMargin_rad);
        if (std::abs(rate) > m_fastest[i])
            share = std::min(share, m_fastest[i] / std::abs(rate));
    }
    motion.slowed = share < 1.0;
    if (motion.atEnd)
        share = 0.0;
    for (std::size_t i = 0; i < rates.rate.size(); ++i)
        motion.rate[i] = share * rates.rate[i];
    motion.achieved =
        m_toLink.jacobian(first_rad, p_Link_Sensor) *
        Eigen::Map<const Eigen::VectorXd>(motion.rate.data(), static_cast<Eigen::Index>(rates.rate.size()));
    return motion;
}

} // namespace teleta::arm_servo
