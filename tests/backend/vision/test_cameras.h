// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/camera/cylinder_projection.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace teleta::vision {

/// Rational distortion of the continued fraction q(s) = 1/(1 + c1 s/(1 + c2 s/(... 1 + c6 s))), evaluated
/// from its inner end by polynomials.
inline RationalDistortion fractionLens(const std::array<double, 6>& c) {
    std::array<double, 5> n{1.0};
    std::array<double, 5> d{1.0};
    for (std::size_t level = c.size(); level-- > 0;) {
        // n/d becomes 1 / (1 + c s n/d) = d / (d + c s n).
        const std::array<double, 5> inner = n;
        n = d;
        for (std::size_t i = 0; i + 1 < d.size(); ++i)
            d[i + 1] += c[level] * inner[i];
    }
    return {n[1], n[2], n[3], d[1], d[2], d[3], 0.0, 0.0};
}

/// The coefficients of atan(r)/r, with which the lens maps angles to distances in proportion (up to a few
/// 1e-5 at 50 degrees).
inline constexpr std::array<double, 6> kEquidistant{1.0 / 3.0,   4.0 / 15.0,  9.0 / 35.0,
                                                    16.0 / 63.0, 25.0 / 99.0, 36.0 / 143.0};

inline Eigen::Matrix3d rotation(const Eigen::Vector3d& vector) {
    return vector.norm() > 0.0 ? Eigen::AngleAxisd(vector.norm(), vector.normalized()).toRotationMatrix()
                               : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
}

/// The camera of the paper: on the axis, 20 mm in front of the sensor frame, looking along it through a lens
/// of 160 degrees.
inline CameraParameters paperCamera() {
    CameraParameters camera;
    camera.fx_px = 700.0;
    camera.fy_px = 698.0;
    camera.cx_px = 826.0;
    camera.cy_px = 609.0;
    camera.distortion = fractionLens(kEquidistant);
    camera.distortion.p1 = 4e-4;
    camera.distortion.p2 = -3e-4;
    camera.R_Camera_Sensor = rotation({0.01, -0.02, 0.3});
    camera.p_Sensor_Camera_m = {0.0006, -0.0004, -0.02};
    camera.mirrored = true;
    return camera;
}

class CameraLottery {
public:
    explicit CameraLottery(unsigned seed)
        : m_engine(seed) {}

    double uniform(double low, double high) { return std::uniform_real_distribution(low, high)(m_engine); }
    double normal(double deviation) { return std::normal_distribution(0.0, deviation)(m_engine); }

    /// A random camera like the paper's: any roll, either handedness, and a lens model that is valid over at
    /// least 65 degrees.
    CameraParameters camera() {
        CameraParameters camera = paperCamera();
        camera.fx_px = uniform(500.0, 900.0);
        camera.fy_px = camera.fx_px * uniform(0.98, 1.02);
        camera.cx_px = 819.5 + uniform(-40.0, 40.0);
        camera.cy_px = 615.5 + uniform(-40.0, 40.0);
        do {
            std::array<double, 6> c = kEquidistant;
            for (double& coefficient : c)
                coefficient *= uniform(0.85, 1.15);
            camera.distortion = fractionLens(c);
            camera.distortion.p1 = uniform(-1e-3, 1e-3);
            camera.distortion.p2 = uniform(-1e-3, 1e-3);
        } while (monotoneRadius(camera.distortion, 2.2) < 2.2);
        camera.R_Camera_Sensor = rotation({uniform(-0.05, 0.05), uniform(-0.05, 0.05), 0.0}) *
                                 rotation({0.0, 0.0, uniform(-std::numbers::pi, std::numbers::pi)});
        camera.p_Sensor_Camera_m = {uniform(-0.002, 0.002), uniform(-0.002, 0.002), uniform(-0.023, -0.017)};
        camera.mirrored = uniform(0.0, 1.0) < 0.5;
        return camera;
    }

    std::mt19937_64& engine() { return m_engine; }

private:
    std::mt19937_64 m_engine;
};

/// Point of the surface by angle and height.
inline Eigen::Vector3d onCylinder(double angle_rad, double z_m, double radius_m = 0.025) {
    return {radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad), z_m};
}

} // namespace teleta::vision
