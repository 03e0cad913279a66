// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/architecture/source_tree.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace teleta::architecture {

/// What each folder of the tree may use, read from the table by which the build links
/// (packaging/cmake/module_graph.txt, which explains its form).
struct ModuleGraph {
    struct Library {
        std::string name;
        std::vector<std::string> headers; ///< how the paths of its headers begin
    };
    struct Folder {
        std::string path; ///< "backend/core/data"
        std::vector<std::string> uses;
        std::vector<std::string> libraries;
    };

    std::vector<Library> libraries;
    std::vector<Folder> folders; ///< in the order of the table

    /// The row of the folder in which a file lies; null when it has none.
    [[nodiscard]] const Folder* folderOf(const std::string& file) const;
};

/// Lines that are not understood, and folders that are used without a row above.
[[nodiscard]] std::vector<Violation> readModuleGraph(const SourceFile& table, ModuleGraph& graph);

/// Edges that no table may have: up through the layers (backend, devices, widgets, app), from one family of
/// views to another, from the command line to widgets.
[[nodiscard]] std::vector<Violation> againstTheLayers(const ModuleGraph& graph);

} // namespace teleta::architecture
