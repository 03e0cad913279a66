// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_device.h"
#include "backend/core/error.h"
#include "backend/core/interface.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace teleta::core {

/// One open connection to a bracelet's board, over any medium. This is all that the driver of a new kind of
/// bracelet implements; BraceletLink does the rest. Thread: one at a time.
class BraceletPort : public Interface {
public:
    enum class Read {
        nothing, ///< none has arrived
        report,
        damaged, ///< one arrived that cannot be decoded
        lost,
    };

    /// Sends a frame; false: the connection is lost.
    /// drive: within the board's limit. timeout_ms: 1 .. the board's limit.
    [[nodiscard]] virtual bool write(std::uint16_t sequence, const Drive& drive,
                                     std::uint16_t timeout_ms) = 0;
    /// The next report that has arrived. Does not wait.
    [[nodiscard]] virtual Read read(BoardReport& report) = 0;
    /// Why the connection was lost, a translated sentence; empty when the reason is unknown.
    [[nodiscard]] virtual std::string failure() const { return {}; }
};

struct OpenedBracelet {
    std::unique_ptr<BraceletPort> port;
    BraceletDescription description;
};

/// Looks for the bracelet and opens it. Error: it is not there, or cannot be opened. Thread: any, one at a
/// time.
using BraceletOpener = std::function<Expected<OpenedBracelet>()>;

} // namespace teleta::core
