// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/ros/array/ros_array_file.h"
#include "devices/taxels/taxels_file.h"

#include <string>
#include <string_view>
#include <variant>

namespace teleta::app {

/// A file that describes an array: one with a link of its own, or one over ROS 2.
using ArrayFile = std::variant<taxels::TaxelsFile, ros_array::RosArrayFile>;

/// Whether a file of this kind describes an array.
[[nodiscard]] bool isArrayFileKind(std::string_view kind);

/// Error: as taxels::readTaxels(), which also refuses a file of any other kind. Thread: any but the GUI's.
[[nodiscard]] core::Expected<ArrayFile> readArrayFile(const std::string& path);

} // namespace teleta::app
