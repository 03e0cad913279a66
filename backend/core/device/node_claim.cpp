// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/node_claim.h"

#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QString>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace teleta::core {

Expected<std::optional<NodeClaim>> NodeClaim::take(const std::string& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (descriptor < 0)
        return Unexpected(Error{ErrorKind::ioFailed, std::strerror(errno), {}, {path}});
    std::optional<NodeClaim> claim{NodeClaim(descriptor)};
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
        return claim;
    if (errno == EWOULDBLOCK)
        return std::optional<NodeClaim>();
    return Unexpected(Error{ErrorKind::ioFailed, std::strerror(errno), {}, {path}});
}

NodeClaim::~NodeClaim() {
    if (m_descriptor >= 0)
        ::close(m_descriptor);
}

Unexpected usedByAnother(const std::string& what) {
    return failed(ErrorKind::unavailable,
                  QCoreApplication::translate("NodeClaim", "another program uses %1", "a device")
                      .arg(QString::fromStdString(what)),
                  QCoreApplication::translate("NodeClaim", "it to be closed there first"));
}

} // namespace teleta::core
