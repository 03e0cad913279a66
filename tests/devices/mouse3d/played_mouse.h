// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/mouse3d/mouse3d.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace teleta::test {

/// Reports of a six-axis mouse: the dead-man button held and let go, and the cap pushed to the right to the
/// end.
using Report = std::vector<std::uint8_t>;

inline const Report kPressed{0x03, 0x01, 0x00};
inline const Report kReleased{0x03, 0x00, 0x00};
inline const Report kRight{0x01, 0x5E, 0x01, 0x00, 0x00, 0x00, 0x00};

/// A mouse that a test plugs in and moves. Thread: any.
class PlayedMouse {
public:
    explicit PlayedMouse(bool plugged)
        : m_plugged(plugged) {}

    void plug(bool plugged) {
        const std::scoped_lock lock(m_mutex);
        m_plugged = plugged;
        m_reports.clear();
        m_changed.notify_all();
    }
    void send(const std::vector<Report>& reports) {
        const std::scoped_lock lock(m_mutex);
        m_reports.insert(m_reports.end(), reports.begin(), reports.end());
        m_changed.notify_all();
    }
    [[nodiscard]] int opened() const {
        const std::scoped_lock lock(m_mutex);
        return m_opened;
    }
    /// The mouse must outlive what it opens.
    mouse3d::HidInputOpener opener() {
        return [this]() -> core::Expected<std::unique_ptr<hid::HidDevice>> {
            const std::scoped_lock lock(m_mutex);
            if (!m_plugged)
                return core::Unexpected(core::Error{core::ErrorKind::unavailable, "none", {}, {}});
            ++m_opened;
            return std::make_unique<Input>(*this);
        };
    }

private:
    class Input : public hid::HidDevice {
    public:
        explicit Input(PlayedMouse& mouse)
            : m_mouse(mouse) {}
        [[nodiscard]] int read(std::span<std::uint8_t> report, int timeout_ms) override {
            std::unique_lock lock(m_mouse.m_mutex);
            m_mouse.m_changed.wait_for(lock, std::chrono::milliseconds(timeout_ms),
                                       [this] { return !m_mouse.m_plugged || !m_mouse.m_reports.empty(); });
            if (!m_mouse.m_plugged)
                return -1;
            if (m_mouse.m_reports.empty())
                return 0;
            const Report next = m_mouse.m_reports.front();
            m_mouse.m_reports.pop_front();
            std::ranges::copy(next, report.begin());
            return static_cast<int>(next.size());
        }
        [[nodiscard]] std::string name() const override { return "played mouse"; }

    private:
        PlayedMouse& m_mouse;
    };

    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    std::deque<Report> m_reports;
    bool m_plugged;
    int m_opened = 0;
};

} // namespace teleta::test
