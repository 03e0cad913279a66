// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/mcap/mcap_types.h"
#include "backend/mcap/recorded/ros_names.h"
#include "backend/recording/recording.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace teleta::mcap {

/// Names of the metadata records.
inline constexpr char kRecordingNote[] = "teleta";
inline constexpr char kStreamsNote[] = "teleta_streams";

/// A time as "2026-11-26T11:05:35.123456789Z". Thread: any (pure), as the others.
[[nodiscard]] std::string utcText(std::int64_t utc_ns);

/// UTC in ns = steady time + this, by the first anchor of a recording; 0 without one.
[[nodiscard]] std::int64_t utcOffset_ns(std::span<const recording::TimeAnchor> anchors);

/// The metadata record "teleta". streams: those that are written.
[[nodiscard]] Metadata recordingNote(const recording::Recording& recording,
                                     std::span<const std::size_t> streams);
/// The metadata record "teleta_streams": for each stream, under its name, what is needed to have it back, as
/// JSON.
[[nodiscard]] Metadata streamsNote(const recording::Recording& recording,
                                   std::span<const std::size_t> streams, const std::vector<RosNames>& names);

/// The files that go with a recording.
[[nodiscard]] std::vector<Attachment> recordingAttachments(const recording::Recording& recording,
                                                           std::span<const std::size_t> streams,
                                                           const std::vector<RosNames>& names);

} // namespace teleta::mcap
