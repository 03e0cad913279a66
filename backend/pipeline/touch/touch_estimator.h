// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm/contact_force.h"
#include "backend/core/device/arm_device.h"
#include "backend/pipeline/touch/skin_kinematics.h"
#include "backend/pipeline/touch/touch_record.h"
#include "backend/pipeline/touch/touched_place.h"
#include "backend/stiffness/contact_detector.h"
#include "backend/stiffness/stiffness_estimator.h"

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace teleta::pipeline {

/// Contact phase of each joint; free past the arm's joints.
using JointPhases = std::array<stiffness::ContactPhase, core::JointVector::kCapacity>;

/// How touches are recognised and evaluated. Times are those of the arm's stream.
struct TouchEstimatorSettings {
    stiffness::DetectionSettings detection;
    stiffness::TorqueWindow window;
    stiffness::Method method = stiffness::Method::regression;
    std::optional<double> torqueNoise_Nm; ///< as in stiffness::TouchSettings
    std::optional<double> angleNoise_rad;
    arm::ForceSettings force;

    double referenceTime_s =
        0.5;                   ///< time constant with which the reference follows the torque of a free joint
    int referenceSamples = 20; ///< averaged for the first reference, before any contact can be told
    double afterWindow_s = 0.01;    ///< the window is complete so long after the torque left it
    double leastSkinForce_N = 0.05; ///< what the skin feels below is noise
    double skinSlack_s = 0.03;      ///< the skin may have felt the contact so much earlier than the joints
    double skinWait_s = 0.1;        ///< a complete touch waits so long for the skin to feel it
    double elbowWait_s = 1.0;       ///< a touch that another joint feels waits so long for the elbow
    double leastLever_m = kLeastLever_m; ///< with a shorter lever about the elbow there is no stiffness
    double leastRise_s = 0.075;          ///< a quicker rise through the window moves the link: no stiffness
    double newReference_s =
        2.0; ///< a torque that stays, without the skin feeling a touch, is a new reference
    /// A reference that is accelerated more than this moves the links' inertia.
    double inertia_radPerS2 = 0.2;
    /// A touch has ended when all joints have been free, or the skin has felt nothing of it, for so long.
    double release_s = 0.02;
};

/// The settings with these torques; the force's noise is a fifth of the floor, which is five times the noise.
[[nodiscard]] TouchEstimatorSettings touchSettings(const core::TouchTorques& torques);

/// Where the arm is touched at this moment, and how hard.
struct LiveContact {
    double contactDistance_m = 0.0;
    double side_rad = 0.0;
    Eigen::Vector3d p_Base_Contact_m = Eigen::Vector3d::Zero();
    /// By the arm on the object; empty when the torques or angles are out of range.
    std::optional<arm::ContactForce> force;
};

/// Recognises touches of the arm while its samples come in, and evaluates each once, as soon as it can.
///
/// The elbow stands for the joint that presses the skin, SkinKinematics::pressingJoint().
///
/// Every joint is watched against a reference: the mean of its torque while it is free, which follows slow
/// drift. A touch begins with the first sample over the noise floor of any joint and ends when all have been
/// free for release_s. It is evaluated
///   by the elbow       afterWindow_s after its torque passed both the threshold and the window, at once when
///                      it is beyond everything that the regression uses or falls back into the window
///   by another joint   when the elbow has not felt it elbowWait_s after the threshold was passed, or at once
///                      when the skin says that the elbow has no lever
/// and in any case at its end, which the skin tells first; then it waits for the skin, skinWait_s at most.
/// One record a touch, however often the arm loads and unloads in it; a touch that never passes the threshold
/// has none. Torque, force and angles are those of the newest sample over the threshold.
///   n       normal of the skin, along which a force without friction acts; J_c of the contact point
///   lever   |n^T J_c,elbow| = P_C |cos(side)|
///   angle   n^T J_c q / n^T J_c,elbow, the rotation of the elbow alone that would press as deep
///   k_ri    SkinKinematics::linkStiffness_NPerM()
/// When the elbow alone moves and touches with the crest
/// of the forearm (side 0 or pi), and the shoulder is rigid, these are the angle and P_C of the paper.
/// Without a torque of the elbow in the upper half of the window there is no stiffness. The free motion of
/// the last kFreeTime_s before the touch tells drift and gravity that are left in the torque. The standard
/// errors of the place, along and around the forearm, enter the interval with what they change in lever,
/// angle and k_ri. What the arm's own motion bends in the line widens the interval.
///
/// The contact point is the mean of what the skin felt during the touch, weighted with the force; a contact
/// elsewhere (further than TouchedPlace::kSame_m) begins it anew. Without the skin the touch is recorded, but
/// not located: no point, no force, no stiffness. While the arm is told to speed up or slow down, the inertia
/// of its links is felt like a touch: what the skin does not feel is then none, and is only counted.
///
/// An arm whose skin has no known place is watched alike, but its touches are not located. A
/// sample with a number that is not finite, or without one for each joint, is left out and counted. A
/// discontinuity, or a time that runs back, ends a touch (it is recorded when it was complete) and begins the
/// reference anew. Samples and contacts come in order of time. Thread: one. Source: TeleTA, section 2.
class TouchEstimator {
public:
    static constexpr double kFreeTime_s = 1.0;

    /// skin: of an arm with as many joints; null: that of skinAroundForearm().
    explicit TouchEstimator(const core::ArmDescription& arm, const TouchEstimatorSettings& settings = {},
                            std::shared_ptr<const SkinKinematics> skin = nullptr);

    /// A record when this sample, or contact, completes a touch.
    [[nodiscard]] std::optional<TouchRecord> update(const core::JointSample& sample);
    [[nodiscard]] std::optional<TouchRecord> update(const SkinContact& contact);

    /// New detection settings forget the reference and a touch that has begun; the others act at once.
    void setSettings(const TouchEstimatorSettings& settings);
    [[nodiscard]] const TouchEstimatorSettings& settings() const { return m_settings; }
    /// Forgets all but the counters.
    void reset();
    /// The next touch has the number after this one.
    void countFrom(std::uint64_t touches) { m_touches = touches; }

    [[nodiscard]] JointPhases phases() const;
    [[nodiscard]] const core::JointVector& reference_Nm() const { return m_reference_Nm; }
    /// What the skin feels now, by the newest joint sample; empty when it feels nothing.
    [[nodiscard]] std::optional<LiveContact> liveContact() const;
    /// A touch has passed the threshold and is not evaluated yet: one of the next samples completes it.
    [[nodiscard]] bool isNearlyComplete() const;

    [[nodiscard]] std::uint64_t touches() const { return m_touches; } ///< records made
    /// Touches that came into the window but not over the threshold.
    [[nodiscard]] std::uint64_t touchesTooGentle() const { return m_tooGentle; }
    /// Torques of inertia that passed the threshold.
    [[nodiscard]] std::uint64_t touchesByInertia() const { return m_byInertia; }
    [[nodiscard]] std::uint64_t samplesLeftOut() const { return m_leftOut; } ///< not finite or not complete

private:
    enum class Stage {
        none,     ///< nobody touches
        rising,   ///< over the noise floor
        complete, ///< to be recorded when the skin has felt it
        held,     ///< recorded, not yet released
    };
    struct Touch {
        Stage stage = Stage::none;
        core::JointSample first;
        core::JointSample loaded;            ///< newest sample over the threshold
        core::JointVector torque_Nm;         ///< of that sample, without the reference
        std::size_t joint = 0;               ///< that felt it most, in that sample
        std::optional<double> elbowPassed_s; ///< when its torque passed the threshold and the window
        std::optional<double> passed_s;      ///< when any joint passed the threshold
        double complete_s = 0.0;
        double free_s = 0.0; ///< since when all joints are free again
        bool reachedWindow = false;
        std::optional<std::int64_t> skinLeft_ns; ///< since when the skin has no longer felt it
        bool accelerated = false;                ///< the arm sped up or slowed down in it, or shortly before
        bool elbowFelt = false;                  ///< the elbow is over the threshold in that sample
        std::optional<TouchedPlace> place;
    };
    struct Motion {
        double time_s = 0.0;
        core::JointVector reference_rad;
    };
    void followReference(const core::JointSample& sample);
    [[nodiscard]] core::JointVector torqueWithoutReference(const core::JointSample& sample) const;
    void watch(const core::JointSample& sample);
    void followMotion(const core::JointSample& sample);
    void takeNewReferences(const core::JointSample& sample);
    [[nodiscard]] std::optional<TouchRecord> follow(const core::JointSample& sample);
    [[nodiscard]] bool isComplete(const core::JointSample& sample, bool allFree) const;
    [[nodiscard]] std::optional<TouchRecord> recordWhenLocated(bool waitNoLonger);
    [[nodiscard]] TouchRecord makeRecord();
    void estimate(const SkinPoint& point, TouchRecord& record) const;
    /// For a contact at a place of the skin.
    [[nodiscard]] stiffness::TouchSettings stiffnessSettings(const SkinPoint& point) const;
    [[nodiscard]] tl::expected<double, stiffness::Refusal> complianceAt(const SkinPoint& point) const;
    /// Of the object's compliance: the samples are evaluated anew at places one standard error away.
    [[nodiscard]] double placeSe_mPerN(double object_mPerN) const;
    void keepFree(const core::JointSample& sample);
    /// The rise of the elbow's torque over the angle of the elbow that would press as deep.
    [[nodiscard]] std::vector<stiffness::JointSample>
    pressingRise(const arm::AnyJointVector& depthPerAngle_m) const;
    [[nodiscard]] std::optional<arm::ContactForce> forceAt(const core::JointVector& torque_Nm,
                                                           const SkinPoint& point) const;
    /// Of the touch, at a place of the skin, in the pose of its newest sample over the threshold.
    [[nodiscard]] SkinPoint locate(double x_m, double y_m) const;
    [[nodiscard]] bool isUsable(const core::JointSample& sample) const;
    [[nodiscard]] std::span<const stiffness::ContactDetector> detectors() const;
    [[nodiscard]] bool anyPhaseIs(stiffness::ContactPhase phase) const;
    void addToPlace(const SkinContact& contact);
    void makeDetectors();

    core::ArmDescription m_arm;
    std::shared_ptr<const SkinKinematics> m_skinAt; ///< null: nobody knows where the skin is
    /// Of the elbow. Without a skin the last joint, which is watched as all are.
    std::size_t m_elbow = 0;
    TouchEstimatorSettings m_settings;
    std::array<stiffness::ContactDetector, core::JointVector::kCapacity> m_detectors;
    std::vector<core::JointVector> m_riseAngles_rad; ///< of all joints, with the elbow's transition
    std::deque<core::JointSample> m_free;            ///< the last kFreeTime_s, and the transition

    std::optional<core::JointSample> m_newest;
    std::optional<SkinContact> m_skin; ///< newest contact; empty while the skin feels nothing
    core::JointVector m_reference_Nm;
    core::JointVector m_recent_Nm; ///< mean torque of the last moments
    int m_referenceSamples = 0;
    core::JointVector m_raisedUnfelt_s;    ///< time over the floor without the skin
    std::vector<Motion> m_motion;          ///< the last looks at the references, at most three
    std::optional<double> m_accelerated_s; ///< when the arm was accelerated last
    Touch m_touch;

    std::uint64_t m_touches = 0;
    std::uint64_t m_tooGentle = 0;
    std::uint64_t m_byInertia = 0;
    std::uint64_t m_leftOut = 0;
};

} // namespace teleta::pipeline
