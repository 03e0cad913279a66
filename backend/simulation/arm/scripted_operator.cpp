// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/arm/scripted_operator.h"

#include "backend/simulation/arm/hanging_posture.h"
#include "backend/simulation/base/arm_inertia.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::simulation {

namespace {

using arm::JointVector;
using Eigen::Vector2d;

/// Before a touch, until the arm no longer rings and what it tells has come back.
constexpr double kWait_s = 0.4;
/// In which an approach takes up its speed.
constexpr double kTakeUp_s = 0.2;
/// Nearer than this he has not been led away from the circle around the place.
constexpr double kOnCircle_m = 0.01;

Vector2d outwards(double angle_rad) {
    return {std::cos(angle_rad), std::sin(angle_rad)};
}

} // namespace

ScriptedOperator::ScriptedOperator(const scene::ArmWorld& world)
    : m_program(std::get<scene::OperatorProgram>(world.program))
    , m_kinematics(dimensionsOf(world.body))
    , m_fastest_radPerS(world.body.fastest_radPerS) {
}

void ScriptedOperator::restart() {
    m_exploration = 0;
    m_touch = 0;
    m_met_m.reset();
    m_begun = false;
}

double ScriptedOperator::touchAngle_rad() const {
    return exploration().startAngle_rad + 2.0 * std::numbers::pi * m_touch / exploration().touches;
}

Vector2d ScriptedOperator::onWay_m(double distance_m) const {
    return Vector2d(exploration().x_m, exploration().y_m) + distance_m * outwards(touchAngle_rad());
}

void ScriptedOperator::begin(Phase phase) {
    m_phase = phase;
    m_phaseTime_s = 0.0;
}

void ScriptedOperator::beginTravel(const core::JointSample& seen) {
    begin(Phase::travel);
    const JointVector reference_rad = Eigen::Map<const JointVector>(seen.reference_rad.data());
    if (!m_begun)
        m_wanted_m = elbowAt_m(m_kinematics, reference_rad);
    m_begun = true;
    m_from_m = m_wanted_m;
    m_distance_m = exploration().radius_m;
    // An arc is at most pi / 2 times as long as its chord.
    const double way_m = 0.5 * std::numbers::pi * (onWay_m(m_distance_m) - m_from_m).norm();
    m_move = SmoothMove::at(way_m, m_program.travel_mPerS);
}

core::JointVector ScriptedOperator::rates_radPerS(double step_s,
                                                  const std::optional<core::JointSample>& seen) {
    if (!seen || done())
        return core::JointVector::zeros(m_fastest_radPerS.size());
    if (!m_begun)
        beginTravel(*seen);
    advance(step_s, *seen);
    return towards(*seen);
}

void ScriptedOperator::advance(double step_s, const core::JointSample& seen) {
    m_phaseTime_s += step_s;
    switch (m_phase) {
    case Phase::travel: {
        const bool arrived = m_move.advance(step_s);
        const Vector2d place_m(exploration().x_m, exploration().y_m);
        const Vector2d from_m = m_from_m - place_m;
        const double radius_m = exploration().radius_m;
        if (std::abs(from_m.norm() - radius_m) < kOnCircle_m) {
            // Around the place, not through it.
            const double from_rad = std::atan2(from_m.y(), from_m.x());
            const double turn_rad = std::remainder(touchAngle_rad() - from_rad, 2.0 * std::numbers::pi);
            m_wanted_m = place_m + radius_m * outwards(from_rad + m_move.share() * turn_rad);
        } else {
            m_wanted_m = m_from_m + m_move.share() * (onWay_m(radius_m) - m_from_m);
        }
        if (arrived)
            beginMove(Phase::near, m_met_m ? std::min(radius_m, *m_met_m + m_program.clearance_m) : radius_m);
        break;
    }
    case Phase::near:
        if (moveOn(step_s))
            begin(Phase::settle);
        break;
    case Phase::settle:
        if (m_phaseTime_s >= kWait_s) {
            m_free_Nm = seen.torque_Nm;
            begin(Phase::approach);
        }
        break;
    case Phase::approach: {
        m_distance_m -= step_s * m_program.approach_mPerS * SmoothMove::shareAt(m_phaseTime_s, kTakeUp_s);
        double change_Nm = 0.0;
        for (std::size_t joint = 0; joint < seen.torque_Nm.size(); ++joint)
            change_Nm = std::max(change_Nm, std::abs(seen.torque_Nm[joint] - m_free_Nm[joint]));
        if (change_Nm >= m_program.feltTorque_Nm || m_distance_m <= 0.0) {
            m_met_m = m_distance_m;
            begin(Phase::react);
        }
        m_wanted_m = onWay_m(m_distance_m);
        break;
    }
    case Phase::react:
        m_distance_m = std::max(0.0, m_distance_m - step_s * m_program.approach_mPerS);
        m_wanted_m = onWay_m(m_distance_m);
        if (m_phaseTime_s >= m_program.reaction_s)
            begin(Phase::hold);
        break;
    case Phase::hold:
        if (m_phaseTime_s >= m_program.hold_s)
            beginMove(Phase::back, exploration().radius_m);
        break;
    case Phase::back:
        if (moveOn(step_s)) {
            nextTouch();
            if (!done())
                beginTravel(seen);
        }
        break;
    }
}

void ScriptedOperator::beginMove(Phase phase, double to_m) {
    begin(phase);
    m_moveFrom_m = m_distance_m;
    m_moveTo_m = to_m;
    m_move = SmoothMove::at(std::abs(m_moveTo_m - m_moveFrom_m), m_program.travel_mPerS);
}

bool ScriptedOperator::moveOn(double step_s) {
    const bool arrived = m_move.advance(step_s);
    m_distance_m = m_moveFrom_m + m_move.share() * (m_moveTo_m - m_moveFrom_m);
    m_wanted_m = onWay_m(m_distance_m);
    return arrived;
}

void ScriptedOperator::nextTouch() {
    if (++m_touch >= exploration().touches) {
        m_touch = 0;
        m_met_m.reset();
        ++m_exploration;
    }
}

core::JointVector ScriptedOperator::towards(const core::JointSample& seen) const {
    const JointVector wanted_rad = hangingPosture(m_kinematics.dimensions(), m_wanted_m);
    core::JointVector rates = core::JointVector::zeros(m_fastest_radPerS.size());
    double scale = 1.0;
    for (std::size_t joint = 0; joint < rates.size(); ++joint) {
        rates[joint] =
            kGain_perS * (wanted_rad[static_cast<Eigen::Index>(joint)] - seen.reference_rad[joint]);
        if (std::abs(rates[joint]) * scale > m_fastest_radPerS[joint])
            scale = m_fastest_radPerS[joint] / std::abs(rates[joint]);
    }
    for (double& rate : rates)
        rate *= scale;
    return rates;
}

} // namespace teleta::simulation
