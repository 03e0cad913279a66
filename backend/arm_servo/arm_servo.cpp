// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_servo/arm_servo.h"

#include "backend/core/device/arm_device.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::arm_servo {

using core::JointVector;

namespace {

/// As the controller counts a longer one.
constexpr double kLongestStep_s = 0.05;

bool isZero(const JointVector& rate) {
    return std::ranges::all_of(rate, [](double one) { return one == 0.0; });
}

servo::ServoController controllerOf(ArmTask task, double force_N, std::shared_ptr<const PadArm> pad) {
    // armPlan() passes the controller's check.
    return servo::ServoController::create(armPlan(task, force_N), std::move(pad)).value();
}

} // namespace

ArmServo::ArmServo(std::shared_ptr<const arm_model::SerialChain> chain, std::shared_ptr<const PadArm> pad,
                   const core::ArrayLayout& layout, const contact::FeatureSettings& features)
    : m_pad(std::move(pad))
    , m_controller(controllerOf(m_task, usualForce_N(m_task), m_pad))
    , m_world(std::move(chain), m_pad, layout, features) {
}

void ArmServo::setTask(ArmTask task, double force_N) {
    m_task = task;
    m_controller = controllerOf(task, force_N, m_pad);
    m_wish = Ending::taskChanged;
}

void ArmServo::forget() {
    m_wish = Ending::armMoved;
}

bool ArmServo::knowsJoints(const ArmServoInput& input) const {
    return !input.jointsOld && input.q_rad.size() == m_pad->joints() &&
           std::ranges::all_of(input.q_rad, [](double q) { return std::isfinite(q); });
}

bool ArmServo::isElsewhere(const JointVector& q_rad) const {
    for (std::size_t i = 0; i < q_rad.size(); ++i)
        if (std::abs(q_rad[i] - m_place_rad[i]) > kMoved_rad)
            return true;
    return false;
}

Ending ArmServo::trouble(const ArmServoInput& input) const {
    if (m_wish != Ending::none)
        return m_wish;
    if (input.stopped)
        return Ending::stopped;
    if (!knowsJoints(input))
        return Ending::noJoints;
    if (m_frameCame_ns == 0 || input.now_ns - m_frameCame_ns > kNoFrame_ns ||
        input.now_ns - input.frame_ns > kOldFrame_ns)
        return Ending::noFrames;
    if (m_stage == Stage::driving && input.hindered && input.now_ns - m_began_ns > kGrace_ns)
        return Ending::hindered;
    // The last command counts no more: whoever carries commands out wants a fresh press by now.
    if (m_stage == Stage::driving && input.now_ns - m_tick_ns > core::ArmCommand::kJogLifetime_ns)
        return Ending::hindered;
    return Ending::none;
}

void ArmServo::watchFrames(const ArmServoInput& input) {
    if (input.frame == m_frame)
        return;
    m_frame = input.frame;
    m_frameCame_ns = input.now_ns;
}

/// What was rehearsed counts from where it was rehearsed, or where the task has brought the arm.
void ArmServo::watchArm(const ArmServoInput& input) {
    if (m_stage == Stage::driving || m_place_rad.empty() || !knowsJoints(input))
        return;
    if (input.now_ns < m_restUntil_ns)
        m_place_rad = input.q_rad;
    else if (isElsewhere(input.q_rad))
        m_wish = Ending::armMoved;
}

void ArmServo::begin(const ArmServoInput& input) {
    m_stage = m_stage == Stage::rehearsed ? Stage::driving : Stage::rehearsing;
    m_ending = Ending::none;
    m_began_ns = m_step_ns = input.now_ns;
    m_controller.reset();
    m_output = {};
    m_advance_m = m_depth_m = 0.0;
    m_taxels = -1; // the plan may have any
    m_rate = JointVector::zeros(m_pad->joints());
    if (m_stage == Stage::driving) {
        m_usedFrame = m_firstFrame = m_frame;
        m_step_ns = input.frame_ns;
        return;
    }
    m_place_rad = input.q_rad;
    m_restUntil_ns = 0;
    m_world.begin(m_task, input.q_rad, input.pad.active > 0);
}

void ArmServo::end(Ending ending, std::int64_t now_ns) {
    const bool drove = m_stage == Stage::driving;
    const bool counts = ending == Ending::letGo || ending == Ending::finished;
    if (!drove && ending == Ending::letGo &&
        1e-9 * static_cast<double>(now_ns - m_began_ns) < kLeastRehearsal_s) {
        m_stage = Stage::idle;
        m_ending = Ending::tooShort;
    } else {
        m_stage = counts ? Stage::rehearsed : Stage::idle;
        m_ending = ending;
    }
    if (m_stage == Stage::idle)
        m_place_rad = {};
    // What was owed of an end in the same step stays.
    if (drove) {
        m_restOwed = true;
        m_restUntil_ns = now_ns + kRest_ns;
    } else if (!m_restOwed) {
        m_restUntil_ns = 0;
    }
    m_rate = {};
}

