// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/tactors.h"
#include "backend/core/device/device.h"
#include "backend/core/interface.h"
#include "backend/core/threads/wakeup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace teleta::core {

/// Intensity 1 in a frame: 12 bits.
inline constexpr std::uint16_t kFullDrive = 4095;

/// Command for each tactor: 0 off, kFullDrive full strength. The board maps values above 0 to the range from
/// start voltage to full voltage.
using Drive = std::array<std::uint16_t, kTactors>;

[[nodiscard]] inline bool isOff(const Drive& drive) {
    return std::ranges::all_of(drive, [](std::uint16_t value) { return value == 0; });
}

/// What a bracelet is; constant while it is open.
struct BraceletDescription {
    std::string name{}; ///< shown to people
    std::string model{};
    std::string firmware{};
    std::string serial{};
    bool simulated = false;
    double maximumRate_Hz = 200.0;            ///< frames a second that the board and its link can take
    std::uint16_t highestDrive = kFullDrive;  ///< the board's own limit
    std::uint16_t longestTimeout_ms = 10'000; ///< the board's own limit
    /// From a frame to what it moves, as the device states it; nobody measured it. NaN: it states nothing.
    double statedLatency_s = std::numeric_limits<double>::quiet_NaN();
    /// The same as it was measured, and its spread; NaN: nobody did.
    double measuredLatency_s = std::numeric_limits<double>::quiet_NaN();
    double latencySpread_s = std::numeric_limits<double>::quiet_NaN();

    /// When a frame that was written at this time moves something; the same time where nobody measured it.
    [[nodiscard]] std::int64_t feltAt_ns(std::int64_t written_ns) const {
        return std::isfinite(measuredLatency_s) ? written_ns + std::llround(1e9 * measuredLatency_s)
                                                : written_ns;
    }
};

/// All tactors at one instant.
struct BraceletFrame {
    Drive drive{};
    /// The board turns its motors off by itself when no frame arrives for this long. Clamped to 1 .. the
    /// board's limit.
    std::uint16_t timeout_ms = 100;
    /// BraceletSource::connection() for which the frame was made.
    std::uint64_t connection = 0;
};

enum class WriteOutcome {
    written, ///< the kernel accepted it; whether the board did shows in its echo
    refused, ///< made for an earlier connection; nothing was written
    lost,    ///< there is no connection, or it was lost in this write
};

struct WriteResult {
    WriteOutcome outcome = WriteOutcome::lost;
    std::int64_t time_ns = 0; ///< steady time at which the write returned
};

/// What a sound card adds to a report, which has no board that could answer: the callback took the frame.
struct SoundReport {
    std::int64_t played_ns = 0;      ///< steady time at which the callback of its first sample began
    double meanShare = 0.0;          ///< of a period that the callback takes, since the opening
    double longestShare = 0.0;       ///< likewise, the longest
    std::uint64_t missedPeriods = 0; ///< that the card did not get in time, since the opening
};

/// What the board reports in answer to a frame.
struct BoardReport {
    std::uint16_t sequence = 0; ///< of the frame that it answers
    bool driving = false;       ///< a motor is on
    bool timedOut = false;      ///< it turned its motors off because no frame came
    bool tooHot = false;
    bool supplyLow = false;
    bool frameRefused = false; ///< the frame that it answers was not understood
    double supply_V = std::numeric_limits<double>::quiet_NaN();         ///< NaN: not reported
    double temperature_degC = std::numeric_limits<double>::quiet_NaN(); ///< likewise
    std::optional<SoundReport> sound{};                                 ///< of a sound card
};

struct BraceletTelemetry {
    BoardReport board;                ///< newest one
    std::int64_t reported_ns = 0;     ///< steady time at which it came; 0 when there was none
    Drive written{};                  ///< newest frame
    std::uint64_t framesWritten = 0;  ///< since start, with the zero frames that the device adds
    std::uint64_t framesEchoed = 0;   ///< confirmed by the board
    std::uint64_t newestSent = 0;     ///< number of the newest frame that was handed to the link
    std::uint64_t newestEchoed = 0;   ///< number of the newest frame that the board confirmed; 0: none
    std::uint64_t framesLost = 0;     ///< never confirmed: refused, before a later one, in flight at a loss
    std::uint64_t framesRefused = 0;  ///< of the lost ones those that the board did not understand
    std::uint64_t strayEchoes = 0;    ///< answers that no frame waits for
    std::uint64_t damagedReports = 0; ///< reports that were not understood
    std::uint64_t zeroedByDevice = 0; ///< times the device turned the motors off because no frame came
};

/// What a bracelet with sensors measures of its motors at one instant.
struct MotorSpeeds {
    std::int64_t time_ns = 0; ///< steady time of the measurement
    Drive drive{};            ///< what the motors were told then
    Intensities speeds_Hz{};
};

/// A bracelet of tactors, real or simulated: facade over a worker thread that keeps the connection.
/// Safety, below whatever drives it:
///   - the first frame of every connection is zero, and so is the last one before it is closed;
///   - while STOP is engaged every frame is written as zero, and a driven bracelet is zeroed unasked;
///   - the device writes a zero frame whenever none was written for 100 ms, which also keeps the telemetry
///     fresh;
///   - a nonzero frame that was made for an earlier connection is refused: after a loss nothing resumes
///     unless somebody asks for it.
/// Thread: start and stop from one controlling thread; write() from one thread; the rest by any.
class BraceletSource : public Interface {
public:
    [[nodiscard]] virtual const BraceletDescription& description() const = 0;
    /// Starts the worker, which notifies the consumer of changes of state and of reports.
    virtual void start(Wakeup& consumer) = 0;
    /// Writes a zero frame, ends the worker and waits for it. Idempotent.
    virtual void stop() = 0;
    /// rate_Hz and framesRead count the board's reports, framesLost the frames that it did not confirm.
    [[nodiscard]] virtual DeviceStatus status() const = 0;
    [[nodiscard]] virtual BraceletTelemetry telemetry() const = 0;
    /// Number of the present connection, counted from 1; 0 while there is none.
    [[nodiscard]] virtual std::uint64_t connection() const = 0;
    /// Writes all tactors in one report and returns as soon as the kernel has accepted it.
    virtual WriteResult write(const BraceletFrame& frame) = 0;
    /// Present speeds of the motors; empty when the bracelet has no sensor for them. Never waits for the
    /// device.
    [[nodiscard]] virtual std::optional<MotorSpeeds> motorSpeeds() const { return std::nullopt; }
};

} // namespace teleta::core
