// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_servo/arm_plans.h"
#include "backend/arm_servo/pad_arm.h"
#include "backend/arm_servo/rehearsal_world.h"
#include "backend/contact/tactile_features.h"
#include "backend/core/device/joint_vector.h"
#include "backend/servo/servo_controller.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace teleta::arm_servo {

enum class Stage {
    idle,       ///< nothing moves; the next press is a rehearsal
    rehearsing, ///< the switch is held and the shadow moves; the arm gets no command
    rehearsed,  ///< nothing moves; the next press moves the arm
    driving,    ///< the switch is held and the arm is moved
};

/// Why the last run ended, or what was rehearsed does not count any more.
enum class Ending {
    none,
    letGo,        ///< of the switch
    tooShort,     ///< a rehearsal of less than ArmServo::kLeastRehearsal_s
    stopped,      ///< STOP
    noFrames,     ///< the pad's frames are old
    noJoints,     ///< the joint readings are old or unusable
    hindered,     ///< the arm does not take commands, or they came too late to count
    jointEnd,     ///< a joint is at the end of its range, and the whole arm rests
    contactLost,  ///< the search for it has ended
    nothingFound, ///< the pad has come kFarthest_m without touching anything
    tooDeep,      ///< it has gone kDeepest_m into what it touches, and feels less than half of the force
    notFollowed,  ///< the shadow cannot follow
    finished,     ///< the plan has ended
    armMoved,     ///< by something else, since it was rehearsed
    taskChanged,
};

/// What is known at one tick.
struct ArmServoInput {
    std::int64_t now_ns = 0; ///< steady clock; rises
    bool held = false;       ///< the dead-man switch
    bool stopped = false;    ///< STOP is engaged, or was since the last tick
    bool jointsOld = false;
    bool hindered = false;        ///< the arm says that it does not take commands
    core::JointVector q_rad;      ///< measured; any other count than the arm's is unknown
    std::uint64_t frame = 0;      ///< counts the pad's frames
    std::int64_t frame_ns = 0;    ///< steady clock of the newest one
    contact::TactileFeatures pad; ///< of it, in N
};

/// What follows from it.
struct ArmServoStep {
    /// To be posted to the arm now; empty: nothing may be posted.
    std::optional<core::JointVector> rate;
    std::optional<core::JointVector> shadow_rad; ///< of a rehearsal, to be drawn
    servo::ServoOutput output;                   ///< of the newest control step while it runs
    double force_N = 0.0;                        ///< that the task feels: of the pad, or of the shadow's
};

/// Runs a servo task on an arm with a pad by a dead-man switch: the first press on a shadow, the second one
/// on the arm. Rates for the arm come out only while the switch is held and the stage is driving; after that
/// one step with zeros, then nothing. Any end but letting go, and every change of the task or motion of the
/// arm by something else, makes the next press a rehearsal again. A press that something ended, or that began
/// while something was in the way, is over until the switch has been let go. Pure: the time is an argument.
/// Thread: one.
class ArmServo {
public:
    /// A rehearsal that was shorter does not count.
    static constexpr double kLeastRehearsal_s = 1.0;
    /// Time without a new frame of the pad that ends a run, and the greatest age of the newest one.
    static constexpr std::int64_t kNoFrame_ns = 150'000'000;
    static constexpr std::int64_t kOldFrame_ns = 500'000'000;
    /// An arm that was moved farther than this is elsewhere.
    static constexpr double kMoved_rad = 0.01;
    /// Bounds of a pad that does not feel what it should: a cable may be off, or taxels saturated.
    static constexpr double kFarthest_m = 0.050;
    static constexpr double kDeepest_m = 0.010;
    /// After a run the arm may come to rest for so long.
    static constexpr std::int64_t kRest_ns = 500'000'000;
    /// A hindrance of the time before a press may last so long: the arm learns with it that the switch was
    /// let go.
    static constexpr std::int64_t kGrace_ns = 300'000'000;

    /// chain, pad: of the same arm, not null. layout: of its pad.
    ArmServo(std::shared_ptr<const arm_model::SerialChain> chain, std::shared_ptr<const PadArm> pad,
             const core::ArrayLayout& layout, const contact::FeatureSettings& features);

    /// The next press is a rehearsal of this task; what runs is ended with the next step.
    void setTask(ArmTask task, double force_N);
    [[nodiscard]] ArmTask task() const { return m_task; }
    [[nodiscard]] const servo::ServoPlan& plan() const { return m_controller.plan(); }
    /// Something else moves the arm: the next press is a rehearsal.
    void forget();

    [[nodiscard]] ArmServoStep step(const ArmServoInput& input);

    [[nodiscard]] Stage stage() const { return m_stage; }
    [[nodiscard]] Ending ending() const { return m_ending; }
    [[nodiscard]] bool isRunning() const { return m_stage == Stage::rehearsing || m_stage == Stage::driving; }

private:
    [[nodiscard]] core::JointVector control(const contact::TactileFeatures& features,
                                            const core::JointVector& q_rad, double dt_s);
    void adaptTo(int taxels);
    [[nodiscard]] Ending afterControl() const;
    [[nodiscard]] Ending trouble(const ArmServoInput& input) const;
    [[nodiscard]] bool knowsJoints(const ArmServoInput& input) const;
    [[nodiscard]] bool isElsewhere(const core::JointVector& q_rad) const;
    void watchArm(const ArmServoInput& input);
    void watchFrames(const ArmServoInput& input);
    void begin(const ArmServoInput& input);
    void end(Ending ending, std::int64_t now_ns);
    void rehearse(const ArmServoInput& input, ArmServoStep& step);
    void drive(const ArmServoInput& input, ArmServoStep& step);

    std::shared_ptr<const PadArm> m_pad;
    ArmTask m_task = ArmTask::point;
    servo::ServoController m_controller;
    RehearsalWorld m_world;
    Stage m_stage = Stage::idle;
    Ending m_ending = Ending::none;
    Ending m_wish = Ending::none; ///< to end with the next step
    bool m_pressed = false;       ///< as of the last step
    bool m_restOwed = false;      ///< zeros are still to be told
    std::int64_t m_began_ns = 0;
    std::int64_t m_step_ns = 0; ///< of the last step on the shadow, or of the frame of the last control step
    std::uint64_t m_frame = 0;
    std::int64_t m_frameCame_ns = 0; ///< when m_frame was seen first; 0: none was
    std::uint64_t m_usedFrame = 0;   ///< of the last control step
    std::uint64_t m_firstFrame = 0;  ///< when the arm began to be driven
    std::int64_t m_restUntil_ns = 0;
    core::JointVector
        m_place_rad; ///< where the arm has to be for the rehearsal to count; empty: nothing counts
    core::JointVector m_rate;
    std::int64_t m_tick_ns = 0; ///< of the last step
    double m_advance_m = 0.0; ///< along the pad's normal since it last felt what it should, without m_depth_m
    double m_depth_m = 0.0;   ///< the part of it while it touched something
    int m_taxels = 0;         ///< most that have been touched together since the pad touches something
    servo::ServoOutput m_output;
};

} // namespace teleta::arm_servo
