// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/arm_model.h"
#include "backend/core/error.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace teleta::arm_model {

/// Largest URDF that is read.
inline constexpr std::size_t kLargestUrdf_bytes = std::size_t{16} << 20;

/// Reads a robot from the text of a URDF file, as /robot_description has it. Axes are normalised. A joint
/// that mimics one which itself mimics another follows the last of them. file: named in errors. Failure:
/// badInput, where possible with line and column: no well-formed XML, xacro that was not expanded, a floating
/// or planar joint, no tree, a number that is not finite or beyond 1e6, an axis of length 0, a lowest above
/// the highest position, a negative mass, a circle of mimic joints, more than kLargestUrdf_bytes. Thread:
/// any; one call at a time reads, others wait. Source: http://wiki.ros.org/urdf/XML
[[nodiscard]] core::Expected<ArmModel> parseUrdf(std::string_view text, const std::string& file);

/// The same from a file. Failure: also notFound, ioFailed.
[[nodiscard]] core::Expected<ArmModel> readUrdf(const std::string& path);

} // namespace teleta::arm_model
