// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/arm_world.h"

#include <cstdint>
#include <vector>

namespace teleta::simulation {

/// The objects of a world where this seed puts them; their order stays. Draws no number when nothing is
/// unknown. Thread: any (pure).
[[nodiscard]] std::vector<scene::ArmObject> drawPlaces(const scene::ArmWorld& world, std::uint64_t seed);

} // namespace teleta::simulation
