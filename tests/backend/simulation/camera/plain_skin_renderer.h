// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/simulation/camera/skin_renderer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace teleta::test {

/// The same picture as SkinRenderer, without light, written down plainly: the ray of every pixel is stepped
/// through the whole shell in which the skin can be, every sample of every pixel looks for its dot.
/// marchSteps: through the shell. Thread: any (const).
class PlainSkinRenderer {
    using SkinDeformation = simulation::SkinDeformation;
    using SkinPlace = simulation::SkinPlace;
    using PrintedDots = simulation::PrintedDots;

public:
    PlainSkinRenderer(const simulation::SkinRenderer& renderer, const scene::CameraSkin& skin, int marchSteps)
        : m_renderer(renderer)
        , m_skin(skin)
        , m_marchSteps(marchSteps)
        , m_lens_m(renderer.camera().camera().centre_m()) {}

    /// Draws the skin into a part of the image; the rest of it stays.
    void draw(const SkinDeformation& deformation, const cv::Rect& part, cv::Mat1f& image) const {
        if (part.empty())
            return;
        // One pixel more on every side, for the differences to the neighbours.
        const cv::Rect wide = cv::Rect(part.x - 1, part.y - 1, part.width + 2, part.height + 2) &
                              cv::Rect(0, 0, m_renderer.places().cols, m_renderer.places().rows);
        cv::Mat2f seenPlace(wide.size());
        for (int v = 0; v < wide.height; ++v) {
            for (int u = 0; u < wide.width; ++u) {
                const cv::Vec2f& place = m_renderer.places()(wide.y + v, wide.x + u);
                if (std::isnan(place[0])) {
                    seenPlace(v, u) = {kNone, kNone};
                    continue;
                }
                const SkinPlace rest = seen(deformation, place[0], place[1]);
                seenPlace(v, u) = {static_cast<float>(rest.angle_rad), static_cast<float>(rest.z_m)};
            }
        }
        const auto step = [&](const cv::Vec2f& from, const cv::Vec2f& to) {
            constexpr double kLongest_m = 0.004; // across the rim of what is hidden there is no footprint
            const double around_m =
                m_skin.radius_m * wrapped_rad(static_cast<double>(to[0]) - static_cast<double>(from[0]));
            const double along_m = static_cast<double>(to[1]) - static_cast<double>(from[1]);
            return Eigen::Vector2d(std::clamp(around_m, -kLongest_m, kLongest_m),
                                   std::clamp(along_m, -kLongest_m, kLongest_m));
        };
        for (int v = part.y; v < part.y + part.height; ++v) {
            for (int u = part.x; u < part.x + part.width; ++u) {
                const auto at = [&](int dv, int du) {
                    const int row = std::clamp(v + dv, wide.y, wide.y + wide.height - 1) - wide.y;
                    const int column = std::clamp(u + du, wide.x, wide.x + wide.width - 1) - wide.x;
                    return seenPlace(row, column);
                };
                const cv::Vec2f here = at(0, 0);
                float& pixel = image(v, u);
                if (std::isnan(here[0])) {
                    pixel = kHousing;
                    continue;
                }
                const auto between = [&](const cv::Vec2f& low, const cv::Vec2f& high) {
                    const bool hasLow = !std::isnan(low[0]);
                    const bool hasHigh = !std::isnan(high[0]);
                    if (hasLow && hasHigh)
                        return Eigen::Vector2d(0.5 * step(low, high));
                    if (hasLow)
                        return step(low, here);
                    return hasHigh ? step(here, high) : Eigen::Vector2d(Eigen::Vector2d::Zero());
                };
                pixel = brightness({static_cast<double>(here[0]), static_cast<double>(here[1])},
                                   between(at(0, -1), at(0, 1)), between(at(-1, 0), at(1, 0)));
            }
        }
    }

private:
    static constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    static constexpr float kHousing = 24.0F;
    static constexpr float kPaint = 205.0F;
    static constexpr float kInk = 45.0F;
    static constexpr double kSample_m = 0.00025;
    static constexpr int kMostSamples = 8;
    static constexpr int kMostSteps = 100;

    static double wrapped_rad(double angle_rad) {
        constexpr double kTurn_rad = 2.0 * std::numbers::pi;
        return angle_rad - kTurn_rad * std::floor(angle_rad / kTurn_rad + 0.5);
    }

