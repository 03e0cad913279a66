// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/recording/recording.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace teleta::replay {

/// One stream of a recording, frame by frame. A damaged block is passed over and counted.
/// Thread: the recording's.
class RecordedTrack {
public:
    /// recording must outlive the track.
    RecordedTrack(const recording::Recording& recording, std::size_t stream);

    /// Goes to the first frame at or after a time; behind the last one there is none.
    [[nodiscard]] core::Expected<void> seek(std::int64_t time_ns);
    /// Goes to the next frame.
    [[nodiscard]] core::Expected<void> advance();
    /// Goes back by so many frames, at most to the first one. Returns by how many.
    [[nodiscard]] core::Expected<std::uint64_t> back(std::uint64_t frames);

    [[nodiscard]] bool atEnd() const { return m_atEnd; }
    [[nodiscard]] std::int64_t time_ns() const { return m_block.time_ns[m_index]; }
    template <typename Number>
    [[nodiscard]] std::span<const Number> values() const {
        return recording::valuesOf<Number>(m_block, m_index, m_channels);
    }
    /// Of a stream of pictures.
    [[nodiscard]] const core::GreyImage& image() const { return m_block.image; }
    /// The stream had jumped before this frame when it was recorded, or frames before it are damaged.
    [[nodiscard]] bool jumps() const { return (m_block.discontinuity || m_passedOver) && m_index == 0; }
    /// Blocks that were passed over, all passes together.
    [[nodiscard]] std::uint64_t damagedBlocks() const { return m_damaged; }

private:
    [[nodiscard]] core::Expected<void> nextBlock();

    recording::StreamReader m_reader;
    std::size_t m_channels;
    core::TappedFrames m_block;
    std::size_t m_index = 0;   ///< behind the last one at the end
    bool m_atEnd = true;       ///< also where nothing was sought yet, or a seek failed
    bool m_passedOver = false; ///< damage right before this block
    std::uint64_t m_damaged = 0;
};

} // namespace teleta::replay
