// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/contact_search.h"

#include <algorithm>
#include <array>

namespace teleta::servo {

namespace {

/// Below this speed the sensor does not slide, and the previous direction is kept.
constexpr double kSliding_mPerS = 1e-4;
/// Distance within which the sensor has reached its target.
constexpr double kThere_m = 1e-6;
constexpr double kTurn_radPerS = 0.2;
/// A target that is not reached within this multiple of the time needed plus this time is out of reach.
constexpr double kPatience = 2.0;
constexpr double kPatience_s = 0.5;

} // namespace

const char* toString(ContactState state) {
    constexpr std::array kNames{"none", "touching", "searching", "lost"};
    return kNames[static_cast<std::size_t>(state)];
}

void ContactSearch::touched(const Eigen::Isometry3d& X_Base_Sensor, const Eigen::Vector3d& slide_Base_mPerS) {
    m_touched = true;
    m_X_Base_Last = X_Base_Sensor;
    Eigen::Vector3d slide_Sensor = X_Base_Sensor.linear().transpose() * slide_Base_mPerS;
    slide_Sensor.z() = 0.0;
    if (slide_Sensor.norm() > kSliding_mPerS)
        m_back_Last = -slide_Sensor.normalized();
}

void ContactSearch::begin() {
    m_running = true;
    m_stage = Stage::retreat;
    m_probe = 0;
    m_left_s.reset();
}

void ContactSearch::reset() {
    m_touched = false;
    m_running = false;
}

Eigen::Isometry3d ContactSearch::target(const SearchSettings& settings) const {
    const int probe = m_probe < 0 ? settings.probes - 1 : m_probe;
    Eigen::Vector3d p_Last = (probe * settings.probeStep_m) * m_back_Last;
    p_Last.z() = m_stage == Stage::approach && m_probe >= 0 ? settings.depth_m : -settings.retreat_m;
    return m_X_Base_Last * Eigen::Translation3d(p_Last);
}

void ContactSearch::advance(const SearchSettings& settings) {
    switch (m_stage) {
    case Stage::retreat:
    case Stage::shift:
        m_stage = Stage::approach;
        break;
    case Stage::approach:
        m_stage = Stage::withdraw;
        break;
    case Stage::withdraw:
        m_probe = m_probe + 1 < settings.probes ? m_probe + 1 : -1;
        m_stage = m_probe < 0 ? Stage::withdraw : Stage::shift;
        break;
    }
}

Twist ContactSearch::step(const Eigen::Isometry3d& X_Base_Sensor_commanded, double dt_s,
                          const SearchSettings& settings) {
    Twist difference = poseDifference(X_Base_Sensor_commanded, target(settings));
    if (!exhausted() && (difference.head<3>().norm() < kThere_m || m_left_s.value_or(dt_s) <= 0.0)) {
        advance(settings);
        m_left_s.reset();
        difference = poseDifference(X_Base_Sensor_commanded, target(settings));
    }
    const double way_s = std::max(difference.head<3>().norm() / settings.speed_mPerS,
                                  difference.tail<3>().norm() / kTurn_radPerS);
    m_left_s = m_left_s.value_or(kPatience * way_s + kPatience_s) - dt_s;
    return difference / std::max(way_s, dt_s);
}

} // namespace teleta::servo
