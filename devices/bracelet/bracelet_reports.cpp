// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/bracelet/bracelet_reports.h"

#include <algorithm>

namespace teleta::bracelet {

namespace {

constexpr std::size_t kSerialAt = 6;
constexpr std::size_t kSerialSize = 16;

void putU16(std::span<std::uint8_t> bytes, std::size_t at, std::uint16_t value) {
    bytes[at] = static_cast<std::uint8_t>(value & 0xFFU);
    bytes[at + 1] = static_cast<std::uint8_t>(value >> 8U);
}

std::uint16_t u16(std::span<const std::uint8_t> bytes, std::size_t at) {
    return static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8U);
}

} // namespace

std::array<std::uint8_t, kFrameSize> encodeFrame(std::uint16_t sequence, const core::Drive& drive,
                                                 std::uint16_t timeout_ms) {
    static_assert(core::kTactors == 6 && core::kFullDrive == 0xFFF);
    std::array<std::uint8_t, kFrameSize> bytes{};
    bytes[0] = kFrameId;
    putU16(bytes, 1, sequence);
    for (std::size_t pair = 0; pair < core::kTactors / 2; ++pair) {
        const std::uint16_t first = std::min(drive[2 * pair], core::kFullDrive);
        const std::uint16_t second = std::min(drive[2 * pair + 1], core::kFullDrive);
        const std::size_t at = 3 + 3 * pair;
        bytes[at] = static_cast<std::uint8_t>(first & 0xFFU);
        bytes[at + 1] = static_cast<std::uint8_t>(first >> 8U | (second & 0xFU) << 4U);
        bytes[at + 2] = static_cast<std::uint8_t>(second >> 4U);
    }
    putU16(bytes, 12, timeout_ms);
    return bytes;
}

std::optional<core::BoardReport> decodeReport(std::span<const std::uint8_t> bytes) {
    if (bytes.size() < kReportSize || bytes[0] != kReportId)
        return std::nullopt;
    const std::uint8_t status = bytes[3];
    core::BoardReport report;
    report.sequence = u16(bytes, 1);
    report.driving = (status & 0x01U) != 0;
    report.timedOut = (status & 0x02U) != 0;
    report.tooHot = (status & 0x04U) != 0;
    report.supplyLow = (status & 0x08U) != 0;
    report.frameRefused = (status & 0x10U) != 0;
    report.supply_V = u16(bytes, 4) / 1000.0;
    report.temperature_degC = static_cast<std::int16_t>(u16(bytes, 6)) / 10.0;
    return report;
}

std::optional<BoardIdentity> decodeIdentity(std::span<const std::uint8_t> bytes) {
    if (bytes.size() < kIdentitySize || bytes[0] != kIdentityId || bytes[1] != kLayoutVersion)
        return std::nullopt;
    BoardIdentity identity;
    identity.model = u16(bytes, 2);
    identity.firmwareMajor = bytes[4];
    identity.firmwareMinor = bytes[5];
    const std::span<const std::uint8_t> serial = bytes.subspan(kSerialAt, kSerialSize);
    const auto end = std::find(serial.begin(), serial.end(), std::uint8_t{0});
    if (!std::all_of(serial.begin(), end, [](std::uint8_t byte) { return byte > 0x20 && byte < 0x7F; }))
        return std::nullopt;
    identity.serial.assign(serial.begin(), end);
    if (bytes[22] != core::kTactors)
        return std::nullopt;
    identity.highestDrive = u16(bytes, 23);
    identity.maximumRate_Hz = u16(bytes, 25);
    identity.longestTimeout_ms = u16(bytes, 27);
    if (identity.serial.empty() || identity.highestDrive == 0 || identity.maximumRate_Hz == 0 ||
        identity.longestTimeout_ms == 0)
        return std::nullopt;
    return identity;
}

} // namespace teleta::bracelet
