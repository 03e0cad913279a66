// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/servo/servo_step.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace teleta::servo {

/// What a figure shows of a servo run, one entry a step. What is not defined is NaN. Thread: one.
struct ServoCurves {
    std::string name;
    bool simulated = true;
    std::vector<double> time_s;
    std::vector<double> force_N;
    std::vector<double> desired_N;
    std::vector<double> copY_m;
    std::vector<double> copYDesired_m;
    std::vector<double> cocX_m;
    std::vector<double> cocXDesired_m;
    std::vector<double> dzmpY_m;
    std::vector<double> dzmpYDesired_m;
    std::vector<double> dzmpYTrue_m;
    std::vector<double> alphaZ_rad;
    std::vector<double> alphaZDesired_rad;
    /// Of the array in the base, from where it was first in contact; NaN before.
    std::vector<double> x_m, y_m, z_m;
    std::vector<double> way_m; ///< the length of that
    /// Turn of the array about its own z since the same moment, and where it was commanded to be.
    std::vector<double> turnZ_rad, turnZCommanded_rad;
    std::vector<std::pair<double, std::string>> phases; ///< when each one began

    struct Span {
        double begin_s;
        double end_s;
        ActiveLimits limits; ///< that acted in it
    };
    static constexpr std::size_t kMostSpans = 4096; ///< of each kind; further ones lengthen the last
    std::vector<Span> contacts;                     ///< while the servo takes itself to be in contact
    std::vector<Span> limits;                       ///< while the same ones act
    std::optional<double> massMoves_s;              ///< when a weight on the tray is moved first

    void add(const ServoStep& step, std::string_view phase);
    /// The events of a step whose curves are left out.
    void note(const ServoStep& step);
    /// Keeps every second entry; the phases stay.
    void thin();

private:
    static void lengthen(std::vector<Span>& spans, double now_s, const ActiveLimits& acting, bool goesOn);

    [[nodiscard]] double turnSinceStart_rad(const Eigen::Quaterniond& q_Base_Sensor) const;

    std::optional<Eigen::Vector3d> m_start_m;
    Eigen::Quaterniond m_q_Base_Start = Eigen::Quaterniond::Identity();
    bool m_touching = false; ///< in the last step
    bool m_limited = false;
    double m_mass_m = ServoStep::kNone;
    double m_noted_s = 0.0;
};

/// Reads a run that `teleta simulate --out` has written. path: its folder or its servo.csv; the folder names
/// the run. Error: badInput with line and column, notFound.
[[nodiscard]] core::Expected<ServoCurves> readServoCurves(const std::string& path);

} // namespace teleta::servo
