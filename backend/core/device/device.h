// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/sample_block.h"
#include "backend/core/data/taxel_layout.h"
#include "backend/core/interface.h"
#include "backend/core/threads/bounded_queue.h"
#include "backend/core/threads/wakeup.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace teleta::core {

enum class DeviceState {
    closed,       ///< not started, or stopped by us
    connecting,   ///< started, no sample yet
    live,         ///< samples arrive
    paused,       ///< a playback that was paused by the user
    stale,        ///< the last sample is older than the stale limit
    lost,         ///< unplugged or failed; DeviceStatus::message says why
    reconnecting, ///< lost, and trying again
    finished,     ///< a playback that reached its end
};

/// Status of a device, published by its worker with each block and with each change of state. Readers compute
/// the age of the data themselves (now - lastData_ns), so that a stuck worker shows as well.
struct DeviceStatus {
    DeviceState state = DeviceState::closed;
    std::int64_t since_ns = 0;    ///< steady time at which the state began
    std::int64_t lastData_ns = 0; ///< steady time of the newest frame; 0 when there was none
    double rate_Hz = 0.0;         ///< achieved rate
    std::uint64_t framesRead = 0; ///< frames read from the device since it was opened
    std::uint64_t framesLost = 0; ///< frames that the device, the link or a full queue of samples lost
    std::string message;          ///< why the device is lost; UTF-8, translated; empty when all is well
};

/// Describes a source; constant while it is open.
struct SourceDescription {
    std::string name; ///< shown to people: file name, scene name, serial number
    TaxelLayout layout;
    std::string unit; ///< unit of the raw values: "N", "counts"
    double nominalRate_Hz = 0.0;
    bool simulated = false; ///< the data is not real, which every view must show
    bool recorded = false;  ///< the data was recorded earlier
};

/// Where a playback stands. Times are the recording's own, from its first frame, in s.
struct PlaybackPosition {
    double time_s = 0.0;     ///< of the frame that is shown
    double target_s = 0.0;   ///< where it continues: time_s, or the target of a seek that is under way
    double duration_s = 0.0; ///< grows while the file is still being indexed
    std::uint64_t frame = 0;
    std::uint64_t frames = 0; ///< known so far
    bool indexed = false;     ///< duration and frames are final
    bool paused = false;
    double speed = 1.0;
    bool loop = false;
    std::uint64_t damagedBlocks = 0; ///< skipped so far
};

/// A mark that somebody set in a recording.
struct PlaybackMark {
    double time_s = 0.0;       ///< as that of PlaybackPosition
    double sourceTime_s = 0.0; ///< as that of the frames
    std::string text;
};

/// Control of a playback. Every call returns at once; the worker carries it out.
/// Thread: one controlling thread.
class PlaybackControl {
public:
    virtual ~PlaybackControl() = default;
    virtual void play() = 0;
    virtual void pause() = 0;
    /// Moves by this many frames (negative: back) and pauses.
    virtual void step(int frames) = 0;
    /// 0.01 .. 100 times the recorded speed; clamped. Infinity: as fast as the consumer takes them.
    virtual void setSpeed(double factor) = 0;
    virtual void seek(double time_s) = 0;
    virtual void setLoop(bool loop) = 0;
    [[nodiscard]] virtual PlaybackPosition position() const = 0;
    /// In order of time; they never change.
    [[nodiscard]] virtual std::vector<PlaybackMark> marks() const { return {}; }
};

/// A tactile array, real, simulated or recorded: facade over a worker thread that reads and stamps frames.
/// Thread: start and stop from one controlling thread; blocks() is drained by one consumer; status() by any.
class TactileSource : public Interface {
public:
    [[nodiscard]] virtual const SourceDescription& description() const = 0;
    /// Starts the worker, which notifies the consumer after each block that it put into blocks().
    virtual void start(Wakeup& consumer) = 0;
    /// Ends the worker and waits for it. Idempotent.
    virtual void stop() = 0;
    [[nodiscard]] virtual BoundedQueue<SampleBlock>& blocks() = 0;
    /// A copy of the newest status. Never waits for the device.
    [[nodiscard]] virtual DeviceStatus status() const = 0;
    /// Null when the source is not a playback.
    [[nodiscard]] virtual PlaybackControl* playback() { return nullptr; }
};

/// Makes the frames of a simulated array, one call a sample period. The device paces the calls and stamps the
/// frames; the generator knows only simulated time. Deterministic: same seed, same frames. Thread: one.
class FrameGenerator {
public:
    virtual ~FrameGenerator() = default;
    [[nodiscard]] virtual SourceDescription description() const = 0;
    /// Advances by one sample period and writes layout.values() numbers. motionHeld: STOP is engaged, nothing
    /// moves.
    virtual void next(std::span<float> values, bool motionHeld) = 0;
    [[nodiscard]] virtual double time_s() const = 0;
    virtual void restart() = 0;
};

} // namespace teleta::core
