// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_link.h"
#include "backend/core/error.h"
#include "backend/core/threads/stop_switch.h"
#include "devices/hid/hid_device.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace teleta::bracelet {

/// Which bracelet is opened. The default ids are the ones that pid.codes reserves for tests; a board with its
/// own ids lists them in a file (readHidBracelet) and in the udev rule.
struct HidBraceletConfig {
    std::uint16_t vendorId = 0x1209;
    std::uint16_t productId = 0x0001;
    std::string serial{}; ///< empty: the first one that is found
    core::BraceletLinkConfig link{};
};

/// The bracelets that are plugged in. Thread: any, one at a time.
[[nodiscard]] std::vector<hid::HidDeviceInfo> listHidBracelets(const HidBraceletConfig& config = {});

/// Opens the node of a bracelet for this program alone. Error: it is gone, access is denied, or another
/// program uses it.
[[nodiscard]] core::Expected<std::unique_ptr<hid::HidDevice>> openBraceletNode(const std::string& path);

/// Opens a bracelet over USB HID that reconnects to the same board by itself. stopSwitch must outlive it.
/// Error: none is plugged in, access is denied, or it uses another report layout.
[[nodiscard]] core::Expected<std::unique_ptr<core::BraceletLink>>
openHidBracelet(const HidBraceletConfig& config, const core::StopSwitch& stopSwitch);

} // namespace teleta::bracelet
