// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_device.h"
#include "backend/core/device/stream_tap.h"
#include "backend/core/threads/latest_copy.h"

#include <array>
#include <memory>
#include <span>
#include <utility>

namespace teleta::console {

/// A bracelet that leaves copies of the frames that are written to it in a tap: a share of the full drive for
/// each tactor, float32. What the device adds by itself, zero frames, is not among them.
/// Thread: as the bracelet; setTap() from any.
class TappedBracelet : public core::BraceletSource {
public:
    /// bracelet: not null.
    explicit TappedBracelet(std::unique_ptr<core::BraceletSource> bracelet)
        : m_bracelet(std::move(bracelet)) {}

    [[nodiscard]] core::BraceletSource& bracelet() { return *m_bracelet; }

    /// From the next frame on; null: none.
    void setTap(std::shared_ptr<core::StreamTap> tap) { m_tap.set(std::move(tap)); }
    /// The same for somebody else who follows.
    void setWatcher(std::shared_ptr<core::StreamTap> tap) { m_watcher.set(std::move(tap)); }

    [[nodiscard]] const core::BraceletDescription& description() const override {
        return m_bracelet->description();
    }
    void start(core::Wakeup& consumer) override { m_bracelet->start(consumer); }
    void stop() override { m_bracelet->stop(); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_bracelet->status(); }
    [[nodiscard]] core::BraceletTelemetry telemetry() const override { return m_bracelet->telemetry(); }
    [[nodiscard]] std::uint64_t connection() const override { return m_bracelet->connection(); }
    [[nodiscard]] std::optional<core::MotorSpeeds> motorSpeeds() const override {
        return m_bracelet->motorSpeeds();
    }
    core::WriteResult write(const core::BraceletFrame& frame) override {
        const core::WriteResult result = m_bracelet->write(frame);
        for (const std::shared_ptr<core::StreamTap>& tap : {m_tap.get(), m_watcher.get()}) {
            if (!tap || result.outcome != core::WriteOutcome::written)
                continue;
            std::array<float, core::kTactors> shares{};
            for (std::size_t i = 0; i < shares.size(); ++i)
                shares[i] = static_cast<float>(frame.drive[i]) / static_cast<float>(core::kFullDrive);
            tap->append(result.time_ns, static_cast<double>(result.time_ns) * 1e-9,
                        std::span<const float>(shares));
        }
        return result;
    }

private:
    std::unique_ptr<core::BraceletSource> m_bracelet;
    core::LatestCopy<std::shared_ptr<core::StreamTap>> m_tap;
    core::LatestCopy<std::shared_ptr<core::StreamTap>> m_watcher;
};

} // namespace teleta::console
