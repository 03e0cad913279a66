// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/hid/hid_device.h"

#include <functional>
#include <memory>
#include <vector>

namespace teleta::mouse3d {

/// Looks for the mouse and opens it. Error: none is plugged in, or access is denied.
using HidInputOpener = std::function<core::Expected<std::unique_ptr<hid::HidDevice>>()>;

/// Six-axis mice that are plugged in, by path: devices that identify as multi-axis controllers (usage page 1,
/// usage 8). Thread: any.
[[nodiscard]] std::vector<hid::HidDeviceInfo> listMice();

/// Opens a listed mouse. Error: it is gone, or access is denied.
[[nodiscard]] core::Expected<std::unique_ptr<hid::HidDevice>> openMouse(const hid::HidDeviceInfo& mouse);

/// Opens the first one.
[[nodiscard]] core::Expected<std::unique_ptr<hid::HidDevice>> openFirstMouse();

} // namespace teleta::mouse3d
