// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/joint_vector.h"
#include "devices/site/site_arm.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace teleta::site_link {

/// What a console asks of an arm until its next command, and the joint rates that do it. Kinds are those of
/// ArmCommand in the protocol:
///   kRatesCommand      a rate of each joint, rad/s (prismatic: m/s)
///   kTwistCommand      velocity x, y, z (m/s) and angular velocity x, y, z (rad/s) of the tip, in the frame
///                      frame_id: the base link of the arm's chain, or its tip link; empty: the base link
///   kPositionsCommand  an angle of each joint, rad (prismatic: m)
/// Thread: any (const).
class AskedMotion {
public:
    /// The time in which a joint would come to its target at its first rate.
    static constexpr double kApproach_s = 0.25;

    /// Empty: the arm cannot do it. It is of another kind or length, the frame is neither end of the chain,
    /// the arm's chain is not known (a twist), or nobody tells its angles (all but rates). values: finite.
    [[nodiscard]] static std::optional<AskedMotion> of(std::uint8_t kind, const std::string& frame,
                                                       std::span<const double> values, const SiteArm& arm);

    /// It needs no angles, or those of the arm are known and new enough.
    [[nodiscard]] bool isLed(const SiteArm& arm, std::int64_t now_ns) const;

    /// The joint rates in the arm's present pose; zeros as long as that is not known, or older than
    /// SiteArm::oldestAngles_ns: a motion that is led by angles must not go on by those of before.
    ///   twist      arm_model::tipRates()
    ///   positions  (target - angle) / kApproach_s, all of them slowed down alike until none is faster than
    ///              its joint allows, so that the joints arrive together. The target lies within the joint's
    ///              range, and a joint that does not move is given up.
    [[nodiscard]] core::JointVector rates(const SiteArm& arm, std::int64_t now_ns) const;

private:
    AskedMotion(std::uint8_t kind, bool isOfTip, std::span<const double> values);

    std::uint8_t m_kind;
    bool m_isOfTip; ///< a twist in the frame of the tip
    core::JointVector m_values;
};

} // namespace teleta::site_link
