// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/random_stream.h"
#include "backend/scene/scene.h"

#include <cstddef>
#include <vector>

namespace teleta::simulation {

/// The factors by which so many taxels read more or less than their load: exp(sd z), z normal.
[[nodiscard]] std::vector<double> gainFactors(const scene::GainSpreadSpec& spec, std::size_t taxels,
                                              core::RandomStream random);

} // namespace teleta::simulation
