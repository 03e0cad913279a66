// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/servo/elastic_array.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>

#ifdef __clang__ // what tells GCC that it may compute several places at once
#pragma clang diagnostic ignored "-Wunknown-attributes"
#pragma clang diagnostic ignored "-Wunknown-pragmas"
#endif

namespace teleta::simulation {

namespace {

constexpr int kSpringsX = 2; ///< a taxel
constexpr int kSpringsY = 4;
/// How far outside the body a spring still counts as near it.
constexpr double kMargin_m = 0.0003;

double inSeries(double a, double b) {
    return a / (1.0 + a / b);
}

/// Springs of which a column has a multiple.
constexpr std::size_t kTogether = 4;

/// Columns of pressed springs, one behind the other's end: the normal and its moment, the stiffness and the
/// force, filled up with springs of stiffness 0.
struct PressedColumns {
    std::array<const double*, 6> screw;
    const double* stiffness_NPerM;
    const double* force_N;
    std::size_t count; ///< a multiple of kTogether
};

template <std::size_t lanes>
struct Together {
    using Doubles [[gnu::vector_size(8 * lanes)]] = double;

    [[gnu::always_inline]] static double sum(const Doubles& numbers) {
        std::array<double, lanes> each;
        std::memcpy(each.data(), &numbers, sizeof(each));
        double sum = each[0];
        for (std::size_t lane = 1; lane < lanes; ++lane)
            sum += each[lane];
        return sum;
    }
};

/// The sums of a row of the tangent, from the diagonal on, and of the wrench. Each has a name of its own, so
/// that all stay in registers, where an array goes through memory.
template <std::size_t lanes, std::size_t row>
[[gnu::always_inline]] inline void addRow(const PressedColumns& pressed, servo::Wrench& wrench,
                                          servo::Matrix6& tangent) {
    using Lanes = typename Together<lanes>::Doubles;
    Lanes onRow{}, sum0{}, sum1{}, sum2{}, sum3{}, sum4{}, sum5{};
    for (std::size_t i = 0; i < pressed.count; i += lanes) {
        Lanes stiffness, force, own, other;
        std::memcpy(&stiffness, pressed.stiffness_NPerM + i, sizeof(stiffness));
        std::memcpy(&force, pressed.force_N + i, sizeof(force));
        std::memcpy(&own, pressed.screw[row] + i, sizeof(own));
        onRow += force * own;
        const Lanes weighted = stiffness * own;
        if constexpr (row <= 0) {
            std::memcpy(&other, pressed.screw[0] + i, sizeof(other));
            sum0 += weighted * other;
        }
        if constexpr (row <= 1) {
            std::memcpy(&other, pressed.screw[1] + i, sizeof(other));
            sum1 += weighted * other;
        }
        if constexpr (row <= 2) {
            std::memcpy(&other, pressed.screw[2] + i, sizeof(other));
            sum2 += weighted * other;
        }
        if constexpr (row <= 3) {
            std::memcpy(&other, pressed.screw[3] + i, sizeof(other));
            sum3 += weighted * other;
        }
        if constexpr (row <= 4) {
            std::memcpy(&other, pressed.screw[4] + i, sizeof(other));
            sum4 += weighted * other;
        }
        std::memcpy(&other, pressed.screw[5] + i, sizeof(other));
        sum5 += weighted * other;
    }
    constexpr auto kRow = static_cast<Eigen::Index>(row);
    wrench[kRow] = Together<lanes>::sum(onRow);
    const std::array<double, 6> sums{Together<lanes>::sum(sum0), Together<lanes>::sum(sum1),
                                     Together<lanes>::sum(sum2), Together<lanes>::sum(sum3),
                                     Together<lanes>::sum(sum4), Together<lanes>::sum(sum5)};
    for (Eigen::Index column = kRow; column < 6; ++column)
        tangent(kRow, column) = tangent(column, kRow) = sums[static_cast<std::size_t>(column)];
}

template <std::size_t lanes>
[[gnu::always_inline]] inline void addPressed(const PressedColumns& pressed, servo::Wrench& wrench,
                                              servo::Matrix6& tangent) {
    addRow<lanes, 0>(pressed, wrench, tangent);
    addRow<lanes, 1>(pressed, wrench, tangent);
    addRow<lanes, 2>(pressed, wrench, tangent);
    addRow<lanes, 3>(pressed, wrench, tangent);
    addRow<lanes, 4>(pressed, wrench, tangent);
    addRow<lanes, 5>(pressed, wrench, tangent);
}

#ifdef __x86_64__
bool hasAvx2() {
    static const bool has = __builtin_cpu_supports("avx2") != 0;
    return has;
}

[[gnu::target("avx2")]] void addPressedAvx2(const PressedColumns& pressed, servo::Wrench& wrench,
                                            servo::Matrix6& tangent) {
    addPressed<kTogether>(pressed, wrench, tangent);
}
#endif

/// Points of springs in {s}, and what nearest() says of each.
struct DepthColumns {
    const double* x;
    const double* y;
    const double* z;
    double* depth_m;
    double* normalX;
    double* normalY;
    double* normalZ;
    double* length;
    std::size_t count;
};

/// A bar without the question at each point whether it is bent.
struct Bent {
    BarSurface bar;
    [[nodiscard, gnu::always_inline]] Nearest nearest(double x, double y, double z) const {
        return bar.nearestBent(x, y, z);
    }
};
struct Straight {
    BarSurface bar;
    [[nodiscard, gnu::always_inline]] Nearest nearest(double x, double y, double z) const {
        return bar.nearestStraight(x, y, z);
    }
};

/// What nearest() of a shape says of the points.
struct FillDepths {
    template <typename Shape>
    [[gnu::always_inline]] void operator()(const Shape& shape, const Eigen::Isometry3d& X_Object_Sensor,
                                           const DepthColumns& columns) const {
        // Copies, which the results cannot overwrite. No two columns overlap.
        const Shape body = shape;
        const Eigen::Matrix3d R = X_Object_Sensor.linear();
        const double xx = R(0, 0), xy = R(0, 1), xz = R(0, 2), x0 = X_Object_Sensor.translation()[0];
        const double yx = R(1, 0), yy = R(1, 1), yz = R(1, 2), y0 = X_Object_Sensor.translation()[1];
        const double zx = R(2, 0), zy = R(2, 1), zz = R(2, 2), z0 = X_Object_Sensor.translation()[2];
        const auto [x, y, z, depth_m, normalX, normalY, normalZ, length, count] = columns;
#pragma GCC ivdep
        for (std::size_t i = 0; i < count; ++i) {
            const Nearest nearest =
                body.nearest(xx * x[i] + xy * y[i] + xz * z[i] + x0, yx * x[i] + yy * y[i] + yz * z[i] + y0,
                             zx * x[i] + zy * y[i] + zz * z[i] + z0);
            depth_m[i] = nearest.depth_m;
            normalX[i] = nearest.x;
            normalY[i] = nearest.y;
            normalZ[i] = nearest.z;
            length[i] = nearest.length;
        }
    }
};

/// Of pressed springs: in, the points in {s} and the normals in the body's frame, not yet divided by their
/// length; out, the normals in {s}, their moments about its origin, and the forces.
struct ScrewColumns {
    const double* x;
    const double* y;
    const double* z;
    const double* stiffness_NPerM;
    const double* depth_m;
    const double* length;
    double* normalX;
    double* normalY;
    double* normalZ;
    double* momentX;
    double* momentY;
    double* momentZ;
    double* force_N;
    std::size_t count;
};

struct FillScrews {
    [[gnu::always_inline]] void operator()(const Eigen::Matrix3d& R, const ScrewColumns& columns) const {
        const double xx = R(0, 0), xy = R(0, 1), xz = R(0, 2);
        const double yx = R(1, 0), yy = R(1, 1), yz = R(1, 2);
        const double zx = R(2, 0), zy = R(2, 1), zz = R(2, 2);
        const auto [x, y, z, stiffness_NPerM, depth_m, length, normalX, normalY, normalZ, momentX, momentY,
                    momentZ, force_N, count] = columns;
#pragma GCC ivdep
        for (std::size_t i = 0; i < count; ++i) {
            const double none = length[i] > 0.0 ? 0.0 : 1.0; // 1: without a normal, which is z then
            const double scale = 1.0 / (length[i] + none);
            const double alongX = scale * normalX[i];
            const double alongY = scale * normalY[i];
            const double alongZ = scale * normalZ[i] + none;
            const double nx = xx * alongX + xy * alongY + xz * alongZ;
            const double ny = yx * alongX + yy * alongY + yz * alongZ;
            const double nz = zx * alongX + zy * alongY + zz * alongZ;
            normalX[i] = nx;
            normalY[i] = ny;
            normalZ[i] = nz;
            momentX[i] = y[i] * nz - z[i] * ny;
            momentY[i] = z[i] * nx - x[i] * nz;
            momentZ[i] = x[i] * ny - y[i] * nx;
            force_N[i] = stiffness_NPerM[i] * depth_m[i];
        }
    }
};

#ifdef __x86_64__
// GCC's elimination of partial redundancies puts parts of a bent bar into branches, which keep it from
// computing several points at once.
template <typename Work, typename... Arguments>
[[gnu::target("avx2"), gnu::optimize("no-tree-pre")]] void doWithAvx2(const Work& work,
                                                                      const Arguments&... arguments) {
    work(arguments...);
}
#endif

/// Work on columns, as many places at once as the processor takes.
template <typename Work, typename... Arguments>
void doQuickly(const Work& work, const Arguments&... arguments) {
#ifdef __x86_64__
    if (hasAvx2()) {
        doWithAvx2(work, arguments...);
        return;
    }
#endif
    work(arguments...);
}

void sumPressed(const PressedColumns& pressed, servo::Wrench& wrench, servo::Matrix6& tangent) {
#ifdef __x86_64__
    if (hasAvx2()) {
        addPressedAvx2(pressed, wrench, tangent);
        return;
    }
#endif
    addPressed<2>(pressed, wrench, tangent);
}

} // namespace

ElasticArray::ElasticArray(const core::ArrayLayout& layout, double taxelStiffness_NPerM,
                           double bodyStiffness_NPerM, std::span<const double> factors,
                           const std::vector<RimSide>& rim)
    : m_layout(layout)
    , m_reach_m(0.0) {
    const double cellX_m = layout.pitchX_m / kSpringsX;
    const double cellY_m = layout.pitchY_m / kSpringsY;
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
                 inSeries(side.stiffness_NPerM, step_m / layout.pitchX_m * bodyStiffness_NPerM), -1});
    }
    for (const Spring& spring : m_springs)
        m_reach_m = std::max(m_reach_m, spring.p_Sensor.norm());
    m_near.reserve(m_springs.size());
    m_pressed.reserve(m_springs.size());
    m_nearby.resize(m_springs.size());
    m_inBody.resize(m_springs.size() + kTogether);
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
                -depthIn(shape, X_Object_Sensor * m_springs[row.first + j].p_Sensor).depth_m - kMargin_m;
            if (outside_m < 0.0) {
                m_near.push_back(row.first + j);
                ++j;
            } else {
                j += static_cast<std::size_t>(std::clamp(outside_m * row.perMetre, 1.0, 1e6));
            }
        }
    }
    for (std::size_t i = 0; i < m_near.size(); ++i) {
        const Spring& spring = m_springs[m_near[i]];
        m_nearby.x[i] = spring.p_Sensor.x();
        m_nearby.y[i] = spring.p_Sensor.y();
        m_nearby.z[i] = spring.p_Sensor.z();
        m_nearby.stiffness_NPerM[i] = spring.stiffness_NPerM;
    }
}

