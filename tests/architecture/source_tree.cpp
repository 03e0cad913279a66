// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/architecture/source_tree.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace teleta::architecture {
namespace {

std::vector<std::string> readLines(std::istream& stream) {
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

} // namespace

std::vector<SourceFile> readFiles(const std::filesystem::path& root, const std::vector<std::string>& folders,
                                  const std::vector<std::string>& endings) {
    std::vector<SourceFile> files;
    for (const std::string& folder : folders) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
            const std::string path = entry.path().lexically_relative(root).generic_string();
            const bool wanted = std::any_of(endings.begin(), endings.end(), [&](const std::string& ending) {
                return path.ends_with(ending);
            });
            if (!entry.is_regular_file() || !wanted)
                continue;
            std::ifstream stream(entry.path());
            files.push_back({path, readLines(stream)});
        }
    }
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    return files;
}

std::vector<std::string> splitLines(const std::string& text) {
    std::istringstream stream(text);
    return readLines(stream);
}

std::string describe(const std::vector<Violation>& violations) {
    std::string text;
    for (const Violation& violation : violations)
        text += violation.path + ':' + std::to_string(violation.line) + ": " + violation.reason + '\n';
    return text;
}

} // namespace teleta::architecture
