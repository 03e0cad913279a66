// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/site/service_manager.h"

#include "backend/core/file_descriptor.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <sys/socket.h>
#include <sys/un.h>

namespace teleta::site_program {

ServiceManager::ServiceManager() {
    if (const char* name = std::getenv("NOTIFY_SOCKET"); name != nullptr && (*name == '/' || *name == '@'))
        m_socket = name;
}

void ServiceManager::tell(std::string_view message) const {
    sockaddr_un address{};
    if (m_socket.empty() || m_socket.size() >= sizeof(address.sun_path))
        return;
    address.sun_family = AF_UNIX;
    std::ranges::copy(m_socket, address.sun_path);
    if (m_socket.front() == '@')
        address.sun_path[0] = '\0'; // an abstract name
    const core::FileDescriptor socketFile(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
    if (!socketFile.isOpen())
        return;
    const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + m_socket.size());
    (void)::sendto(socketFile.get(), message.data(), message.size(), MSG_NOSIGNAL,
                   reinterpret_cast<const sockaddr*>(&address), length);
}

} // namespace teleta::site_program
