// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/array/foundation_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace teleta::simulation {

namespace {

constexpr int kCellsPerSide = 8;

/// Index of the taxel that a coordinate lies in, clamped to the array. position: in pitches from the array's
/// start.
int taxelIndex(double position, int count) {
    return static_cast<int>(std::clamp(std::floor(position), 0.0, static_cast<double>(count - 1)));
}

} // namespace

FoundationContact::FoundationContact(const core::ArrayLayout& layout, double stiffness_NPerM)
    : m_layout(layout)
    , m_stiffness_NPerM3(stiffness_NPerM / layout.taxelArea_m2()) {
}

void FoundationContact::press(std::span<const RigidIndenter> indenters, std::span<double> load_N,
                              std::span<IndenterLoad> loads) {
    std::ranges::fill(load_N, 0.0);
    m_force_N.assign(indenters.size(), 0.0);
    m_momentX_Nm.assign(indenters.size(), 0.0);
    m_momentY_Nm.assign(indenters.size(), 0.0);

    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Box reach{kInfinity, -kInfinity, kInfinity, -kInfinity};
    for (const RigidIndenter& body : indenters) {
        if (!body.touches())
            continue;
        reach.lowX_m = std::min(reach.lowX_m, body.pose().x_m - body.halfWidthX_m());
        reach.highX_m = std::max(reach.highX_m, body.pose().x_m + body.halfWidthX_m());
        reach.lowY_m = std::min(reach.lowY_m, body.pose().y_m - body.halfWidthY_m());
        reach.highY_m = std::max(reach.highY_m, body.pose().y_m + body.halfWidthY_m());
    }
    if (reach.lowX_m < reach.highX_m && reach.lowY_m < reach.highY_m) {
        const double pitch_m = m_layout.pitch_m;
        const auto column = [&](double x_m) {
            return taxelIndex(x_m / pitch_m + 0.5 * m_layout.columns, m_layout.columns);
        };
        const auto row = [&](double y_m) {
            return taxelIndex(y_m / pitch_m + 0.5 * m_layout.rows, m_layout.rows);
        };
        for (int r = row(reach.lowY_m); r <= row(reach.highY_m); ++r) {
            for (int c = column(reach.lowX_m); c <= column(reach.highX_m); ++c) {
                const double x_m = m_layout.x_m(c);
                const double y_m = m_layout.y_m(r);
                const Box taxel{x_m - 0.5 * pitch_m, x_m + 0.5 * pitch_m, y_m - 0.5 * pitch_m,
                                y_m + 0.5 * pitch_m};
                pressTaxel(indenters, taxel, load_N[static_cast<std::size_t>(r) * m_layout.columns + c]);
            }
        }
    }
    for (std::size_t i = 0; i < indenters.size(); ++i) {
        loads[i] = {.force_N = m_force_N[i], .copX_m = {}, .copY_m = {}};
        if (m_force_N[i] > 0.0) {
            loads[i].copX_m = m_momentX_Nm[i] / m_force_N[i];
            loads[i].copY_m = m_momentY_Nm[i] / m_force_N[i];
        }
    }
}

void FoundationContact::pressTaxel(std::span<const RigidIndenter> indenters, const Box& taxel,
                                   double& load_N) {
    m_reaching.clear();
    Box part{taxel.highX_m, taxel.lowX_m, taxel.highY_m, taxel.lowY_m};
    for (std::size_t i = 0; i < indenters.size(); ++i) {
        const RigidIndenter& body = indenters[i];
        const Box inside{std::max(taxel.lowX_m, body.pose().x_m - body.halfWidthX_m()),
                         std::min(taxel.highX_m, body.pose().x_m + body.halfWidthX_m()),
                         std::max(taxel.lowY_m, body.pose().y_m - body.halfWidthY_m()),
                         std::min(taxel.highY_m, body.pose().y_m + body.halfWidthY_m())};
        if (!body.touches() || inside.lowX_m >= inside.highX_m || inside.lowY_m >= inside.highY_m)
            continue;
        m_reaching.push_back(i);
        part = {std::min(part.lowX_m, inside.lowX_m), std::max(part.highX_m, inside.highX_m),
                std::min(part.lowY_m, inside.lowY_m), std::max(part.highY_m, inside.highY_m)};
    }
    if (m_reaching.empty())
        return;

    const double width_m = (part.highX_m - part.lowX_m) / kCellsPerSide;
    const double height_m = (part.highY_m - part.lowY_m) / kCellsPerSide;
    const double stiffness_NPerM = m_stiffness_NPerM3 * width_m * height_m;
    for (int j = 0; j < kCellsPerSide; ++j) {
        const double y_m = part.lowY_m + (j + 0.5) * height_m;
        for (int i = 0; i < kCellsPerSide; ++i) {
            const double x_m = part.lowX_m + (i + 0.5) * width_m;
            // Bodies that overlap press as one: the deeper one carries the cell.
            double deepest_m = 0.0;
            std::size_t carrier = 0;
            for (const std::size_t index : m_reaching) {
                const double depth_m = indenters[index].meanPenetration_m(x_m, y_m, width_m, height_m);
                if (depth_m > deepest_m) {
                    deepest_m = depth_m;
                    carrier = index;
                }
            }
            if (deepest_m <= 0.0)
                continue;
            const double force_N = stiffness_NPerM * deepest_m;
            load_N += force_N;
            m_force_N[carrier] += force_N;
            m_momentX_Nm[carrier] += force_N * x_m;
            m_momentY_Nm[carrier] += force_N * y_m;
        }
    }
}

} // namespace teleta::simulation
