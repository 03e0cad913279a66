// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/frame_conditioner.h"
#include "backend/core/device/stream_tap.h"
#include "backend/pipeline/touch_channel.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace teleta::console {

/// Collects raw frames of an array while more than half of its taxels are loaded, until they cover kWanted_s
/// of the array's time or are kMostFrames; other frames are left out. All frames of a press have the same
/// settings: a change of the array's settings discards the frames so far. Thread: GUI.
class PressCollector {
public:
    static constexpr double kWanted_s = 5.0;
    static constexpr std::size_t kMostFrames = 5000;

    explicit PressCollector(std::shared_ptr<pipeline::TouchChannel> channel);
    ~PressCollector();
    PressCollector(const PressCollector&) = delete;
    PressCollector& operator=(const PressCollector&) = delete;

    /// Takes the frames that have arrived since.
    void update();
    [[nodiscard]] bool isComplete() const;
    /// Whether the newest frame was without load.
    [[nodiscard]] bool isWaiting() const { return m_waiting; }
    [[nodiscard]] double collected_s() const { return m_collected_s; }
    /// Settings with which the frames are read.
    [[nodiscard]] const contact::ConditioningSettings& conditioning() const { return m_conditioning; }
    /// All frames, concatenated.
    [[nodiscard]] std::vector<float> takeFrames() { return std::move(m_frames); }

private:
    void takeSettings();
    void take(const core::TappedFrames& block);

    std::shared_ptr<pipeline::TouchChannel> m_channel;
    std::shared_ptr<core::StreamTap> m_tap;
    std::size_t m_taxels;
    std::uint64_t m_revision = 0;
    double m_threshold_N = 0.0;
    contact::ConditioningSettings m_conditioning; ///< without gains
    std::optional<contact::FrameConditioner> m_conditioner;
    core::TappedFrames m_block;
    std::vector<float> m_frame;
    std::vector<float> m_load;
    std::vector<std::uint8_t> m_dead;
    std::vector<float> m_frames;
    std::optional<double> m_last_s;
    double m_collected_s = 0.0;
    bool m_waiting = true;
};

} // namespace teleta::console
