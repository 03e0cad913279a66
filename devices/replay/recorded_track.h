// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/recording/recording.h"
#include "devices/replay/playback_track.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace teleta::replay {

/// A stream of a .teleta recording. Damaged blocks are skipped and counted.
/// Thread: the recording's.
class RecordedTrack : public PlaybackTrack {
public:
    /// recording must outlive the track.
    RecordedTrack(const recording::Recording& recording, std::size_t stream);

    [[nodiscard]] core::Expected<void> seek(std::int64_t time_ns) override;
    [[nodiscard]] core::Expected<void> advance() override;
    [[nodiscard]] core::Expected<std::uint64_t> back(std::uint64_t frames) override;

    [[nodiscard]] bool atEnd() const override { return m_atEnd; }
    [[nodiscard]] std::int64_t time_ns() const override { return m_block.time_ns[m_index]; }
    [[nodiscard]] double sourceTime_s() const override {
        return static_cast<double>(time_ns() - m_start_ns) / 1e9;
    }
    [[nodiscard]] core::GreyImage image() const override { return m_block.image; }
    [[nodiscard]] bool jumps() const override { return (m_block.discontinuity || m_skipped) && m_index == 0; }
    [[nodiscard]] std::uint64_t damagedBlocks() const override { return m_damaged; }

protected:
    [[nodiscard]] std::span<const std::byte> bytes() const override;

private:
    [[nodiscard]] core::Expected<void> nextBlock();

    recording::StreamReader m_reader;
    std::int64_t m_start_ns; ///< of the recording
    core::TappedFrames m_block;
    std::size_t m_index = 0; ///< behind the last one at the end
    bool m_atEnd = true;     ///< also before the first seek, and after one that failed
    bool m_skipped = false;  ///< damage right before this block
    std::uint64_t m_damaged = 0;
};

} // namespace teleta::replay
