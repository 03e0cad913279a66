// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <string>
#include <vector>

namespace teleta::study {

/// Names of the files and folders that an analysis writes about people into a folder.
[[nodiscard]] const std::vector<std::string>& resultFiles();

/// Opens what was written of a study to others, as far as the person's umask does: the named files and
/// folders in a folder, with all that is in them, and the way to them. Names that are not there are passed
/// over. Files that are written again later stay open. Error: ioFailed. Thread: any.
[[nodiscard]] core::Expected<void> shareFiles(const std::string& folder,
                                              const std::vector<std::string>& names);

} // namespace teleta::study
