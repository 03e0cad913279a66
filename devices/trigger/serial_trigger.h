// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/trigger_port.h"
#include "backend/core/file_descriptor.h"

#include <memory>
#include <string>

namespace teleta::trigger {

/// One byte an event on a serial line, 115200 baud, 8 bits, no parity, one stop bit; the byte 0 ends it.
class SerialTrigger : public core::TriggerPort {
public:
    /// pulse_ms: until the byte 0; 0: none. Error: notFound when the device is missing, refused when it is
    /// not a serial line or another program has it, ioFailed. Thread: any.
    [[nodiscard]] static core::Expected<std::unique_ptr<core::TriggerPort>> open(const std::string& device,
                                                                                 double pulse_ms);

    [[nodiscard]] core::Expected<void> write(const core::TriggerEvent& event) override;
    [[nodiscard]] std::int64_t pulse_ns() const override { return m_pulse_ns; }
    [[nodiscard]] core::Expected<void> clear() override;

private:
    SerialTrigger(std::string device, core::FileDescriptor line, std::int64_t pulse_ns);
    [[nodiscard]] core::Expected<void> send(std::uint8_t byte) const;

    std::string m_device;
    core::FileDescriptor m_line;
    std::int64_t m_pulse_ns;
};

} // namespace teleta::trigger
