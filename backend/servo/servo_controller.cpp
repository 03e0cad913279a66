// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/servo_controller.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace teleta::servo {

namespace {

bool finite(const std::optional<double>& value) {
    return !value || std::isfinite(*value);
}

bool usable(const ServoInput& input) {
    const contact::TactileFeatures& f = input.features;
    return input.dt_s > 0.0 && std::isfinite(input.dt_s) && std::isfinite(f.force_N) &&
           std::isfinite(f.peak_N) && finite(f.copX_m) && finite(f.copY_m) && finite(f.cocX_m) &&
           finite(f.cocY_m) && finite(f.alphaZ_rad) &&
           input.X_Base_Sensor.matrix().array().isFinite().all() &&
           (!input.q_rad || std::ranges::all_of(*input.q_rad, [](double q) { return std::isfinite(q); }));
}

Twist feedForward(const FeedForward& forward, double time_s) {
    return forward.constant_Sensor +
           std::cos(2.0 * std::numbers::pi * time_s / forward.period_s) * forward.sway_Sensor;
}

/// The part of a velocity that would increase a deviation beyond its limit.
Eigen::Vector3d kept(const Eigen::Vector3d& velocity, const Eigen::Vector3d& away, double bound,
                     double dt_s) {
    const Eigen::Vector3d next = away + dt_s * velocity;
    if (next.norm() <= bound || next.norm() <= away.norm())
        return velocity;
    const Eigen::Vector3d outward = next.normalized();
    const double allowed = std::max(0.0, (bound - away.dot(outward)) / dt_s);
    return velocity - std::max(0.0, velocity.dot(outward) - allowed) * outward;
}

} // namespace

std::optional<double> ServoOutput::desiredCocX_m() const {
    if (projection(kX, kX) != 0.0)
        return desired[kX];
    if (!edge && projection(kWy, kWy) != 0.0)
        return desired[kWy];
    return std::nullopt;
}

std::optional<double> ServoOutput::desiredDzmpY_m() const {
    // Row 5 of an edge is -DZMP_y.
    if (edge && (projection(kWy, kWy) != 0.0 || projection(kX, kWy) != 0.0))
        return 0.0 - desired[kWy];
    return std::nullopt;
}

tl::expected<ServoController, TaskRefusal> ServoController::create(ServoPlan plan,
                                                                   std::shared_ptr<const ServoArm> arm) {
    if (const auto fine = check(plan); !fine)
        return tl::unexpected(fine.error());
    return ServoController(std::move(plan), std::move(arm));
}

tl::expected<void, TaskRefusal> ServoController::setTask(std::size_t index, const ServoTask& task) {
    if (index >= m_plan.tasks.size())
        return tl::unexpected(TaskRefusal::badReference);
    const ServoTask before = m_plan.tasks[index];
    m_plan.tasks[index] = task;
    if (const auto fine = check(m_plan); !fine) {
        m_plan.tasks[index] = before;
        return fine;
    }
    return {};
}

tl::expected<void, TaskRefusal> ServoController::enter(std::size_t index) {
    if (index >= m_plan.tasks.size())
        return tl::unexpected(TaskRefusal::badReference);
    m_phases.enter(index);
    m_phaseBegan = true;
    m_search.end();
    return {};
}

void ServoController::reset() {
    m_phases = ServoPhases(m_plan);
    m_regulator.reset();
    m_desired.reset();
    m_direction.reset();
    m_search.reset();
    m_started = false;
    m_held = false;
    m_phaseBegan = true;
    m_untouched_s = 0.0;
    m_path_m = 0.0;
    m_velocity_Base_mPerS.setZero();
}

void ServoController::updateContact(const ServoInput& input, double dt_s, ServoOutput& output) {
    const bool needed = m_plan.tasks[m_phases.index()].needsContact;
    if (input.features.active > 0) {
        m_untouched_s = 0.0;
        m_search.touched(input.X_Base_Sensor, m_velocity_Base_mPerS);
        if (m_search.running()) {
            m_search.end();
            m_regulator.reset();
            if (m_phases.foundAgain(m_plan))
                m_phaseBegan = true;
        }
        output.contact = ContactState::touching;
        return;
    }
    m_untouched_s += dt_s;
    m_direction.reset();
    if (!needed) {
        output.contact = ContactState::none;
        return;
    }
    if (!m_search.running() && m_untouched_s < m_plan.search.lostAfter_s) {
        output.contact = ContactState::touching;
        return;
    }
    if (!m_search.running()) {
        if (!m_search.hasTouched())
            m_search.touched(input.X_Base_Sensor, Eigen::Vector3d::Zero());
        m_search.begin();
        m_regulator.reset();
    }
    output.contact = m_search.exhausted() ? ContactState::lost : ContactState::searching;
}

