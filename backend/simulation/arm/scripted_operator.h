// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm/arm4_kinematics.h"
#include "backend/core/device/arm_device.h"
#include "backend/scene/arm_world.h"
#include "backend/simulation/arm/smooth_move.h"

#include <cstddef>
#include <optional>

namespace teleta::simulation {

/// The operator of scene::OperatorProgram: guides the hanging forearm through his explorations and turns back
/// when he feels a contact. He knows only what has come back to him:
///   rate = kGain (posture he wants - newest reference that he knows of)
/// For each touch: around the place to where it begins -> to clearance_m before where he met the object last
/// -> wait -> towards the place until a torque has
/// changed by feltTorque_Nm, or the place is reached -> on for reaction_s -> hold -> back. Thread: one.
class ScriptedOperator {
public:
    static constexpr double kGain_perS = 5.0;

    explicit ScriptedOperator(const scene::ArmWorld& world);

    /// What he asks of the joints in this step. seen: the newest sample that has come back; empty: none yet,
    /// then he waits.
    [[nodiscard]] core::JointVector rates_radPerS(double step_s,
                                                  const std::optional<core::JointSample>& seen);
    /// Starts the current touch again after somebody else has moved the arm.
    void takeOver() { m_begun = false; }
    [[nodiscard]] bool done() const { return m_exploration >= m_program.explorations.size(); }
    void restart();

private:
    enum class Phase { travel, near, settle, approach, react, hold, back };

    [[nodiscard]] const scene::Exploration& exploration() const {
        return m_program.explorations[m_exploration];
    }
    [[nodiscard]] double touchAngle_rad() const;
    [[nodiscard]] Eigen::Vector2d onWay_m(double distance_m) const;
    void begin(Phase phase);
    void beginTravel(const core::JointSample& seen);
    void advance(double step_s, const core::JointSample& seen);
    void nextTouch();
    void beginMove(Phase phase, double to_m);
    [[nodiscard]] bool moveOn(double step_s);
    [[nodiscard]] core::JointVector towards(const core::JointSample& seen) const;

    scene::OperatorProgram m_program;
    arm::Arm4Kinematics m_kinematics;
    core::JointVector m_fastest_radPerS;

    std::size_t m_exploration = 0;
    int m_touch = 0;
    Phase m_phase = Phase::travel;
    bool m_begun = false;
    double m_phaseTime_s = 0.0;
    SmoothMove m_move;
    Eigen::Vector2d m_wanted_m = Eigen::Vector2d::Zero(); ///< where he wants the elbow
    Eigen::Vector2d m_from_m = Eigen::Vector2d::Zero();
    double m_distance_m = 0.0; ///< of the elbow from the place, on the way of the touch
    double m_moveFrom_m = 0.0; ///< of it, where a move began
    double m_moveTo_m = 0.0;
    std::optional<double> m_met_m; ///< of it, where he met the object last
    core::JointVector m_free_Nm{};
};

} // namespace teleta::simulation
