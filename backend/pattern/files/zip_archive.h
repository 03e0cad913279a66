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
inline constexpr std::size_t kMostZipBytes = 64U << 20U; ///< of all entries together, unpacked

/// Reads all files of a zip archive that is in memory, in the archive's order; folders are left out.
/// file: for errors. Error: badInput: no zip archive, damaged (checksums are checked), encrypted, or larger
/// than the limits, which a small archive of huge content does not pass either.
[[nodiscard]] core::Expected<std::vector<ZipEntry>> readZip(const std::string& bytes,
                                                            const std::string& file);

/// The bytes of a zip archive with these entries; the same entries give the same bytes.
[[nodiscard]] core::Expected<std::string> writeZip(const std::vector<ZipEntry>& entries);

} // namespace teleta::pattern
