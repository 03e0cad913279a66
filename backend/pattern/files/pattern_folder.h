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
    std::string id;                         ///< of no other pattern of the folder and of no built-in one
    std::shared_ptr<const Pattern> pattern; ///< with this id; null: the file is damaged
    std::optional<core::Error> error;       ///< what is wrong with it
    std::int64_t modified_ms = 0;           ///< with the size: whether the file has to be read again
    std::int64_t size = 0;
    std::string idInFile;
};

/// The user's own patterns, a file each, in a folder. Files that cannot be read stay where they are and are
/// listed with the reason. What is deleted goes to a folder "deleted" below and can come back.
/// Of files with the same id the first in the order of their names keeps it, the id of the others gets the
/// name of their file behind it; an id of a built-in pattern is never taken.
/// Thread: any, one at a time.
class PatternFolder {
public:
    static constexpr std::size_t kMostFiles = 2000;

    explicit PatternFolder(std::string path);

    [[nodiscard]] const std::string& path() const { return m_path; }
    /// All pattern files, in the order of their names; the first kMostFiles of them. A folder that is not
    /// there has none. before: files that are in it and have not changed are not read again.
    [[nodiscard]] std::vector<StoredPattern> read(const std::vector<StoredPattern>& before = {}) const;

    /// A path in the folder for a pattern of this name, which no file has.
    [[nodiscard]] std::string freePath(const std::string& name) const;
    /// Writes a new file; makes the folder. Returns its path.
    [[nodiscard]] core::Expected<std::string> add(const Pattern& pattern) const;
    /// The same pattern once more with another id and name. Returns the path of the new file.
    [[nodiscard]] core::Expected<std::string> duplicate(const Pattern& pattern,
                                                        const std::string& name) const;
    /// Gives the pattern of a file in the program's own format another name. Error: refused: another format.
    [[nodiscard]] core::Expected<void> rename(const std::string& path, const std::string& name) const;
    /// Returns where the file is now, for restore().
    [[nodiscard]] core::Expected<std::string> remove(const std::string& path) const;
    /// Back to its path, or beside it when there is another file by now. Returns where it is.
    [[nodiscard]] core::Expected<std::string> restore(const std::string& removed,
                                                      const std::string& path) const;

private:
    std::string m_path;
};

/// An id that no other pattern has.
[[nodiscard]] std::string newPatternId();

} // namespace teleta::pattern
