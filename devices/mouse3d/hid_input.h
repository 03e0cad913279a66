// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace teleta::mouse3d {

/// An open HID device that is read report by report. A test puts one in its place that it plays itself.
/// Thread: one at a time.
class HidInput {
public:
    virtual ~HidInput() = default;
    HidInput() = default;
    HidInput(const HidInput&) = delete;
    HidInput& operator=(const HidInput&) = delete;

    /// Waits for the next input report, with its id: number of bytes, 0 when none came in time, -1 when the
    /// device is gone.
    [[nodiscard]] virtual int read(std::span<std::uint8_t> report, int timeout_ms) = 0;
    [[nodiscard]] virtual std::string name() const = 0;
};

/// Looks for the mouse and opens it. Error: none is plugged in, or it may not be opened.
using HidInputOpener = std::function<core::Expected<std::unique_ptr<HidInput>>()>;

struct Mouse3dInfo {
    std::string path; ///< "/dev/hidraw3"
    std::string product;
    std::uint16_t vendorId = 0;
    std::uint16_t productId = 0;
};

/// Six-axis mice that are plugged in, by path: what calls itself a multi-axis controller (usage page 1,
/// usage 8). Thread: any.
[[nodiscard]] std::vector<Mouse3dInfo> listMice();

/// Opens a listed mouse by hidapi. Error: it is gone, or may not be opened.
[[nodiscard]] core::Expected<std::unique_ptr<HidInput>> openMouse(const Mouse3dInfo& mouse);

/// Opens the first one.
[[nodiscard]] core::Expected<std::unique_ptr<HidInput>> openFirstMouse();

} // namespace teleta::mouse3d
