// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/stiffness/joint_sample.h"

#include <cstdint>
#include <random>
#include <vector>

namespace teleta::stiffness::test {

/// A joint that turns at constant speed until its link, a spring, meets an object, another spring in series.
/// Truth for the estimators; uses none of their code.
struct SimulatedTouch {
    double objectCompliance_mPerN = 0.0; ///< 0: rigid
    double link_NPerM = 3468.6;
    double contactDistance_m = 0.17;
    double speed_radPerS = 0.005;
    double rate_Hz = 1000.0;
    double freeMotion_s = 0.1;   ///< too short to tell a drift
    double lastTorque_Nm = 0.06; ///< the motion ends with the first reading over this
    double torqueNoise_Nm = 0.0005;
    double angleNoise_rad = 0.0;
    double torqueReference_Nm = 0.0;

    [[nodiscard]] double totalStiffness_NPerM() const {
        return 1.0 / (objectCompliance_mPerN + 1.0 / link_NPerM);
    }

    [[nodiscard]] std::vector<JointSample> record(std::uint64_t seed) const {
        std::mt19937_64 random(seed);
        std::normal_distribution<double> normal;
        const double jointStiffness_NmPerRad = contactDistance_m * contactDistance_m * totalStiffness_NPerM();
        // The object stands anywhere between two samples.
        const double contactAngle_rad =
            speed_radPerS *
            (freeMotion_s + std::uniform_real_distribution<double>(0.0, 1.0 / rate_Hz)(random));
        std::vector<JointSample> log;
        for (std::uint64_t i = 0; log.empty() || log.back().torque_Nm <= torqueReference_Nm + lastTorque_Nm;
             ++i) {
            const double time_s = static_cast<double>(i) / rate_Hz;
            const double angle_rad = speed_radPerS * time_s;
            const double pressed_rad = angle_rad > contactAngle_rad ? angle_rad - contactAngle_rad : 0.0;
            const double torque_Nm = torqueReference_Nm + jointStiffness_NmPerRad * pressed_rad;
            log.push_back({time_s, angle_rad + angleNoise_rad * normal(random),
                           torque_Nm + torqueNoise_Nm * normal(random)});
        }
        return log;
    }
};

} // namespace teleta::stiffness::test