    SkinPlace seen(const SkinDeformation& deformation, float angle_rad, float z_m) const {
        const double deepest_m = deformation.deepest_m();
        if (deepest_m == 0.0)
            return {static_cast<double>(angle_rad), static_cast<double>(z_m)};
        const double radius_m = m_skin.radius_m;
        const Eigen::Vector3d hit(radius_m * std::cos(static_cast<double>(angle_rad)),
                                  radius_m * std::sin(static_cast<double>(angle_rad)),
                                  static_cast<double>(z_m));
        const Eigen::Vector3d way = hit - m_lens_m;
        // Where the ray enters the shell in which the surface can be: |lens + t way| = radius - deepest.
        const double a = way.head<2>().squaredNorm();
        const double b = m_lens_m.head<2>().dot(way.head<2>());
        const double inner_m = radius_m - deepest_m;
        const double c = m_lens_m.head<2>().squaredNorm() - inner_m * inner_m;
        const double enters = c >= 0.0 ? 0.0 : -c / (b + std::sqrt(b * b - a * c));
        const Eigen::Vector3d entry = m_lens_m + enters * way;
        const double entryTurn_rad =
            wrapped_rad(std::atan2(entry.y(), entry.x()) - static_cast<double>(angle_rad));
        // Over the last stretch the angle hardly changes: linear in between.
        struct Point {
            double angle_rad, z_m, above_m;
        };
        const auto at = [&](double t) {
            const double share = (1.0 - t) / (1.0 - enters);
            Point point{static_cast<double>(angle_rad) + share * entryTurn_rad, m_lens_m.z() + t * way.z(),
                        0.0};
            const double rho_m = std::sqrt((m_lens_m.head<2>() + t * way.head<2>()).squaredNorm());
            point.above_m = radius_m - deformation.depth_m(point.angle_rad, point.z_m) - rho_m;
            return point;
        };
        double before = enters;
        double heightBefore_m = at(before).above_m;
        double after = 1.0;
        Point last = at(heightBefore_m > 0.0 ? after : before);
        for (int i = 1; i <= m_marchSteps && heightBefore_m > 0.0; ++i) {
            const double t = enters + (1.0 - enters) * i / m_marchSteps;
            const Point point = at(t);
            if (point.above_m <= 0.0 || i == m_marchSteps) {
                after = t;
                last = point;
                break;
            }
            before = t;
            heightBefore_m = point.above_m;
        }
        // False position; of an end that stands still half counts (Illinois).
        double heightAfter_m = last.above_m;
        int side = 0;
        for (int i = 0; i < kMostSteps && heightBefore_m > 0.0 && std::abs(last.above_m) > 1e-10; ++i) {
            const double t = before + (after - before) * heightBefore_m / (heightBefore_m - heightAfter_m);
            last = at(t);
            if (last.above_m > 0.0) {
                before = t;
                heightBefore_m = last.above_m;
                heightAfter_m *= side == 1 ? 0.5 : 1.0;
                side = 1;
            } else {
                after = t;
                heightAfter_m = last.above_m;
                heightBefore_m *= side == -1 ? 0.5 : 1.0;
                side = -1;
            }
        }
        return deformation.atRest(last.angle_rad, last.z_m);
    }

    float brightness(const SkinPlace& place, const Eigen::Vector2d& right_m,
                     const Eigen::Vector2d& down_m) const {
        if (place.z_m < m_skin.begin_m || place.z_m > m_skin.begin_m + m_skin.length_m)
            return kHousing;
        // right, down: how the place (around, along) changes to the next pixel.
        const auto samples = [](const Eigen::Vector2d& step_m) {
            return std::clamp(static_cast<int>(std::ceil(step_m.norm() / kSample_m)), 1, kMostSamples);
        };
        const int columns = samples(right_m);
        const int rows = samples(down_m);
        double covered = 0.0;
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < columns; ++column) {
                const Eigen::Vector2d offset_m =
                    ((column + 0.5) / columns - 0.5) * right_m + ((row + 0.5) / rows - 0.5) * down_m;
                const PrintedDots::Rim rim = m_renderer.dots().nearest(
                    {place.angle_rad + offset_m.x() / m_skin.radius_m, place.z_m + offset_m.y()});
                const Eigen::Vector2d outward(rim.aroundDirection, rim.alongDirection);
                const double width_m =
                    std::abs(outward.dot(right_m)) / columns + std::abs(outward.dot(down_m)) / rows;
                covered += std::clamp(0.5 - rim.distance_m / std::max(width_m, 1e-9), 0.0, 1.0);
            }
        }
        return kPaint + (kInk - kPaint) * static_cast<float>(covered / (rows * columns));
    }

    const simulation::SkinRenderer& m_renderer;
    scene::CameraSkin m_skin;
    int m_marchSteps;
    Eigen::Vector3d m_lens_m;
};

} // namespace teleta::test
