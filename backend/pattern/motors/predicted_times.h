// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/tactors.h"
#include "backend/pattern/model/pattern.h"
#include "backend/pattern/motors/motor_model.h"

#include <cstddef>
#include <functional>
#include <span>

namespace teleta::pattern {

/// What forEachPredictedSample() predicts, at any times, which do not decrease and are >= 0; also beyond the
/// pattern, where the motors run down. Between two times the model takes steps of its own, so that the values
/// differ from those at a fixed rate by the error of the step, below 1e-3. Ends when visit returns false.
/// profiles: valid(). Thread: any (pure).
void forEachPredictedTime(const Pattern& pattern, const MotorProfiles& profiles,
                          std::span<const double> times_s,
                          const std::function<bool(std::size_t index, const core::Intensities&)>& visit);

} // namespace teleta::pattern
