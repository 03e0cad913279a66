// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/frames/arrays/array_file.h"

#include <memory>
#include <string>

namespace teleta::frames {

/// Opens an npy file: one array without a name. Error: badInput with the place, ioFailed. Thread: any.
[[nodiscard]] core::Expected<std::unique_ptr<ArrayFile>> openNpy(const std::string& path);

/// Opens an npz file: a zip archive of npy files, stored or deflated, whose names are those of the arrays.
/// Error: badInput when it is damaged or holds no array, ioFailed. Thread: any.
[[nodiscard]] core::Expected<std::unique_ptr<ArrayFile>> openNpz(const std::string& path);

} // namespace teleta::frames
