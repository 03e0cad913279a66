// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace teleta::mcap {

/// How the records of a chunk are kept.
enum class Compression {
    none,
    lz4, ///< frames of LZ4
    zstd,
};

/// Its word in files; empty for none.
[[nodiscard]] std::string_view toString(Compression compression);
/// The inverse; empty for any other word.
[[nodiscard]] std::optional<Compression> compressionOf(std::string_view word);

/// Compresses chunks. Keeps its tables from one chunk to the next. Thread: one.
class ChunkCompressor {
public:
    explicit ChunkCompressor(Compression compression);
    ~ChunkCompressor();
    ChunkCompressor(ChunkCompressor&&) noexcept;
    ChunkCompressor& operator=(ChunkCompressor&&) noexcept;

    [[nodiscard]] Compression compression() const { return m_compression; }
    /// The compressed bytes, valid until the next call; those given when they are not compressed.
    [[nodiscard]] std::string_view compress(std::string_view bytes);

private:
    struct Tables;

    Compression m_compression;
    std::unique_ptr<Tables> m_tables;
    std::string m_compressed;
};

/// Decompresses a chunk that is said to have so many bytes. False: it has more or fewer, or is damaged.
/// Thread: any (pure).
[[nodiscard]] bool decompress(Compression compression, std::string_view compressed, std::size_t size,
                              std::string& bytes);

} // namespace teleta::mcap
