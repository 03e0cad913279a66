// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/node_claim.h"
#include "backend/core/interface.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace teleta::hid {

/// One open HID device, report by report. Tests replace it with one that they play themselves. Thread: one at
/// a time.
class HidDevice : public core::Interface {
public:
    /// Hands an output report, with its id, to the kernel; false: the device is gone, or takes none.
    [[nodiscard]] virtual bool write(std::span<const std::uint8_t> /*report*/) { return false; }
    /// Waits for the next input report, with its id: number of bytes, 0 on a timeout, -1 when the device is
    /// gone.
    [[nodiscard]] virtual int read(std::span<std::uint8_t> report, int timeout_ms) = 0;
    /// Asks for the feature report whose id is the first byte: number of bytes with the id, -1 on failure.
    [[nodiscard]] virtual int getFeature(std::span<std::uint8_t> /*report*/) { return -1; }
    /// The product name that the device reports.
    [[nodiscard]] virtual std::string name() const { return {}; }
};

struct HidDeviceInfo {
    std::string path; ///< "/dev/hidraw3"
    std::string serial{};
    std::string product{};
    std::uint16_t vendorId = 0;
    std::uint16_t productId = 0;
    std::uint16_t usagePage = 0; ///< 0 when the system does not know it
    std::uint16_t usage = 0;
};

/// The devices with these ids (0: any) that the system lists, by path. Thread: any.
[[nodiscard]] std::vector<HidDeviceInfo> listHidDevices(std::uint16_t vendorId = 0,
                                                        std::uint16_t productId = 0);

/// Opens a listed device by hidapi; claim: held until it is closed. Null: it is gone, or access is denied.
[[nodiscard]] std::unique_ptr<HidDevice> openHidDevice(const HidDeviceInfo& info,
                                                       std::optional<core::NodeClaim> claim = {});

/// Whether the node exists but may not be read or written.
[[nodiscard]] bool isForbidden(const std::string& path);

} // namespace teleta::hid
