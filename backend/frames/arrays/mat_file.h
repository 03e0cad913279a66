// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/frames/arrays/array_file.h"

#include <memory>
#include <string>

namespace teleta::frames {

/// Opens a MAT file of MATLAB, version 4, 5 (also 6 and 7) or 7.3: its full arrays of real numbers, by name.
/// Which of their dimensions counts the frames is open. libmatio is loaded by the call, and may end the
/// process when a file is hostile: call it in a process of its own (openApart). Error: badInput, also for a
/// file that is cut off. Thread: one.
[[nodiscard]] core::Expected<std::unique_ptr<ArrayFile>> openMat(const std::string& path);

} // namespace teleta::frames
