// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <memory>
#include <string>
#include <string_view>

class QFileDevice;

namespace teleta::core {

/// Where a program writes text: a file that appears under its name only when it is complete, or standard
/// output.
/// A file is written without a name (or under a temporary one); finish() makes it durable and gives it its
/// name. Without finish() it vanishes and an older file of that name stays as it was. What is not a regular
/// file (a pipe, /dev/null) is written to directly.
/// The first error is kept and reported by finish(): ioFailed, or cancelled when the reader of a pipe went
/// away.
/// Thread: one.
class OutputFile {
public:
    [[nodiscard]] static Expected<OutputFile> create(const std::string& path);
    [[nodiscard]] static OutputFile standardOutput();

    ~OutputFile();
    OutputFile(OutputFile&&) noexcept;
    OutputFile& operator=(OutputFile&&) noexcept;

    /// Appends to a buffer that is written out when it is full.
    void write(std::string_view text) {
        m_buffer.append(text);
        if (m_buffer.size() >= kFlushAt)
            flush();
    }

    /// Writes the buffer out, for a reader who waits at the other end of a pipe.
    void flush();

    [[nodiscard]] bool failed() const { return !m_state; }

    /// Writes the rest and completes the file; nothing may be written after it.
    [[nodiscard]] Expected<void> finish();

private:
    static constexpr std::size_t kFlushAt = 64U << 10U;

    OutputFile(std::unique_ptr<QFileDevice> device, std::string name);
    void keepError();

    std::unique_ptr<QFileDevice> m_device;
    std::string m_name; ///< for errors
    std::string m_buffer;
    Expected<void> m_state;
};

/// Makes names that were given or taken in a folder last through a power cut; a file's own bytes are synced
/// apart from that. Does nothing where the file system has no such call. Error: ioFailed. Thread: any.
[[nodiscard]] Expected<void> syncFolder(const std::string& path);

/// Writes a whole file, see OutputFile. Error: ioFailed, cancelled. Thread: any.
[[nodiscard]] Expected<void> writeFile(const std::string& path, std::string_view content);

/// Makes a folder, and those above it, unless they are there. It lasts through a power cut. Error: ioFailed.
/// Thread: any.
[[nodiscard]] Expected<void> makeFolder(const std::string& path);

} // namespace teleta::core
