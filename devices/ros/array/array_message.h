// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/ros/messages.h"
#include "devices/ros/array/ros_array_file.h"

#include <span>

namespace teleta::ros_array {

// What a message says of an array, as loads in the unit of its file, row by row. Numbers that are not finite
// become NaN, which is a taxel that tells nothing. loads: file.layout.taxels() entries; unchanged on an
// error, badInput, which says in what the message does not fit the file. Thread: any (pure).

/// The sensor that the file names. Nothing of it in the message: false, and no error.
[[nodiscard]] core::Expected<bool> loadsOf(const ros::TactileState& message, const RosArrayFile& file,
                                           std::span<float> loads);
/// Without dimensions the numbers alone count; with them they are rows and columns, without gaps.
[[nodiscard]] core::Expected<bool> loadsOf(const ros::Float64MultiArray& message, const RosArrayFile& file,
                                           std::span<float> loads);
/// Encodings 32FC1, 16UC1 and mono16, 8UC1 and mono8, of either order of bytes.
[[nodiscard]] core::Expected<bool> loadsOf(const ros::Image& message, const RosArrayFile& file,
                                           std::span<float> loads);

} // namespace teleta::ros_array
