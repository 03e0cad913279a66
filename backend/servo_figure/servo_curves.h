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

namespace teleta::servo_figure {

/// The curves of a servo run that a figure shows, one entry per step. Undefined values are NaN. Thread: one.
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
    /// Position of the array in the base, relative to where it was first in contact; NaN before.
    std::vector<double> x_m, y_m, z_m;
    std::vector<double> way_m; ///< length of the path since then
    /// Turn of the array about its own z since the same moment, measured and commanded.
    std::vector<double> turnZ_rad, turnZCommanded_rad;
    std::vector<std::pair<double, std::string>> phases; ///< start of each phase and its name

    struct Span {
        double begin_s;
        double end_s;
        servo::ActiveLimits limits; ///< limits that acted in the span
    };
    static constexpr std::size_t kMostSpans =
        4096;                          ///< largest number of spans of each kind; further ones extend the last
    std::vector<Span> contacts;        ///< while the servo reports contact
    std::vector<Span> limits;          ///< each while the same limits act
    std::optional<double> massMoves_s; ///< when a weight on the tray is first moved

    void add(const servo::ServoStep& step, std::string_view phase);
    /// Takes the events of a step without adding to the curves.
    void note(const servo::ServoStep& step);
    /// Keeps every second entry of the curves and all phases.
    void thin();

private:
    static void lengthen(std::vector<Span>& spans, double now_s, const servo::ActiveLimits& acting,
                         bool goesOn);

    [[nodiscard]] double turnSinceStart_rad(const Eigen::Quaterniond& q_Base_Sensor) const;

    std::optional<Eigen::Vector3d> m_start_m;
    Eigen::Quaterniond m_q_Base_Start = Eigen::Quaterniond::Identity();
    bool m_touching = false; ///< in the last step
    bool m_limited = false;
    double m_mass_m = servo::ServoStep::kNone;
    double m_noted_s = 0.0;
};

/// Reads a run written by `teleta simulate --out`. path: its folder or its servo.csv; the run is named after
/// the folder. Error: badInput with line and column, notFound. Thread: any.
[[nodiscard]] core::Expected<ServoCurves> readServoCurves(const std::string& path);

} // namespace teleta::servo_figure
