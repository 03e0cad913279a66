// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/architecture/module_graph.h"
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

/// Checks every #include against the module graph, and the graph against the includes.
class IncludeRules {
public:
    IncludeRules(ModuleGraph graph, QtModules qtModules);

    /// Every #include of the file that the graph does not allow.
    [[nodiscard]] std::vector<Violation> forbiddenIncludes(const SourceFile& file) const;

    /// Folders and libraries that a row names although no file of the folder includes one of their headers.
    [[nodiscard]] std::vector<Violation> unusedEdges(const std::vector<SourceFile>& files) const;

private:
    struct Include {
        int line = 0;
        std::string used;   ///< a folder or a library; empty for the standard library and the own folder
        std::string reason; ///< why nothing of the graph is named; empty otherwise
        bool isFolder = false;
    };

    [[nodiscard]] std::vector<Include> includesOf(const SourceFile& file) const;
    [[nodiscard]] std::string libraryOf(const std::string& header) const;

    ModuleGraph m_graph;
    QtModules m_qtModules;
};

} // namespace teleta::architecture
