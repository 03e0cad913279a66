// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/recording/recording_types.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace teleta::recording {

/// Whether the pictures of a stream are in colour: each has the bytes of core::bytesOf().
[[nodiscard]] bool isColour(const StreamInfo& stream);

/// Whether the frames of an array are vectors, three values a taxel: "t0_x", "t0_y", "t0_z", "t1_x", ...
[[nodiscard]] bool isVectorArray(const StreamInfo& stream);

/// Kinds of value in a stream of joint samples: first all angles, then all torques, then all references.
inline constexpr std::size_t kJointKinds = 3;

/// The stream of an arm's joints, but for name, source and details.
[[nodiscard]] StreamInfo jointStream(double nominalRate_Hz, std::size_t joints);

/// The number of joints in a stream of joint samples; empty when it is none, or of no arm that can be.
[[nodiscard]] std::optional<std::size_t> jointsOf(const StreamInfo& stream);

/// A joint sample as the stream of an arm with so many joints has it; NaN: the sample does not tell it.
[[nodiscard]] std::vector<double> jointValues(const core::JointSample& sample, std::size_t joints);

/// The angles, torques and references of a joint sample, back from its stream. values: of a whole sample.
[[nodiscard]] core::JointSample jointSample(std::span<const double> values);

/// The columns of a stream of features, in order. loadUnit: of the loads; another one than N stands in the
/// names of what is made of them ("force_counts"). vectors: the array tells the shear as well.
[[nodiscard]] std::vector<Column> featureColumns(const std::string& loadUnit = "N", bool vectors = false);

/// The columns of a stream of touches, in order.
[[nodiscard]] const std::vector<Column>& touchColumns();

/// The columns of a stream of camera contacts, in order.
[[nodiscard]] const std::vector<Column>& contactColumns();

/// The columns of a stream of contacts on a flat gel, in order.
[[nodiscard]] const std::vector<Column>& gelContactColumns();

/// The columns of a stream with the temperatures of so many chips.
[[nodiscard]] std::vector<Column> temperatureColumns(std::size_t chips);

/// The columns of a stream of forces and torques, in order.
[[nodiscard]] const std::vector<Column>& wrenchColumns();

/// Words for the numbers in a stream of features: none, point, edge.
inline constexpr std::array<const char*, 3> kContactTypes{"none", "point", "edge"};

} // namespace teleta::recording
