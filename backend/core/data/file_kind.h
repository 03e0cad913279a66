// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <cstddef>
#include <string>
#include <string_view>

class QString;

namespace teleta::core {

/// What the first bytes of a file say that it is.
enum class FileKind {
    text, ///< no byte that texts do not have; also an empty file
    npy,  ///< an array of NumPy
    zip,  ///< npz is one
    hdf5,
    matlab,  ///< MAT file of version 4, 5, 6 or 7
    matlab7, ///< MAT file of version 7.3: HDF5 behind a header
    sqlite,  ///< recordings and stores of studies
    mcap,
    gzip,
    zstd,
    png,
    jpeg,
    pdf,
    excel,
    parquet,
    pickle,
    video, ///< AVI, MP4, Matroska
    wav,
    utf16,  ///< text in UTF-16
    binary, ///< none of these
};

/// So many bytes decide.
inline constexpr std::size_t kFileKindBytes = 4096;

/// Of the first kFileKindBytes bytes of a file, or of all. Thread: any (pure).
[[nodiscard]] FileKind fileKindOf(std::string_view head);

/// The same of a regular file. Error: as requireFile(). Thread: any.
[[nodiscard]] Expected<FileKind> fileKind(const std::string& path);

/// "a NumPy array (npy)", for messages. Thread: any (pure).
[[nodiscard]] QString describe(FileKind kind);

} // namespace teleta::core
