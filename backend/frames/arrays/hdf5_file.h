// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/frames/arrays/array_file.h"

#include <memory>
#include <string>

namespace teleta::frames {

/// Opens an HDF5 file: its datasets of numbers, by their paths without the first slash ("run1/frames"), with
/// the attributes unit, rate_hz and pitch_m. Stored as they are, or packed with gzip and shuffle; nothing
/// that lies in another file. libhdf5 is loaded by the call, and may end the process when a file is hostile:
/// call it in a process of its own (openApart). Error: badInput with what the library says. Thread: one.
[[nodiscard]] core::Expected<std::unique_ptr<ArrayFile>> openHdf5(const std::string& path);

} // namespace teleta::frames
