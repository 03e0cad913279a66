// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_snapshot.h"
#include "backend/scene/scene.h"

namespace teleta::scene_run {

/// How the frames of a scene's taxels are to be processed, in the console as in a run.
///   array      the sensor's firing threshold, or the default one
///   arm's skin its firing threshold, three standard deviations of its noise, or 5 mN, whichever is largest:
///   a
///              touch is evaluated at 0.3 N, spread over several taxels. Fewer than four taxels that fire
///              together are noise, and so is the load of the taxels that do not fire.
[[nodiscard]] pipeline::ChannelSettings channelSettings(const scene::Scene& scene);

} // namespace teleta::scene_run
