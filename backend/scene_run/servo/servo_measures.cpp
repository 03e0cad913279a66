// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/servo/servo_measures.h"

#include "backend/scene_run/base/scene_summary.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace teleta::scene_run {

namespace {

using nlohmann::ordered_json;

constexpr double kBalanced_m = 0.0005;
constexpr double kSpeedWindow_s = 0.1;
constexpr double kSettled_s = 1.0;

} // namespace

void ServoMeasures::Errors::add(double error) {
    squares += error * error;
    most = std::max(most, std::abs(error));
    ++count;
}

ordered_json ServoMeasures::Errors::rms() const {
    return count > 0 ? jsonNumber(std::sqrt(squares / static_cast<double>(count))) : ordered_json();
}

ordered_json ServoMeasures::Errors::largest() const {
    return count > 0 ? jsonNumber(most) : ordered_json();
}

ServoMeasures::ServoMeasures(const scene::Scene& scene)
    : m_task(scene.servo().task)
    , m_alignment(m_task)
    , m_cycle_s(1.0 / scene.rate_Hz)
    , m_frame_s(1.0 / std::min(scene.servo().sensor.acquisition_Hz, scene.rate_Hz)) {
    const double servoStep_s = 1.0 / std::min(scene.servo().sensor.servo_Hz, scene.rate_Hz);
    m_ways_m.assign(static_cast<std::size_t>(std::max(1.0, std::round(kSpeedWindow_s / servoStep_s))), 0.0);
    m_waysTime_s = servoStep_s * static_cast<double>(m_ways_m.size());
    if (!scene.servo().object.hinge)
        return;
    const auto& motion = scene.servo().object.hinge->motion;
    const auto moves = std::ranges::adjacent_find(
        motion, [](const auto& from, const auto& to) { return from.x_m != to.x_m; });
    if (moves != motion.end())
        m_massMoves_s = moves->time_s;
}

bool ServoMeasures::add(const simulation::ServoLoop& loop) {
    m_now_s = loop.world().time_s();
    if (loop.world().truth().touching) {
        if (!m_firstContact_s)
            m_firstContact_s = m_now_s;
    } else if (m_firstContact_s) {
        m_lost_s += m_cycle_s;
    }
    if (m_massMoves_s)
        m_tilt_rad = std::max(m_tilt_rad, std::abs(loop.world().truth().hinge_rad));
    const servo::TaskKind kind = loop.output().kind;
    m_lasts = m_lasts || kind == servo::TaskKind::explore || kind == servo::TaskKind::comanipulation;
    m_alignment.add(loop);
    if (loop.frameCame())
        addFrame(loop);
    if (!loop.servoed())
        return false;
    const bool another = m_phases.empty() || loop.output().phaseBegan;
    if (another) {
        m_phase = servo::toString(loop.output().kind);
        m_phases.push_back({m_phase, m_now_s});
    }
    addServoCycle(loop);
    return another;
}

bool ServoMeasures::lasting(const simulation::ServoLoop& loop) const {
    if (m_lasts)
        return true;
    switch (loop.output().kind) {
    case servo::TaskKind::roll:
        return m_task.kind == scene::ServoTaskKind::roll && m_alignment.since_s();
    case servo::TaskKind::pointFollowing:
        return m_task.kind == scene::ServoTaskKind::point && m_alignment.since_s();
    default:
        return false;
    }
}

void ServoMeasures::addFrame(const simulation::ServoLoop& loop) {
    const simulation::ServoFrameTruth& frame = loop.world().frameTruth();
    const bool loaded = frame.loads.force_N > 0.0;
    const double dzmpY_m = frame.loads.copX_m - frame.loads.cocX_m;
    const double copError_m = std::hypot(frame.loads.copX_m, frame.loads.copY_m - m_task.copY_m);
    m_highestForce_N = std::max(m_highestForce_N, loop.world().truth().force_N);
    if (lasting(loop)) {
        m_force_N.add(loop.world().truth().force_N - m_task.force_N);
        if (loaded && !frame.alphaZ_rad)
            m_cop_m.add(copError_m);
        const auto aligned_s = m_alignment.since_s();
        if (aligned_s && m_now_s >= *aligned_s + kSettled_s)
            m_settledForce_N.add(loop.world().truth().force_N - m_task.force_N);
    }
    if (m_massMoves_s && m_now_s >= *m_massMoves_s) {
        m_dzmpY_m.push_back(loaded ? dzmpY_m : std::nan(""));
        if (!loaded || std::abs(dzmpY_m) >= kBalanced_m)
            m_unsettled_s = m_now_s;
        if (loaded && frame.alphaZ_rad)
            m_alpha_rad.add(*frame.alphaZ_rad);
    }
}

