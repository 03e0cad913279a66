// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"

#include <Eigen/Core>

namespace teleta::view3d {

/// The body that carries the taxels.
enum class Surface {
    plate,    ///< flat
    cylinder, ///< wrapped around a tactile cylinder: x along its axis, y along its circumference
};

struct CylinderSize {
    double radius_m = 0.025;
    double length_m = 0.100;

    bool operator==(const CylinderSize&) const = default;
};

/// The smallest cylinder at least as large as `wanted` on which the array fits, wrapped at most once around.
/// wanted: finite, > 0.
[[nodiscard]] CylinderSize cylinderThatFits(const CylinderSize& wanted, const core::ArrayLayout& layout);

/// Points of a taxel array in space, in the array's frame {s}.
///   plate:    p = (x, y, h),                                        n = (0, 0, 1)
///   cylinder: p = (x, (rho + h) sin(y/rho), (rho + h) cos(y/rho)),  n = (0, sin(y/rho), cos(y/rho))
/// On the cylinder the axis is x, and the array's centre lies on top, at (0, 0, rho).
/// Thread: any (pure).
class SurfaceMap {
public:
    SurfaceMap() = default;
    /// radius_m: > 0; used by the cylinder only.
    SurfaceMap(Surface surface, double radius_m)
        : m_surface(surface)
        , m_radius_m(radius_m) {}

    /// height_m: above the surface; > -rho on the cylinder.
    [[nodiscard]] Eigen::Vector3d point(double x_m, double y_m, double height_m) const;
    /// Outward unit normal.
    [[nodiscard]] Eigen::Vector3d normal(double y_m) const;
    [[nodiscard]] Surface surface() const { return m_surface; }
    [[nodiscard]] double radius_m() const { return m_radius_m; }

private:
    Surface m_surface = Surface::plate;
    double m_radius_m = 0.025;
};

} // namespace teleta::view3d
