// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/simulation/arm/arm_program.h"
#include "backend/simulation/arm/smooth_move.h"

namespace teleta::simulation {

/// Touches something again and again:
///   travel to the clearance -> settle -> approach until a torque has changed by the limit, or the way is
///   used up -> hold -> back -> next probe
/// Where the probes are is the derived class's business: a probe is a way from its far end (position
/// -retract) through the clearance to the surface (position 0) and on.
class ProbingProgram : public ArmProgram {
public:
    struct Settings {
        double approachSpeed = 0.0; ///< of the position, units of the way a second
        double clearance = 0.0;
        double retract = 0.0;
        double beyond = 0.0; ///< the furthest position of an approach that meets nothing
        double torqueLimit_Nm = 0.0;
        double hold_s = 0.0;
        double travel_radPerS = 0.0; ///< of the fastest joint
        double travelSpeed = 0.0;    ///< of the position on the way back and forth
    };

    ProbingProgram(const Settings& settings, std::size_t probes);

    void advance(double step_s, const arm::JointVector& torque_Nm, arm::JointVector& reference_rad) override;
    void takeOver(const arm::JointVector& reference_rad) override;
    [[nodiscard]] bool done() const override { return m_probe >= m_probes; }
    void restart() override;

protected:
    [[nodiscard]] std::size_t probe() const { return m_probe; }
    /// References at a position of the current probe.
    [[nodiscard]] virtual arm::JointVector referenceAt(double position) const = 0;
    /// References on the way from where the arm is to the far end of the current probe; share 0 .. 1.
    [[nodiscard]] virtual arm::JointVector travelAt(const arm::JointVector& from_rad, double share) const;

private:
    enum class Phase { travel, close, settle, approach, hold, back };

    void begin(Phase phase);
    void beginTravel(const arm::JointVector& reference_rad);
    void beginMove(Phase phase, double to);
    /// True when the move has ended.
    [[nodiscard]] bool moveOn(double step_s, arm::JointVector& reference_rad);

    Settings m_settings;
    std::size_t m_probes;
    std::size_t m_probe = 0;
    Phase m_phase = Phase::travel;
    bool m_begun = false;
    double m_phaseTime_s = 0.0;
    double m_position = 0.0;
    double m_from = 0.0; ///< position at which a move began
    double m_to = 0.0;   ///< and at which it ends
    SmoothMove m_move;
    arm::JointVector m_from_rad = arm::JointVector::Zero();
    arm::JointVector m_free_Nm = arm::JointVector::Zero(); ///< torques before the approach
};

} // namespace teleta::simulation