template <typename Shape>
void ElasticArray::findDepths(const Eigen::Isometry3d& X_Object_Sensor, const Shape& shape) const {
    const DepthColumns columns{.x = m_nearby.x.data(),
                               .y = m_nearby.y.data(),
                               .z = m_nearby.z.data(),
                               .depth_m = m_nearby.depth_m.data(),
                               .normalX = m_nearby.normalX.data(),
                               .normalY = m_nearby.normalY.data(),
                               .normalZ = m_nearby.normalZ.data(),
                               .length = m_nearby.length.data(),
                               .count = m_near.size()};
    if constexpr (std::is_same_v<Shape, BarSurface>)
        shape.isBent() ? doQuickly(FillDepths(), Bent{shape}, X_Object_Sensor, columns)
                       : doQuickly(FillDepths(), Straight{shape}, X_Object_Sensor, columns);
    else
        doQuickly(FillDepths(), shape, X_Object_Sensor, columns);
}

void ElasticArray::findPressed(const Eigen::Isometry3d& X_Sensor_Object, const TouchedShape& touched) const {
    if (m_pressedShape == &touched && m_X_Sensor_Object.matrix() == X_Sensor_Object.matrix())
        return;
    m_pressedShape = &touched;
    m_X_Sensor_Object = X_Sensor_Object;
    const Eigen::Isometry3d X_Object_Sensor = X_Sensor_Object.inverse(Eigen::Isometry);
    const double moved_m = (X_Object_Sensor.translation() - m_X_Object_Sensor.translation()).norm() +
                           m_reach_m * (X_Object_Sensor.linear() - m_X_Object_Sensor.linear()).norm();
    std::visit(
        [&](const auto& shape) {
            if (m_nearShape != &shape || !(moved_m < kMargin_m))
                findNear(X_Object_Sensor, shape);
            findDepths(X_Object_Sensor, shape);
        },
        touched);

    std::size_t pressed = 0;
    m_pressed.resize(m_near.size());
    for (std::size_t i = 0; i < m_near.size(); ++i) {
        // Without a branch: which springs are pressed is hard to predict.
        m_pressed[pressed] = i;
        pressed += m_nearby.depth_m[i] > 0.0 ? 1 : 0;
    }
    m_pressed.resize(pressed);

    for (std::size_t i = 0; i < pressed; ++i) {
        const std::size_t from = m_pressed[i];
        m_inBody.x[i] = m_nearby.x[from];
        m_inBody.y[i] = m_nearby.y[from];
        m_inBody.z[i] = m_nearby.z[from];
        m_inBody.stiffness_NPerM[i] = m_nearby.stiffness_NPerM[from];
        m_inBody.depth_m[i] = m_nearby.depth_m[from];
        m_inBody.normalX[i] = m_nearby.normalX[from];
        m_inBody.normalY[i] = m_nearby.normalY[from];
        m_inBody.normalZ[i] = m_nearby.normalZ[from];
        m_inBody.length[i] = m_nearby.length[from];
    }
    const ScrewColumns columns{.x = m_inBody.x.data(),
                               .y = m_inBody.y.data(),
                               .z = m_inBody.z.data(),
                               .stiffness_NPerM = m_inBody.stiffness_NPerM.data(),
                               .depth_m = m_inBody.depth_m.data(),
                               .length = m_inBody.length.data(),
                               .normalX = m_inBody.normalX.data(),
                               .normalY = m_inBody.normalY.data(),
                               .normalZ = m_inBody.normalZ.data(),
                               .momentX = m_inBody.momentX.data(),
                               .momentY = m_inBody.momentY.data(),
                               .momentZ = m_inBody.momentZ.data(),
                               .force_N = m_inBody.force_N.data(),
                               .count = pressed};
    doQuickly(FillScrews(), Eigen::Matrix3d(X_Sensor_Object.linear()), columns);
}

