// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/array/foundation_contact.h"

#include <algorithm>
#include <cmath>

namespace teleta::simulation {

namespace {

using Eigen::AlignedBox2d;

constexpr int kCellsPerSide = 8;

/// Index of the taxel that a coordinate lies in, clamped to the array. position: in pitches from the array's
/// start.
int taxelIndex(double position, int count) {
    return static_cast<int>(std::clamp(std::floor(position), 0.0, static_cast<double>(count - 1)));
}

AlignedBox2d boxAround(double x_m, double y_m, double halfX_m, double halfY_m) {
    return {Eigen::Vector2d(x_m - halfX_m, y_m - halfY_m), Eigen::Vector2d(x_m + halfX_m, y_m + halfY_m)};
}

AlignedBox2d boxOf(const RigidIndenter& body) {
    return boxAround(body.pose().x_m, body.pose().y_m, body.halfWidthX_m(), body.halfWidthY_m());
}

bool hasArea(const AlignedBox2d& box) {
    return (box.min().array() < box.max().array()).all();
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

    AlignedBox2d reach;
    for (const RigidIndenter& body : indenters) {
        if (body.touches())
            reach.extend(boxOf(body));
    }
    if (hasArea(reach)) {
        const auto column = [&](double x_m) {
            return taxelIndex(x_m / m_layout.pitchX_m + 0.5 * m_layout.columns, m_layout.columns);
        };
        const auto row = [&](double y_m) {
            return taxelIndex(y_m / m_layout.pitchY_m + 0.5 * m_layout.rows, m_layout.rows);
        };
        for (int r = row(reach.min().y()); r <= row(reach.max().y()); ++r) {
            for (int c = column(reach.min().x()); c <= column(reach.max().x()); ++c) {
                const AlignedBox2d taxel = boxAround(m_layout.x_m(c), m_layout.y_m(r),
                                                     0.5 * m_layout.pitchX_m, 0.5 * m_layout.pitchY_m);
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

void FoundationContact::pressTaxel(std::span<const RigidIndenter> indenters, const AlignedBox2d& taxel,
                                   double& load_N) {
    m_reaching.clear();
    AlignedBox2d part;
    for (std::size_t i = 0; i < indenters.size(); ++i) {
        const AlignedBox2d inside = taxel.intersection(boxOf(indenters[i]));
        if (!indenters[i].touches() || !hasArea(inside))
            continue;
        m_reaching.push_back(i);
        part.extend(inside);
    }
    if (m_reaching.empty())
        return;

    const double width_m = (part.max().x() - part.min().x()) / kCellsPerSide;
    const double height_m = (part.max().y() - part.min().y()) / kCellsPerSide;
    const double stiffness_NPerM = m_stiffness_NPerM3 * width_m * height_m;
    for (int j = 0; j < kCellsPerSide; ++j) {
        const double y_m = part.min().y() + (j + 0.5) * height_m;
        for (int i = 0; i < kCellsPerSide; ++i) {
            const double x_m = part.min().x() + (i + 0.5) * width_m;
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
