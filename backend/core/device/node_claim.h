// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/file_descriptor.h"

#include <optional>
#include <string>
#include <utility>

namespace teleta::core {

/// The right to use the node of a device ("/dev/hidraw3"), which the kernel lets any number of programs open:
/// one holder at a time, by an advisory lock (flock) that ends with the program, however it ends. It keeps
/// programs out that ask for the same lock, this one's other instances above all. Thread: any.
class NodeClaim {
public:
    /// Empty when another program, or another part of this one, has it. Error: ioFailed, there is no such
    /// node or it may not be read.
    [[nodiscard]] static Expected<std::optional<NodeClaim>> take(const std::string& path);

private:
    explicit NodeClaim(FileDescriptor node)
        : m_node(std::move(node)) {}
    FileDescriptor m_node;
};

/// The error for a device that another program uses; a later attempt may succeed. what: as the user knows it
/// ("/dev/ttyUSB0", "camera 0").
[[nodiscard]] Unexpected usedByAnother(const std::string& what);

} // namespace teleta::core
