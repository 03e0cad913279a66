// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/servo_world.h"
#include "backend/simulation/servo/impedance_arm.h"
#include "backend/simulation/servo/lwr_inertia.h"

#include <Eigen/Geometry>

#include <memory>
#include <mujoco/mujoco.h>

namespace teleta::benchmarks {

/// MuJoCo with the arm of a servo scene: our joints, masses, spring in space and damping, a box with a touch
/// sensor for each taxel in its hand, and a capsule in the place of the straight bar, without friction as in
/// the scene. It starts in the posture that the arm has and is held to the same reference. The stiffness of
/// its contact is MuJoCo's own. A model that MuJoCo refuses ends the program with its reason. Thread: one.
class ServoInMujoco {
public:
    /// arm: touching the bar.
    ServoInMujoco(const simulation::ImpedanceArm& arm, const scene::BarShape& bar,
                  const simulation::Impedance& impedance);

    /// 1 ms.
    void step();
    [[nodiscard]] double force_N() const; ///< of all taxels
    [[nodiscard]] int pressedTaxels() const;
    /// Largest difference of an entry of its mass matrix from ours, kg m^2.
    [[nodiscard]] double massDifference_kgm2() const { return m_massDifference_kgm2; }

private:
    struct Delete {
        void operator()(mjModel* model) const { mj_deleteModel(model); }
        void operator()(mjData* data) const { mj_deleteData(data); }
    };
    Eigen::Isometry3d m_X_Base_Reference;
    servo::Vector6 m_stiffness;
    simulation::LwrMatrix m_damping;
    double m_massDifference_kgm2 = 0.0;
    std::unique_ptr<mjModel, Delete> m_model;
    std::unique_ptr<mjData, Delete> m_data;
};

} // namespace teleta::benchmarks
