// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/cost/ladder.h"

#include <vector>

namespace teleta::cost {

/// Stiffness of an object from the log of a touch: two points or all samples of the window, 2..1000 samples.
/// Touches are computed from the object's stiffness in closed form, with the noise of the paper's joint.
[[nodiscard]] Ladder stiffnessLadder();

/// Curve through contact points: approximating or interpolating, 8..360 noisy points of a circle, a rectangle
/// and a bent profile. Errors are the distances of points of the true outline from the curve.
[[nodiscard]] Ladder contourLadder();

/// Place of a ball that presses on an array, also over its border: centroid of the active taxels, centre of
/// pressure, summit of a paraboloid. Loads come from the foundation model.
[[nodiscard]] Ladder tactileFeaturesLadder();

/// All ladders in the order of their list.
[[nodiscard]] std::vector<Ladder> allLadders();

} // namespace teleta::cost
