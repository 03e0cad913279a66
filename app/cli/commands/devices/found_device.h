// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commands/devices/taxels_report.h"
#include "backend/core/error.h"

#include <optional>
#include <string>
#include <vector>

namespace teleta::cli {

/// One quantity that a device reports.
struct DeviceValue {
    std::string name;
    double value = 0.0;
    std::string unit;
};

/// A device that was found, or one that was looked for and not found.
struct FoundDevice {
    /// hid_bracelet, sound_bracelet, mouse3d, modbus, wts, camera, marker_gel, ros_tactile, ros_camera, or of
    /// a taxels::isArrayKind()
    std::string kind;
    std::string name;
    std::string where;                    ///< path or address
    std::optional<core::Error> error{};   ///< why it cannot be used; nothing: it is connected
    std::optional<double> frameRate_Hz{}; ///< frames of the motors, the array or the camera a second
    std::optional<double> inputRate_Hz{}; ///< readings of all inputs a second
    std::vector<DeviceValue> values{};
    std::string warning{};                ///< translated; empty: none
    std::string lines{};                  ///< for its description, as it was measured; empty: none
    std::optional<TaxelsReport> stream{}; ///< of a described array
};

template <typename T>
std::optional<core::Error> errorOf(const core::Expected<T>& result) {
    return result ? std::nullopt : std::optional(result.error());
}

} // namespace teleta::cli
