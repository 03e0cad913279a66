// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"
#include "backend/core/threads/bounded_queue.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace teleta::core {

/// Some consecutive frames of one stream, as a data thread left them in a StreamTap.
///   values: frames() x channels numbers of the stream's type, row-major, in the machine's byte order.
/// time_ns: steady clock at the read, never decreasing. sourceTime_s: the stream's own time.
struct TappedFrames {
    std::vector<std::int64_t> time_ns;
    std::vector<double> sourceTime_s;
    std::vector<std::byte> values;
    GreyImage image;            ///< instead of values, of one frame
    bool discontinuity = false; ///< the stream jumped before these frames

    [[nodiscard]] std::size_t frames() const { return time_ns.size(); }
    /// Steady times never decrease, and source times are finite.
    [[nodiscard]] bool hasTimesInOrder() const {
        return std::ranges::is_sorted(time_ns) &&
               std::ranges::all_of(sourceTime_s, [](double time_s) { return std::isfinite(time_s); });
    }
};

/// Passes copies of a data thread's frames to whoever records them. The data thread never waits: if the
/// recorder is late, frames are dropped and counted.
/// Thread: append() from one data thread, pop() from the recorder's, close() and the counters from any.
class StreamTap {
public:
    explicit StreamTap(std::size_t capacity)
        : m_queue(capacity) {}

    /// Copies frames. time_ns and sourceTime_s: as many entries each; at least one.
    template <typename Number>
    void append(std::span<const std::int64_t> time_ns, std::span<const double> sourceTime_s,
                std::span<const Number> values, bool discontinuity = false) {
        if (isClosed())
            return;
        m_queue.push(copyOf(time_ns, sourceTime_s, values, discontinuity), time_ns.size());
    }

    /// One frame.
    template <typename Number>
    void append(std::int64_t time_ns, double sourceTime_s, std::span<const Number> values,
                bool discontinuity = false) {
        append(std::span(&time_ns, 1), std::span(&sourceTime_s, 1), values, discontinuity);
    }

    /// One picture, whose pixels are shared.
    void append(const CameraFrame& frame) {
        if (isClosed() || frame.image.isEmpty())
            return;
        m_queue.push({.time_ns = {frame.time_ns},
                      .sourceTime_s = {frame.capture_s},
                      .values = {},
                      .image = frame.image,
                      .discontinuity = frame.discontinuity});
    }

    /// One picture, for a thread that can wait; as below.
    [[nodiscard]] bool tryAppend(const CameraFrame& frame) {
        if (isClosed() || frame.image.isEmpty())
            return true;
        TappedFrames frames{.time_ns = {frame.time_ns},
                            .sourceTime_s = {frame.capture_s},
                            .values = {},
                            .image = frame.image,
                            .discontinuity = frame.discontinuity};
        return m_queue.tryPush(frames);
    }

    /// For a thread that can wait: returns false and changes nothing when there is no room.
    template <typename Number>
    [[nodiscard]] bool tryAppend(std::span<const std::int64_t> time_ns, std::span<const double> sourceTime_s,
                                 std::span<const Number> values) {
        if (isClosed())
            return true;
        TappedFrames frames = copyOf(time_ns, sourceTime_s, values, /*discontinuity=*/false);
        return m_queue.tryPush(frames);
    }

    /// Frames of the stream that its source lost; from the thread of append(), before what follows them.
    void lose(std::uint64_t frames) {
        if (!isClosed())
            m_lost.fetch_add(frames, std::memory_order_relaxed);
    }

    bool pop(TappedFrames& frames) { return m_queue.pop(frames); }
    /// Items that fit.
    [[nodiscard]] std::size_t capacity() const { return m_queue.capacity(); }
    [[nodiscard]] std::uint64_t dropped() const { return m_queue.overflow(); }
    [[nodiscard]] std::uint64_t lost() const { return m_lost.load(std::memory_order_relaxed); }

    /// Frames that are appended from now on are discarded and not counted.
    void close() { m_closed.store(true, std::memory_order_relaxed); }
    [[nodiscard]] bool isClosed() const { return m_closed.load(std::memory_order_relaxed); }

private:
    template <typename Number>
    static TappedFrames copyOf(std::span<const std::int64_t> time_ns, std::span<const double> sourceTime_s,
                               std::span<const Number> values, bool discontinuity) {
        const std::span<const std::byte> bytes = std::as_bytes(values);
        return {.time_ns = {time_ns.begin(), time_ns.end()},
                .sourceTime_s = {sourceTime_s.begin(), sourceTime_s.end()},
                .values = {bytes.begin(), bytes.end()},
                .image = {},
                .discontinuity = discontinuity};
    }

    BoundedQueue<TappedFrames> m_queue;
    std::atomic<std::uint64_t> m_lost{0};
    std::atomic<bool> m_closed{false};
};

} // namespace teleta::core
