// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/simulation/array/rigid_indenter.h"

#include <Eigen/Geometry>

#include <optional>
#include <span>
#include <vector>

namespace teleta::simulation {

/// What one indenter does to the array, before any effect of the sensor.
struct IndenterLoad {
    double force_N = 0.0;
    std::optional<double> copX_m; ///< centre of pressure; empty without force
    std::optional<double> copY_m;
};

/// Contact of rigid bodies with an array of independent springs (a Winkler foundation).
///   force of a taxel = k / pitch^2 * integral over its area of the depth of the deepest body
/// The integral is a sum over 8 x 8 cells of the part of the taxel that bodies reach. The total force is
/// within 1 % of the closed form while a body is not deeper than its radius, and within 2 % beyond. What
/// reaches over the border of the array is not carried.
/// Thread: one.
class FoundationContact {
public:
    /// stiffness_NPerM of one taxel; > 0.
    FoundationContact(const core::ArrayLayout& layout, double stiffness_NPerM);

    /// load_N: layout.taxels() values, overwritten. loads: one an indenter, overwritten.
    void press(std::span<const RigidIndenter> indenters, std::span<double> load_N,
               std::span<IndenterLoad> loads);

private:
    void pressTaxel(std::span<const RigidIndenter> indenters, const Eigen::AlignedBox2d& taxel,
                    double& load_N);

    core::ArrayLayout m_layout;
    double m_stiffness_NPerM3;
    std::vector<std::size_t> m_reaching; ///< bodies that reach the taxel at hand
    std::vector<double> m_force_N;       ///< of each body, and its first moments
    std::vector<double> m_momentX_Nm;
    std::vector<double> m_momentY_Nm;
};

} // namespace teleta::simulation
