// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <cstddef>
#include <string>
#include <vector>

namespace teleta::pattern {

struct ZipEntry {
    std::string name;
    std::string content;
};

inline constexpr std::size_t kMostZipEntries = 64;
inline constexpr std::size_t kMostZipBytes = 64U << 20U; ///< total unpacked size

/// Reads all files of a zip archive in memory, in the order of the archive; folders are skipped. file: for
/// errors. Error: badInput: not a zip archive, damaged (checksums are verified), encrypted, or larger than
/// the limits, which apply to the unpacked content. Thread: any (pure).
[[nodiscard]] core::Expected<std::vector<ZipEntry>> readZip(const std::string& bytes,
                                                            const std::string& file);

/// Returns the bytes of a zip archive with these entries; equal entries give equal bytes. Error: ioFailed.
/// Thread: any (pure).
[[nodiscard]] core::Expected<std::string> writeZip(const std::vector<ZipEntry>& entries);

} // namespace teleta::pattern
