// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <mutex>
#include <utility>

namespace teleta::core {

/// Frames between a camera and who works on them. When it is full the oldest frame is dropped, and the next
/// one tells how many went before it: a picture of what is now is worth more than one of what was.
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
