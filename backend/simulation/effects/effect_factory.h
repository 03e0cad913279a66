// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"
#include "backend/simulation/base/effect.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace teleta::simulation {

/// The effects on taxels that a valid scene lists, and no others, in the order in which they act:
/// crosstalk, hysteresis; nonlinear_response, drift, noise, saturation, quantization, dead_taxels,
/// latency.
[[nodiscard]] std::vector<std::unique_ptr<Effect>> makeEffects(const scene::Scene& scene, double frameRate_Hz,
                                                               std::uint64_t seed);

} // namespace teleta::simulation
