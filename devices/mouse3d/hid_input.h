// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/interface.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace teleta::mouse3d {

/// An open HID device that is read report by report. Tests replace it with one that they play themselves.
/// Thread: one at a time.
class HidInput : public core::Interface {
public:
    /// Waits for the next input report, with its id: number of bytes, 0 on a timeout, -1 when the device is
    /// gone.
    [[nodiscard]] virtual int read(std::span<std::uint8_t> report, int timeout_ms) = 0;
    [[nodiscard]] virtual std::string name() const = 0;
};

/// Looks for the mouse and opens it. Error: none is plugged in, or access is denied.
using HidInputOpener = std::function<core::Expected<std::unique_ptr<HidInput>>()>;

struct Mouse3dInfo {
    std::string path; ///< "/dev/hidraw3"
    std::string product;
    std::uint16_t vendorId = 0;
    std::uint16_t productId = 0;
};

/// Six-axis mice that are plugged in, by path: devices that identify as multi-axis controllers (usage page 1,
/// usage 8). Thread: any.
[[nodiscard]] std::vector<Mouse3dInfo> listMice();

/// Opens a listed mouse by hidapi. Error: it is gone, or access is denied.
[[nodiscard]] core::Expected<std::unique_ptr<HidInput>> openMouse(const Mouse3dInfo& mouse);

/// Opens the first one.
[[nodiscard]] core::Expected<std::unique_ptr<HidInput>> openFirstMouse();

} // namespace teleta::mouse3d