/// A contact of more taxels is harder. It counts as that of the most until it is lost, so that the gain does
/// not follow each frame.
void ArmServo::adaptTo(int taxels) {
    const int most = taxels > 0 ? std::max(m_taxels, taxels) : 0;
    if (std::exchange(m_taxels, most) == most)
        return;
    for (std::size_t i = 0; i < m_controller.plan().tasks.size(); ++i) {
        servo::ServoTask task = m_controller.plan().tasks[i];
        task.normalCompliance_mPerN = contactCompliance_mPerN(most);
        (void)m_controller.setTask(i, task); // as valid as it was
    }
}

/// One step of the controller: the joint rates that follow.
JointVector ArmServo::control(const contact::TactileFeatures& features, const JointVector& q_rad,
                              double dt_s) {
    adaptTo(features.active);
    servo::ServoInput input;
    input.features = features;
    input.dt_s = dt_s;
    input.X_Base_Sensor = m_pad->X_Base_Sensor(q_rad);
    input.q_rad = q_rad;
    input.bySpeed = true;
    m_output = m_controller.step(input);
    const Eigen::Matrix3d R_Base_Sensor = input.X_Base_Sensor.linear();
    servo::Twist twist_Base;
    twist_Base << R_Base_Sensor * m_output.twist_Sensor.head<3>(),
        R_Base_Sensor * m_output.twist_Sensor.tail<3>();

    const servo::ServoTask& task = m_controller.plan().tasks[m_output.phase];
    const bool touches = features.active > 0;
    // Not when the contact comes and goes: that of a broken taxel may flicker.
    if (touches && features.force_N >= 0.5 * task.desired.force_N)
        m_advance_m = m_depth_m = 0.0;
    (touches ? m_depth_m : m_advance_m) += std::min(dt_s, kLongestStep_s) * m_output.twist_Sensor[servo::kZ];
    return m_pad->carryOut(q_rad, twist_Base).rate;
}

/// What ends the run after a step of the controller.
Ending ArmServo::afterControl() const {
    if (m_output.contact == servo::ContactState::lost)
        return Ending::contactLost;
    if (m_output.finished)
        return Ending::finished;
    if (m_depth_m > kDeepest_m)
        return Ending::tooDeep;
    if (m_advance_m > kFarthest_m)
        return Ending::nothingFound;
    // To whoever carries commands out a zero says that the switch was let go, and what follows is a new
    // press. While the controller waits for a contact to come back, that does no harm.
    const bool rests = m_stage == Stage::driving && m_usedFrame > m_firstFrame && isZero(m_rate) &&
                       m_output.limits.has(servo::Limit::jointEnd);
    return rests ? Ending::jointEnd : Ending::none;
}

void ArmServo::rehearse(const ArmServoInput& input, ArmServoStep& step) {
    constexpr double kFirst_s = 0.01;
    const double passed_s = 1e-9 * static_cast<double>(input.now_ns - m_step_ns);
    const double dt_s = passed_s > 0.0 ? std::min(passed_s, kLongestStep_s) : kFirst_s;
    m_step_ns = input.now_ns;
    const contact::TactileFeatures felt = m_world.feel();
    const JointVector rate = control(felt, m_world.q_rad(), dt_s);
    const bool follows = m_world.move(rate, dt_s);
    step.force_N = felt.force_N;
    step.shadow_rad = m_world.q_rad();
    if (!follows)
        end(Ending::notFollowed, input.now_ns);
}

void ArmServo::drive(const ArmServoInput& input, ArmServoStep& step) {
    // Between two frames the arm goes on.
    if (std::exchange(m_usedFrame, m_frame) != m_frame) {
        const double dt_s = 1e-9 * static_cast<double>(input.frame_ns - m_step_ns);
        m_step_ns = input.frame_ns;
        m_rate = control(input.pad, input.q_rad, dt_s);
    }
    step.force_N = input.pad.force_N;
    step.rate = m_rate;
}

ArmServoStep ArmServo::step(const ArmServoInput& input) {
    ArmServoStep step;
    watchFrames(input);
    if (isRunning() && !input.held)
        end(Ending::letGo, input.now_ns);
    watchArm(input);
    // An arm that is not moved has nothing to end, but what was rehearsed does not count any more.
    if (m_stage == Stage::rehearsed && (m_wish != Ending::none || input.stopped))
        end(m_wish != Ending::none ? m_wish : Ending::stopped, input.now_ns);
    if (!isRunning() && m_stage == Stage::idle)
        m_wish = Ending::none;

    const bool wasPressed = std::exchange(m_pressed, input.held);
    const bool begins = input.held && !wasPressed;
    if (begins || isRunning()) {
        if (const Ending reason = trouble(input); reason != Ending::none)
            end(reason, input.now_ns);
        else if (begins)
            begin(input);
    }
    m_wish = isRunning() ? m_wish : Ending::none;

    if (m_stage == Stage::rehearsing) {
        rehearse(input, step);
    } else if (m_stage == Stage::driving) {
        if (begins)
            step.rate = JointVector::zeros(m_pad->joints()); // the arm learns that the switch had been let go
        else
            drive(input, step);
    }
    if (const Ending reason = isRunning() ? afterControl() : Ending::none; reason != Ending::none)
        end(reason, input.now_ns);
    step.output = m_output;
    m_tick_ns = input.now_ns;
    if (std::exchange(m_restOwed, false))
        step.rate = JointVector::zeros(m_pad->joints());
    return step;
}

} // namespace teleta::arm_servo
