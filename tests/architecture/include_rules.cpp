// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/architecture/include_rules.h"

#include <algorithm>
#include <regex>
#include <set>
#include <string_view>
#include <utility>

namespace teleta::architecture {
namespace {

/// Headers of the C++ standard library have neither dots nor capitals.
bool isStandard(std::string_view header) {
    return !header.empty() && std::ranges::all_of(header, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    });
}

} // namespace

QtModules readQtModules(const std::filesystem::path& qtIncludes) {
    QtModules modules;
    for (const auto& folder : std::filesystem::directory_iterator(qtIncludes)) {
        if (!folder.is_directory())
            continue;
        for (const auto& header : std::filesystem::directory_iterator(folder))
            modules.emplace(header.path().filename().string(), folder.path().filename().string());
    }
    return modules;
}

IncludeRules::IncludeRules(ModuleGraph graph, QtModules qtModules)
    : m_graph(std::move(graph))
    , m_qtModules(std::move(qtModules)) {
}

std::string IncludeRules::libraryOf(const std::string& header) const {
    for (const ModuleGraph::Library& library : m_graph.libraries) {
        for (const std::string& beginning : library.headers) {
            if (header.starts_with(beginning))
                return library.name;
        }
    }
    if (header.starts_with("Qt") && header.find('/') != std::string::npos)
        return header.substr(0, header.find('/'));
    const auto found = m_qtModules.find(header);
    return found == m_qtModules.end() ? std::string() : found->second;
}

std::vector<IncludeRules::Include> IncludeRules::includesOf(const SourceFile& file) const {
    static const std::regex include(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
    const std::string own = file.path.substr(0, file.path.rfind('/'));
    std::vector<Include> includes;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
        std::smatch match;
        if (!std::regex_match(file.lines[i], match, include))
            continue;
        const std::string header = match[2];
        Include found;
        found.line = static_cast<int>(i) + 1;
        found.isFolder = match[1] == "\"";
        if (found.isFolder) {
            const ModuleGraph::Folder* folder = m_graph.folderOf(header);
            if (header.ends_with(".moc"))
                continue;
            if (folder == nullptr)
                found.reason =
                    "\"" + header + "\" is not a path from the project root to a folder of the module graph";
            else if (folder->path != own)
                found.used = folder->path;
        } else if (!isStandard(header) || m_qtModules.contains(header)) {
            found.used = libraryOf(header);
            if (found.used.empty())
                found.reason = "<" + header + "> is of no library that the table lists";
        }
        includes.push_back(found);
    }
    return includes;
}

std::vector<Violation> IncludeRules::forbiddenIncludes(const SourceFile& file) const {
    const ModuleGraph::Folder* folder = m_graph.folderOf(file.path);
    if (folder == nullptr)
        return {{file.path, 0, "this folder has no row in the table of the module graph"}};
    std::vector<Violation> violations;
    for (const Include& include : includesOf(file)) {
        const std::vector<std::string>& allowed = include.isFolder ? folder->uses : folder->libraries;
        if (!include.reason.empty())
            violations.push_back({file.path, include.line, include.reason});
        else if (!include.used.empty() && std::ranges::find(allowed, include.used) == allowed.end())
            violations.push_back({file.path, include.line, folder->path + " must not use " + include.used});
    }
    return violations;
}

std::vector<Violation> IncludeRules::unusedEdges(const std::vector<SourceFile>& files) const {
    std::map<std::string, std::set<std::string>> used;
    for (const SourceFile& file : files) {
        for (const Include& include : includesOf(file))
            used[file.path.substr(0, file.path.rfind('/'))].insert(include.used);
    }
    std::vector<Violation> violations;
    for (const ModuleGraph::Folder& folder : m_graph.folders) {
        for (const std::vector<std::string>* row : {&folder.uses, &folder.libraries}) {
            for (const std::string& name : *row) {
                if (!used[folder.path].contains(name))
                    violations.push_back(
                        {folder.path, 0, "its row names " + name + ", which it does not include"});
            }
        }
    }
    return violations;
}

} // namespace teleta::architecture
