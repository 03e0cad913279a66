// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/playback/safety_limiter.h"

#include <algorithm>
#include <cmath>

namespace teleta::playback {

namespace {

/// NaN becomes the lowest value.
double clamped(double value, double lowest, double highest) {
    return value > lowest ? std::min(value, highest) : lowest;
}

SafetyLimits sane(SafetyLimits limits) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (double& limit : limits.userLimit)
        limit = clamped(limit, 0.0, 1.0);
    limits.rise_perS = clamped(limits.rise_perS, 0.0, kInfinity);
    // A limit that is NaN or not positive does not slow down falls.
    limits.fall_perS = limits.fall_perS > 0.0 ? limits.fall_perS : kInfinity;
    limits.heatBudget = clamped(limits.heatBudget, 0.0, 1.0);
    if (!(limits.heatTime_s > 0.0) || std::isinf(limits.heatTime_s)) {
        limits.heatTime_s = 1.0;
        limits.heatBudget = 0.0;
    }
    return limits;
}

/// Largest change of the intensity; without a limit infinite, even for a time of 0.
double way(double speed_perS, double time_s) {
    return std::isinf(speed_perS) ? speed_perS : speed_perS * time_s;
}

std::uint16_t toDrive(double share) {
    // A count that went through a division comes back as the same count.
    constexpr double kRounding = 1e-9;
    return static_cast<std::uint16_t>(std::min(share, 1.0) * core::kFullDrive + kRounding);
}

DriveRange sane(const DriveRange& range) {
    return range.start >= 0.0 && range.start < range.full && range.full <= 1.0 ? range : DriveRange{};
}

double driveOf(const DriveRange& range, double intensity) {
    return intensity > 0.0 ? range.start + intensity * (range.full - range.start) : 0.0;
}

double intensityOf(const DriveRange& range, double drive) {
    return std::clamp((drive - range.start) / (range.full - range.start), 0.0, 1.0);
}

} // namespace

SafetyLimiter::SafetyLimiter(const SafetyLimits& limits, double period_s)
    : m_limits(sane(limits))
    , m_period_s(period_s) {
}

void SafetyLimiter::setLimits(const SafetyLimits& limits) {
    m_limits = sane(limits);
}

core::Drive SafetyLimiter::step(const core::Intensities& wanted, double elapsed_s,
                                const DriveRanges& ranges) {
    const double passed_s = elapsed_s > 0.0 ? elapsed_s : 0.0;
    warm(passed_s);
    const double slewTime_s = std::min(passed_s, 2.0 * m_period_s);
    const double rise = way(m_limits.rise_perS, slewTime_s);
    const double fall = way(m_limits.fall_perS, slewTime_s);

    core::Drive drive{};
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        double intensity = clamped(wanted[i], 0.0, 1.0);
        intensity = std::min(intensity, m_limits.userLimit[i]);
        if (!std::isnan(wanted[i]))
            intensity = std::max(intensity, m_output[i] - fall);
        // A fall is slowed down, but not above a limit that was lowered.
        intensity = std::min({intensity, m_output[i] + rise, m_limits.userLimit[i]});
        const DriveRange range = sane(ranges[i]);
        intensity = withinHeat(i, intensity, range);
        m_drive[i] = driveOf(range, intensity);
        drive[i] = toDrive(m_drive[i]);
        // The slew continues from what was asked for: whole counts would hold a slow rise at 0 forever.
        m_output[i] = intensity;
    }
    return drive;
}

/// The intensity that a motor can bear until the next frame.
double SafetyLimiter::withinHeat(std::size_t motor, double intensity, const DriveRange& range) {
    const double heat = m_heat[motor];
    const double budget = m_limits.heatBudget;
    if (heat <= kRestedShare * budget)
        m_resting[motor] = false;
    // With a lower start it can be driven forever, close to its budget.
    const bool tires = range.start * range.start > kRestedShare * budget;
    if (tires && m_resting[motor])
        return 0.0;
    const double share = -std::expm1(-m_period_s / m_limits.heatTime_s);
    const double highestDrive = std::sqrt(std::max(heat + (budget - heat) / share, 0.0));
    if (driveOf(range, intensity) <= highestDrive)
        return intensity;
    // A motor that would not turn with what is left is turned off.
    m_resting[motor] = tires && highestDrive <= range.start;
    return intensityOf(range, highestDrive);
}

void SafetyLimiter::off(double elapsed_s) {
    warm(elapsed_s > 0.0 ? elapsed_s : 0.0);
    m_output = {};
    m_drive = {};
}

void SafetyLimiter::resume(const core::Intensities& heat, double elapsed_s) {
    m_heat = heat;
    m_output = {};
    m_drive = {};
    warm(elapsed_s > 0.0 ? elapsed_s : 0.0);
}

void SafetyLimiter::warm(double elapsed_s) {
    const double share = -std::expm1(-elapsed_s / m_limits.heatTime_s);
    for (std::size_t i = 0; i < core::kTactors; ++i)
        m_heat[i] += (m_drive[i] * m_drive[i] - m_heat[i]) * share;
}

} // namespace teleta::playback
