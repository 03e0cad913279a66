// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/device/source_outlet.h"
#include "backend/core/error.h"
#include "backend/core/threads/latest_copy.h"
#include "devices/replay/frame_index.h"
#include "devices/replay/playback_desk.h"
#include "devices/replay/replay_config.h"
#include "devices/replay/replay_cursor.h"

#include <atomic>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>

namespace teleta::replay {

/// Reads, paces and delivers the frames of a recording, and carries out the playback commands.
///   due = anchor + (time of the frame - time at the anchor) / speed
/// The anchor is set anew by play, seek, step, a change of speed and at the seam of a loop.
/// Thread: run() is the worker's, buildIndex() another one's, open() before both; wake() and position() from
/// any; the commands from one controlling thread.
class ReplayWorker {
public:
    /// cursor: has read at least one frame. nominalRate_Hz: 0 when unknown.
    ReplayWorker(ReplayCursor cursor, double nominalRate_Hz, ReplayConfig config);

    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    void buildIndex(const std::stop_token& stop);
    void wake();

    void play();
    void pause();
    void step(int frames);
    void setSpeed(double factor);
    void seek(double time_s);
    void setLoop(bool loop);
    [[nodiscard]] core::PlaybackPosition position() const;

    [[nodiscard]] core::SourceOutlet& outlet() { return m_outlet; }
    [[nodiscard]] const core::SourceOutlet& outlet() const { return m_outlet; }

private:
    struct Shown {
        double time_s = 0.0;
        std::uint64_t frame = 0;
    };

    void seekTo(double time_s, const std::stop_token& stop);
    void stepBy(long long frames, const std::stop_token& stop);
    template <typename Reached>
    [[nodiscard]] bool scan(const FramePlace& from, const Reached& reached, const std::stop_token& stop);
    void showPending(const std::stop_token& stop);
    void playDue(const std::stop_token& stop);
    void rewind();
    void reachEnd(const core::Expected<bool>& read);
    void endAs(core::DeviceState state, std::string message = {});

    void append(core::SampleBlock& block);
    void deliver(core::SampleBlock& block, const std::stop_token& stop);
    void anchorAt(double time_s);
    [[nodiscard]] double timeOf_s(const FramePlace& place) const;
    [[nodiscard]] std::int64_t due_ns(double time_s) const;
    [[nodiscard]] std::int64_t now_ns() const { return m_config.clock->now_ns(); }

    ReplayConfig m_config;
    double m_nominalRate_Hz;
    core::SourceOutlet m_outlet;
    FrameIndex m_index;
    core::LatestCopy<Shown> m_shown;

    PlaybackDesk m_desk;
    std::atomic<bool> m_abandonScan{false}; ///< a newer seek, or stop

    // The worker's own.
    ReplayCursor m_cursor;
    PlaybackCommands m_active;
    bool m_pending = false;                ///< the cursor's frame was read and not delivered
    std::optional<FramePlace> m_delivered; ///< newest one
    bool m_discontinuity = false;          ///< before the next block
    std::int64_t m_anchor_ns = 0;
    double m_anchorTime_s = 0.0;
};

} // namespace teleta::replay
