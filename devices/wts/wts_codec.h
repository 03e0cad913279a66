// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// The binary protocol of the Weiss WTS tactile arrays, without any input or output. Little-endian:
///   request  AA AA AA | id u8 | size u16 | params              | crc u16
///   answer   AA AA AA | id u8 | size u16 | status u16 | params | crc u16   (size counts the status)
///   frame    AA AA AA | 00    | size u16 | timestamp u32 | flags u8 | cells | crc u16
namespace teleta::wts {

inline constexpr std::uint8_t kPreambleByte = 0xAA;
inline constexpr std::size_t kPreambleBytes = 3;
inline constexpr std::size_t kHeaderBytes = kPreambleBytes + 3; ///< preamble, id, size
inline constexpr std::size_t kChecksumBytes = 2;
inline constexpr std::size_t kFrameHeaderBytes = 5; ///< timestamp, flags
inline constexpr std::uint8_t kRunLengthFlag = 0x01;

enum class Command : std::uint8_t {
    periodicFrame = 0x00, ///< only sent by the sensor
    loop = 0x06,
    readFrame = 0x20,
    startFrames = 0x21,
    stopFrames = 0x22,
    tare = 0x23,
    matrixInfo = 0x30,
    setThreshold = 0x34,
    threshold = 0x35,
    setGain = 0x36,
    gain = 0x37,
    sensorType = 0x38,
    temperature = 0x46,
    systemInfo = 0x50,
    setTag = 0x51,
    tag = 0x52,
};

/// The sensor's verdict on a request. Unknown codes are kept as numbers.
enum class Status : std::uint16_t {
    success = 0,
    notAvailable = 1,
    noSensor = 2,
    notInitialised = 3,
    alreadyRunning = 4,
    notSupported = 5,
    inconsistentData = 6,
    timeOut = 7,
    readError = 8,
    writeError = 9,
    checksumError = 11,
    unknownCommand = 14,
    formatError = 15,
    accessDenied = 16,
};

/// Checksum over a whole message with its preamble; sent little-endian.
///   start FFFF, crc = T[(crc ^ byte) & FF] ^ (crc >> 8), T the table of polynomial 1021, MSB first
/// This mixes the update of a reflected CRC with the table of an unreflected one: no standard CRC-16.
/// Thread: any.
[[nodiscard]] std::uint16_t checksum(std::span<const std::uint8_t> bytes);

/// A request with its checksum. params: at most 65535 bytes. Thread: any.
[[nodiscard]] std::vector<std::uint8_t> encodeRequest(Command command,
                                                      std::span<const std::uint8_t> params = {});
[[nodiscard]] std::vector<std::uint8_t> encodeStartFrames(bool runLength, std::uint16_t delay_ms);

/// One message that arrived whole, with its checksum checked. The payload belongs to the decoder.
struct Message {
    std::uint8_t id = 0;
    std::span<const std::uint8_t> payload;
};

struct Answer {
    Status status = Status::success;
    std::span<const std::uint8_t> params;
};

/// Empty when the payload is too short for a status. message: not a periodic frame.
[[nodiscard]] std::optional<Answer> readAnswer(const Message& message);

/// Answer to Command::matrixInfo.
struct MatrixInfo {
    std::uint16_t columns = 0;
    std::uint16_t rows = 0;
    std::uint16_t cellWidth_10um = 0;
    std::uint16_t cellHeight_10um = 0;
    std::uint16_t fullScale = 0; ///< largest value of a cell

    [[nodiscard]] std::size_t cells() const { return std::size_t(columns) * rows; }
    bool operator==(const MatrixInfo&) const = default;
};

/// Empty unless the parameters have exactly the size of a matrix info.
[[nodiscard]] std::optional<MatrixInfo> readMatrixInfo(std::span<const std::uint8_t> params);

/// Why a periodic frame with a right checksum is not one of this array.
enum class FrameFault {
    tooShort, ///< not even timestamp and flags
    oddSize,  ///< half a cell
    emptyRun, ///< a run of no cells
    tooFewCells,
    tooManyCells,
};

/// Reads a periodic frame into cells, row by row; returns the sensor's timestamp, which wraps.
/// Run-length words hold a value in the low 12 bits and a count of 1 .. 15 in the high 4.
/// cells: as many as the array has; what they hold after a fault is not defined. Thread: any (pure).
[[nodiscard]] tl::expected<std::uint32_t, FrameFault> readFrame(std::span<const std::uint8_t> payload,
                                                                std::span<float> cells);

} // namespace teleta::wts
