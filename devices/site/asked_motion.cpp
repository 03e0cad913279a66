// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/asked_motion.h"

#include "backend/arm_model/serial_chain.h"
#include "backend/arm_model/tip_motion.h"
#include "devices/site/site_topics.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace teleta::site_link {

namespace {

constexpr std::size_t kTwistValues = 6;
/// Farther is no target of a joint without a limit, so that no rate is infinite.
constexpr double kFarthest_rad = 1e9;

/// Of a joint without a limit, the angle as it is asked for, within kFarthest_rad.
double withinRange(const core::ArmDescription& arm, std::size_t joint, double angle_rad) {
    const double lowest = arm.lowest_rad[joint];
    const double highest = arm.highest_rad[joint];
    const double near = std::clamp(angle_rad, -kFarthest_rad, kFarthest_rad);
    return lowest <= highest ? std::clamp(near, lowest, highest) : near;
}

bool isKnown(const ArmReading& reading, const SiteArm& arm, std::int64_t now_ns) {
    return reading.angle_rad.size() == arm.source->description().joints() &&
           now_ns - reading.time_ns <= arm.oldestAngles_ns &&
           std::ranges::all_of(reading.angle_rad, [](double angle) { return std::isfinite(angle); });
}

core::JointVector ratesTo(const core::JointVector& target_rad, const core::ArmDescription& arm,
                          const core::JointVector& angle_rad) {
    core::JointVector rates = core::JointVector::zeros(target_rad.size());
    double slower = 1.0;
    for (std::size_t i = 0; i < rates.size(); ++i) {
        const double fastest = arm.fastest_radPerS[i];
        if (!(fastest > 0.0))
            continue;
        rates[i] = (withinRange(arm, i, target_rad[i]) - angle_rad[i]) / AskedMotion::kApproach_s;
        if (std::abs(rates[i]) > fastest)
            slower = std::min(slower, fastest / std::abs(rates[i]));
    }
    for (double& rate : rates)
        rate *= slower;
    return rates;
}

} // namespace

AskedMotion::AskedMotion(std::uint8_t kind, bool isOfTip, std::span<const double> values)
    : m_kind(kind)
    , m_isOfTip(isOfTip)
    , m_values(core::JointVector::of(values).value_or(core::JointVector())) {
}

std::optional<AskedMotion> AskedMotion::of(std::uint8_t kind, const std::string& frame,
                                           std::span<const double> values, const SiteArm& arm) {
    const bool isOfJoints = values.size() == arm.source->description().joints();
    switch (kind) {
    case kRatesCommand:
        if (isOfJoints)
            return AskedMotion(kind, false, values);
        break;
    case kPositionsCommand:
        if (isOfJoints && arm.angles)
            return AskedMotion(kind, false, values);
        break;
    case kTwistCommand:
        if (values.size() == kTwistValues && arm.angles && arm.chain &&
            (frame.empty() || frame == arm.chain->baseLink() || frame == arm.chain->tipLink()))
            return AskedMotion(kind, frame == arm.chain->tipLink(), values);
        break;
    default:
        break;
    }
    return std::nullopt;
}

bool AskedMotion::isLed(const SiteArm& arm, std::int64_t now_ns) const {
    return m_kind == kRatesCommand || isKnown(arm.angles(), arm, now_ns);
}

core::JointVector AskedMotion::rates(const SiteArm& arm, std::int64_t now_ns) const {
    if (m_kind == kRatesCommand)
        return m_values;
    const core::ArmDescription& description = arm.source->description();
    const ArmReading reading = arm.angles();
    if (!isKnown(reading, arm, now_ns))
        return core::JointVector::zeros(description.joints());
    const core::JointVector& angle_rad = reading.angle_rad;
    if (m_kind == kPositionsCommand)
        return ratesTo(m_values, description, angle_rad);
    const Eigen::Map<const Eigen::Vector<double, kTwistValues>> values(m_values.data());
    arm_model::TipTwist twist{values.head<3>(), values.tail<3>()};
    if (m_isOfTip) {
        const Eigen::Matrix3d R_Base_Tip = arm.chain->X_Base_Tip(angle_rad).linear();
        twist = {R_Base_Tip * twist.velocity_mPerS, R_Base_Tip * twist.turn_radPerS};
    }
    return arm_model::tipRates(*arm.chain, angle_rad, twist).rate;
}

} // namespace teleta::site_link
