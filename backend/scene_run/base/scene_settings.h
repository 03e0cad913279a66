// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_snapshot.h"
#include "backend/scene/scene.h"

namespace teleta::scene_run {

/// How the frames of a scene's taxels are processed, in the console as in a run. Thresholds:
///   array       the sensor's firing threshold, or the default
///   arm's skin  the largest of its firing threshold, three standard deviations of its noise, and 5 mN: a
///               touch is evaluated at 0.3 N, spread over several taxels
/// On a skin, fewer than four taxels that fire together are noise, and so is the load of those that do not.
[[nodiscard]] pipeline::ChannelSettings channelSettings(const scene::Scene& scene);

} // namespace teleta::scene_run
