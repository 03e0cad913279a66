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

/// Steady speed of a motor at a drive. drive: voltage as a share of the full voltage.
struct SpeedPoint {
    double drive = 0.0;
    double speed_Hz = 0.0;

    bool operator==(const SpeedPoint&) const = default;
};

/// Calibration of one motor. An intensity i > 0 is the drive start + i (full - start). valid(): all finite; 0
/// < startDrive < fullDrive <= 1; times > 0; at least two points of the curve, rising in drive and speed, the
/// first not above the start, the last at drive 1; overdrive >= 1.
struct MotorProfile {
    std::string name;
    bool assumed = true;      ///< lag and curve are assumed, not measured
    bool rangeAssumed = true; ///< start and full drive are assumed, not measured
    double startDrive = 0.0;  ///< below this drive the motor stands still
    double fullDrive =
        1.0; ///< drive at intensity 1, chosen so that all motors of a bracelet are equally strong
    double riseTime_s = 0.0;       ///< from rest to 90 % of a speed
    double fallTime_s = 0.0;       ///< from a speed to 10 % of it
    std::vector<SpeedPoint> curve; ///< linear between its points
    double overdrive = 1.0;        ///< largest drive while speeding up
    double longestOverdrive_s =
        0.0; ///< longest overdrive at a time; recovers at a tenth of the rate while not overdriven

    bool operator==(const MotorProfile&) const = default;

    [[nodiscard]] bool valid() const;

    /// Default coin motor until a calibration replaces it: starts at a third of the full voltage, 250 Hz at
    /// full voltage with proportional speed (TeleTA, 4 and 5.3), rise and fall times typical of motors of
    /// this size.
    [[nodiscard]] static MotorProfile assumedCoinMotor();
};

using MotorProfiles = std::array<MotorProfile, core::kTactors>;
[[nodiscard]] MotorProfiles assumedMotors();

/// Drive for an intensity, clamped to 0..1; 0 for an intensity of 0 and for NaN.
[[nodiscard]] double driveOf(const MotorProfile& profile, double intensity);
/// Steady speed at a drive; 0 below the start. Above drive 1 the last segment is extrapolated.
[[nodiscard]] double steadySpeed_Hz(const MotorProfile& profile, double drive);
/// Intensity with this steady speed; 0 below the speed at the start, 1 above the speed at the full drive.
[[nodiscard]] double intensityOfSpeed(const MotorProfile& profile, double speed_Hz);

/// Lag of a motor: its speed approaches the steady speed with one time constant upwards and one downwards,
///   speed' = (steady - speed) / tau,   tau_up = rise / ln 10,   tau_down = fall / ln 10
/// integrated exactly while the drive is constant. Thread: one.
class MotorModel {
public:
    /// profile: valid().
    explicit MotorModel(const MotorProfile& profile)
        : m_profile(profile) {}

    /// Advances by step_s > 0 with this drive; returns the speed at the end.
    double step(double drive, double step_s);
    [[nodiscard]] double speed_Hz() const { return m_speed_Hz; }
    void reset() { m_speed_Hz = 0.0; }

private:
    MotorProfile m_profile;
    double m_speed_Hz = 0.0;
};

/// Makes a motor start faster: gives the largest allowed drive until the model reaches the desired speed,
/// limited by a budget of longestOverdrive_s. Thread: one.
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

/// Predicts how the motors follow a pattern, sampled at k / rate in [0, duration): intensities
/// (intensityOfSpeed()) and speeds. The motors stand still at 0 s. Ends when visit returns false. profiles:
/// valid(). Thread: any (pure).
void forEachPredictedSample(const Pattern& pattern, const MotorProfiles& profiles, double rate_Hz,
                            const std::function<bool(double t_s, const core::Intensities& intensities,
                                                     const core::Intensities& speeds_Hz)>& visit);

} // namespace teleta::pattern
