// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/camera_calibration.h"
#include "tests/backend/vision/test_cameras.h"

#include <algorithm>
#include <vector>

namespace teleta::vision {

/// Disturbances of simulated pairs.
struct PairErrors {
    double noise_px = 0.0;
    double outliers = 0.0; ///< share of the pairs
};

struct SimulatedPairs {
    std::vector<CalibrationPair> pairs;
    std::vector<bool> good;
};

/// The holes of the paper's shell, 25 around by 10 along the axis, as pixels of a known camera with normal
/// noise; gross outliers are anywhere in the image.
inline SimulatedPairs simulatePairs(const CameraParameters& parameters, const PairErrors& errors,
                                    CameraLottery& lottery, int around = 25, int along = 10) {
    const CameraModel camera = *CameraModel::create(parameters);
    SimulatedPairs result;
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < along; ++j) {
            const double angle = 2.0 * std::numbers::pi * i / around;
            const double z_m = 0.002 + 0.096 * j / (along - 1.0);
            const Eigen::Vector3d p = onCylinder(angle, z_m);
            const Eigen::Vector2d noise(lottery.normal(1.0), lottery.normal(1.0));
            result.pairs.push_back({*camera.project(p) + errors.noise_px * noise, p});
        }
    }
    result.good.assign(result.pairs.size(), true);
    const auto wrong = static_cast<std::size_t>(errors.outliers * static_cast<double>(result.pairs.size()));
    std::vector<std::size_t> order(result.pairs.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::shuffle(order.begin(), order.end(), lottery.engine());
    for (std::size_t i = 0; i < wrong; ++i) {
        CalibrationPair& pair = result.pairs[order[i]];
        const Eigen::Vector2d right = pair.pixel;
        do {
            pair.pixel = {lottery.uniform(0.0, 1639.0), lottery.uniform(0.0, 1231.0)};
        } while ((pair.pixel - right).norm() < 10.0);
        result.good[order[i]] = false;
    }
    return result;
}

/// Error of a calibrated camera for points that the true one sees.
struct SurfaceErrors {
    std::vector<double> errors_m;    ///< of the points that are located
    std::vector<double> farErrors_m; ///< of those in the last quarter of the tube
    int notLocated = 0;              ///< points whose pixels have no ray

    [[nodiscard]] double mean_m() const {
        double sum_m = 0.0;
        for (const double error_m : errors_m)
            sum_m += error_m;
        return sum_m / static_cast<double>(errors_m.size());
    }
};

/// Points all over the surface and at its very ends. For this the cylinder goes on beyond its ends, so that a
/// point near an end may be found a little beyond it.
inline SurfaceErrors surfaceErrors(const CameraParameters& truth, const CylinderCamera& calibrated) {
    const CameraModel camera = *CameraModel::create(truth);
    CylinderSurface longer = calibrated.surface();
    longer.lowest_z_m -= 0.01;
    longer.highest_z_m += 0.1;
    const CylinderCamera found(calibrated.camera(), longer);
    SurfaceErrors result;
    for (int i = 0; i < 36; ++i) {
        for (int j = 0; j <= 20; ++j) {
            const Eigen::Vector3d p = onCylinder(2.0 * std::numbers::pi * (i + 0.5) / 36.0, 0.1 * j / 20.0);
            if (const auto point = found.locate_m(*camera.project(p))) {
                result.errors_m.push_back((*point - p).norm());
                if (j >= 15)
                    result.farErrors_m.push_back(result.errors_m.back());
            } else {
                ++result.notLocated;
            }
        }
    }
    return result;
}

} // namespace teleta::vision
