// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/node_claim.h"

#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QString>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>

namespace teleta::core {

Expected<std::optional<NodeClaim>> NodeClaim::take(const std::string& path) {
    FileDescriptor node(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    if (node.isOpen() && ::flock(node.get(), LOCK_EX | LOCK_NB) == 0)
        return NodeClaim(std::move(node));
    if (node.isOpen() && errno == EWOULDBLOCK)
        return std::nullopt;
    return Unexpected(Error{ErrorKind::ioFailed, std::strerror(errno), {}, {path}});
}

Unexpected usedByAnother(const std::string& what) {
    return failed(ErrorKind::unavailable,
                  QCoreApplication::translate("NodeClaim", "another program uses %1", "a device")
                      .arg(QString::fromStdString(what)),
                  QCoreApplication::translate("NodeClaim", "it to be closed there first"));
}

} // namespace teleta::core
