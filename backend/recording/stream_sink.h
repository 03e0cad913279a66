// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/stream_tap.h"
#include "backend/core/interface.h"
#include "backend/recording/recording_types.h"

#include <memory>

namespace teleta::recording {

/// Takes streams of frames, and events: a recorder, or whoever else follows what runs.
/// Thread: any; both calls return at once.
class StreamSink : public core::Interface {
public:
    /// Adds a stream. A name that is taken gets a number. The tap may outlive the sink and is then ignored.
    [[nodiscard]] virtual std::shared_ptr<core::StreamTap> addStream(StreamInfo info) = 0;
    /// Adds an event; time_ns: steady clock.
    virtual void add(RecordingEvent event) = 0;
};

} // namespace teleta::recording
