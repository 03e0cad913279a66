// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/wav_writer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace teleta::core {

namespace {

constexpr std::uint32_t kBytesPerSample = 2;
constexpr double kFullScale = 32767.0;

/// Little-endian, whatever the machine is.
void put(std::string& bytes, std::uint64_t value, int count) {
    for (int i = 0; i < count; ++i)
        bytes += static_cast<char>((value >> (8 * i)) & 0xFFU);
}

std::uint32_t headerBytes(std::uint16_t channels) {
    return channels == 1 ? 44 : 68;
}

std::string header(std::uint16_t channels, std::uint32_t rate_Hz, std::uint32_t dataBytes) {
    const std::uint32_t bytesPerFrame = kBytesPerSample * channels;
    const bool plain = channels == 1;
    std::string bytes = "RIFF";
    put(bytes, headerBytes(channels) - 8 + std::uint64_t{dataBytes}, 4);
    bytes += "WAVEfmt ";
    put(bytes, plain ? 16 : 40, 4);
    put(bytes, plain ? 1 : 0xFFFE, 2); // PCM, or the extensible format
    put(bytes, channels, 2);
    put(bytes, rate_Hz, 4);
    put(bytes, std::uint64_t{rate_Hz} * bytesPerFrame, 4);
    put(bytes, bytesPerFrame, 2);
    put(bytes, 8 * kBytesPerSample, 2);
    if (!plain) {
        put(bytes, 22, 2);                  // of the extension
        put(bytes, 8 * kBytesPerSample, 2); // valid bits
        put(bytes, 0, 4);                   // speakers
        put(bytes, 1, 4);                   // GUID of PCM: 00000001-0000-0010-8000-00AA00389B71
        put(bytes, 0x0010'0000, 4);
        put(bytes, 0xAA00'0080, 4);
        put(bytes, 0x719B'3800, 4);
    }
    bytes += "data";
    put(bytes, dataBytes, 4);
    return bytes;
}

} // namespace

std::uint64_t WavWriter::mostFrames(std::uint16_t channels) {
    return (std::numeric_limits<std::uint32_t>::max() - headerBytes(channels)) / (kBytesPerSample * channels);
}

Expected<WavWriter> WavWriter::create(const std::string& path, std::uint16_t channels, std::uint32_t rate_Hz,
                                      std::uint64_t frames) {
    TELETA_TRY(OutputFile output, OutputFile::create(path));
    output.write(header(channels, rate_Hz, static_cast<std::uint32_t>(frames * kBytesPerSample * channels)));
    return WavWriter(std::move(output));
}

void WavWriter::write(std::span<const double> frame) {
    m_bytes.clear();
    for (const double value : frame)
        put(m_bytes, static_cast<std::uint64_t>(std::lround(kFullScale * std::clamp(value, -1.0, 1.0))),
            kBytesPerSample);
    m_output.write(m_bytes);
}

} // namespace teleta::core
