// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/motors/motor_model.h"

#include "backend/pattern/motors/sampled_output.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::pattern {

namespace {

constexpr double kOverdriveReturn = 0.1;
constexpr double kLongestStep_s = 0.001; ///< with which a prediction follows a pattern

double onLine(const SpeedPoint& a, const SpeedPoint& b, double drive) {
    return a.speed_Hz + (drive - a.drive) / (b.drive - a.drive) * (b.speed_Hz - a.speed_Hz);
}

} // namespace

bool MotorProfile::valid() const {
    const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
    if (!(startDrive > 0.0 && startDrive < fullDrive && fullDrive <= 1.0 && positive(riseTime_s) &&
          positive(fallTime_s) && std::isfinite(overdrive) && overdrive >= 1.0 &&
          std::isfinite(longestOverdrive_s) && longestOverdrive_s >= 0.0 && curve.size() >= 2))
        return false;
    if (!(curve.front().drive >= 0.0 && curve.front().drive <= startDrive && curve.front().speed_Hz >= 0.0 &&
          curve.back().drive == 1.0 && std::isfinite(curve.back().speed_Hz)))
        return false;
    for (std::size_t i = 1; i < curve.size(); ++i) {
        if (!(curve[i].drive > curve[i - 1].drive && curve[i].speed_Hz > curve[i - 1].speed_Hz))
            return false;
    }
    return true;
}

MotorProfile MotorProfile::assumedCoinMotor() {
    MotorProfile profile;
    profile.name = "Coin motor (assumed)";
    profile.startDrive = 1.0 / 3.0;
    profile.riseTime_s = 0.055;
    profile.fallTime_s = 0.075;
    profile.curve = {{0.0, 0.0}, {1.0, kLevelSpeeds_Hz.back()}};
    profile.overdrive = 1.0;
    profile.longestOverdrive_s = 0.05;
    return profile;
}

MotorProfiles assumedMotors() {
    MotorProfiles profiles;
    profiles.fill(MotorProfile::assumedCoinMotor());
    return profiles;
}

double driveOf(const MotorProfile& profile, double intensity) {
    if (!(intensity > 0.0))
        return 0.0;
    return profile.startDrive + std::min(intensity, 1.0) * (profile.fullDrive - profile.startDrive);
}

double steadySpeed_Hz(const MotorProfile& profile, double drive) {
    if (!(drive >= profile.startDrive))
        return 0.0;
    const auto& curve = profile.curve;
    const auto next =
        std::ranges::upper_bound(curve.begin() + 1, curve.end() - 1, drive, {}, &SpeedPoint::drive);
    return onLine(*(next - 1), *next, drive);
}

double intensityOfSpeed(const MotorProfile& profile, double speed_Hz) {
    const double lowest_Hz = steadySpeed_Hz(profile, profile.startDrive);
    if (!(speed_Hz > lowest_Hz))
        return 0.0;
    const auto& curve = profile.curve;
    const auto next =
        std::ranges::upper_bound(curve.begin() + 1, curve.end() - 1, speed_Hz, {}, &SpeedPoint::speed_Hz);
    const SpeedPoint& a = *(next - 1);
    const double drive =
        a.drive + (speed_Hz - a.speed_Hz) / (next->speed_Hz - a.speed_Hz) * (next->drive - a.drive);
    return std::clamp((drive - profile.startDrive) / (profile.fullDrive - profile.startDrive), 0.0, 1.0);
}

double MotorModel::step(double drive, double step_s) {
    const double steady_Hz = steadySpeed_Hz(m_profile, drive);
    const double change_s = steady_Hz > m_speed_Hz ? m_profile.riseTime_s : m_profile.fallTime_s;
    m_speed_Hz = steady_Hz + (m_speed_Hz - steady_Hz) * std::exp(-step_s * std::numbers::ln10 / change_s);
    return m_speed_Hz;
}

Overdrive::Overdrive(const MotorProfile& profile)
    : m_profile(profile)
    , m_model(profile)
    , m_budget_s(profile.longestOverdrive_s) {
}

double Overdrive::step(double intensity, double step_s) {
    const double wanted = driveOf(m_profile, intensity);
    const double reached = 0.9 * steadySpeed_Hz(m_profile, wanted);
    const bool boosted =
        wanted > 0.0 && wanted < m_profile.overdrive && m_model.speed_Hz() < reached && m_budget_s >= step_s;
    const double drive = boosted ? m_profile.overdrive : wanted;
    m_budget_s = boosted ? m_budget_s - step_s
                         : std::min(m_budget_s + kOverdriveReturn * step_s, m_profile.longestOverdrive_s);
    m_model.step(drive, step_s);
    return drive;
}

void forEachPredictedSample(const Pattern& pattern, const MotorProfiles& profiles, double rate_Hz,
                            const std::function<bool(double t_s, const core::Intensities& intensities,
                                                     const core::Intensities& speeds_Hz)>& visit) {
    const CompiledPattern compiled(pattern);
    std::vector<MotorModel> motors;
    for (const MotorProfile& profile : profiles)
        motors.emplace_back(profile);
    const std::uint64_t samples = samplesOf(pattern.duration_s, rate_Hz);
    const int steps = static_cast<int>(std::ceil(1.0 / (rate_Hz * kLongestStep_s)));
    const double step_s = 1.0 / (rate_Hz * steps);
    core::Intensities intensities{};
    core::Intensities speeds_Hz{};
    for (std::uint64_t k = 0; k < samples; ++k) {
        const double t_s = static_cast<double>(k) / rate_Hz;
        for (std::size_t i = 0; i < core::kTactors; ++i) {
            speeds_Hz[i] = motors[i].speed_Hz();
            intensities[i] = intensityOfSpeed(profiles[i], speeds_Hz[i]);
        }
        if (!visit(t_s, intensities, speeds_Hz))
            return;
        for (int step = 0; step < steps; ++step) {
            const core::Intensities wanted = compiled.evaluate(t_s + (step + 0.5) * step_s);
            for (std::size_t i = 0; i < core::kTactors; ++i)
                motors[i].step(driveOf(profiles[i], wanted[i]), step_s);
        }
    }
}

} // namespace teleta::pattern
