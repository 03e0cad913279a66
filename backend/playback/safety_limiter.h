// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_device.h"
#include "backend/core/bracelet/tactors.h"

#include <array>
#include <limits>

namespace teleta::playback {

/// Limits of a tactor's drive. A value out of range is replaced by the nearest safe one; NaN allows nothing.
struct SafetyLimits {
    /// Highest intensity of each tactor that the wearer wants, 0 .. 1.
    core::Intensities userLimit{1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
    /// Fastest rise of the intensity, > 0: full strength takes 1/rise. Falls are not limited by default,
    /// since less is never unsafe.
    double rise_perS = 50.0;
    double fall_perS = std::numeric_limits<double>::infinity();
    /// Heat of a motor: h' = (u^2 - h) / heatTime_s with the drive u. h never exceeds heatBudget, the share
    /// of the full power that a motor can bear forever, 0 .. 1.
    double heatTime_s = 30.0;
    double heatBudget = 0.5;

    bool operator==(const SafetyLimits&) const = default;
};

/// What the device is told for the weakest intensity above 0 and for intensity 1, as shares of its full
/// drive:
///   drive = start + intensity (full - start)
/// The default passes intensities on, since the board has a start voltage of its own. It also stands in for
/// values out of 0 .. 1, NaN, and a full drive below the start.
struct DriveRange {
    double start = 0.0;
    double full = 1.0;

    bool operator==(const DriveRange&) const = default;
};
using DriveRanges = std::array<DriveRange, core::kTactors>;

/// The last step before a frame, whatever the source of the intensities. In this order:
///   clamp to 0 .. 1 (NaN is off) -> user's limit -> slew limit -> heat budget -> integer, rounded down
/// The heat is that of the drive that was really given. From rest at full drive the budget is reached after
/// t = -heatTime ln(1 - heatBudget); then the drive is sqrt(heatBudget). A motor that does not turn at that
/// drive is off until its heat is down to kRestedShare heatBudget, so that it rests for seconds instead of
/// being switched with every frame. Nothing is allocated. Thread: one.
class SafetyLimiter {
public:
    /// Share of the heat budget at which a motor that had to rest may be driven again.
    static constexpr double kRestedShare = 0.9;

    /// period_s: time for which an output is expected to hold, > 0.
    SafetyLimiter(const SafetyLimits& limits, double period_s);

    void setLimits(const SafetyLimits& limits);

    /// The drives that may be sent now. elapsed_s: since the last call, for which the last output held; at
    /// most two periods count for the slew limit, so that tactors rise from rest after a pause. 0, negative
    /// or NaN: no time has passed. An intensity of NaN is off at once, however slow a fall may be.
    [[nodiscard]] core::Drive step(const core::Intensities& wanted, double elapsed_s,
                                   const DriveRanges& ranges = {});

    /// All off, at once, whatever the limits are.
    void off(double elapsed_s);

    /// Continues from the heat of the motors elapsed_s ago; all have been off since.
    void resume(const core::Intensities& heat, double elapsed_s);

    /// Intensities of the last output.
    [[nodiscard]] const core::Intensities& output() const { return m_output; }
    /// Heat of each motor, 0 .. heatBudget while calls come on time.
    [[nodiscard]] const core::Intensities& heat() const { return m_heat; }

private:
    void warm(double elapsed_s);
    [[nodiscard]] double withinHeat(std::size_t motor, double intensity, const DriveRange& range);

    SafetyLimits m_limits;
    double m_period_s;
    core::Intensities m_output{};
    core::Intensities m_drive{}; ///< of the last output, as a share of the full one
    core::Intensities m_heat{};
    std::array<bool, core::kTactors> m_resting{}; ///< until its heat is down
};

} // namespace teleta::playback
