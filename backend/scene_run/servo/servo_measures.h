// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"
#include "backend/simulation/servo/alignment_watch.h"
#include "backend/simulation/servo/servo_loop.h"

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace teleta::scene_run {

/// Gathers the measures of a servo run, from the world's truth unless said otherwise.
/// - first_contact_s, phases [[name, start_s]], force_desired_n, contact_lost_s (from the first contact on)
/// - aligned_after_s: from the first contact until simulation::AlignmentWatch finds the array aligned
/// - force_rms_error_n, force_max_error_n: of the whole force on array and housing, in the plan's lasting
///   task. Exploring, co-manipulation: from their first step to the end, whatever task is fallen back to
///   meanwhile. A point: once it is aligned, following or rolling.
/// - explore: reconstruction_rms_m (contact points felt, from the true line), path_length_m and
///   max_sliding_speed_m_s (over 0.1 s) along the array's x
/// - comanipulate: dzmp_y_settle_s (from the mass's first motion until |DZMP_y| stays < 0.5 mm),
///   dzmp_y_final_m (mean of the last second), alpha_z_rms_rad (from then on), tray_tilt_max_rad (ever)
/// - point, roll: cop_rms_error_m, cop_max_error_m, once aligned and in the lasting task;
///   force_settled_max_error_n, the largest force error from 1 s after the alignment on;
///   force_overshoot_n, the largest force over the desired one in the whole run
/// Thread: one.
class ServoMeasures {
public:
    explicit ServoMeasures(const scene::Scene& scene);

    /// After every cycle of the loop. True when another phase has begun.
    bool add(const simulation::ServoLoop& loop);

    void report(nlohmann::ordered_json& measures) const;

    [[nodiscard]] const std::string& phase() const { return m_phase; }
    [[nodiscard]] double desiredForce_N() const { return m_task.force_N; }
    /// Where the array has felt the contact while it explored, in the base.
    [[nodiscard]] const std::vector<Eigen::Vector3d>& points_m() const { return m_points_m; }

private:
    struct Phase {
        std::string name;
        double start_s;
    };
    struct Errors {
        double squares = 0.0;
        double most = 0.0;
        std::size_t count = 0;

        void add(double error);
        [[nodiscard]] nlohmann::ordered_json rms() const; ///< null without any
        [[nodiscard]] nlohmann::ordered_json largest() const;
    };

    void addFrame(const simulation::ServoLoop& loop);
    void addServoCycle(const simulation::ServoLoop& loop);
    [[nodiscard]] bool lasting(const simulation::ServoLoop& loop) const;

    scene::ServoTaskSettings m_task;
    simulation::AlignmentWatch m_alignment;
    double m_cycle_s;
    std::optional<double> m_massMoves_s; ///< empty: no mass is moved
    std::string m_phase;
    std::vector<Phase> m_phases;
    std::optional<double> m_firstContact_s;
    std::optional<double> m_unsettled_s; ///< last time at which DZMP_y was too large
    double m_now_s = 0.0;
    double m_lost_s = 0.0;
    double m_path_m = 0.0;
    double m_fastest_mPerS = 0.0;
    double m_tilt_rad = 0.0;
    double m_highestForce_N = 0.0;
    Errors m_force_N;
    Errors m_settledForce_N;
    bool m_lasts = false; ///< exploring or co-manipulation has begun
    Errors m_cop_m;
    Errors m_alpha_rad;
    Errors m_line_m;
    std::vector<double> m_dzmpY_m; ///< since the mass moves, one a frame
    double m_frame_s;
    std::vector<Eigen::Vector3d> m_points_m;
    std::optional<Eigen::Vector3d> m_last_m; ///< place of the array in the last servo cycle of exploring
    std::vector<double> m_ways_m;            ///< the last ways of servo cycles, around
    std::size_t m_way = 0;
    double m_waysTime_s;
};

} // namespace teleta::scene_run
