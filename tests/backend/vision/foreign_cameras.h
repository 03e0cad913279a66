// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/calibration_pair.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

namespace teleta::vision {

/// Lenses of foreign cameras; theta: angle to the axis.
enum class ForeignLens {
    rational,      ///< the one that the calibration knows, as a continued fraction of tan(theta)
    kannalaBrandt, ///< theta (1 + k1 theta^2 + ... + k4 theta^8)
    ocam,          ///< the ray of a radius rho is (rho, a0 + a2 rho^2 + a3 rho^3 + a4 rho^4)
    equisolid,     ///< 2 sin(theta / 2)
    stereographic, ///< 2 tan(theta / 2)
};
inline constexpr std::array kForeignLenses{ForeignLens::rational, ForeignLens::kannalaBrandt,
                                           ForeignLens::ocam, ForeignLens::equisolid,
                                           ForeignLens::stereographic};
inline const char* nameOf(ForeignLens lens) {
    static constexpr std::array kNames{"rational", "Kannala-Brandt", "OCam", "equisolid", "stereographic"};
    return kNames[static_cast<std::size_t>(lens)];
}

/// A camera in a tube of 25 mm radius and 100 mm length, with a projection of its own: no code is shared with
/// the program.
struct ForeignCamera {
    ForeignLens lens = ForeignLens::rational;
    std::array<double, 6> shape{};
    double focus_px = 700.0; ///< px per radian on the axis
    double aspect = 1.0;
    Eigen::Vector2d middle_px{819.5, 615.5};
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity(); ///< with a reflection in a mirrored camera
    Eigen::Vector3d centre_m{0.0, 0.0, -0.02};

    /// Distance from the middle over the focal length.
    [[nodiscard]] double radius(double theta_rad) const {
        const double s = theta_rad * theta_rad;
        switch (lens) {
        case ForeignLens::rational: {
            const double r = std::tan(theta_rad);
            double denominator = 1.0;
            for (std::size_t i = shape.size(); i-- > 0;)
                denominator = 1.0 + shape[i] * r * r / denominator;
            return r / denominator;
        }
        case ForeignLens::kannalaBrandt:
            return theta_rad * (1.0 + s * (shape[0] + s * (shape[1] + s * (shape[2] + s * shape[3]))));
        case ForeignLens::ocam: {
            double low = 0.0;
            double high = 3.0;
            for (int i = 0; i < 60; ++i) {
                const double rho = 0.5 * (low + high);
                const double forward = 1.0 + rho * rho * (shape[0] + rho * (shape[1] + rho * shape[2]));
                (std::atan2(rho, forward) > theta_rad ? high : low) = rho;
            }
            return low;
        }
        case ForeignLens::equisolid:
            return 2.0 * std::sin(0.5 * theta_rad);
        case ForeignLens::stereographic:
            return 2.0 * std::tan(0.5 * theta_rad);
        }
        return 0.0;
    }

    /// Whether the radius grows up to 60 degrees.
    [[nodiscard]] bool isUsable() const {
        for (int i = 1; i <= 60; ++i) {
            const double step = std::numbers::pi / 180.0;
            if (!(radius(i * step) > radius((i - 1) * step)))
                return false;
        }
        return true;
    }

    /// Where a point is seen, also beyond the edge of the image.
    [[nodiscard]] Eigen::Vector2d pixel(const Eigen::Vector3d& point_m) const {
        const Eigen::Vector3d p = turn * (point_m - centre_m);
        const double across = std::hypot(p.x(), p.y());
        const double distance_px = focus_px * radius(std::atan2(across, p.z()));
        const Eigen::Vector2d direction =
            across > 0.0 ? Eigen::Vector2d(p.x() / across, p.y() / across) : Eigen::Vector2d(0.0, 0.0);
        return {middle_px.x() + distance_px * direction.x(),
                middle_px.y() + aspect * distance_px * direction.y()};
    }
    [[nodiscard]] bool sees(const Eigen::Vector3d& point_m) const {
        const Eigen::Vector2d at = pixel(point_m);
        return at.x() >= 0.0 && at.x() <= 1639.0 && at.y() >= 0.0 && at.y() <= 1231.0;
    }
};

/// What is wrong with the pairs of a foreign camera.
struct ForeignPairs {
    double outliers = 0.05;  ///< share of pixels that are somewhere in the image
    double holeFactor = 1.0; ///< of the holes that are told instead of the points that were touched
    bool swapped = false;    ///< u and v
    double nearest_m = 0.1;  ///< no pairs beyond
};

/// Random cameras and their pairs.
class ForeignLottery {
public:
    explicit ForeignLottery(unsigned seed)
        : m_engine(seed) {}

