// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"
#include "backend/simulation/base/joint_effect.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace teleta::simulation {

/// The effects on joint readings that a valid scene of an arm lists, and no others, in the order in which
/// they act: gravity_error, gear_ripple, torque_noise, encoder_quantization.
[[nodiscard]] std::vector<std::unique_ptr<JointEffect>> makeJointEffects(const scene::Scene& scene,
                                                                         std::uint64_t seed);

} // namespace teleta::simulation
