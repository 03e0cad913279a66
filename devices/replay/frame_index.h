// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace teleta::replay {

/// Where a frame stands in its file.
struct FramePlace {
    std::uint64_t frame = 0;
    double time_s = 0.0; ///< as in the file
    std::uint64_t offset = 0;
    long long line = 0;
};

/// Places of some frames of a recording, evenly spaced; when there are too many, every second one is removed,
/// so that they stay few for any length of file.
/// Thread: add() and complete() from one; the others from any.
class FrameIndex {
public:
    static constexpr std::size_t kMaximumPlaces = 4096;

    /// What is known of the recording so far.
    struct Extent {
        std::uint64_t frames = 0;
        double lastTime_s = 0.0;
        bool complete = false;
    };

    /// The next frame of the recording; times do not decrease.
    void add(const FramePlace& place);
    /// There are no more frames.
    void complete();

    [[nodiscard]] Extent extent() const;

    /// The last known place at or before a frame; the first one when there is none. After the first add().
    [[nodiscard]] FramePlace atFrame(std::uint64_t frame) const;
    /// The last known place before a time; the first one when there is none. After the first add().
    [[nodiscard]] FramePlace beforeTime(double time_s) const;

private:
    mutable std::mutex m_mutex;
    std::vector<FramePlace> m_places;
    std::uint64_t m_stride = 1;
    Extent m_extent;
};

} // namespace teleta::replay
