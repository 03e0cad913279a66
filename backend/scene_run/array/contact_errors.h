// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/contact_segmenter.h"

#include <nlohmann/json.hpp>

#include <span>
#include <vector>

namespace teleta::scene_run {

/// How far found contacts are from true ones. For every true contact point of a frame the distance to the
/// nearest contact that was found; two loads that are found as one contact both count with their distance to
/// it.
class ContactErrors {
public:
    /// Adds a true contact point of a frame; without any contact found it counts as missed.
    void add(double x_m, double y_m, std::span<const contact::Contact> found);

    [[nodiscard]] std::size_t compared() const { return m_errors_m.size(); }
    [[nodiscard]] std::size_t missed() const { return m_missed; }
    /// contact_error_mean_m, contact_error_p95_m.
    void report(nlohmann::ordered_json& measures);

private:
    std::vector<double> m_errors_m;
    std::size_t m_missed = 0;
};

} // namespace teleta::scene_run
