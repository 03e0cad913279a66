// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"

#include <optional>
#include <string>
#include <vector>

namespace teleta::cli {

/// One quantity that a device tells.
struct DeviceValue {
    std::string name;
    double value = 0.0;
    std::string unit;
};

/// A device that was found, or that was looked for in vain.
struct FoundDevice {
    std::string kind; ///< hid_bracelet, mouse3d, modbus, wts, camera
    std::string name;
    std::string where;                    ///< path or address
    std::optional<core::Error> error{};   ///< why it cannot be used; nothing: it is connected
    std::optional<double> frameRate_Hz{}; ///< frames of the motors, the array or the camera a second
    std::optional<double> inputRate_Hz{}; ///< readings of all inputs a second
    std::vector<DeviceValue> values{};
};

/// teleta devices: what is connected, why not, and how fast.
class DevicesCommand : public Command {
public:
    [[nodiscard]] const char* name() const override { return "devices"; }
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] const char* example() const override;
    void declare(CLI::App& app) override;
    [[nodiscard]] core::Expected<void> run() override;

private:
    std::string m_probePath;
    bool m_json = false;
};

} // namespace teleta::cli
