// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/serial_chain.h"
#include "backend/core/device/joint_vector.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace teleta::arm_model {

/// What limits the motion of an arm. Numbers of a prismatic joint are in m instead of rad. All > 0 and
/// finite.
struct MotionLimits {
    double speedScale = 0.25; ///< share of each joint's own speed limit, 0..1
    double acceleration_radPerS2 = 3.0;
    double deceleration_radPerS2 = 3.0;
    double stopDeceleration_radPerS2 = 6.0; ///< with STOP; at least deceleration_radPerS2
    double leash_rad = 0.05;                ///< largest distance between commanded and measured position
    double jointMargin_rad = 0.05;          ///< the arm comes to rest this far before the end of a joint
    double tipSpeed_mPerS = 0.1;
    double tipTurn_radPerS = 0.5;
    /// Of the tip's origin in the base frame; none: everywhere.
    std::optional<Eigen::AlignedBox3d> box_m;
    core::JointVector
        effortStop_Nm; ///< change of a joint's effort since rest that holds the arm; empty: none
    std::optional<double> forceStop_N; ///< force at the wrist that holds the arm; none: no limit
};

/// The limits that acted in a step, as bits.
enum class MotionFlag : std::uint32_t {
    notFinite = 1U << 0U,    ///< the demand was not finite and counts as zero
    jointRate = 1U << 1U,    ///< slowed down to a joint's speed
    acceleration = 1U << 2U, ///< the change of the rates is limited
    tipSpeed = 1U << 3U,     ///< slowed down to the tip's speed
    jointEnd = 1U << 4U,     ///< a joint comes near its end
    workspace = 1U << 5U,    ///< the tip would leave the box
    effort = 1U << 6U,       ///< held: a joint's effort rose
    force = 1U << 7U,        ///< held: the force at the wrist; only retreat is carried out
    leash = 1U << 8U,        ///< the arm lags; the commanded position waits for it
};

/// What the arm should do. After STOP or without a demand it brakes and stands.
struct MotionDemand {
    core::JointVector rate; ///< as many as the chain has joints; any other count is no demand
    bool stop = false;      ///< STOP is engaged
};

/// What the arm measures. Efforts and force are optional.
struct MotionReading {
    core::JointVector position;                  ///< measured; as many finite numbers as the chain has joints
    core::JointVector effort;                    ///< empty: not told
    std::optional<Eigen::Vector3d> force_Base_N; ///< what acts on the arm
};

struct MotionStep {
    core::JointVector commanded; ///< q_c, rad or m
    core::JointVector rate;      ///< v, the rate with which q_c moves
    std::uint32_t flags = 0;     ///< MotionFlag
    /// The arm did not follow for kFollowingTime_s. The caller stops commanding and calls reset() when the
    /// cause is gone.
    bool fault = false;

    [[nodiscard]] bool has(MotionFlag flag) const { return (flags & static_cast<std::uint32_t>(flag)) != 0; }
};

/// Turns demands into commanded positions that keep the limits, in this order: finite; held by effort or
/// force; speed of the joints; acceleration; speed of the tip; ends of the joints; box; leash. Speeds of
/// joints and tip slow down all joints alike, which keeps the direction. From every commanded state the arm
/// can come to rest, after reaction_s at the same rate and with the deceleration of the limits, without
/// passing the end of a joint less its margin or leaving the box. An arm that starts beyond them can move
/// back only. Thread: one; step() allocates nothing.
class MotionGovernor {
public:
    /// An arm that lags by the leash for so long has a fault.
    static constexpr double kFollowingTime_s = 0.3;
    /// Efforts at rest are averaged over this time.
    static constexpr double kRestTime_s = 0.5;

    /// reaction_s: time that the arm goes on before it brakes when no further command comes; >= 0.
    MotionGovernor(std::shared_ptr<const SerialChain> chain, const MotionLimits& limits, double reaction_s);

    /// Begins at rest where the arm is. measured: as many finite numbers as the chain has joints.
    void reset(const core::JointVector& measured);

    /// Goes on at rest where the arm is, with the efforts at rest that are known: for an arm that is not
    /// commanded. measured: as reset().
    void restAt(const core::JointVector& measured);

    /// One step of dt_s, > 0. A reading that is not finite or has another count faults at once.
    [[nodiscard]] MotionStep step(const MotionDemand& demand, const MotionReading& reading, double dt_s);

    [[nodiscard]] const MotionLimits& limits() const { return m_limits; }

private:
    static constexpr std::size_t kRestSamples = 64;

    [[nodiscard]] bool validReading(const MotionReading& reading) const;
    [[nodiscard]] core::JointVector demanded(const MotionDemand& demand, std::uint32_t& flags) const;
    [[nodiscard]] bool effortRose(const core::JointVector& effort, double dt_s);
    void limitJointRates(core::JointVector& rate, std::uint32_t& flags) const;
    void limitAcceleration(core::JointVector& rate, double deceleration, double dt_s,
                           std::uint32_t& flags) const;
    void limitTip(core::JointVector& rate, std::uint32_t& flags) const;
    void limitEnds(core::JointVector& rate, double dt_s, std::uint32_t& flags) const;
    void limitBox(core::JointVector& rate, double dt_s, std::uint32_t& flags) const;
    /// How far outside the box the tip comes on its way to rest.
    [[nodiscard]] double outside_m(const core::JointVector& rate, double dt_s) const;
    [[nodiscard]] bool keepLeash(const core::JointVector& measured, double dt_s, std::uint32_t& flags);

    std::shared_ptr<const SerialChain> m_chain;
    MotionLimits m_limits;
    double m_reaction_s;
    core::JointVector m_lowest;
    core::JointVector m_highest;
    core::JointVector m_fastest;
    core::JointVector m_commanded;
    core::JointVector m_rate;
    double m_lagging_s = 0.0;
    // Efforts of the last kRestTime_s at rest, the newest last.
    std::array<core::JointVector, kRestSamples> m_restEfforts{};
    std::array<double, kRestSamples> m_restAges_s{};
    std::size_t m_restCount = 0;
};

} // namespace teleta::arm_model
