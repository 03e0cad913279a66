// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_device.h"
#include "backend/core/threads/pacing_clock.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace teleta::test {

/// A clock that is set.
class SetClock : public core::PacingClock {
public:
    [[nodiscard]] std::int64_t now_ns() const override { return m_now_ns += m_eachLook_ns; }
    [[nodiscard]] std::int64_t suspended_ns() const override { return m_suspended_ns; }
    void add(std::int64_t step_ns) { m_now_ns += step_ns; }
    /// As if the machine had slept for so long.
    void suspend(std::int64_t duration_ns) { m_suspended_ns += duration_ns; }
    /// As if time went on between one look at the clock and the next.
    void addAtEachLook(std::int64_t step_ns) { m_eachLook_ns = step_ns; }

private:
    std::int64_t m_eachLook_ns = 0;
    std::int64_t m_suspended_ns = 0;
    mutable std::int64_t m_now_ns = 1'000'000'000'000;
};

/// A bracelet that remembers its frames and does what the test says.
class ScriptedBracelet : public core::BraceletSource {
public:
    struct Written {
        core::BraceletFrame frame;
        std::int64_t time_ns = 0;
    };

    explicit ScriptedBracelet(std::shared_ptr<core::PacingClock> clock)
        : m_clock(std::move(clock)) {}

    [[nodiscard]] const core::BraceletDescription& description() const override { return m_description; }
    void start(core::Wakeup&) override {}
    void stop() override {}
    [[nodiscard]] core::DeviceStatus status() const override { return {}; }
    [[nodiscard]] core::BraceletTelemetry telemetry() const override {
        const std::scoped_lock lock(m_mutex);
        return m_telemetry;
    }
    [[nodiscard]] std::uint64_t connection() const override {
        const std::scoped_lock lock(m_mutex);
        return m_connection;
    }
    core::WriteResult write(const core::BraceletFrame& frame) override {
        if (m_whileWriting)
            m_whileWriting();
        const std::scoped_lock lock(m_mutex);
        const std::int64_t now_ns = m_clock->now_ns();
        if (m_connection == 0)
            return {core::WriteOutcome::lost, now_ns};
        if (!core::isOff(frame.drive) && frame.connection != m_connection)
            return {core::WriteOutcome::refused, now_ns};
        if (!m_mute)
            m_telemetry.reported_ns = now_ns;
        m_written.push_back({frame, now_ns});
        m_changed.notify_all();
        return {core::WriteOutcome::written, now_ns};
    }

    void connect(std::uint64_t connection) {
        const std::scoped_lock lock(m_mutex);
        m_connection = connection;
    }
    void setLongestTimeout_ms(std::uint16_t timeout_ms) { m_description.longestTimeout_ms = timeout_ms; }
    void setSerial(std::string serial) { m_description.serial = std::move(serial); }
    void setMaximumRate_Hz(double rate_Hz) { m_description.maximumRate_Hz = rate_Hz; }
    void setFramesLost(std::uint64_t frames) {
        const std::scoped_lock lock(m_mutex);
        m_telemetry.framesLost = frames;
    }
    void setFramesRefused(std::uint64_t frames) {
        const std::scoped_lock lock(m_mutex);
        m_telemetry.framesRefused = frames;
    }
    /// What its board says of itself.
    void setTooHot(bool tooHot) {
        const std::scoped_lock lock(m_mutex);
        m_telemetry.board.tooHot = tooHot;
    }
    /// Takes frames and answers none.
    void setMute(bool mute) {
        const std::scoped_lock lock(m_mutex);
        m_mute = mute;
    }
    /// Of the newest frames that were sent and echoed.
    void setNumbers(std::uint64_t sent, std::uint64_t echoed) {
        const std::scoped_lock lock(m_mutex);
        m_telemetry.newestSent = sent;
        m_telemetry.newestEchoed = echoed;
    }
    /// Runs in every write, before the frame is taken.
    void whileWriting(std::function<void()> act) { m_whileWriting = std::move(act); }

    [[nodiscard]] std::vector<Written> written() const {
        const std::scoped_lock lock(m_mutex);
        return m_written;
    }
    void forget() {
        const std::scoped_lock lock(m_mutex);
        m_written.clear();
    }
    /// Waits for a write until a condition on what was written holds; false when it does not come to hold.
    template <typename Condition>
    [[nodiscard]] bool waitFor(const Condition& condition) {
        std::unique_lock lock(m_mutex);
        return m_changed.wait_for(lock, std::chrono::seconds(20), [&] { return condition(m_written); });
    }

private:
    std::shared_ptr<core::PacingClock> m_clock;
    core::BraceletDescription m_description{.name = "scripted", .maximumRate_Hz = 1000.0};
    std::function<void()> m_whileWriting;

    mutable std::mutex m_mutex; ///< of what follows
    std::condition_variable m_changed;
    core::BraceletTelemetry m_telemetry;
    bool m_mute = false;
    std::uint64_t m_connection = 1;
    std::vector<Written> m_written;
};

[[nodiscard]] inline core::Intensities all(double intensity) {
    core::Intensities intensities;
    intensities.fill(intensity);
    return intensities;
}

} // namespace teleta::test
