// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/tactors.h"
#include "backend/core/error.h"

#include <string>
#include <string_view>

namespace teleta::motors {

/// The strongest vibration that a wearer accepts from each motor of a bracelet. Stored separately from the
/// calibration of the motors, so that neither overwrites the other.
struct WearerLimits {
    std::string bracelet;                                      ///< its serial number
    core::Intensities strongest{1.0, 1.0, 1.0, 1.0, 1.0, 1.0}; ///< 0 .. 1

    bool operator==(const WearerLimits&) const = default;
};

/// Limit of every motor when limits were set but cannot be read; deliberately low.
inline constexpr double kUnknownStrongest = 0.3;

/// Reads and writes limits:
///   format = "teleta-limits", version = 1, bracelet = "SERIAL", six times [[motor]] strongest = 0.8
/// Error: notFound, ioFailed, badInput with line and column: an unknown or missing key, a value outside 0 ..
/// 1, a wrong number of motors, a newer version. Thread: any.
[[nodiscard]] core::Expected<WearerLimits> readLimits(const std::string& path);
[[nodiscard]] core::Expected<WearerLimits> parseLimits(std::string_view text, const std::string& file);
[[nodiscard]] std::string limitsText(const WearerLimits& limits);
/// Writes the file atomically; creates its folder.
[[nodiscard]] core::Expected<void> writeLimits(const WearerLimits& limits, const std::string& path);

/// Path of the limits, next to the profile of the bracelet: "motors/SERIAL.limits.toml". Empty when the
/// serial number is empty.
[[nodiscard]] std::string limitsPath(const std::string& serial);
/// Reads that file; full strength when there is none.
[[nodiscard]] core::Expected<WearerLimits> findLimits(const std::string& serial);

} // namespace teleta::motors
