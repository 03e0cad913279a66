// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/recording/recording.h"
#include "backend/signal/series.h"
#include "backend/signal/signal_name.h"

#include <cstddef>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace teleta::signal {

/// One value of a block of a stream of numbers. Thread: any (pure).
[[nodiscard]] double valueOf(const core::TappedFrames& frames, const recording::StreamInfo& stream,
                             std::size_t frame, std::size_t column);

/// The streams of a recording that have signals. Error: as Recording::open. Thread: any.
[[nodiscard]] core::Expected<std::vector<recording::StreamInfo>> signalStreamsOf(const std::string& path);

/// The sources of these streams that were simulated, as what playback knows of them says. Thread: any (pure).
[[nodiscard]] std::set<std::string> simulatedSourcesOf(std::span<const recording::StreamInfo> streams);

/// What was read of a stream.
struct RecordedSignals {
    std::vector<Series> series; ///< one for each column that was asked for
    std::size_t damagedBlocks = 0;
};

/// Reads columns of a stream of a recording from its begin to its end; zero of the time axis is its start.
/// Damaged blocks are gaps, and are counted.
///   goOn: called now and then with the share that is done; false ends the reading. May be empty.
/// Error: as Recording::open, ioFailed; notFound: no such stream or column; cancelled. Thread: any.
[[nodiscard]] core::Expected<RecordedSignals> readSignals(const std::string& path, const std::string& stream,
                                                          std::span<const std::string> columns,
                                                          const std::function<bool(double share)>& goOn);

} // namespace teleta::signal
