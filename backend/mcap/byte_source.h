// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/interface.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace teleta::mcap {

/// The bytes of a file, in any order. Thread: one.
class ByteSource : public core::Interface {
public:
    [[nodiscard]] virtual std::uint64_t size() const = 0;
    /// Reads so many bytes; false when they are not all there.
    [[nodiscard]] virtual bool read(std::uint64_t at, std::size_t size, std::string& bytes) = 0;
};

/// Those of a file on the disk. Error: notFound, ioFailed.
[[nodiscard]] core::Expected<std::unique_ptr<ByteSource>> openFile(const std::string& path);

/// Those of a text, which must outlive it.
[[nodiscard]] std::unique_ptr<ByteSource> bytesOf(std::string_view text);

} // namespace teleta::mcap
