// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/servo_phases.h"

#include <cmath>

namespace teleta::servo {

namespace {

bool within(const std::optional<double>& bound, const std::optional<double>& value) {
    return !bound || (value && std::abs(*value) <= *bound);
}

bool atLeast(const std::optional<double>& bound, double value) {
    return !bound || value >= *bound;
}

} // namespace

bool ServoPhases::update(const ServoPlan& plan, const contact::TactileFeatures& features,
                         double alphaError_rad, double path_m, double dt_s) {
    const ServoTask& task = plan.tasks[m_index];
    m_time_s += dt_s;
    m_path_m += path_m;

    const bool point = features.type == contact::ContactType::point;
    m_point_s = point ? m_point_s + dt_s : 0.0;
    if (task.ifPoint && *task.ifPoint != m_index && point && m_point_s >= task.pointFor_s) {
        enter(*task.ifPoint);
        return true;
    }

    const ExitCondition& exit = task.exit;
    if (!exit.named())
        return false;
    const bool edge = features.type == contact::ContactType::edge;
    const std::optional<double> alpha_rad =
        features.alphaZ_rad ? std::optional(alphaError_rad) : std::optional<double>();
    const std::optional<double> copYError_m =
        features.copY_m ? std::optional(task.desired.copY_m - *features.copY_m) : std::optional<double>();
    const bool holds = (!exit.contact || features.active > 0) && (!exit.edge || edge) &&
                       within(exit.alphaWithin_rad, alpha_rad) &&
                       within(exit.dzmpYWithin_m, features.dzmpY_m) &&
                       within(exit.copYWithin_m, copYError_m) && atLeast(exit.path_m, m_path_m) &&
                       atLeast(exit.time_s, m_time_s);
    m_held_s = holds ? m_held_s + dt_s : 0.0;
    if (!holds || m_held_s < exit.hold_s)
        return false;
    if (!task.next) {
        m_finished = true;
        return false;
    }
    enter(*task.next);
    return true;
}

bool ServoPhases::foundAgain(const ServoPlan& plan) {
    const std::optional<std::size_t> target = plan.tasks[m_index].afterSearch;
    if (!target || *target == m_index)
        return false;
    enter(*target);
    return true;
}

void ServoPhases::enter(std::size_t index) {
    m_index = index;
    m_time_s = 0.0;
    m_path_m = 0.0;
    m_held_s = 0.0;
    m_point_s = 0.0;
    m_finished = false;
}

} // namespace teleta::servo
