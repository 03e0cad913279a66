// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/model/pattern.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace teleta::pattern {

/// One file of a folder of patterns.
struct StoredPattern {
    std::string path;
    std::string id;                         ///< unique in the folder and different from all built-in ids
    std::shared_ptr<const Pattern> pattern; ///< pattern with this id; null: the file is damaged
    std::optional<core::Error> error;       ///< what is wrong with it
    std::int64_t modified_ms = 0;           ///< with the size it tells whether the file has to be read again
    std::int64_t size = 0;
    std::string idInFile;
};

/// A folder with the user's own patterns, one per file. Files that cannot be read are kept and listed with
/// the reason. Deleted files are moved to the subfolder "deleted" and can be restored. Of several files with
/// the same id the first by name keeps it; the name of the file is appended to the id of the others. The ids
/// of built-in patterns are never used. Thread: any, one at a time.
class PatternFolder {
public:
    static constexpr std::size_t kMostFiles = 2000;

    explicit PatternFolder(std::string path);

    [[nodiscard]] const std::string& path() const { return m_path; }
    /// Reads all pattern files sorted by name, at most kMostFiles; none when the folder does not exist.
    /// before: the result of an earlier call; unchanged files are not read again.
    [[nodiscard]] std::vector<StoredPattern> read(const std::vector<StoredPattern>& before = {}) const;

    /// An unused path in the folder for a pattern of this name.
    [[nodiscard]] std::string freePath(const std::string& name) const;
    /// Writes a new file and returns its path; creates the folder.
    [[nodiscard]] core::Expected<std::string> add(const Pattern& pattern) const;
    /// Writes a copy with a new id and another name. Returns the path of the new file.
    [[nodiscard]] core::Expected<std::string> duplicate(const Pattern& pattern,
                                                        const std::string& name) const;
    /// Changes the name of the pattern in a file. Error: refused: the file is not in the program's own
    /// format.
    [[nodiscard]] core::Expected<void> rename(const std::string& path, const std::string& name) const;
    /// Deletes a file; returns its new path for restore().
    [[nodiscard]] core::Expected<std::string> remove(const std::string& path) const;
    /// Moves a deleted file back to its path, or to a similar one if that is taken. Returns its path.
    [[nodiscard]] core::Expected<std::string> restore(const std::string& removed,
                                                      const std::string& path) const;

private:
    std::string m_path;
};

/// A new unique id.
[[nodiscard]] std::string newPatternId();

} // namespace teleta::pattern
