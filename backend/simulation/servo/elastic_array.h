// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/servo/arm/rigid_motion.h"
#include "backend/simulation/effects/housing_rim.h"
#include "backend/simulation/servo/touched_shape.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <span>
#include <vector>

namespace teleta::simulation {

/// What a body does to the array at one pose.
struct ArrayContact {
    double energy_J = 0.0;
    servo::Wrench wrench_Sensor = servo::Wrench::Zero(); ///< on the array, in {s} about its origin
    /// Gauss-Newton part of the energy's second derivative over a twist of the array in {s}; symmetric, >= 0.
    servo::Matrix6 tangent_Sensor = servo::Matrix6::Zero();
    int springs = 0; ///< that are pressed
};

/// A spring that a body presses, as friction sees it.
struct PressedPoint {
    Eigen::Vector3d p_Sensor;
    Eigen::Vector3d normal_Sensor; ///< of the body, unit vector
    double force_N;                ///< along the normal
};

/// Sums of one frame over the array, before any effect of the sensor.
struct ArrayLoads {
    double force_N = 0.0; ///< on the taxels, along -z
    double rim_N = 0.0;   ///< on the housing
    double copX_m = 0.0;  ///< of the taxels' loads; defined when force_N > 0
    double copY_m = 0.0;
    /// Middle of the contact: mean over the columns of springs of which at least one is pressed, and over all
    /// pressed springs; defined when force_N > 0.
    double cocX_m = 0.0;
    double cocY_m = 0.0;
};

/// An array of springs along z of {s}, 2 x 4 a taxel, that a rigid body presses, and a rim of springs around
/// it where the housing is simulated. A spring at p is shortened by the depth d of p in the body:
///   energy = k d^2 / 2,  wrench = k d [n; p x n],  n the body's normal at p
/// in series with the body's own stiffness: k = k_array k_body / (k_array + k_body), each of a patch as large
/// as the spring's. The wrench, without friction, is the derivative of the energy. Which springs are near the
/// body is remembered while the pose changes little. After a shape has changed its form,
/// forget() has to be called.
/// Thread: one; press() and readLoads() allocate nothing.
class ElasticArray {
public:
    /// taxelStiffness_NPerM: of one taxel; bodyStiffness_NPerM: of the body's patch of a taxel's area.
    /// factors: one a taxel, or empty: all 1.
    ElasticArray(const core::ArrayLayout& layout, double taxelStiffness_NPerM, double bodyStiffness_NPerM,
                 std::span<const double> factors, const std::vector<RimSide>& rim);

    [[nodiscard]] ArrayContact press(const Eigen::Isometry3d& X_Sensor_Object,
                                     const TouchedShape& shape) const;

    /// The springs that are pressed, in place of what was in points; allocates nothing once it has held as
    /// many.
    void listPressed(const Eigen::Isometry3d& X_Sensor_Object, const TouchedShape& shape,
                     std::vector<PressedPoint>& points) const;
    [[nodiscard]] std::size_t springs() const { return m_springs.size(); }

    /// Loads of the taxels in N (layout.taxels() values, overwritten), along -z.
    ArrayLoads readLoads(const Eigen::Isometry3d& X_Sensor_Object, const TouchedShape& shape,
                         std::span<double> load_N) const;

    /// What is remembered of a shape.
    void forget() {
        m_nearShape = nullptr;
        m_pressedShape = nullptr;
    }

    [[nodiscard]] const core::ArrayLayout& layout() const { return m_layout; }

private:
    struct Spring {
        Eigen::Vector3d p_Sensor;
        double stiffness_NPerM; ///< in series with the body
        int taxel;              ///< -1: of the housing
    };
    /// Springs in a row, so far from one another that a distance from a body skips some of them.
    struct Row {
        std::size_t first;
        std::size_t count;
        double perMetre;
    };

    /// Numbers of springs side by side, one of each for every spring of the array.
    struct Columns {
        std::vector<double> x, y, z, stiffness_NPerM, depth_m, normalX, normalY, normalZ;
        std::vector<double> length; ///< of a normal
        std::vector<double> force_N;
        std::vector<double> momentX, momentY, momentZ; ///< of a normal about the origin of {s}

        void resize(std::size_t springs) {
            for (auto* each : {&x, &y, &z, &stiffness_NPerM, &depth_m, &normalX, &normalY, &normalZ, &length,
                               &force_N, &momentX, &momentY, &momentZ})
                each->resize(springs);
        }
    };

    /// Finds the springs that are pressed, in the order of the springs: m_pressed and the first entries of
    /// m_inBody, normals in {s}.
    void findPressed(const Eigen::Isometry3d& X_Sensor_Object, const TouchedShape& touched) const;
    template <typename Shape>
    void findDepths(const Eigen::Isometry3d& X_Object_Sensor, const Shape& shape) const;
    /// take(spring, depth, normal in {s})
    template <typename Take>
    void forEachPressed(const Eigen::Isometry3d& X_Sensor_Object, const TouchedShape& touched,
                        Take&& take) const;
    template <typename Shape>
    void findNear(const Eigen::Isometry3d& X_Object_Sensor, const Shape& shape) const;

    core::ArrayLayout m_layout;
    double m_reach_m; ///< of the farthest spring from the origin
    std::vector<Spring> m_springs;
    std::vector<Row> m_rows; ///< columns of the array from -x to x, then the sides of the housing
    // The springs that were near the body, or in it, when it was at a pose: until something has moved by the
    // margin, no others can be pressed.
    mutable std::vector<std::size_t> m_near;
    mutable Eigen::Isometry3d m_X_Object_Sensor = Eigen::Isometry3d::Identity();
    mutable const void* m_nearShape = nullptr;
    mutable Columns m_nearby; ///< of m_near; normals in the body's frame, not yet divided by their length
    mutable std::vector<std::size_t> m_pressed; ///< places in m_near
    mutable Columns m_inBody;                   ///< of m_pressed
    // The pose and shape of which these are: a frame is read where the last step ended.
    mutable Eigen::Isometry3d m_X_Sensor_Object = Eigen::Isometry3d::Identity();
    mutable const TouchedShape* m_pressedShape = nullptr;
};

} // namespace teleta::simulation
