// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <memory>
#include <optional>
#include <string>

namespace teleta::study {

/// A file that one program at a time holds, by a lock of the kernel: whatever ends the program, at whatever
/// instant, ends the hold. The file stays and names its last holder. Thread: any.
class FileClaim {
public:
    /// Empty when somebody has it, this program too. holder: written into the file. Error: ioFailed.
    [[nodiscard]] static core::Expected<std::unique_ptr<FileClaim>> take(const std::string& path,
                                                                         const std::string& holder);
    /// What its holder wrote into the file; empty when nobody holds it.
    [[nodiscard]] static std::optional<std::string> holderOf(const std::string& path);

    ~FileClaim();
    FileClaim(const FileClaim&) = delete;
    FileClaim& operator=(const FileClaim&) = delete;

private:
    explicit FileClaim(int descriptor)
        : m_descriptor(descriptor) {}
    int m_descriptor;
};

} // namespace teleta::study
