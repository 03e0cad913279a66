// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_port.h"
#include "backend/core/error.h"
#include "devices/hid/hid_device.h"

#include <memory>

namespace teleta::bracelet {

/// Speaks the reports of README.md over a HID device. Thread: one at a time.
class HidBraceletPort : public core::BraceletPort {
public:
    explicit HidBraceletPort(std::unique_ptr<hid::HidDevice> device)
        : m_device(std::move(device)) {}

    [[nodiscard]] bool write(std::uint16_t sequence, const core::Drive& drive,
                             std::uint16_t timeout_ms) override;
    [[nodiscard]] Read read(core::BoardReport& report) override;

private:
    std::unique_ptr<hid::HidDevice> m_device;
};

/// Asks the board who it is. Error: it does not answer, or not in this layout.
[[nodiscard]] core::Expected<core::OpenedBracelet>
openHidBraceletPort(std::unique_ptr<hid::HidDevice> device);

} // namespace teleta::bracelet