void ServoController::observe(const ServoInput& input, const ServoTask& task, ServoOutput& output) {
    MeasuredFeatures measured = featureVector(input.features, task.normalCompliance_mPerN);
    if (measured.defined[kWz])
        measured.s[kWz] = m_direction.follow(measured.s[kWz], task.desired.alphaZ_rad);

    output.kind = task.kind;
    output.edge = task.jacobian == JacobianRule::edge ||
                  (task.jacobian == JacobianRule::touch && input.features.type == contact::ContactType::edge);
    output.inverseJacobian = inverseTactileJacobian(output.edge);
    output.projection = projectionMatrix(task.projection);
    const DesiredFeatures& desired = task.desired;
    output.desired << desired.copX_m, desired.copY_m, task.normalCompliance_mPerN * desired.force_N,
        desired.wx_m, desired.wy_m, desired.alphaZ_rad;
    output.actual = output.inverseJacobian * measured.s;

    Vector6 error = output.desired - output.actual;
    for (std::size_t row = 0; row < 6; ++row) {
        // A point has no direction to control, whatever the task asks for.
        const bool controllable = row != kWz || output.edge;
        output.known[row] = input.features.active > 0 && measured.defined[row] && controllable;
        if (!output.known[row])
            error[static_cast<Eigen::Index>(row)] = 0.0;
    }
    output.error = output.projection * error;
}

ServoController::Wanted ServoController::law(const ServoInput& input, const ServoTask& task, double dt_s,
                                             ServoOutput& output) {
    Wanted wanted;
    if (m_search.running()) {
        wanted.twist = m_search.step(m_X_Base_Sensor, dt_s, m_plan.search);
        return wanted;
    }
    wanted.regulated = true;

    const Projection& P = task.projection;
    // How a moment changes with a turn depends on the contact; place, depth and direction follow the motion
    // one to one.
    PiRegulator::Rows rows{.takesPart = {P.x || P.com, P.y, P.z, P.wx, P.wy, P.wz},
                           .known = output.known,
                           .oneToOne = {!P.com, true, true, false, false, true}};
    rows.known[kX] = (P.x && output.known[kX]) || (P.com && output.known[kWy]);
    const Vector6 desired = output.projection * output.desired;
    if (m_desired)
        m_regulator.expect(desired - *m_desired);
    m_desired = desired;
    Twist& twist = wanted.twist;
    twist = m_regulator.step(output.error, rows, dt_s, task.gains);
    // Do not continue sliding during a momentary loss of contact.
    if (input.features.active > 0 || !task.needsContact)
        twist += feedForward(task.feedForward, m_phases.timeInTask_s());

    // The turn is limited first, because the motion that keeps the contact in place is computed from it.
    const double turn_radPerS = twist.tail<3>().norm();
    if (turn_radPerS > task.limits.turnRate_radPerS) {
        output.limits.set(Limit::turnRate);
        wanted.cut.tail<3>() = (1.0 - task.limits.turnRate_radPerS / turn_radPerS) * twist.tail<3>();
        twist -= wanted.cut;
    }
    if (task.turnsAboutContact && input.features.cocX_m && input.features.cocY_m) {
        const Eigen::Vector3d p_Sensor_Contact(*input.features.cocX_m, *input.features.cocY_m, 0.0);
        twist.head<3>() -= twist.tail<3>().cross(p_Sensor_Contact);
    }
    return wanted;
}

Twist ServoController::limited(const Twist& wanted, const ServoInput& input, const ServoTask& task,
                               bool regulated, ServoOutput& output) const {
    const ServoLimits& limits = task.limits;
    Twist twist = wanted;
    if (input.features.force_N > limits.force_N) {
        output.limits.set(Limit::force);
        twist << 0.0, 0.0, std::min(twist[kZ], 0.0), 0.0, 0.0, 0.0;
    }
    if (regulated && limits.saturation_N && input.features.peak_N >= *limits.saturation_N &&
        twist[kZ] > 0.0) {
        output.limits.set(Limit::saturation);
        twist[kZ] = 0.0;
    }
    // Scaled together, so that the screw axis and the place of the contact do not change.
    const double speed_mPerS = twist.head<3>().norm();
    if (speed_mPerS > limits.toolSpeed_mPerS) {
        output.limits.set(Limit::toolSpeed);
        twist *= limits.toolSpeed_mPerS / speed_mPerS;
    }
    if (!m_arm || !input.q_rad || input.q_rad->size() != m_arm->joints())
        return twist;

    const Eigen::Matrix3d R_Base_Sensor = m_X_Base_Sensor.linear();
    Twist atSensor_Base;
    atSensor_Base << R_Base_Sensor * twist.head<3>(), R_Base_Sensor * twist.tail<3>();
    const SensorMotion motion = m_arm->carryOut(*input.q_rad, atSensor_Base);
    if (motion.slowed)
        output.limits.set(Limit::jointSpeed);
    if (motion.atEnd)
        output.limits.set(Limit::jointEnd);
    if (motion.singular)
        output.limits.set(Limit::singular);
    if (!motion.isLimited())
        return twist;
    twist << R_Base_Sensor.transpose() * motion.achieved.head<3>(),
        R_Base_Sensor.transpose() * motion.achieved.tail<3>();
    return twist;
}

