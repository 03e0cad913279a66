// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/fuzz_check.h"
#include "tests/fuzz/fuzz_targets.h"

#include <string>
#include <sys/mman.h>
#include <unistd.h>

namespace teleta::fuzz {

/// A regular file in memory, for readers that take a path.
class MemoryFile {
public:
    explicit MemoryFile(Bytes bytes)
        : m_file(memfd_create("input", MFD_CLOEXEC)) {
        require(m_file >= 0, "there is a file in memory");
        for (std::size_t done = 0; done < bytes.size();) {
            const ssize_t count = ::write(m_file, bytes.data() + done, bytes.size() - done);
            require(count > 0, "the file in memory takes all bytes");
            done += static_cast<std::size_t>(count);
        }
    }
    ~MemoryFile() { ::close(m_file); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(m_file); }

private:
    int m_file;
};

} // namespace teleta::fuzz
