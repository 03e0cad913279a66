// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <linux/uhid.h>
#include <span>
#include <string>

namespace teleta::peer {

/// What a HID device tells the kernel when it is plugged in.
struct HidIdentity {
    std::string product;
    std::string serial;
    std::uint16_t productId = 0; ///< of vendor 0x1209, whose first 16 are for tests
    std::span<const std::uint8_t> reportDescriptor;
};

/// A HID device of the kernel that this program plays, by /dev/uhid. The kernel takes it for a USB device,
/// since hidapi lists no others. Functions throw std::system_error when the kernel refuses.
/// Thread: send, plugIn, unplug: any; receive: one at a time.
class UhidDevice {
public:
    UhidDevice();
    ~UhidDevice();
    UhidDevice(const UhidDevice&) = delete;
    UhidDevice& operator=(const UhidDevice&) = delete;

    void plugIn(const HidIdentity& identity);
    void unplug();
    /// Sends an input report, with its id first.
    void sendInput(std::span<const std::uint8_t> report);
    void send(const uhid_event& event);
    /// Takes the next event of the kernel; false when there is none.
    [[nodiscard]] bool receive(uhid_event& event);
    /// For poll().
    [[nodiscard]] int descriptor() const { return m_device; }

private:
    int m_device = -1;
};

} // namespace teleta::peer
