// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/array/contact_errors.h"

#include "backend/scene_run/base/scene_summary.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace teleta::scene_run {

void ContactErrors::add(double x_m, double y_m, std::span<const contact::Contact> found) {
    if (found.empty()) {
        ++m_missed;
        return;
    }
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const contact::Contact& contact : found)
        nearest_m = std::min(nearest_m, std::hypot(contact.x_m - x_m, contact.y_m - y_m));
    m_errors_m.push_back(nearest_m);
}

void ContactErrors::report(nlohmann::ordered_json& measures) {
    reportContactErrors(m_errors_m, measures);
}

} // namespace teleta::scene_run
