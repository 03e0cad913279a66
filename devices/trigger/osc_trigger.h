// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/trigger_port.h"
#include "backend/core/file_descriptor.h"

#include <cstdint>
#include <memory>
#include <netdb.h>
#include <string>
#include <sys/socket.h>
#include <vector>

namespace teleta::trigger {

/// An event as a message of Open Sound Control 1.0: address /teleta/trial, arguments event (string, as
/// TriggerEvent::word()), session (string), trial (int32), level (float32, NaN: none), steady time (int64,
/// ns). Thread: any (pure). Source: Wright 2002, The Open Sound Control 1.0 Specification.
[[nodiscard]] std::vector<char> oscMessage(const core::TriggerEvent& event);

/// One OSC message an event, by UDP. Nobody has to listen, and nobody says whether anybody does.
class OscTrigger : public core::TriggerPort {
public:
    /// Error: notFound when the host has no address, ioFailed. Thread: any; it may wait for a name server.
    [[nodiscard]] static core::Expected<std::unique_ptr<core::TriggerPort>> open(const std::string& host,
                                                                                 std::uint16_t port);

    [[nodiscard]] core::Expected<void> write(const core::TriggerEvent& event) override;

private:
    OscTrigger(std::string name, core::FileDescriptor socket, const sockaddr_storage& address,
               socklen_t length);

    std::string m_name;
    core::FileDescriptor m_socket;
    sockaddr_storage m_address;
    socklen_t m_length;
};

} // namespace teleta::trigger
