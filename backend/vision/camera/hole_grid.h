// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/camera/cylinder_projection.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace teleta::vision {

/// Holes of a shell around the tactile cylinder, through which a stick presses on the skin: rings of evenly
/// spaced holes. Source: VTacArm, section III-B (250 holes).
struct HoleGrid {
    int around = 25; ///< holes per ring; > 0
    int along = 10;  ///< rings; > 0
    double first_z_m = 0.005;
    double last_z_m = 0.095;
    double firstAngle_rad = 0.0; ///< angle of the first hole of each ring, from x towards y

    [[nodiscard]] std::size_t size() const {
        return static_cast<std::size_t>(around) * static_cast<std::size_t>(along);
    }
    [[nodiscard]] int ring(std::size_t hole) const { return static_cast<int>(hole) / around; }
    [[nodiscard]] double angle_rad(std::size_t hole) const;
    [[nodiscard]] double z_m(std::size_t hole) const;
};

/// Centres of the holes on the skin in the sensor frame {s}, ring by ring. Thread: any (pure).
[[nodiscard]] std::vector<Eigen::Vector3d> holesOnSkin_m(const HoleGrid& grid, const CylinderSurface& skin);

} // namespace teleta::vision
