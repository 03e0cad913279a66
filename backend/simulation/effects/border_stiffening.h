// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/scene/scene.h"

#include <vector>

namespace teleta::simulation {

/// The cover is held from the sides: the taxels along the border are stiffer by a share, those at the corners
/// twice that. One factor >= 1 a taxel. Source: servoing paper, appendix A.
[[nodiscard]] std::vector<double> borderStiffness(const scene::BorderStiffeningSpec& spec,
                                                  const core::ArrayLayout& layout);

} // namespace teleta::simulation
