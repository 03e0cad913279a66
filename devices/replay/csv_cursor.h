// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/frame_file.h"
#include "devices/replay/frame_index.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace teleta::replay {

/// Reads the frames of a recording one after the other and knows their numbers.
/// Thread: one.
class CsvCursor {
public:
    /// Error: as core::FrameFile::open; refused for a pipe, which has no positions to go to.
    [[nodiscard]] static core::Expected<CsvCursor> open(const std::string& path,
                                                        const core::ArrayLayout& layout);

    /// Reads the next frame. False at the end of the file: the last frame that was read then stays.
    [[nodiscard]] core::Expected<bool> read();

    /// The next frame to be read is this one.
    [[nodiscard]] core::Expected<void> goTo(const FramePlace& place);

    /// The frame that was read last.
    [[nodiscard]] const FramePlace& place() const { return m_place; }
    [[nodiscard]] std::span<const float> values() const { return m_values; }
    /// The first frame of the recording; after the first read().
    [[nodiscard]] const FramePlace& first() const { return m_first; }
    /// Number of the next frame.
    [[nodiscard]] std::uint64_t next() const { return m_next; }

private:
    explicit CsvCursor(core::FrameFile file);

    core::FrameFile m_file;
    FramePlace m_first;
    FramePlace m_place;
    std::vector<float> m_values;
    std::uint64_t m_next = 0;
};

} // namespace teleta::replay
