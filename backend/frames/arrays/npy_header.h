// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/frames/arrays/array_file.h"

#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace teleta::frames {

/// How the numbers of an npy array are kept.
struct NpyType {
    char kind = 'f'; ///< b, i, u, f
    std::size_t bytes = 8;
    bool isBigEndian = false;
};

/// The head of an npy file.
struct NpyHeader {
    ArrayHead head;
    NpyType type; ///< only when head.problem is empty
};

/// Reads so many bytes, fewer only at the end. Error: ioFailed, or what unpacks them finds damage.
using ReadBytes = std::function<core::Expected<std::size_t>(std::span<char>)>;

/// Reads the head of an npy array of format 1.0, 2.0 or 3.0: "\x93NUMPY", version, the length of the head, a
/// literal of Python with descr, fortran_order and shape (NumPy's page numpy.lib.format). what: the file, and
/// what of it, for messages. Error: badInput with the byte.
[[nodiscard]] core::Expected<NpyHeader> readNpyHeader(const ReadBytes& read, const std::string& path);

/// Hands the values behind the head to take. Error: badInput when there are fewer or more bytes than the
/// shape says; cancelled by take.
[[nodiscard]] core::Expected<void> readNpyValues(const ReadBytes& read, const NpyHeader& header,
                                                 const std::string& path, const ArrayFile::Take& take);

/// The head of an npy array of format 1.0 in C order, little-endian. descr: as "<f4". Thread: any (pure).
[[nodiscard]] std::string npyHead(const std::string& descr, std::span<const std::uint64_t> shape);

} // namespace teleta::frames
