// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/recording/recording_types.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace teleta::recording {

/// Values of a joint sample: angles, torques, references.
inline constexpr std::size_t kJointValues = 3 * core::kArmJoints;

/// The stream of an arm's joints, without name, source and details.
[[nodiscard]] StreamInfo jointStream(double nominalRate_Hz);

/// A joint sample as recorded in its stream.
[[nodiscard]] std::array<double, kJointValues> jointValues(const core::JointSample& sample);

/// The columns of a stream of features, in order.
[[nodiscard]] const std::vector<Column>& featureColumns();

/// The columns of a stream of touches, in order.
[[nodiscard]] const std::vector<Column>& touchColumns();

/// The columns of a stream of camera contacts, in order.
[[nodiscard]] const std::vector<Column>& contactColumns();

/// Words for the numbers in a stream of features: none, point, edge.
inline constexpr std::array<const char*, 3> kContactTypes{"none", "point", "edge"};

} // namespace teleta::recording
