// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <mutex>
#include <utility>

namespace teleta::core {

/// Frames on their way from a camera to their consumer. A full queue drops its oldest frame, since a current
/// picture is worth more than an old one; the next frame tells how many were dropped before it.
/// Thread: any.
class CameraFrameQueue {
public:
    /// capacity: at least 1.
    explicit CameraFrameQueue(std::size_t capacity)
        : m_capacity(std::max<std::size_t>(capacity, 1)) {}

    void push(CameraFrame frame) {
        const std::scoped_lock lock(m_mutex);
        m_frames.push_back(std::move(frame));
        if (m_frames.size() <= m_capacity)
            return;
        m_frames[1].replace(m_frames[0]);
        m_frames.pop_front();
    }

    bool pop(CameraFrame& frame) {
        const std::scoped_lock lock(m_mutex);
        if (m_frames.empty())
            return false;
        frame = std::move(m_frames.front());
        m_frames.pop_front();
        return true;
    }

    [[nodiscard]] std::size_t size() const {
        const std::scoped_lock lock(m_mutex);
        return m_frames.size();
    }
    [[nodiscard]] std::size_t capacity() const { return m_capacity; }

private:
    mutable std::mutex m_mutex;
    std::deque<CameraFrame> m_frames;
    std::size_t m_capacity;
};

} // namespace teleta::core