    double uniform(double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(m_engine);
    }

    /// Any roll, either handedness, up to 2 mm off the axis and tilted by up to 4 degrees; the nearest ring
    /// is in the image, or nearly.
    ForeignCamera camera(ForeignLens lens) {
        ForeignCamera camera;
        camera.lens = lens;
        do {
            switch (lens) {
            case ForeignLens::rational:
                camera.shape = {1.0 / 3.0, 4.0 / 15.0, 9.0 / 35.0, 16.0 / 63.0, 25.0 / 99.0, 36.0 / 143.0};
                for (double& coefficient : camera.shape)
                    coefficient *= uniform(0.85, 1.15);
                break;
            case ForeignLens::kannalaBrandt:
                camera.shape = {uniform(-0.15, 0.15),
                                uniform(-0.1, 0.1),
                                uniform(-0.1, 0.1),
                                uniform(-0.05, 0.05),
                                0.0,
                                0.0};
                break;
            case ForeignLens::ocam:
                camera.shape = {
                    uniform(-0.5, -0.2), uniform(-0.15, 0.15), uniform(-0.1, 0.05), 0.0, 0.0, 0.0};
                break;
            case ForeignLens::equisolid:
            case ForeignLens::stereographic:
                break;
            }
        } while (!camera.isUsable());
        camera.focus_px = uniform(500.0, 600.0) / camera.radius(50.0 / 180.0 * std::numbers::pi);
        camera.aspect = uniform(0.98, 1.02);
        camera.middle_px = {819.5 + uniform(-40.0, 40.0), 615.5 + uniform(-40.0, 40.0)};
        const auto about = [](double angle_rad, const Eigen::Vector3d& axis) {
            return Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix();
        };
        camera.turn = about(uniform(-0.05, 0.05), Eigen::Vector3d::UnitX()) *
                      about(uniform(-0.05, 0.05), Eigen::Vector3d::UnitY()) *
                      about(uniform(-std::numbers::pi, std::numbers::pi), Eigen::Vector3d::UnitZ());
        if (uniform(0.0, 1.0) < 0.5)
            camera.turn.col(1) = -camera.turn.col(1);
        camera.centre_m = {uniform(-0.002, 0.002), uniform(-0.002, 0.002), uniform(-0.023, -0.017)};
        return camera;
    }

    /// The 250 holes of the paper's shell, or those that the camera sees, with 0.3 to 0.5 px of noise.
    std::vector<CalibrationPair> pairs(const ForeignCamera& camera, const ForeignPairs& how) {
        std::normal_distribution<double> normal(0.0, uniform(0.3, 0.5));
        std::vector<CalibrationPair> pairs;
        for (int ring = 0; ring < 10; ++ring) {
            const double z_m = 0.002 + 0.096 * ring / 9.0;
            if (z_m > how.nearest_m)
                break;
            for (int i = 0; i < 25; ++i) {
                const double angle_rad = 2.0 * std::numbers::pi * i / 25.0;
                const Eigen::Vector3d touched_m(0.025 * std::cos(angle_rad), 0.025 * std::sin(angle_rad),
                                                z_m);
                Eigen::Vector2d pixel = camera.pixel(touched_m);
                pixel += Eigen::Vector2d(normal(m_engine), normal(m_engine));
                if (!camera.sees(touched_m))
                    continue;
                if (uniform(0.0, 1.0) < how.outliers)
                    pixel = {uniform(0.0, 1639.0), uniform(0.0, 1231.0)};
                if (how.swapped)
                    std::swap(pixel.x(), pixel.y());
                Eigen::Vector3d told_m = touched_m;
                told_m.head<2>() /= how.holeFactor;
                pairs.push_back({pixel, told_m});
            }
        }
        return pairs;
    }

private:
    std::mt19937_64 m_engine;
};

} // namespace teleta::vision
