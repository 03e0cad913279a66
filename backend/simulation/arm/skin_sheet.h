// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/core/device/arm_device.h"

#include <span>

namespace teleta::simulation {

/// How the loads of contacts spread over the taxels of a sheet around the forearm: the elastic cover hands
/// each load to 4 x 4 taxels, with the weights of uniform cubic B-splines. Inside the sheet the taxels
/// therefore sum to the load, and their centre is the contact point, exactly. What reaches over the sheet's
/// border is not carried. Where a sheet longer than the circumference overlaps, both layers feel the load.
/// Thread: any (const).
class SkinSheet {
public:
    SkinSheet(const core::ArrayLayout& layout, const core::SkinPlacement& placement)
        : m_layout(layout)
        , m_placement(placement) {}

    /// Adds a load at a distance from the elbow and a side of the forearm. load_N: layout.taxels() values.
    void press(double distance_m, double side_rad, double force_N, std::span<double> load_N) const;

private:
    void pressAt(double x_m, double y_m, double force_N, std::span<double> load_N) const;

    core::ArrayLayout m_layout;
    core::SkinPlacement m_placement;
};

} // namespace teleta::simulation
