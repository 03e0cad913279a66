// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/servo/elastic_array.h"

#include <algorithm>
#include <array>

namespace teleta::simulation {

namespace {

constexpr int kSpringsX = 2; ///< a taxel
constexpr int kSpringsY = 4;
/// How far outside the body a spring still counts as near it.
constexpr double kMargin_m = 0.0003;

double inSeries(double a, double b) {
    return a / (1.0 + a / b);
}

} // namespace

ElasticArray::ElasticArray(const core::ArrayLayout& layout, double taxelStiffness_NPerM,
                           double bodyStiffness_NPerM, std::span<const double> factors,
                           const std::vector<RimSide>& rim)
    : m_layout(layout)
    , m_reach_m(0.0) {
    const double cellX_m = layout.pitch_m / kSpringsX;
    const double cellY_m = layout.pitch_m / kSpringsY;
    const int cellsX = layout.columns * kSpringsX;
    const int cellsY = layout.rows * kSpringsY;
    for (int i = 0; i < cellsX; ++i) {
        m_rows.push_back({m_springs.size(), static_cast<std::size_t>(cellsY), 1.0 / cellY_m});
        for (int j = 0; j < cellsY; ++j) {
            const int taxel = j / kSpringsY * layout.columns + i / kSpringsX;
            const double factor = factors.empty() ? 1.0 : factors[static_cast<std::size_t>(taxel)];
            m_springs.push_back(
                {Eigen::Vector3d((i - 0.5 * (cellsX - 1)) * cellX_m, (j - 0.5 * (cellsY - 1)) * cellY_m, 0.0),
                 inSeries(factor * taxelStiffness_NPerM, bodyStiffness_NPerM) / (kSpringsX * kSpringsY),
                 taxel});
        }
    }
    for (const RimSide& side : rim) {
        const double step_m = side.step_m.norm();
        m_rows.push_back({m_springs.size(), static_cast<std::size_t>(side.count), 1.0 / step_m});
        for (int j = 0; j < side.count; ++j)
            m_springs.push_back(
                {side.first_m + j * side.step_m,
                 inSeries(side.stiffness_NPerM, step_m / layout.pitch_m * bodyStiffness_NPerM), -1});
    }
    for (const Spring& spring : m_springs)
        m_reach_m = std::max(m_reach_m, spring.p_Sensor.norm());
    m_near.reserve(m_springs.size());
}

/// A depth changes by no more than the way of the point: springs that are nearer to one outside the body than
/// its distance are outside as well, and skipped.
template <typename Shape>
void ElasticArray::findNear(const Eigen::Isometry3d& X_Object_Sensor, const Shape& shape) const {
    m_near.clear();
    m_X_Object_Sensor = X_Object_Sensor;
    m_nearShape = &shape;
    for (const Row& row : m_rows) {
        for (std::size_t j = 0; j < row.count;) {
            const double outside_m =
                -shape.at(X_Object_Sensor * m_springs[row.first + j].p_Sensor).depth_m - kMargin_m;
            if (outside_m < 0.0) {
                m_near.push_back(row.first + j);
                ++j;
            } else {
                j += static_cast<std::size_t>(std::clamp(outside_m * row.perMetre, 1.0, 1e6));
            }
        }
    }
}

/// take(spring, depth, normal in {s}), in the order of the springs.
template <typename Take>
void ElasticArray::forEachPressed(const Eigen::Isometry3d& X_Sensor_Object, const TouchedShape& touched,
                                  Take&& take) const {
    const Eigen::Isometry3d X_Object_Sensor = X_Sensor_Object.inverse(Eigen::Isometry);
    const double moved_m = (X_Object_Sensor.translation() - m_X_Object_Sensor.translation()).norm() +
                           m_reach_m * (X_Object_Sensor.linear() - m_X_Object_Sensor.linear()).norm();
    std::visit(
        [&](const auto& shape) {
            if (m_nearShape != &shape || !(moved_m < kMargin_m))
                findNear(X_Object_Sensor, shape);
            for (const std::size_t index : m_near) {
                const Spring& spring = m_springs[index];
                if (Depth depth; contains(shape, X_Object_Sensor * spring.p_Sensor, depth))
                    take(spring, depth.depth_m, Eigen::Vector3d(X_Sensor_Object.linear() * depth.normal));
            }
        },
        touched);
}

ArrayContact ElasticArray::press(const Eigen::Isometry3d& X_Sensor_Object, const TouchedShape& shape) const {
    double energy_J = 0.0;
    std::array<double, 6> wrench{};
    std::array<double, 36> tangent{}; ///< column by column
    int springs = 0;
    forEachPressed(
        X_Sensor_Object, shape, [&](const Spring& spring, double depth_m, const Eigen::Vector3d& normal) {
            const Eigen::Vector3d moment = spring.p_Sensor.cross(normal);
            // Plain numbers stay in registers, where a vector goes through memory.
            const std::array screw{normal.x(), normal.y(), normal.z(), moment.x(), moment.y(), moment.z()};
            const double stiffness_NPerM = spring.stiffness_NPerM;
            const double force_N = stiffness_NPerM * depth_m;
            energy_J += 0.5 * force_N * depth_m;
            for (std::size_t column = 0; column < 6; ++column) {
                wrench[column] += force_N * screw[column];
                for (std::size_t row = 0; row < 6; ++row)
                    tangent[6 * column + row] += stiffness_NPerM * screw[row] * screw[column];
            }
            ++springs;
        });
    ArrayContact contact;
    contact.energy_J = energy_J;
    contact.wrench_Sensor = Eigen::Map<const servo::Wrench>(wrench.data());
    contact.tangent_Sensor = Eigen::Map<const servo::Matrix6>(tangent.data());
    contact.springs = springs;
    return contact;
}

void ElasticArray::listPressed(const Eigen::Isometry3d& X_Sensor_Object, const TouchedShape& shape,
                               std::vector<PressedPoint>& points) const {
    points.clear();
    forEachPressed(X_Sensor_Object, shape,
                   [&](const Spring& spring, double depth_m, const Eigen::Vector3d& normal) {
                       points.push_back({spring.p_Sensor, normal, spring.stiffness_NPerM * depth_m});
                   });
}

ArrayLoads ElasticArray::readLoads(const Eigen::Isometry3d& X_Sensor_Object, const TouchedShape& shape,
                                   std::span<double> load_N) const {
    std::ranges::fill(load_N, 0.0);
    ArrayLoads loads;
    int pressed = 0;
    int columns = 0;
    double column_m = -m_reach_m;
    forEachPressed(X_Sensor_Object, shape,
                   [&](const Spring& spring, double depth_m, const Eigen::Vector3d& normal) {
                       const Eigen::Vector3d& place = spring.p_Sensor;
                       // The body is in front of the array: it presses along -z.
                       const double force_N = spring.stiffness_NPerM * depth_m * -normal.z();
                       if (spring.taxel < 0) {
                           loads.rim_N += force_N;
                           return;
                       }
                       load_N[static_cast<std::size_t>(spring.taxel)] += force_N;
                       loads.force_N += force_N;
                       loads.copX_m += force_N * place.x();
                       loads.copY_m += force_N * place.y();
                       loads.cocY_m += place.y();
                       ++pressed;
                       // Springs come column by column.
                       if (place.x() > column_m) {
                           column_m = place.x();
                           loads.cocX_m += place.x();
                           ++columns;
                       }
                   });
    if (pressed > 0) {
        loads.cocX_m /= columns;
        loads.cocY_m /= pressed;
    }
    if (loads.force_N > 0.0) {
        loads.copX_m /= loads.force_N;
        loads.copY_m /= loads.force_N;
    }
    return loads;
}

} // namespace teleta::simulation
