// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace teleta::core {

/// A path that stands in a file, from the folder of that file; one that starts at the root stays as it is.
/// Thread: any.
[[nodiscard]] std::string besideFile(const std::string& file, const std::string& path);

} // namespace teleta::core
