// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace teleta::study {

/// A file that one program at a time holds, by a lock of the kernel: whatever ends the program, at whatever
/// instant, ends the hold. The file names its holder and goes with the hold; what a killed program left
/// behind goes with the next one, or by removeUnheld(). Thread: any.
class FileClaim {
public:
    /// Empty when somebody has it, this program too. holder: written into the file. Error: ioFailed.
    [[nodiscard]] static core::Expected<std::unique_ptr<FileClaim>> take(const std::string& path,
                                                                         const std::string& holder);
    /// What its holder wrote into the file; empty when nobody holds it.
    [[nodiscard]] static std::optional<std::string> holderOf(const std::string& path);

    /// Removes the files of a folder whose names fit and that nobody holds.
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
