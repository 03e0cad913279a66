// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_device.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

/// The bytes of the bracelet's HID reports, as README.md of this folder lays them out. Pure, no I/O.
namespace teleta::bracelet {

inline constexpr std::uint8_t kFrameId = 1;    ///< output report
inline constexpr std::uint8_t kReportId = 2;   ///< input report
inline constexpr std::uint8_t kIdentityId = 3; ///< feature report

// With the report's id.
inline constexpr std::size_t kFrameSize = 14;
inline constexpr std::size_t kReportSize = 8;
inline constexpr std::size_t kIdentitySize = 29;

inline constexpr std::uint8_t kLayoutVersion = 1;

inline constexpr std::uint16_t kUsagePage = 0xFF00;

/// What the feature report says of the board.
struct BoardIdentity {
    std::uint16_t model = 0;
    std::uint8_t firmwareMajor = 0;
    std::uint8_t firmwareMinor = 0;
    std::string serial; ///< printable ASCII, 1 .. 16 characters
    std::uint16_t highestDrive = 0;
    std::uint16_t maximumRate_Hz = 0;
    std::uint16_t longestTimeout_ms = 0;

    bool operator==(const BoardIdentity&) const = default;
};

/// The output report. Drives above core::kFullDrive are written as that.
[[nodiscard]] std::array<std::uint8_t, kFrameSize>
encodeFrame(std::uint16_t sequence, const core::Drive& drive, std::uint16_t timeout_ms);

/// Nothing when the bytes are no input report of the bracelet. Bytes after the report are ignored, since a
/// host may pad it.
[[nodiscard]] std::optional<core::BoardReport> decodeReport(std::span<const std::uint8_t> bytes);

/// Nothing when the bytes are no feature report of this layout version, or when what they say makes no sense:
/// no serial number, a limit of 0.
[[nodiscard]] std::optional<BoardIdentity> decodeIdentity(std::span<const std::uint8_t> bytes);

} // namespace teleta::bracelet
