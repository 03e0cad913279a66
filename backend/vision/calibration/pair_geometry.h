// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/camera_calibration.h"

namespace teleta::vision {

/// What is wrong with pairs before anything is fitted; empty: nothing.
[[nodiscard]] std::optional<CalibrationRefusal> degeneracy(std::span<const CalibrationPair> pairs);

} // namespace teleta::vision
