// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/keys/toml_table.h"
#include "backend/pattern/motors/motor_model.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace teleta::motors {

/// The profile of one motor, its standard errors, and where each value comes from.
struct CalibratedMotor {
    enum class Origin { assumed, answers, recording };

    pattern::MotorProfile profile = pattern::MotorProfile::assumedCoinMotor();
    Origin startFrom = Origin::assumed;
    Origin lagFrom = Origin::assumed; ///< origin of rise, fall and curve
    double startError = 0.0;          ///< standard errors; 0: unknown
    double riseError_s = 0.0;
    double fallError_s = 0.0;

    /// Whether at least one value was measured.
    [[nodiscard]] bool measured() const { return startFrom != Origin::assumed || lagFrom != Origin::assumed; }
    bool operator==(const CalibratedMotor&) const = default;
};

/// The motors of one bracelet.
struct MotorCalibration {
    std::string bracelet; ///< its serial number
    std::array<CalibratedMotor, core::kTactors> motors;

    bool operator==(const MotorCalibration&) const = default;

    [[nodiscard]] pattern::MotorProfiles profiles() const;
    /// Whether at least one motor was measured.
    [[nodiscard]] bool measured() const;
};

/// The motor with another start drive; its curve is extended down to it along its first segment, and a curve
/// that begins at rest begins there. start: 0 < start < full drive.
[[nodiscard]] pattern::MotorProfile withStart(pattern::MotorProfile motor, double start);

/// Reads and writes a profile:
///   format = "teleta-motors", version = 1, bracelet = "SERIAL", six times
///   [[motor]] start_drive, full_drive, rise_s, fall_s, curve = [{ drive, speed_Hz } ...], overdrive,
///   longest_overdrive_s, start_from and lag_from ("assumed", "answers", "recording"), standard errors
/// Drives are shares of the full drive. Error: notFound, ioFailed; badInput with line and column: an unknown
/// or missing key, inconsistent values, a newer version. Thread: any.
[[nodiscard]] core::Expected<MotorCalibration> readMotors(const std::string& path);
[[nodiscard]] core::Expected<MotorCalibration> parseMotors(std::string_view text, const std::string& file);
[[nodiscard]] std::string motorsText(const MotorCalibration& calibration);
/// Writes the file atomically; creates its folder.
[[nodiscard]] core::Expected<void> writeMotors(const MotorCalibration& calibration, const std::string& path);

/// Reads what the files of a bracelet's motors share: format, version, the bracelet's serial number, which it
/// returns, and six tables [[motor]], for which it calls read(table, motor). The document keeps errors.
[[nodiscard]] std::string
readBraceletFile(const core::TomlDocument& document, const char* format,
                 const std::function<void(core::TomlTable table, std::size_t motor)>& read);

/// Path of the profile of a bracelet: "motors/SERIAL.toml" in the user's configuration folder, with
/// characters that a file name cannot contain as %XX. Empty when the serial number is empty.
[[nodiscard]] std::string profilePath(const std::string& serial);
/// Reads that file; empty when there is none.
[[nodiscard]] core::Expected<std::optional<MotorCalibration>> findMotors(const std::string& serial);

} // namespace teleta::motors