template <typename Take>
void ElasticArray::forEachPressed(const Eigen::Isometry3d& X_Sensor_Object, const TouchedShape& touched,
                                  Take&& take) const {
    findPressed(X_Sensor_Object, touched);
    for (std::size_t i = 0; i < m_pressed.size(); ++i)
        take(m_springs[m_near[m_pressed[i]]], m_inBody.depth_m[i],
             Eigen::Vector3d(m_inBody.normalX[i], m_inBody.normalY[i], m_inBody.normalZ[i]));
}

ArrayContact ElasticArray::press(const Eigen::Isometry3d& X_Sensor_Object, const TouchedShape& shape) const {
    findPressed(X_Sensor_Object, shape);
    const std::size_t pressed = m_pressed.size();
    Columns& columns = m_inBody;
    ArrayContact contact;
    for (std::size_t i = 0; i < pressed; ++i)
        contact.energy_J += 0.5 * columns.force_N[i] * columns.depth_m[i];
    const std::size_t filled = (pressed + kTogether - 1) / kTogether * kTogether;
    for (std::size_t i = pressed; i < filled; ++i)
        columns.stiffness_NPerM[i] = columns.force_N[i] = 0.0;
    sumPressed({.screw = {columns.normalX.data(), columns.normalY.data(), columns.normalZ.data(),
                          columns.momentX.data(), columns.momentY.data(), columns.momentZ.data()},
                .stiffness_NPerM = columns.stiffness_NPerM.data(),
                .force_N = columns.force_N.data(),
                .count = filled},
               contact.wrench_Sensor, contact.tangent_Sensor);
    contact.springs = static_cast<int>(pressed);
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
