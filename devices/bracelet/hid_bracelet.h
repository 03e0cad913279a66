// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_link.h"
#include "backend/core/error.h"
#include "backend/core/threads/stop_switch.h"
#include "devices/bracelet/hid_bracelet_config.h"
#include "devices/bracelet/hid_transport.h"

#include <memory>
#include <vector>

namespace teleta::bracelet {

/// The bracelets that are plugged in. Thread: any, one at a time.
[[nodiscard]] std::vector<HidDeviceInfo> listHidBracelets(const HidBraceletConfig& config = {});

/// Opens a bracelet over USB HID that reconnects to the same board by itself. stopSwitch must outlive it.
/// Error: none is plugged in, access is denied, or it uses another report layout.
[[nodiscard]] core::Expected<std::unique_ptr<core::BraceletLink>>
openHidBracelet(const HidBraceletConfig& config, const core::StopSwitch& stopSwitch);

} // namespace teleta::bracelet
