// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/interface.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace teleta::bracelet {

/// One open HID device, report by report. Tests replace it with one that they play themselves. Thread: one at
/// a time.
class HidTransport : public core::Interface {
public:
    /// Hands an output report, with its id, to the kernel; false: the device is gone.
    [[nodiscard]] virtual bool write(std::span<const std::uint8_t> report) = 0;
    /// The next input report, with its id: number of bytes, 0 when none has arrived, -1 when the device is
    /// gone. Does not wait.
    [[nodiscard]] virtual int read(std::span<std::uint8_t> report) = 0;
    /// Asks for the feature report whose id is the first byte: number of bytes with the id, -1 on failure.
    [[nodiscard]] virtual int getFeature(std::span<std::uint8_t> report) = 0;
};

struct HidDeviceInfo {
    std::string path; ///< "/dev/hidraw3"
    std::string serial;
    std::string product;
    std::uint16_t usagePage = 0; ///< 0 when the system does not tell
};

/// The devices with these ids that the system lists, by path. Thread: any.
[[nodiscard]] std::vector<HidDeviceInfo> listHidDevices(std::uint16_t vendorId, std::uint16_t productId);

/// Opens a listed device by hidapi. Error: it is gone, or access is denied.
[[nodiscard]] core::Expected<std::unique_ptr<HidTransport>> openHidTransport(const std::string& path);

} // namespace teleta::bracelet
