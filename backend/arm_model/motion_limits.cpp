// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_model/motion_limits.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::arm_model {

namespace {

void raise(std::uint32_t& flags, MotionFlag flag) {
    flags |= static_cast<std::uint32_t>(flag);
}

bool allFinite(const core::JointVector& values) {
    return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

void scale(core::JointVector& values, double factor) {
    for (double& value : values)
        value *= factor;
}

bool moves(const core::JointVector& rate) {
    return std::ranges::any_of(rate, [](double value) { return value != 0.0; });
}

/// The greatest rate from which the way left suffices: v t + v^2 / (2 a) = way. way: any; a > 0; t >= 0.
double greatestRate(double way, double deceleration, double reaction_s) {
    if (!(way > 0.0))
        return 0.0;
    const double lost = deceleration * reaction_s;
    return 2.0 * deceleration * way / (lost + std::sqrt(lost * lost + 2.0 * deceleration * way));
}

} // namespace

MotionGovernor::MotionGovernor(std::shared_ptr<const SerialChain> chain, const MotionLimits& limits,
                               double reaction_s)
    : m_chain(std::move(chain))
    , m_limits(limits)
    , m_reaction_s(reaction_s)
    , m_lowest(m_chain->lowest())
    , m_highest(m_chain->highest())
    , m_fastest(m_chain->fastest()) {
    scale(m_fastest, m_limits.speedScale);
    reset(core::JointVector::zeros(m_chain->joints()));
}

void MotionGovernor::reset(const core::JointVector& measured) {
    restAt(measured);
    m_restCount = 0;
}

void MotionGovernor::restAt(const core::JointVector& measured) {
    m_commanded = measured;
    m_rate = core::JointVector::zeros(m_chain->joints());
    m_lagging_s = 0.0;
}

bool MotionGovernor::validReading(const MotionReading& reading) const {
    return reading.position.size() == m_chain->joints() && allFinite(reading.position);
}

core::JointVector MotionGovernor::demanded(const MotionDemand& demand, std::uint32_t& flags) const {
    core::JointVector none = core::JointVector::zeros(m_chain->joints());
    if (demand.stop || demand.rate.size() != m_chain->joints())
        return none;
    if (!allFinite(demand.rate)) {
        raise(flags, MotionFlag::notFinite);
        return none;
    }
    return demand.rate;
}

MotionStep MotionGovernor::step(const MotionDemand& demand, const MotionReading& reading, double dt_s) {
    MotionStep result;
    if (!validReading(reading)) {
        m_rate = core::JointVector::zeros(m_chain->joints());
        result.commanded = m_commanded;
        result.rate = m_rate;
        result.fault = true;
        return result;
    }
    core::JointVector rate = demanded(demand, result.flags);
    if (effortRose(reading.effort, dt_s)) {
        rate = core::JointVector::zeros(m_chain->joints());
        raise(result.flags, MotionFlag::effort);
    }
    if (m_limits.forceStop_N && reading.force_Base_N) {
        const Eigen::Vector3d& force_N = *reading.force_Base_N;
        if (!(force_N.stableNorm() <= *m_limits.forceStop_N)) {
            raise(result.flags, MotionFlag::force);
            const Eigen::Map<const Eigen::VectorXd> joints(rate.data(),
                                                           static_cast<Eigen::Index>(rate.size()));
            const Eigen::Vector3d tip = m_chain->jacobian(m_commanded).topRows<3>() * joints;
            // Away from what presses: the force acts on the arm.
            if (!(tip.dot(force_N) > 0.0))
                rate = core::JointVector::zeros(m_chain->joints());
        }
    }
    limitJointRates(rate, result.flags);
    limitAcceleration(rate, demand.stop ? m_limits.stopDeceleration_radPerS2 : m_limits.deceleration_radPerS2,
                      dt_s, result.flags);
    limitTip(rate, result.flags);
    limitEnds(rate, dt_s, result.flags);
    limitTip(rate, result.flags); // a joint that stops at its end may have slowed the tip down
    limitBox(rate, dt_s, result.flags);

    m_rate = rate;
    for (std::size_t i = 0; i < m_commanded.size(); ++i)
        m_commanded[i] += rate[i] * dt_s;
    result.fault = keepLeash(reading.position, dt_s, result.flags);
    result.commanded = m_commanded;
    result.rate = m_rate;
    return result;
}

bool MotionGovernor::effortRose(const core::JointVector& effort, double dt_s) {
    const std::size_t joints = m_chain->joints();
    if (m_limits.effortStop_Nm.size() != joints || effort.size() != joints || !allFinite(effort))
        return false;
    const auto meanAtRest = [this](std::size_t joint) {
        double sum = 0.0;
        for (std::size_t k = 0; k < m_restCount; ++k)
            sum += m_restEfforts[k][joint];
        return sum / static_cast<double>(m_restCount);
    };
    bool rose = false;
    for (std::size_t i = 0; i < joints && m_restCount > 0; ++i)
        rose = rose || std::abs(effort[i] - meanAtRest(i)) > m_limits.effortStop_Nm[i];
    if (!moves(m_rate)) {
        std::size_t kept = 0;
        for (std::size_t k = 0; k < m_restCount; ++k) {
            m_restAges_s[k] += dt_s;
            if (m_restAges_s[k] > kRestTime_s || m_restCount - k >= kRestSamples)
                continue;
            m_restAges_s[kept] = m_restAges_s[k];
            m_restEfforts[kept] = m_restEfforts[k];
            ++kept;
        }
        m_restEfforts[kept] = effort;
        m_restAges_s[kept] = 0.0;
        m_restCount = kept + 1;
    }
    return rose;
}

void MotionGovernor::limitJointRates(core::JointVector& rate, std::uint32_t& flags) const {
    double factor = 1.0;
    for (std::size_t i = 0; i < rate.size(); ++i) {
        if (std::abs(rate[i]) * factor > m_fastest[i])
            factor = m_fastest[i] / std::abs(rate[i]);
    }
    if (factor < 1.0) {
        scale(rate, factor);
        raise(flags, MotionFlag::jointRate);
    }
}

void MotionGovernor::limitAcceleration(core::JointVector& rate, double deceleration, double dt_s,
                                       std::uint32_t& flags) const {
    double factor = 1.0;
    for (std::size_t i = 0; i < rate.size(); ++i) {
        const double change = std::abs(rate[i] - m_rate[i]);
        const bool speedsUp = std::abs(rate[i]) > std::abs(m_rate[i]) && rate[i] * m_rate[i] >= 0.0;
        const double most = (speedsUp ? m_limits.acceleration_radPerS2 : deceleration) * dt_s;
        if (change * factor > most)
            factor = most / change;
    }
    if (factor < 1.0) {
        for (std::size_t i = 0; i < rate.size(); ++i)
            rate[i] = m_rate[i] + factor * (rate[i] - m_rate[i]);
        raise(flags, MotionFlag::acceleration);
    }
}

void MotionGovernor::limitTip(core::JointVector& rate, std::uint32_t& flags) const {
    const Eigen::Map<const Eigen::VectorXd> joints(rate.data(), static_cast<Eigen::Index>(rate.size()));
    const ChainJacobian jacobian = m_chain->jacobian(m_commanded);
    const double speed = (jacobian.topRows<3>() * joints).norm();
    const double turn = (jacobian.bottomRows<3>() * joints).norm();
    double factor = 1.0;
    if (speed > m_limits.tipSpeed_mPerS)
        factor = m_limits.tipSpeed_mPerS / speed;
    if (turn * factor > m_limits.tipTurn_radPerS)
        factor = m_limits.tipTurn_radPerS / turn;
    if (factor < 1.0) {
        scale(rate, factor);
        raise(flags, MotionFlag::tipSpeed);
    }
}

void MotionGovernor::limitEnds(core::JointVector& rate, double dt_s, std::uint32_t& flags) const {
    for (std::size_t i = 0; i < rate.size(); ++i) {
        const double margin = m_limits.jointMargin_rad;
        const double way =
            rate[i] > 0.0 ? m_highest[i] - margin - m_commanded[i] : m_commanded[i] - (m_lowest[i] + margin);
        if (std::isinf(way))
            continue;
        const double most = greatestRate(way, m_limits.deceleration_radPerS2, m_reaction_s + dt_s);
        if (std::abs(rate[i]) > most) {
            rate[i] = std::copysign(most, rate[i]);
            raise(flags, MotionFlag::jointEnd);
        }
    }
}

double MotionGovernor::outside_m(const core::JointVector& rate, double dt_s) const {
    // Along the ride that follows if this is the last command: on for the reaction time, then braking.
    const double deceleration = m_limits.deceleration_radPerS2;
    double braking_s = 0.0;
    for (const double v : rate)
        braking_s = std::max(braking_s, std::abs(v) / deceleration);
    const double on_s = dt_s + m_reaction_s;
    double farthest_m = 0.0;
    for (const double time_s :
         {dt_s, on_s, on_s + 0.25 * braking_s, on_s + 0.5 * braking_s, on_s + braking_s}) {
        core::JointVector place = m_commanded;
        for (std::size_t i = 0; i < place.size(); ++i) {
            const double braked_s = std::clamp(time_s - on_s, 0.0, std::abs(rate[i]) / deceleration);
            place[i] += rate[i] * std::min(time_s, on_s) + rate[i] * braked_s -
                        std::copysign(0.5 * deceleration * braked_s * braked_s, rate[i]);
        }
        farthest_m =
            std::max(farthest_m, m_limits.box_m->exteriorDistance(m_chain->X_Base_Tip(place).translation()));
    }
    return farthest_m;
}

void MotionGovernor::limitBox(core::JointVector& rate, double dt_s, std::uint32_t& flags) const {
    if (!m_limits.box_m || !moves(rate))
        return;
    // The way to rest must lie in the box, or less far outside than the arm is now.
    const double now_m = m_limits.box_m->exteriorDistance(m_chain->X_Base_Tip(m_commanded).translation());
    const auto allowed = [&](double factor) {
        core::JointVector slower = rate;
        scale(slower, factor);
        const double then_m = outside_m(slower, dt_s);
        return then_m == 0.0 || then_m < now_m;
    };
    if (allowed(1.0))
        return;
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < 12; ++i) {
        const double middle = 0.5 * (low + high);
        (allowed(middle) ? low : high) = middle;
    }
    scale(rate, low);
    raise(flags, MotionFlag::workspace);
}

bool MotionGovernor::keepLeash(const core::JointVector& measured, double dt_s, std::uint32_t& flags) {
    bool lags = false;
    for (std::size_t i = 0; i < m_commanded.size(); ++i) {
        const double low = measured[i] - m_limits.leash_rad;
        const double high = measured[i] + m_limits.leash_rad;
        if (m_commanded[i] < low || m_commanded[i] > high) {
            m_commanded[i] = std::clamp(m_commanded[i], low, high);
            lags = true;
        }
    }
    if (lags)
        raise(flags, MotionFlag::leash);
    m_lagging_s = lags ? m_lagging_s + dt_s : 0.0;
    return m_lagging_s >= kFollowingTime_s;
}

} // namespace teleta::arm_model
