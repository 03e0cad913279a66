// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/interface.h"
#include "backend/recording/recording_types.h"

#include <QString>

#include <cstdint>
#include <optional>

namespace teleta::console {

/// Records the streams of a session into a file. Nothing here fails a session: what cannot be recorded is not
/// recorded. Thread: GUI; no call waits.
class SessionRecording : public core::Interface {
public:
    /// Starts a file, unless one is being recorded already, which then has the session too.
    virtual void start(const QString& path) = 0;
    /// Ends what start() began.
    virtual void stop() = 0;
    /// Adds an event; ignored without a file.
    virtual void add(recording::RecordingEvent event) = 0;
    /// The file, once it exists and as long as it is written; empty: nothing is recorded.
    [[nodiscard]] virtual QString file() const = 0;
    /// Zero of the recording's clock, steady clock; empty as file().
    [[nodiscard]] virtual std::optional<std::int64_t> start_ns() const = 0;
};

} // namespace teleta::console
