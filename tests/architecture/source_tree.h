// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace teleta::architecture {

/// A text file of the source tree. path is relative to the root, with '/'.
struct SourceFile {
    std::string path;
    std::vector<std::string> lines;
};

/// A place in the tree that breaks a rule.
struct Violation {
    std::string path;
    int line = 0; ///< from 1; 0 when the file as a whole is meant
    std::string reason;

    bool operator==(const Violation&) const = default;
};

/// All files under the named folders of root whose name ends in one of the endings, sorted by path.
[[nodiscard]] std::vector<SourceFile> readFiles(const std::filesystem::path& root,
                                                const std::vector<std::string>& folders,
                                                const std::vector<std::string>& endings);

[[nodiscard]] std::vector<std::string> splitLines(const std::string& text);

/// "path:line: reason" for each, one a line.
[[nodiscard]] std::string describe(const std::vector<Violation>& violations);

} // namespace teleta::architecture
