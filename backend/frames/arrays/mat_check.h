// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <string>

namespace teleta::frames {

/// Whether a MAT file of version 5 is whole: its elements fill it to the end, and what is packed unpacks with
/// the right checksum. libmatio reads zeros where a file was cut off. Source: MathWorks, MAT-File Format,
/// "Level 5 MAT-File Format". Error: badInput, ioFailed. Thread: any.
[[nodiscard]] core::Expected<void> checkMat5(const std::string& path);

/// The same of version 4: headers of 20 bytes with the sizes of what follows ("Level 4 MAT-File Format").
[[nodiscard]] core::Expected<void> checkMat4(const std::string& path);

} // namespace teleta::frames
