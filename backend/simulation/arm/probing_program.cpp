// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/arm/probing_program.h"

#include <algorithm>
#include <cmath>

namespace teleta::simulation {

namespace {

using arm::JointVector;

/// After a move, until the arm no longer rings.
constexpr double kSettle_s = 0.3;
/// In which an approach takes up its speed.
constexpr double kSpeedUp_s = 0.2;

} // namespace

ProbingProgram::ProbingProgram(const Settings& settings, std::size_t probes)
    : m_settings(settings)
    , m_probes(probes) {
}

JointVector ProbingProgram::travelAt(const JointVector& from_rad, double share) const {
    return from_rad + share * (referenceAt(-m_settings.retract) - from_rad);
}

void ProbingProgram::begin(Phase phase) {
    m_phase = phase;
    m_phaseTime_s = 0.0;
}

void ProbingProgram::beginTravel(const JointVector& reference_rad) {
    begin(Phase::travel);
    m_from_rad = reference_rad;
    // Long enough for the fastest joint on any way between the ends.
    double way_rad = 0.0;
    constexpr int kSamples = 16;
    JointVector before_rad = reference_rad;
    for (int i = 1; i <= kSamples; ++i) {
        const JointVector at_rad = travelAt(m_from_rad, static_cast<double>(i) / kSamples);
        way_rad = std::max(way_rad, kSamples * (at_rad - before_rad).lpNorm<Eigen::Infinity>());
        before_rad = at_rad;
    }
    m_position = -m_settings.retract;
    m_move = SmoothMove::at(way_rad, m_settings.travel_radPerS);
}

void ProbingProgram::beginMove(Phase phase, double to) {
    begin(phase);
    m_from = m_position;
    m_to = to;
    m_move = SmoothMove::at(std::abs(m_to - m_from), m_settings.travelSpeed);
}

bool ProbingProgram::moveOn(double step_s, JointVector& reference_rad) {
    const bool arrived = m_move.advance(step_s);
    m_position = m_from + m_move.share() * (m_to - m_from);
    reference_rad = referenceAt(m_position);
    return arrived;
}

void ProbingProgram::advance(double step_s, const JointVector& torque_Nm, JointVector& reference_rad) {
    if (done())
        return;
    if (!m_begun) {
        m_begun = true;
        beginTravel(reference_rad);
    }
    m_phaseTime_s += step_s;
    switch (m_phase) {
    case Phase::travel: {
        const bool arrived = m_move.advance(step_s);
        reference_rad = travelAt(m_from_rad, m_move.share());
        if (arrived)
            beginMove(Phase::close, -m_settings.clearance);
        break;
    }
    case Phase::close:
        if (moveOn(step_s, reference_rad))
            begin(Phase::settle);
        break;
    case Phase::settle:
        if (m_phaseTime_s >= kSettle_s) {
            m_free_Nm = torque_Nm;
            begin(Phase::approach);
        }
        break;
    case Phase::approach: {
        const double speedShare = SmoothMove::shareAt(m_phaseTime_s, kSpeedUp_s);
        m_position += step_s * m_settings.approachSpeed * speedShare;
        reference_rad = referenceAt(m_position);
        const double change_Nm = (torque_Nm - m_free_Nm).lpNorm<Eigen::Infinity>();
        if (change_Nm >= m_settings.torqueLimit_Nm || m_position >= m_settings.beyond)
            begin(Phase::hold);
        break;
    }
    case Phase::hold:
        if (m_phaseTime_s >= m_settings.hold_s)
            beginMove(Phase::back, -m_settings.retract);
        break;
    case Phase::back:
        if (moveOn(step_s, reference_rad)) {
            ++m_probe;
            if (!done())
                beginTravel(reference_rad);
        }
        break;
    }
}

void ProbingProgram::takeOver(const JointVector& reference_rad) {
    if (!done() && m_begun)
        beginTravel(reference_rad);
}

void ProbingProgram::restart() {
    m_probe = 0;
    m_begun = false;
    m_phase = Phase::travel;
    m_phaseTime_s = m_position = m_from = 0.0;
}

} // namespace teleta::simulation
