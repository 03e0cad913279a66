// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace teleta::study {

/// A lock file that one program at a time holds, by a kernel lock: the lock ends with the program, however it
/// ends. The file names its holder and is removed with the lock; the file of a killed program is removed by
/// the next holder or by removeUnheld(). Thread: any.
class FileClaim {
public:
    /// Empty when somebody holds it, even this program. holder: written into the file. Error: ioFailed.
    [[nodiscard]] static core::Expected<std::unique_ptr<FileClaim>> take(const std::string& path,
                                                                         const std::string& holder);
    /// The text of its holder; empty when nobody holds it.
    [[nodiscard]] static std::optional<std::string> holderOf(const std::string& path);

    /// Removes the matching files of a folder that nobody holds.
    static void removeUnheld(const std::string& folder, const char* namePattern);

    ~FileClaim();
    FileClaim(const FileClaim&) = delete;
    FileClaim& operator=(const FileClaim&) = delete;

private:
    FileClaim(int descriptor, std::string path)
        : m_descriptor(descriptor)
        , m_path(std::move(path)) {}
    int m_descriptor;
    std::string m_path;
};

} // namespace teleta::study
