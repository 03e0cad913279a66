// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/shape_models.h"

#include <array>
#include <cstddef>

namespace teleta::contour {

/// The explanations of a contour, weighed: log posterior of each model up to a constant, -infinity for a
/// model that explains nothing.
using ModelWeights = std::array<double, kModels>;

/// Weighs the explanations of a contour of so many points:
///   w_M = t(n) log E_M + a_M + b_M log(n/12) + log(share of the whole or of the part)
/// E_M: sum of the evidence of the model's explanations; n: number of points, 4 to 60 at most and least. t is
/// under 1 for few points, whose exact fits prove little, and for many, whose deviations are not independent.
/// A circle of which the share g was left out is an arc with probability logistic((g - g0) / (s + r/n)), a
/// triangle or rectangle likewise only a part, and more so when an edge has no point. All constants were
/// fitted together, by the largest likelihood of the right answer, to random contours (see README.md).
/// Thread: any (pure).
[[nodiscard]] ModelWeights weigh(const Explanations& explanations, std::size_t points);

} // namespace teleta::contour
