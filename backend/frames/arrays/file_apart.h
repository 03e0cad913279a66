// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/frames/arrays/array_file.h"

#include <memory>
#include <string>

namespace teleta::frames {

/// How a file is opened in a process of its own.
using OpenArrays = core::Expected<std::unique_ptr<ArrayFile>> (*)(const std::string& path);

/// Opens a file of arrays in processes of their own (fork), whose memory and time are limited: a library that
/// a hostile file ends, or that wants too much, gives an error here, and what it prints is not seen. The
/// libraries are loaded there only. Error: as open; badInput when such a process ends or is silent for two
/// minutes; ioFailed when there is none. Thread: one at a time.
[[nodiscard]] core::Expected<std::unique_ptr<ArrayFile>> openApart(const std::string& path, OpenArrays open);

} // namespace teleta::frames
