// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/recorded/png_encoder.h"

#include <cstdint>
#include <string_view>
#include <zlib.h>

namespace teleta::mcap {

namespace {

constexpr std::string_view kSignature{"\x89PNG\r\n\x1a\n", 8};
/// 8 bits, grey or red, green and blue, the usual compression and filters, not interlaced.
constexpr std::string_view kGrey8{"\x08\0\0\0\0", 5};
constexpr std::string_view kColour8{"\x08\2\0\0\0", 5};

void appendBigEndian(std::string& bytes, std::uint32_t value) {
    for (const unsigned shift : {24U, 16U, 8U, 0U})
        bytes.push_back(static_cast<char>(value >> shift & 0xffU));
}

const Bytef* bytesAt(const std::string& bytes, std::size_t at) {
    return reinterpret_cast<const Bytef*>(bytes.data()) + at;
}

/// content(): appends what is in the chunk.
template <typename Content>
void appendPngChunk(std::string& bytes, std::string_view type, const Content& content) {
    const std::size_t start = bytes.size();
    appendBigEndian(bytes, 0);
    bytes.append(type);
    content();
    const std::size_t size = bytes.size() - start - 8;
    std::string length;
    appendBigEndian(length, static_cast<std::uint32_t>(size));
    bytes.replace(start, length.size(), length);
    const std::size_t checked = start + length.size();
    appendBigEndian(bytes,
                    static_cast<std::uint32_t>(crc32_z(0, bytesAt(bytes, checked), bytes.size() - checked)));
}

} // namespace

std::string encodePng(const core::GreyImage& image, int level, PngPixel pixel) {
    const auto width = static_cast<std::size_t>(image.width_px);
    const auto height = static_cast<std::size_t>(image.height_px);
    std::string rows;
    rows.reserve((width + 1) * height);
    for (std::size_t row = 0; row < height; ++row) {
        rows.push_back('\0'); // no filter
        rows.append(reinterpret_cast<const char*>(image.pixels.get()) + row * width, width);
    }
    uLongf size = compressBound(static_cast<uLong>(rows.size()));
    std::string png;
    png.reserve(size + 64);
    png.append(kSignature);
    appendPngChunk(png, "IHDR", [&] {
        appendBigEndian(png, static_cast<std::uint32_t>(pixel == PngPixel::colour ? width / 3 : width));
        appendBigEndian(png, static_cast<std::uint32_t>(height));
        png.append(pixel == PngPixel::colour ? kColour8 : kGrey8);
    });
    appendPngChunk(png, "IDAT", [&] {
        const std::size_t start = png.size();
        png.resize(start + size);
        // There is room for the worst case.
        (void)compress2(reinterpret_cast<Bytef*>(png.data()) + start, &size, bytesAt(rows, 0),
                        static_cast<uLong>(rows.size()), level);
        png.resize(start + size);
    });
    appendPngChunk(png, "IEND", [] {});
    return png;
}

} // namespace teleta::mcap
