// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/tactors.h"
#include "backend/core/error.h"

#include <string>
#include <string_view>

namespace teleta::motors {

/// How strongly somebody wants to feel the motors of one bracelet at most. A choice of the wearer, kept apart
/// from what was measured of the motors, so that neither overwrites the other.
struct WearerLimits {
    std::string bracelet;                                      ///< its serial number
    core::Intensities strongest{1.0, 1.0, 1.0, 1.0, 1.0, 1.0}; ///< 0 .. 1

    bool operator==(const WearerLimits&) const = default;
};

/// Strongest of every motor where limits were set but cannot be read: less than may have been wanted.
inline constexpr double kUnknownStrongest = 0.3;

/// Reads and writes limits:
///   format = "teleta-limits", version = 1, bracelet = "SERIAL", six times [[motor]] strongest = 0.8
/// Error: notFound, ioFailed, badInput with line and column: an unknown or missing key, a value beyond
/// 0 .. 1, another number of motors, a newer version. Thread: any.
[[nodiscard]] core::Expected<WearerLimits> readLimits(const std::string& path);
[[nodiscard]] core::Expected<WearerLimits> parseLimits(std::string_view text, const std::string& file);
[[nodiscard]] std::string limitsText(const WearerLimits& limits);
/// The file is whole or as it was; its folder is made.
[[nodiscard]] core::Expected<void> writeLimits(const WearerLimits& limits, const std::string& path);

/// Beside the profile of the bracelet: "motors/SERIAL.limits.toml". Empty serial: empty.
[[nodiscard]] std::string limitsPath(const std::string& serial);
/// Reads that file; full strength where there is none.
[[nodiscard]] core::Expected<WearerLimits> findLimits(const std::string& serial);

} // namespace teleta::motors