Twist ServoController::withinDeviation(const Twist& twist, const ServoInput& input, const ServoTask& task,
                                       double dt_s, ServoOutput& output) const {
    const Eigen::Matrix3d R_Sensor_Base = m_X_Base_Sensor.linear().transpose();
    const Eigen::Vector3d away_m =
        R_Sensor_Base * (m_X_Base_Sensor.translation() - input.X_Base_Sensor.translation());
    const Eigen::Vector3d away_rad =
        logSO3(input.X_Base_Sensor.linear().transpose() * m_X_Base_Sensor.linear());
    Twist result;
    result << kept(twist.head<3>(), away_m, task.limits.deviation_m, dt_s),
        kept(twist.tail<3>(), away_rad, task.limits.deviation_rad, dt_s);
    if (result != twist)
        output.limits.set(Limit::deviation);
    return result;
}

ServoOutput ServoController::step(const ServoInput& input) {
    ServoOutput output;
    const bool good = usable(input);
    if (!good)
        output.limits.set(Limit::badInput);
    // The pose may be good even if the features are not; without it a hold would command the origin of the
    // base.
    const bool poseIsKnown = input.X_Base_Sensor.matrix().array().isFinite().all();
    if (!m_started && poseIsKnown) {
        m_X_Base_Sensor = input.X_Base_Sensor;
        m_started = good;
    }
    if (!input.hold)
        m_held = false;
    else if (!m_held && poseIsKnown) {
        m_X_Base_Sensor = input.X_Base_Sensor;
        m_held = true;
    }
    if (!good || input.hold) {
        m_regulator.reset();
        m_velocity_Base_mPerS.setZero();
        m_path_m = 0.0;
        output.X_Base_Sensor = m_X_Base_Sensor;
        output.phase = m_phases.index();
        output.finished = m_phases.finished();
        if (good) {
            observe(input, m_plan.tasks[output.phase], output);
            output.contact = input.features.active > 0 ? ContactState::touching : ContactState::none;
        }
        return output;
    }

    const double longest_s = m_plan.tasks[m_phases.index()].limits.longestStep_s;
    const double dt_s = std::min(input.dt_s, longest_s);
    if (input.dt_s > longest_s)
        output.limits.set(Limit::gap);

    updateContact(input, dt_s, output);
    if (input.bySpeed && !m_search.running())
        m_X_Base_Sensor = input.X_Base_Sensor;
    if (!m_search.running()) {
        const double desired_rad = m_plan.tasks[m_phases.index()].desired.alphaZ_rad;
        const double alphaError_rad =
            input.features.alphaZ_rad
                ? desired_rad - EdgeDirection(m_direction).follow(*input.features.alphaZ_rad, desired_rad)
                : 0.0;
        if (m_phases.update(m_plan, input.features, alphaError_rad, m_path_m, dt_s))
            m_phaseBegan = true;
    }
    const ServoTask& task = m_plan.tasks[m_phases.index()];
    output.phase = m_phases.index();
    output.phaseBegan = std::exchange(m_phaseBegan, false);
    output.finished = m_phases.finished();

    observe(input, task, output);
    const Wanted wanted = law(input, task, dt_s, output);
    const Twist twist = withinDeviation(limited(wanted.twist, input, task, wanted.regulated, output), input,
                                        task, dt_s, output);
    if (wanted.regulated)
        m_regulator.giveBack(wanted.twist + wanted.cut - twist);

    output.integral = m_regulator.integral();
    output.twist_Sensor = twist;
    output.twist_Base = twistTo(m_X_Base_Sensor, twist);
    m_velocity_Base_mPerS = m_X_Base_Sensor.linear() * twist.head<3>();
    m_path_m = twist.head<3>().norm() * dt_s;
    m_X_Base_Sensor = moved(m_X_Base_Sensor, dt_s * output.twist_Base);
    output.X_Base_Sensor = m_X_Base_Sensor;
    return output;
}

} // namespace teleta::servo
