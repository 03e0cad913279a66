// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/tactile_features.h"
#include "backend/servo/servo_controller.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace teleta::servo::test {

/// Frames of a WTS 0614 array modelled as a bed of springs.
class Bed {
public:
    static constexpr int kRows = 6;
    static constexpr int kColumns = 14;

    Bed()
        : m_load_N(kRows * kColumns, 0.0F)
        , m_extractor(core::ArrayLayout{}) {}

    void clear() { std::fill(m_load_N.begin(), m_load_N.end(), 0.0F); }
    float& at(int row, int column) { return m_load_N[static_cast<std::size_t>(row * kColumns + column)]; }

    /// A bar along x over rows 2 and 3: load of each taxel from the middle of the bed to its ends.
    contact::TactileFeatures bar(double mean_N, double slope_NPerM = 0.0, int first = 0,
                                 int last = kColumns - 1) {
        clear();
        const core::ArrayLayout layout;
        for (int column = first; column <= last; ++column)
            for (const int row : {2, 3})
                at(row, column) =
                    static_cast<float>(std::max(0.0, mean_N + slope_NPerM * layout.x_m(column)));
        return features();
    }

    /// A ball over 2 x 2 taxels.
    contact::TactileFeatures ball(double force_N, int row, int column) {
        clear();
        for (const int r : {row, row + 1})
            for (const int c : {column, column + 1})
                at(r, c) = static_cast<float>(0.25 * force_N);
        return features();
    }

    contact::TactileFeatures features() { return m_extractor.compute(m_load_N); }

private:
    std::vector<float> m_load_N;
    contact::FeatureExtractor m_extractor;
};

/// Features of a contact with given values.
inline contact::TactileFeatures feel(contact::ContactType type, double force_N, double copX_m, double copY_m,
                                     double cocX_m, double cocY_m, double alphaZ_rad = 0.0) {
    contact::TactileFeatures f;
    f.type = type;
    f.force_N = force_N;
    f.active = type == contact::ContactType::none ? 0 : 12;
    f.peak_N = force_N / 10.0;
    if (f.active == 0)
        return f;
    f.copX_m = copX_m;
    f.copY_m = copY_m;
    f.cocX_m = cocX_m;
    f.cocY_m = cocY_m;
    f.dzmpX_m = copY_m - cocY_m;
    f.dzmpY_m = copX_m - cocX_m;
    f.alphaZ_rad = alphaZ_rad;
    f.lambda1_m2 = type == contact::ContactType::edge ? 2e-4 : 3e-6;
    f.lambda2_m2 = 2e-6;
    return f;
}

inline contact::TactileFeatures nothing() {
    return feel(contact::ContactType::none, 0.0, 0.0, 0.0, 0.0, 0.0);
}

/// Ad = [R, skew(p) R; 0, R], the matrix of twistTo(), eq. (13) of the paper.
inline Matrix6 adjoint(const Eigen::Isometry3d& X_A_B) {
    Matrix6 Ad = Matrix6::Zero();
    Ad.topLeftCorner<3, 3>() = X_A_B.linear();
    Ad.bottomRightCorner<3, 3>() = X_A_B.linear();
    Ad.topRightCorner<3, 3>() = skew(X_A_B.translation()) * X_A_B.linear();
    return Ad;
}

/// Writes a wrench of frame B in frame A: [R f; p x R f + R m], the dual of twistTo().
inline Wrench wrenchTo(const Eigen::Isometry3d& X_A_B, const Wrench& wrench_B) {
    const Eigen::Vector3d f = X_A_B.linear() * wrench_B.head<3>();
    Wrench wrench_A;
    wrench_A << f, X_A_B.translation().cross(f) + X_A_B.linear() * wrench_B.tail<3>();
    return wrench_A;
}

/// A plan of one task.
inline ServoPlan planOf(const ServoTask& task) {
    ServoPlan plan;
    plan.name = "test";
    plan.tasks = {task};
    return plan;
}

inline ServoController controllerOf(const ServoTask& task) {
    return *ServoController::create(planOf(task));
}

inline ServoInput inputOf(const contact::TactileFeatures& features, double dt_s = 0.01,
                          const Eigen::Isometry3d& X_Base_Sensor = Eigen::Isometry3d::Identity()) {
    ServoInput input;
    input.features = features;
    input.dt_s = dt_s;
    input.X_Base_Sensor = X_Base_Sensor;
    return input;
}

} // namespace teleta::servo::test
