// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/chunk_compression.h"

#include "backend/core/words.h"

#include <lz4frame.h>
#include <utility>
#include <zstd.h>

namespace teleta::mcap {

namespace {

constexpr core::Words<Compression, 3> kCompressions{{"", "lz4", "zstd"}};
constexpr int kFastest = 1;

bool decompressLz4(std::string_view compressed, std::string& bytes) {
    LZ4F_dctx* context = nullptr;
    if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION)) != 0)
        return false;
    std::size_t done = 0;
    std::size_t more = 1;
    while (!compressed.empty()) {
        std::size_t written = bytes.size() - done;
        std::size_t read = compressed.size();
        more = LZ4F_decompress(context, bytes.data() + done, &written, compressed.data(), &read, nullptr);
        if (LZ4F_isError(more) != 0 || (written == 0 && read == 0))
            break;
        done += written;
        compressed.remove_prefix(read);
    }
    LZ4F_freeDecompressionContext(context);
    return more == 0 && compressed.empty() && done == bytes.size();
}

} // namespace

std::string_view toString(Compression compression) {
    return kCompressions.of(compression);
}

std::optional<Compression> compressionOf(std::string_view word) {
    return kCompressions.find(word);
}

struct ChunkCompressor::Tables {
    Tables() = default;
    Tables(const Tables&) = delete;
    Tables& operator=(const Tables&) = delete;
    ~Tables() { ZSTD_freeCCtx(zstd); }

    ZSTD_CCtx* zstd = nullptr;
};

ChunkCompressor::ChunkCompressor(Compression compression)
    : m_compression(compression)
    , m_tables(std::make_unique<Tables>()) {
    if (compression == Compression::zstd)
        m_tables->zstd = ZSTD_createCCtx();
}

ChunkCompressor::~ChunkCompressor() = default;
ChunkCompressor::ChunkCompressor(ChunkCompressor&&) noexcept = default;
ChunkCompressor& ChunkCompressor::operator=(ChunkCompressor&&) noexcept = default;

std::string_view ChunkCompressor::compress(std::string_view bytes) {
    // Neither can fail: there is room for the worst case.
    switch (m_compression) {
    case Compression::zstd:
        m_compressed.resize(ZSTD_compressBound(bytes.size()));
        m_compressed.resize(ZSTD_compressCCtx(m_tables->zstd, m_compressed.data(), m_compressed.size(),
                                              bytes.data(), bytes.size(), kFastest));
        return m_compressed;
    case Compression::lz4:
        m_compressed.resize(LZ4F_compressFrameBound(bytes.size(), nullptr));
        m_compressed.resize(LZ4F_compressFrame(m_compressed.data(), m_compressed.size(), bytes.data(),
                                               bytes.size(), nullptr));
        return m_compressed;
    case Compression::none:
        break;
    }
    return bytes;
}

bool decompress(Compression compression, std::string_view compressed, std::size_t size, std::string& bytes) {
    switch (compression) {
    case Compression::zstd:
        bytes.resize(size);
        return ZSTD_decompress(bytes.data(), size, compressed.data(), compressed.size()) == size;
    case Compression::lz4:
        bytes.resize(size);
        return decompressLz4(compressed, bytes);
    case Compression::none:
        bytes.assign(compressed);
        return compressed.size() == size;
    }
    return false;
}

} // namespace teleta::mcap
