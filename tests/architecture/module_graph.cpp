// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/architecture/module_graph.h"

#include <algorithm>
#include <sstream>
#include <string_view>

namespace teleta::architecture {
namespace {

void appendWords(const std::string& text, std::vector<std::string>& words) {
    std::istringstream stream(text);
    for (std::string word; stream >> word;)
        words.push_back(word);
}

/// "widgets/touch/jog" -> "widgets/touch"; the first two parts of a path.
std::string familyOf(const std::string& path) {
    return path.substr(0, path.find('/', path.find('/') + 1));
}

bool lies(const std::string& path, std::string_view folder) {
    return path == folder || (path.starts_with(folder) && path.substr(folder.size()).starts_with('/'));
}

bool isLayered(const std::string& from, const std::string& to) {
    if (lies(to, "backend"))
        return true;
    if (lies(from, "devices"))
        return lies(to, "devices");
    if (lies(from, "widgets"))
        return familyOf(to) == "widgets/base" || familyOf(to) == "widgets/plot" ||
               (lies(to, "widgets") && familyOf(to) == familyOf(from));
    if (lies(from, "app/console"))
        return lies(to, "devices") || lies(to, "widgets") || lies(to, "app/common") ||
               lies(to, "app/sources") || lies(to, "app/console");
    if (lies(from, "app/sources"))
        return lies(to, "devices") || lies(to, "app/common");
    if (lies(from, "app/site"))
        return lies(to, "devices") || lies(to, "app/common") || lies(to, "app/sources") ||
               lies(to, "app/site");
    if (lies(from, "app/cli"))
        return lies(to, "devices") || lies(to, "app/common") || lies(to, "app/sources") ||
               lies(to, "app/cli");
    if (lies(from, "app/python"))
        return lies(to, "app/common") || lies(to, "app/python");
    return false;
}

} // namespace

const ModuleGraph::Folder* ModuleGraph::folderOf(const std::string& file) const {
    const std::string path = file.substr(0, file.rfind('/'));
    const auto found = std::ranges::find(folders, path, &Folder::path);
    return found == folders.end() ? nullptr : &*found;
}

std::vector<Violation> readModuleGraph(const SourceFile& table, ModuleGraph& graph) {
    std::vector<Violation> violations;
    for (std::size_t i = 0; i < table.lines.size(); ++i) {
        const std::string& line = table.lines[i];
        const auto rest = [&](std::string_view beginning) { return line.substr(beginning.size()); };
        const auto fail = [&](const std::string& reason) {
            violations.push_back({table.path, static_cast<int>(i) + 1, reason});
        };
        if (line.empty() || line.starts_with('#'))
            continue;
        if (line.starts_with("library ")) {
            graph.libraries.push_back({rest("library "), {}});
        } else if (line.starts_with("folder ")) {
            graph.folders.push_back({rest("folder "), {}, {}});
        } else if (line.starts_with("    headers ") && graph.folders.empty() && !graph.libraries.empty()) {
            appendWords(rest("    headers "), graph.libraries.back().headers);
        } else if (line.starts_with("    uses ") && !graph.folders.empty()) {
            appendWords(rest("    uses "), graph.folders.back().uses);
            for (const std::string& used : graph.folders.back().uses) {
                const auto isUsed = [&](const ModuleGraph::Folder& folder) { return folder.path == used; };
                if (std::none_of(graph.folders.begin(), graph.folders.end() - 1, isUsed))
                    fail(used + " has no row above");
            }
        } else if (line.starts_with("    libraries ") && !graph.folders.empty()) {
            appendWords(rest("    libraries "), graph.folders.back().libraries);
            for (const std::string& used : graph.folders.back().libraries) {
                if (std::ranges::find(graph.libraries, used, &ModuleGraph::Library::name) ==
                    graph.libraries.end())
                    fail(used + " is no library of the table");
            }
        } else if (!line.starts_with("    targets ")) {
            fail("not understood");
        }
    }
    return violations;
}

std::vector<Violation> againstTheLayers(const ModuleGraph& graph) {
    std::vector<Violation> violations;
    for (const ModuleGraph::Folder& folder : graph.folders) {
        for (const std::string& used : folder.uses) {
            if (!isLayered(folder.path, used))
                violations.push_back({folder.path, 0, "must not use " + used});
        }
    }
    return violations;
}

} // namespace teleta::architecture
