// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/stiffness/joint_sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string_view>
#include <vector>

namespace teleta::stiffness::test {

/// What disturbs the log of a touch. Each has the size that made the intervals fail that knew white noise
/// only.
enum class Disturbance {
    none,
    missingSamples,    ///< 30 % of the samples are lost, the others are up to 0.4 ms late
    angleSteps,        ///< of 1e-4 rad
    torqueSteps1,      ///< of 1 mNm
    torqueSteps5,      ///< of 5 mNm
    friction,          ///< 10 mNm against the motion
    offset15,          ///< +-15 mNm
    offset30,          ///< +-30 mNm
    correlated20,      ///< noise of first order, 20 ms
    correlated200,     ///< noise of first order, 200 ms
    drift,             ///< +-2 mNm/s
    gravity,           ///< +-1 Nm/rad
    distance,          ///< the contact is up to 3 mm from where it is told to be
    link,              ///< the link's stiffness is up to 3 % from what is told
    kelvinVoigtSlow,   ///< spring beside a damper, 0.1 s, at 0.003 rad/s
    kelvinVoigt,       ///< the same at 0.03 rad/s
    kelvinVoigtQuick,  ///< the same at 0.1 rad/s
    standardSolid,     ///< spring beside spring and damper in series, at 0.03 rad/s
    standardSolidHeld, ///< the same, and held until the force has decayed
    hertz,             ///< force over depth to the power 1.5; the secant over the window is the truth
    stickSlip,         ///< the joint sticks and slips forward
    backlash,          ///< the operator goes back and forth in a joint with 0.3 mrad of play
    speedUp,           ///< from rest to 0.03 rad/s, shortly before or during the contact; 0.1 mNm of noise
    speedUpGravity,    ///< the same with +-1 Nm/rad
};

struct DisturbanceName {
    Disturbance disturbance;
    std::string_view name;
};

inline constexpr std::array<DisturbanceName, 24> kDisturbances{{
    {Disturbance::none, "none"},
    {Disturbance::missingSamples, "30 % of samples missing and jitter"},
    {Disturbance::angleSteps, "angle steps 0.1 mrad"},
    {Disturbance::torqueSteps1, "torque steps 1 mNm"},
    {Disturbance::torqueSteps5, "torque steps 5 mNm"},
    {Disturbance::friction, "friction 10 mNm"},
    {Disturbance::offset15, "torque offset 15 mNm"},
    {Disturbance::offset30, "torque offset 30 mNm"},
    {Disturbance::correlated20, "correlated noise 20 ms"},
    {Disturbance::correlated200, "correlated noise 200 ms"},
    {Disturbance::drift, "drift 2 mNm/s"},
    {Disturbance::gravity, "residual gravity 1 Nm/rad"},
    {Disturbance::distance, "contact distance 3 mm"},
    {Disturbance::link, "link stiffness 3 %"},
    {Disturbance::kelvinVoigtSlow, "Kelvin-Voigt 0.1 s at 0.003 rad/s"},
    {Disturbance::kelvinVoigt, "Kelvin-Voigt 0.1 s at 0.03 rad/s"},
    {Disturbance::kelvinVoigtQuick, "Kelvin-Voigt 0.1 s at 0.1 rad/s"},
    {Disturbance::standardSolid, "standard linear solid at 0.03 rad/s"},
    {Disturbance::standardSolidHeld, "standard linear solid, held"},
    {Disturbance::hertz, "Hertz, secant as truth"},
    {Disturbance::stickSlip, "stick-slip"},
    {Disturbance::backlash, "backlash 0.3 mrad"},
    {Disturbance::speedUp, "speed-up to 0.03 rad/s before the contact"},
    {Disturbance::speedUpGravity, "speed-up, residual gravity 1 Nm/rad"},
}};

/// A log, what is told about it, and the truth.
struct DisturbedTouch {
    std::vector<JointSample> log;
    double told_contactDistance_m = 0.0;
    double told_contactDistanceSe_m = 0.0;
    double told_link_NPerM = 0.0;
    double told_linkSe_NPerM = 0.0;
    double truth_NPerM = 0.0;
};

/// A touch, random but for its seed: an object of 150 to 3000 N/m (even in the logarithm) 0.17 m from a joint
/// that turns at 5 mrad/s, first 0.8 to 2 s free, then against the object until 60 mNm; 1 kHz, 0.5 mNm of
/// noise. Contact, link and object are integrated with steps of 1/20 of a sample. Uses no code of the
/// estimators.
inline DisturbedTouch disturbedTouch(Disturbance kind, std::uint64_t seed) {
    std::mt19937_64 random(seed * 1'000'003U + static_cast<std::uint64_t>(kind));
    std::normal_distribution<double> normal;
    const auto between = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    constexpr double kLink_NPerM = 3468.6;
    constexpr double kDistance_m = 0.17;
    constexpr double kStep_s = 0.001;
    constexpr int kParts = 20;

    DisturbedTouch touch;
    touch.told_contactDistance_m = kDistance_m;
    touch.told_link_NPerM = kLink_NPerM;
    const bool speedsUp = kind == Disturbance::speedUp || kind == Disturbance::speedUpGravity;
    const double noise_Nm = speedsUp ? 0.0001 : 0.0005;
    double object_NPerM = 150.0 * std::pow(20.0, between(0.0, 1.0));
    touch.truth_NPerM = object_NPerM;

    double distance_m = kDistance_m;
    double link_NPerM = kLink_NPerM;
    if (kind == Disturbance::distance) {
        distance_m += between(-0.003, 0.003);
        touch.told_contactDistanceSe_m = 0.003 / std::sqrt(3.0);
    }
    if (kind == Disturbance::link) {
        link_NPerM *= 1.0 + between(-0.03, 0.03);
        touch.told_linkSe_NPerM = 0.03 / std::sqrt(3.0) * kLink_NPerM;
    }
    double speed_radPerS = 0.005;
    double damper_s = 0.0; // of the Kelvin-Voigt body
    double branch = 0.0;   // of the Maxwell branch, over the static spring
    double relaxation_s = 0.0;
    double hold_s = 0.0;
    switch (kind) {
    case Disturbance::kelvinVoigtSlow:
        speed_radPerS = 0.003;
        damper_s = 0.1;
        break;
    case Disturbance::kelvinVoigt:
        speed_radPerS = 0.03;
        damper_s = 0.1;
        break;
    case Disturbance::kelvinVoigtQuick:
        speed_radPerS = 0.1;
        damper_s = 0.1;
        break;
    case Disturbance::standardSolid:
    case Disturbance::standardSolidHeld:
        speed_radPerS = 0.03;
        branch = 1.0;
        relaxation_s = 0.1;
        hold_s = kind == Disturbance::standardSolidHeld ? 0.6 : 0.0;
        break;
    case Disturbance::speedUp:
    case Disturbance::speedUpGravity:
        speed_radPerS = 0.03;
        break;
    default:
        break;
    }

    double offset_Nm = 0.0;
    if (kind == Disturbance::offset15 || kind == Disturbance::offset30)
        offset_Nm = (random() % 2 == 0 ? 1.0 : -1.0) * (kind == Disturbance::offset15 ? 0.015 : 0.030);
    if (kind == Disturbance::friction)
        offset_Nm = 0.010;
    const double sign = random() % 2 == 0 ? 1.0 : -1.0;
    const double drift_NmPerS = kind == Disturbance::drift ? 0.002 * sign : 0.0;
    const bool hasGravity = kind == Disturbance::gravity || kind == Disturbance::speedUpGravity;
    const double gravity_NmPerRad = hasGravity ? 1.0 * sign : 0.0;
    double memory_s = 0.0;
    if (kind == Disturbance::correlated20)
        memory_s = 0.020;
    if (kind == Disturbance::correlated200)
        memory_s = 0.200;
    const double keeps = memory_s > 0.0 ? std::exp(-kStep_s / memory_s) : 0.0;
    double noise = normal(random);

    // Hertz: the depth at the middle of the window is that of a spring of the drawn stiffness.
    double hertz_NPerM15 = 0.0;
    if (kind == Disturbance::hertz) {
        const double middle_N = 0.035 / distance_m;
        hertz_NPerM15 = middle_N / std::pow(middle_N / object_NPerM, 1.5);
        const auto depth_m = [&](double torque_Nm) {
            return std::pow(torque_Nm / distance_m / hertz_NPerM15, 2.0 / 3.0);
        };
        touch.truth_NPerM = 0.03 / distance_m / (depth_m(0.05) - depth_m(0.02));
    }

    const double free_s = between(0.8, 2.0);
    double contact_rad = speed_radPerS * free_s;
    // Rest, then half a cosine up to the speed; the links' inertia is felt through a damped joint.
    constexpr double kRest_s = 0.3;
    constexpr double kSpeedUp_s = 0.2;
    constexpr double kInertia_kgm2 = 0.012;
    constexpr double kDamped_s = 0.03;
    if (speedsUp)
        contact_rad = speed_radPerS * between(0.1, 0.25);
    double inertia_Nm = 0.0;
    double motor_rad = 0.0;
    double depth_m = 0.0;   // of the object
    double maxwell_N = 0.0; // of its viscous branch
    double force_N = 0.0;
    double stuck_rad = 0.0; // how far the motor is ahead of the joint
    double back_rad = 0.0;  // left to go back
    bool holding = false;
    double held_s = 0.0;
    double direction = 1.0;
    int turns = 0;
    const double substep_s = kStep_s / kParts;
    for (int sample = 0; sample < 200'000; ++sample) {
        const double time_s = sample * kStep_s;
        // The reading.
        noise =
            memory_s > 0.0 ? keeps * noise + std::sqrt(1.0 - keeps * keeps) * normal(random) : normal(random);
        double torque_Nm = force_N * distance_m + offset_Nm + drift_NmPerS * time_s +
                           gravity_NmPerRad * motor_rad + inertia_Nm + noise_Nm * noise;
        double angle_rad = motor_rad;
        if (kind == Disturbance::angleSteps)
            angle_rad = 1e-4 * std::round(angle_rad / 1e-4);
        if (kind == Disturbance::torqueSteps1)
            torque_Nm = 1e-3 * std::round(torque_Nm / 1e-3);
        if (kind == Disturbance::torqueSteps5)
            torque_Nm = 5e-3 * std::round(torque_Nm / 5e-3);
        if (kind != Disturbance::missingSamples)
            touch.log.push_back({time_s, angle_rad, torque_Nm});
        else if (between(0.0, 1.0) > 0.3)
            touch.log.push_back({time_s + between(0.0, 0.0004), angle_rad, torque_Nm});
        if (!holding && torque_Nm > offset_Nm + 0.06) {
            if (hold_s <= 0.0)
                break;
            holding = true;
        }
        if (holding && (held_s += kStep_s) > hold_s)
            break;
        // The motion until the next one.
        for (int part = 0; part < kParts; ++part) {
            double rate_radPerS = holding ? 0.0 : direction * speed_radPerS;
            if (speedsUp) {
                const double phase =
                    std::clamp((time_s + part * substep_s - kRest_s) / kSpeedUp_s, 0.0, 1.0) *
                    std::numbers::pi;
                rate_radPerS *= 0.5 - 0.5 * std::cos(phase);
                const double acceleration_radPerS2 =
                    0.5 * speed_radPerS * std::numbers::pi / kSpeedUp_s * std::sin(phase);
                inertia_Nm += (kInertia_kgm2 * acceleration_radPerS2 - inertia_Nm) * substep_s / kDamped_s;
            }
            if (kind == Disturbance::backlash) {
                // Goes back by 0.6 mrad, three times on the way.
                constexpr std::array<double, 3> kTurnAt_Nm{0.025, 0.033, 0.042};
                if (direction > 0.0 && turns < 3 &&
                    force_N * distance_m > kTurnAt_Nm[static_cast<std::size_t>(turns)]) {
                    direction = -1.0;
                    back_rad = 0.0006;
                    ++turns;
                }
            }
            motor_rad += rate_radPerS * substep_s;
            double joint_rad = motor_rad;
            if (kind == Disturbance::backlash) {
                // stuck_rad: the joint lags by half the play, on the side from which it is driven.
                stuck_rad = std::clamp(stuck_rad + rate_radPerS * substep_s, -0.00015, 0.00015);
                joint_rad = motor_rad - stuck_rad;
                if (direction < 0.0 && (back_rad -= speed_radPerS * substep_s) < 0.0)
                    direction = 1.0;
            }
            if (kind == Disturbance::stickSlip) {
                // The joint stays until the motor has wound up its spring, then jumps after it.
                constexpr double kSlip_Nm = 0.1;
                const double joint_NmPerRad = distance_m * distance_m * link_NPerM;
                stuck_rad += rate_radPerS * substep_s;
                if (stuck_rad * joint_NmPerRad > kSlip_Nm)
                    stuck_rad = 0.0;
                joint_rad = motor_rad - stuck_rad;
            }
            const double pressed_m = distance_m * (joint_rad - contact_rad);
            // Force on the link's spring equals that on the object.
            if (pressed_m <= 0.0 && depth_m <= 0.0) {
                force_N = 0.0;
                continue;
            }
            if (kind == Disturbance::hertz) {
                double low_m = 0.0;
                double high_m = pressed_m;
                for (int i = 0; i < 50; ++i) {
                    const double middle_m = 0.5 * (low_m + high_m);
                    (hertz_NPerM15 * std::pow(middle_m, 1.5) > link_NPerM * (pressed_m - middle_m) ? high_m
                                                                                                   : low_m) =
                        middle_m;
                }
                depth_m = low_m;
            } else if (damper_s > 0.0) {
                // k d + k T d' = K (p - d), exact over the step for a constant p.
                const double rest_m = link_NPerM * pressed_m / (link_NPerM + object_NPerM);
                const double slow_s = damper_s * object_NPerM / (link_NPerM + object_NPerM);
                depth_m = rest_m + (depth_m - rest_m) * std::exp(-substep_s / slow_s);
            } else if (branch > 0.0) {
                // The branch decays, then all springs share the step.
                maxwell_N *= std::exp(-substep_s / relaxation_s);
                const double before_m = depth_m;
                const double quick_NPerM = object_NPerM * (1.0 + branch);
                depth_m = (link_NPerM * pressed_m - maxwell_N + object_NPerM * branch * before_m) /
                          (link_NPerM + quick_NPerM);
                maxwell_N += object_NPerM * branch * (depth_m - before_m);
            } else {
                depth_m = link_NPerM * pressed_m / (link_NPerM + object_NPerM);
            }
            force_N = std::max(0.0, link_NPerM * (pressed_m - depth_m));
        }
    }
    return touch;
}

} // namespace teleta::stiffness::test
