// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/arm/skin_sheet.h"

#include <array>
#include <cmath>
#include <numbers>

namespace teleta::simulation {

namespace {

struct Spread {
    int first;
    std::array<double, 4> weight;
};

Spread spreadAt(double position) {
    const double base = std::floor(position);
    const double t = position - base;
    const double s = 1.0 - t;
    return {static_cast<int>(base) - 1,
            {s * s * s / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
             (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0, t * t * t / 6.0}};
}

} // namespace

void SkinSheet::press(double distance_m, double side_rad, double force_N, std::span<double> load_N) const {
    const double turn_rad = std::remainder(side_rad - m_placement.centreSide_rad, 2.0 * std::numbers::pi);
    const double circumference_m = 2.0 * std::numbers::pi * m_placement.radius_m;
    const double y_m = m_placement.y_m(m_placement.centreSide_rad + turn_rad);
    for (const double layer_m : {-circumference_m, 0.0, circumference_m})
        pressAt(m_placement.x_m(distance_m), y_m + layer_m, force_N, load_N);
}

void SkinSheet::pressAt(double x_m, double y_m, double force_N, std::span<double> load_N) const {
    const double column = x_m / m_layout.pitchX_m + 0.5 * (m_layout.columns - 1);
    const double row = y_m / m_layout.pitchY_m + 0.5 * (m_layout.rows - 1);
    if (!(column > -2.0 && column < m_layout.columns + 1.0 && row > -2.0 && row < m_layout.rows + 1.0))
        return;
    const Spread across = spreadAt(column);
    const Spread around = spreadAt(row);
    for (int j = 0; j < 4; ++j) {
        const int r = around.first + j;
        if (r < 0 || r >= m_layout.rows)
            continue;
        for (int i = 0; i < 4; ++i) {
            const int c = across.first + i;
            if (c < 0 || c >= m_layout.columns)
                continue;
            load_N[static_cast<std::size_t>(r) * static_cast<std::size_t>(m_layout.columns) +
                   static_cast<std::size_t>(c)] += force_N * around.weight[static_cast<std::size_t>(j)] *
                                                   across.weight[static_cast<std::size_t>(i)];
        }
    }
}

} // namespace teleta::simulation