void ServoMeasures::addServoCycle(const simulation::ServoLoop& loop) {
    if (loop.output().kind != servo::TaskKind::explore) {
        m_last_m.reset();
        std::ranges::fill(m_ways_m, 0.0);
        return;
    }
    const Eigen::Isometry3d& X_Base_Sensor = loop.world().arm().X_Base_Sensor();
    if (m_last_m) {
        const double way_m =
            std::abs((X_Base_Sensor.translation() - *m_last_m).dot(X_Base_Sensor.linear().col(0)));
        m_path_m += way_m;
        m_ways_m[m_way++ % m_ways_m.size()] = way_m;
        m_fastest_mPerS =
            std::max(m_fastest_mPerS, std::accumulate(m_ways_m.begin(), m_ways_m.end(), 0.0) / m_waysTime_s);
    }
    m_last_m = X_Base_Sensor.translation();
    const contact::TactileFeatures& felt = loop.features();
    if (!felt.copX_m || !felt.copY_m)
        return;
    m_points_m.push_back(X_Base_Sensor * Eigen::Vector3d(*felt.copX_m, *felt.copY_m, 0.0));
    m_line_m.add(loop.world().contourDistance_m(m_points_m.back()));
}

void ServoMeasures::report(ordered_json& measures) const {
    measures["first_contact_s"] = orNull(m_firstContact_s);
    const auto aligned_s = m_alignment.since_s();
    measures["aligned_after_s"] =
        aligned_s && m_firstContact_s ? jsonNumber(*aligned_s - *m_firstContact_s) : ordered_json(nullptr);
    ordered_json phases = ordered_json::array();
    for (const Phase& phase : m_phases)
        phases.push_back({phase.name, phase.start_s});
    measures["phases"] = phases;
    measures["force_desired_n"] = jsonNumber(m_task.force_N);
    measures["force_rms_error_n"] = m_force_N.rms();
    measures["force_max_error_n"] = m_force_N.largest();
    measures["contact_lost_s"] = jsonNumber(m_lost_s);
    if (m_massMoves_s) {
        const double settled_s = m_unsettled_s ? *m_unsettled_s + m_frame_s : *m_massMoves_s;
        measures["dzmp_y_settle_s"] =
            settled_s < m_now_s - m_frame_s ? jsonNumber(settled_s - *m_massMoves_s) : ordered_json(nullptr);
        const auto last = std::min(m_dzmpY_m.size(), static_cast<std::size_t>(std::round(1.0 / m_frame_s)));
        measures["dzmp_y_final_m"] =
            jsonNumber(mean({m_dzmpY_m.end() - static_cast<std::ptrdiff_t>(last), m_dzmpY_m.end()}));
        measures["alpha_z_rms_rad"] = m_alpha_rad.rms();
        measures["tray_tilt_max_rad"] = jsonNumber(m_tilt_rad);
    }
    if (m_task.kind == scene::ServoTaskKind::exploreEdge) {
        measures["reconstruction_rms_m"] = m_line_m.rms();
        measures["path_length_m"] = jsonNumber(m_path_m);
        measures["max_sliding_speed_m_s"] = jsonNumber(m_fastest_mPerS);
    }
    if (m_cop_m.count > 0) {
        measures["cop_rms_error_m"] = m_cop_m.rms();
        measures["cop_max_error_m"] = m_cop_m.largest();
        measures["force_settled_max_error_n"] = m_settledForce_N.largest();
        measures["force_overshoot_n"] = jsonNumber(std::max(0.0, m_highestForce_N - m_task.force_N));
    }
}

} // namespace teleta::scene_run
