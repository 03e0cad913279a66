// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/wts/wts_codec.h"

#include <cstdint>
#include <initializer_list>
#include <vector>

/// The sensor's side of the protocol: what the tests and the emulated sensor send.
namespace teleta::wts::test {

using Bytes = std::vector<std::uint8_t>;

inline void appendU16(Bytes& bytes, unsigned value) {
    bytes.push_back(static_cast<std::uint8_t>(value & 0xFF));
    bytes.push_back(static_cast<std::uint8_t>(value >> 8 & 0xFF));
}

inline void append(Bytes& bytes, const Bytes& more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

/// Closes a message with the checksum, computed bit by bit without a table.
inline Bytes sealed(Bytes bytes) {
    unsigned crc = 0xFFFF;
    for (const std::uint8_t byte : bytes) {
        unsigned entry = ((crc ^ byte) & 0xFF) << 8;
        for (int bit = 0; bit < 8; ++bit)
            entry = (entry << 1 ^ ((entry & 0x8000) != 0 ? 0x1021 : 0)) & 0xFFFF;
        crc = entry ^ crc >> 8;
    }
    appendU16(bytes, crc);
    return bytes;
}

inline Bytes message(unsigned id, const Bytes& payload) {
    Bytes bytes{0xAA, 0xAA, 0xAA, static_cast<std::uint8_t>(id)};
    appendU16(bytes, static_cast<unsigned>(payload.size()));
    append(bytes, payload);
    return sealed(std::move(bytes));
}

inline Bytes answer(Command command, unsigned status, const Bytes& params = {}) {
    Bytes payload;
    appendU16(payload, status);
    append(payload, params);
    return message(static_cast<unsigned>(command), payload);
}

inline Bytes matrixInfoParams(unsigned columns, unsigned rows, unsigned width_10um = 340,
                              unsigned height_10um = 340, unsigned fullScale = 4095) {
    Bytes params;
    for (const unsigned value : {columns, rows, width_10um, height_10um, fullScale})
        appendU16(params, value);
    return params;
}

/// The payload of a periodic frame from its 16-bit words, cells or runs.
inline Bytes framePayload(std::uint32_t timestamp, bool runLength, const std::vector<unsigned>& words) {
    Bytes payload;
    appendU16(payload, timestamp & 0xFFFF);
    appendU16(payload, timestamp >> 16);
    payload.push_back(runLength ? 1 : 0);
    for (const unsigned word : words)
        appendU16(payload, word);
    return payload;
}

inline Bytes frame(std::uint32_t timestamp, bool runLength, const std::vector<unsigned>& words) {
    return message(0x00, framePayload(timestamp, runLength, words));
}

} // namespace teleta::wts::test
