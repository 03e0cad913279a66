// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/tactors.h"
#include "backend/core/error.h"
#include "backend/pattern/model/pattern.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace teleta::pattern {

/// Speeds of the paper's levels 1..5 of vibration (TeleTA, 5.3).
inline constexpr std::array<double, 5> kLevelSpeeds_Hz{167.0, 188.0, 208.0, 229.0, 250.0};

/// A steady state of a motor. drive: voltage as a share of the full one.
struct SpeedPoint {
    double drive = 0.0;
    double speed_Hz = 0.0;

    bool operator==(const SpeedPoint&) const = default;
};

/// What a calibration knows of one motor. Above zero, intensity i is the drive start + i (full - start).
/// valid(): 0 < startDrive < fullDrive <= 1; times > 0; at least two points of the curve, rising in both, the
/// first not above the start, the last at drive 1; overdrive >= 1; finite all.
struct MotorProfile {
    std::string name;
    bool assumed = true;             ///< lag and curve: nobody has measured them
    bool rangeAssumed = true;        ///< start and full drive: nobody has measured them
    double startDrive = 0.0;         ///< below it the motor stands
    double fullDrive = 1.0;          ///< of intensity 1, so that all motors of a bracelet are equally strong
    double riseTime_s = 0.0;         ///< from rest to 90 % of a speed
    double fallTime_s = 0.0;         ///< from a speed to 10 % of it
    std::vector<SpeedPoint> curve;   ///< straight lines between its points
    double overdrive = 1.0;          ///< largest drive while speeding up
    double longestOverdrive_s = 0.0; ///< at once; it comes back at a tenth of the time without overdrive

    bool operator==(const MotorProfile&) const = default;

    [[nodiscard]] bool valid() const;

    /// A coin motor as nobody measured it, to be replaced by a calibration: starts at a third of the full
    /// voltage, 250 Hz at the full one and speed in proportion (TeleTA, 4 and 5.3); rise and fall as is
    /// usual for motors of this size.
    [[nodiscard]] static MotorProfile assumedCoinMotor();
};

using MotorProfiles = std::array<MotorProfile, core::kTactors>;
[[nodiscard]] MotorProfiles assumedMotors();

/// 0 for an intensity of 0 and for NaN; limited to 1.
[[nodiscard]] double driveOf(const MotorProfile& profile, double intensity);
/// Speed to which a drive leads in the end; 0 below the start. Above 1 the last line goes on.
[[nodiscard]] double steadySpeed_Hz(const MotorProfile& profile, double drive);
/// The intensity with this steady speed; 0 below the speed at the start, 1 above that of the full drive.
[[nodiscard]] double intensityOfSpeed(const MotorProfile& profile, double speed_Hz);
/// Force of the eccentric mass as a share of that at full speed: it goes with the square of speed.
[[nodiscard]] double forceShare(const MotorProfile& profile, double speed_Hz);

/// How a motor follows: its speed goes to the steady one with one time constant up and one down,
///   speed' = (steady - speed) / tau,   tau_up = rise / ln 10,   tau_down = fall / ln 10
/// integrated without error while the drive stays. Thread: one.
class MotorModel {
public:
    /// profile: valid().
    explicit MotorModel(const MotorProfile& profile)
        : m_profile(profile) {}

    /// Goes on by a time with this drive; returns the speed at its end. step_s: > 0.
    double step(double drive, double step_s);
    [[nodiscard]] double speed_Hz() const { return m_speed_Hz; }
    void reset() { m_speed_Hz = 0.0; }

private:
    MotorProfile m_profile;
    double m_speed_Hz = 0.0;
};

/// Makes a motor start faster: gives the largest allowed drive until the model has reached the wanted speed,
/// at most longestOverdrive_s of a budget. Thread: one.
class Overdrive {
public:
    explicit Overdrive(const MotorProfile& profile);

    /// Drive for the next step_s > 0.
    [[nodiscard]] double step(double intensity, double step_s);

private:
    MotorProfile m_profile;
    MotorModel m_model;
    double m_budget_s;
};

/// What the motors will do with a pattern, sampled at k / rate in [0, duration): predicted intensities
/// (intensityOfSpeed) and speeds. The motors stand at 0 s. profiles: valid().
void forEachPredictedSample(const Pattern& pattern, const MotorProfiles& profiles, double rate_Hz,
                            const std::function<bool(double t_s, const core::Intensities& intensities,
                                                     const core::Intensities& speeds_Hz)>& visit);

} // namespace teleta::pattern
