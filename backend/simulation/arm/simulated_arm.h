// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/error.h"
#include "backend/scene/scene.h"
#include "backend/simulation/arm/arm_program.h"
#include "backend/simulation/arm/flexible_arm.h"
#include "backend/simulation/arm/skin_sheet.h"
#include "backend/simulation/base/joint_effect.h"
#include "backend/simulation/effects/effect_chain.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace teleta::simulation {

/// An object as the world knows it.
struct ArmObjectTruth {
    std::string name; ///< what it is made of, or what it is
    double stiffness_NPerM = 0.0;
    scene::Outline shape;
    OutlineGeometry outline;
};

/// One object's contact with the forearm, as it truly is.
struct ArmContactTruth {
    std::size_t object = 0;
    double force_N = 0.0;
    double depth_m = 0.0;
    double contactDistance_m = 0.0;                             ///< P_C, from the elbow along the forearm
    double side_rad = 0.0;                                      ///< as in arm::Arm4Kinematics::p_Link_Skin
    Eigen::Vector3d p_Base_Contact_m = Eigen::Vector3d::Zero(); ///< point of the skin
    Eigen::Vector3d normal = Eigen::Vector3d::UnitX(); ///< from the object to the forearm, in the base
};

/// A touch from its first to its last contact.
struct ArmTouchTruth {
    std::size_t object = 0;
    double begin_s = 0.0;
    std::optional<double> end_s; ///< empty while it lasts
    ArmContactTruth strongest;   ///< the contact at the highest force so far
};

/// What the simulated world knows after the newest step and no estimator may see.
struct ArmTruth {
    std::vector<ArmContactTruth> contacts; ///< with force, now
    std::vector<ArmTouchTruth> touches;    ///< all since the start, in the order in which they began
    std::vector<bool> present;             ///< a flag an object
    arm::JointVector link_rad = arm::JointVector::Zero();  ///< angles of the links, behind the springs
    arm::JointVector torque_Nm = arm::JointVector::Zero(); ///< of the joints, without any effect
};

/// The arm of a scene, among the scene's objects. One joint sample a call:
///   program or jog -> references -> FlexibleArm -> joint effects (gravity error, ripple, noise, encoder)
///   -> every few samples the skin: contact loads -> skin effects -> firing threshold -> read-out effects
/// The torque of a sample is what the joint presses on its link: positive when the joint pushes an object
/// that stops it from turning on, so angle and torque grow together, and J^T F with the force F of the arm on
/// the object. The angle is the motor's. Only effects that the scene lists exist. Deterministic: same scene,
/// seed and demands, same samples. Thread: one.
class SimulatedArm : public core::ArmGenerator {
public:
    /// Error: badInput when the scene is not valid or not of an arm (scene::checkArmScene).
    [[nodiscard]] static core::Expected<std::unique_ptr<SimulatedArm>> make(const scene::Scene& scene,
                                                                            std::uint64_t seed);

    [[nodiscard]] core::ArmDescription description() const override { return m_description; }
    [[nodiscard]] core::SourceDescription skinDescription() const override { return m_skinDescription; }
    void next(const core::ArmDemand& demand, core::JointSample& sample) override;
    bool skinFrame(std::span<float> values) override;
    [[nodiscard]] double time_s() const override;
    [[nodiscard]] bool programDone() const override { return m_program->done(); }
    void restart() override;
    [[nodiscard]] std::uint64_t presentObjects() const override;

    [[nodiscard]] const ArmTruth& truth() const { return m_truth; }
    [[nodiscard]] const std::vector<ArmObjectTruth>& objects() const { return m_objects; }
    /// Distance of a point from an object's true outline, in the x-y plane of the base; negative inside.
    [[nodiscard]] double outlineDistance_m(std::size_t object, const Eigen::Vector2d& p_Base_Point_m) const;
    [[nodiscard]] std::vector<EffectTime> effectTimes() const;

private:
    SimulatedArm(const scene::Scene& scene, std::uint64_t seed);
    void moveReference(const core::ArmDemand& demand);
    void jog(const core::JointVector& rate_radPerS);
    void updatePresence();
    void updateTruth();
    void readSkin();

    scene::ArmBody m_body;
    core::ArmDescription m_description;
    core::SourceDescription m_skinDescription;
    double m_step_s;
    double m_firingThreshold_N;
    std::uint64_t m_samplesPerFrame;
    std::vector<ArmObjectTruth> m_objects;
    FlexibleArm m_arm;
    std::unique_ptr<ArmProgram> m_program;
    SkinSheet m_sheet;
    TimedEffects<JointEffect> m_jointEffects;
    EffectChain m_skinEffects;
    bool m_nonlinearObjects = false;

    arm::JointVector m_reference_rad = arm::JointVector::Zero();
    arm::JointVector m_reading_Nm = arm::JointVector::Zero();
    bool m_programLeft = false; ///< somebody else has moved the references since the program did
    std::uint64_t m_sample = 0;
    bool m_frameDue = false;
    std::vector<double> m_load_N;
    std::vector<std::ptrdiff_t> m_openTouch; ///< index of each object's touch that lasts; -1: none
    ArmTruth m_truth;
};

} // namespace teleta::simulation
