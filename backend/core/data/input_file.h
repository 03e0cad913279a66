// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <cstddef>
#include <string>

namespace teleta::core {

/// The largest file that readFile() takes unless told otherwise: 64 MiB.
inline constexpr std::size_t kMostFileBytes = std::size_t{64} << 20U;

/// Checks that a path names a file, and nothing whose reading may never end: a pipe, a device. It opens
/// nothing, so that this process keeps its locks of the file. Error: notFound, badInput, ioFailed.
/// Thread: any.
[[nodiscard]] Expected<void> requireFile(const std::string& path);

/// Reads a whole file and never waits for a pipe or a device. Paths that begin with ":/" are resources of the
/// program. Error: as requireFile(); badInput when it is larger than most bytes. Thread: any.
[[nodiscard]] Expected<std::string> readFile(const std::string& path, std::size_t most = kMostFileBytes);

} // namespace teleta::core
