// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <string>

namespace teleta::cli {

/// Watches the arm of a file and prints what was found: a row a finding. Error: those of the file; refused,
/// the arm cannot be moved. Thread: one; it waits for some seconds.
[[nodiscard]] core::Expected<void> reportArmCheck(const std::string& path, bool json);

} // namespace teleta::cli
