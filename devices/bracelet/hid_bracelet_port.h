// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_port.h"
#include "backend/core/error.h"
#include "devices/bracelet/hid_transport.h"

#include <memory>

namespace teleta::bracelet {

/// Speaks the reports of README.md over a HID device. Thread: one at a time.
class HidBraceletPort : public core::BraceletPort {
public:
    explicit HidBraceletPort(std::unique_ptr<HidTransport> transport)
        : m_transport(std::move(transport)) {}

    [[nodiscard]] bool write(std::uint16_t sequence, const core::Drive& drive,
                             std::uint16_t timeout_ms) override;
    [[nodiscard]] Read read(core::BoardReport& report) override;

private:
    std::unique_ptr<HidTransport> m_transport;
};

/// Asks the board who it is. Error: it does not answer, or not in this layout.
[[nodiscard]] core::Expected<core::OpenedBracelet>
openHidBraceletPort(std::unique_ptr<HidTransport> transport);

} // namespace teleta::bracelet
