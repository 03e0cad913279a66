// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/core/keys/keys.h"

#include <cstddef>
#include <string>
#include <vector>

namespace teleta::scene {

using core::Keys;
using core::Need;
using core::NumberRange;

inline constexpr NumberRange kAny = NumberRange::any();
inline constexpr NumberRange kPositive = NumberRange::positive();
inline constexpr NumberRange kNotNegative = NumberRange::notNegative();
inline constexpr NumberRange kShare = NumberRange::between(0.0, 1.0);

/// rows, columns and pitch_m.
void describeLayout(Keys& keys, core::ArrayLayout& layout);
/// full_scale_N and firing_threshold_N.
void describeReadings(Keys& keys, double& fullScale_N, double& firingThreshold_N);

/// Refuses time_s when it is not after the time before.
void refuseUnordered(Keys& keys, double before_s);

/// time_s of the i-th of some frames, which must be after that of the one before.
template <typename Frame>
void describeTime(Keys& keys, std::vector<Frame>& frames, std::size_t i) {
    keys.number("time_s", frames[i].time_s, NumberRange::notNegative(), "When, since the start");
    if (i > 0 && frames[i].time_s <= frames[i - 1].time_s)
        refuseUnordered(keys, frames[i - 1].time_s);
}

} // namespace teleta::scene
