// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/camera_calibration.h"

namespace teleta::vision {

/// Checks pairs before fitting; empty when they can determine a camera. Thread: any (pure).
[[nodiscard]] std::optional<CalibrationRefusal> degeneracy(std::span<const CalibrationPair> pairs);

} // namespace teleta::vision
