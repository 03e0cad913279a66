// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"
#include "backend/recording/recording.h"
#include "devices/replay/recorded_track.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace teleta::replay {

/// The reference pictures of a recorded camera, which may have been renewed during the recording. Keeps only
/// their times; damaged ones are skipped.
/// Thread: the recording's.
class RecordedReferences {
public:
    /// stream: of the references; empty: there are none. recording must outlive it.
    RecordedReferences(const recording::Recording& recording, std::optional<std::size_t> stream);

    /// The reference of a picture of this time if it differs from that of the last call (initially: from the
    /// first one); otherwise empty.
    [[nodiscard]] core::GreyImage changeAt(std::int64_t time_ns);

private:
    std::optional<RecordedTrack> m_track;
    std::vector<std::int64_t> m_times_ns; ///< rising
    std::size_t m_inUse = 0;
};

} // namespace teleta::replay
