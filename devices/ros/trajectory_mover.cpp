// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/trajectory_mover.h"

#include <algorithm>
#include <utility>

namespace teleta::ros_arm {

namespace {

constexpr double kShortestStep_s = 1e-3;

bool moves(const core::JointVector& rate) {
    // NaN moves as well: the governor says that it is no number.
    return std::ranges::any_of(rate, [](double value) { return value != 0.0; });
}

} // namespace

TrajectoryMover::TrajectoryMover(std::shared_ptr<const arm_model::SerialChain> chain,
                                 const arm_model::MotionLimits& limits, std::int64_t period_ns,
                                 double reaction_s)
    : m_chain(std::move(chain))
    , m_period_ns(period_ns)
    , m_governor(m_chain, limits, reaction_s) {
}

void TrajectoryMover::post(core::ArmCommand command, std::int64_t now_ns) {
    command.time_ns = std::min(command.time_ns, now_ns);
    if (!moves(command.rate_radPerS)) {
        // Kept apart: a press that follows at once must not hide it.
        std::int64_t known_ns = m_released_ns.load(std::memory_order_acquire);
        while (known_ns < command.time_ns &&
               !m_released_ns.compare_exchange_weak(known_ns, command.time_ns, std::memory_order_acq_rel)) {
        }
    }
    m_commands.post(command);
}

void TrajectoryMover::block(std::int64_t now_ns) {
    m_blocked_ns = std::max(m_blocked_ns, now_ns);
}

bool TrajectoryMover::released() const {
    return m_released_ns.load(std::memory_order_acquire) > m_blocked_ns;
}

void TrajectoryMover::takeCommand(const MoverInput& input) {
    // A press that has been silent for long must not go on by itself.
    const auto checkGap = [this](std::int64_t until_ns) {
        if (m_command && until_ns - m_command->time_ns > kLongestGap_ns)
            block(m_command->time_ns);
    };
    checkGap(input.now_ns);
    if (std::optional<core::ArmCommand> command = m_commands.take()) {
        checkGap(command->time_ns);
        if (moves(command->rate_radPerS))
            m_command = command;
        else
            m_command.reset();
    }
}

bool TrajectoryMover::isPressed(std::int64_t now_ns) const {
    return m_command && now_ns - m_command->time_ns <= core::ArmCommand::kJogLifetime_ns;
}

bool TrajectoryMover::active(std::int64_t now_ns) const {
    return isPressed(now_ns) && released() && m_command->time_ns > m_blocked_ns;
}

bool TrajectoryMover::mayMove(const MoverInput& input, bool late) {
    if (input.trouble) {
        if (!m_state.fault)
            m_state.fault = input.trouble;
        block(input.now_ns);
    } else if (m_state.fault && released()) {
        m_state.fault.reset();
    }
    const bool known = input.reading && input.reading->position.size() == m_chain->joints();
    if (!known || !input.ready || late)
        block(input.now_ns);
    return !m_state.fault && known && input.ready && !late;
}

std::optional<std::array<arm_model::TrajectoryPoint, 2>> TrajectoryMover::step(const MoverInput& input) {
    const std::int64_t since_ns = m_lastStep_ns == kNever_ns ? m_period_ns : input.now_ns - m_lastStep_ns;
    m_lastStep_ns = input.now_ns;
    const bool engaged = std::exchange(m_engagements, input.engagements) != input.engagements;
    if (input.stopped || engaged || input.lacking)
        block(input.now_ns);
    takeCommand(input);
    const bool goesOn = mayMove(input, since_ns > kLatestStep_ns);
    m_state.needsRelease = !released();
    m_state.ignoresPress = !input.stopped && isPressed(input.now_ns) && !active(input.now_ns);
    m_state.flags = 0;
    m_state.rate = core::JointVector::zeros(m_chain->joints());
    m_state.drive = input.stopped ? core::ArmDrive::stopped : core::ArmDrive::held;
    if (!goesOn) {
        // The controller comes to rest at the end of what it has.
        m_moving = false;
        m_moved_ns = kNever_ns;
        return std::nullopt;
    }

    const bool pressed = !input.stopped && active(input.now_ns);
    const bool settling = m_moved_ns != kNever_ns && input.now_ns - m_moved_ns <= kSettling_ns;
    if (!m_moving && !settling)
        m_governor.restAt(input.reading->position);
    // A late step moves no farther than the points before it did.
    const double dt_s =
        std::clamp(static_cast<double>(since_ns) * 1e-9, kShortestStep_s, arm_model::kFirstPoint_s);
    arm_model::MotionDemand demand;
    demand.stop = input.stopped;
    if (pressed)
        demand.rate = m_command->rate_radPerS;
    const arm_model::MotionStep step = m_governor.step(demand, *input.reading, dt_s);
    m_state.commanded = step.commanded;
    m_state.flags = step.flags;
    if (step.fault) {
        m_state.fault = ArmFault{ArmFaultKind::notFollowing, {}};
        block(input.now_ns);
        m_state.needsRelease = true;
        m_moving = false;
        m_moved_ns = kNever_ns;
        return std::nullopt;
    }
    m_state.rate = step.rate;
    // The efforts at rest soon include what the arm presses against: without a fresh press it would press on.
    if (pressed && step.has(arm_model::MotionFlag::effort)) {
        block(input.now_ns);
        m_state.needsRelease = true;
        m_state.ignoresPress = true;
    }
    if (pressed)
        m_state.drive = core::ArmDrive::jog;
    const bool movesNow = pressed || moves(step.rate);
    if (!movesNow && !std::exchange(m_moving, false))
        return std::nullopt;
    m_moving = movesNow;
    m_moved_ns = input.now_ns;
    return points(input.stopped);
}

std::array<arm_model::TrajectoryPoint, 2> TrajectoryMover::points(bool stopped) const {
    const arm_model::MotionLimits& limits = m_governor.limits();
    core::JointVector deceleration = core::JointVector::zeros(m_chain->joints());
    std::ranges::fill(deceleration,
                      stopped ? limits.stopDeceleration_radPerS2 : limits.deceleration_radPerS2);
    return arm_model::trajectoryPoints(m_state.commanded, m_state.rate, deceleration);
}

} // namespace teleta::ros_arm
