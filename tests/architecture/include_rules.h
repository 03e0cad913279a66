// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/architecture/source_tree.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace teleta::architecture {

/// Which module of Qt a header belongs to: "QString" -> "QtCore".
using QtModules = std::map<std::string, std::string, std::less<>>;

/// Reads the folder that holds QtCore, QtGui, ... Headers that two modules share count for the one named
/// first.
[[nodiscard]] QtModules readQtModules(const std::filesystem::path& qtIncludes);

/// The folder of the module graph that a path lies in ("backend/core"), empty when no rule names it.
[[nodiscard]] std::string moduleOf(const std::string& path);

/// Every #include of the file that the module graph does not allow.
[[nodiscard]] std::vector<Violation> forbiddenIncludes(const SourceFile& file, const QtModules& qtModules);

} // namespace teleta::architecture
