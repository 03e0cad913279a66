// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/skin_renderer.h"

#include "backend/simulation/camera/skin_rays.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace teleta::simulation {

namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

// Grey levels of the tube's ends, the painted skin and the dots.
constexpr float kHousing = 24.0F;
constexpr float kPaint = 205.0F;
constexpr float kInk = 45.0F;

constexpr double kSample_m = 0.00025; ///< a pixel that sees more of the skin is sampled more than once
constexpr double kBeyondEnds_m = 0.03;
constexpr int kMostSamples = 8;
constexpr double kLongestStep_m = 0.004; ///< across the rim of what is hidden there is no footprint
constexpr std::uint8_t kAtRest = 0;
constexpr std::uint8_t kMoved = 1;

} // namespace

SkinRenderer::SkinRenderer(const vision::CylinderCamera& camera, const scene::CameraSkin& skin,
                           PrintedDots dots)
    : m_camera(camera)
    , m_skin(skin)
    , m_dots(std::move(dots))
    , m_lens_m(camera.camera().centre_m())
    , m_place(camera.camera().parameters().height_px, camera.camera().parameters().width_px)
    , m_light(m_place.size(), 1.0F)
    , m_atRest(m_place.size()) {
    // Beyond its ends too: a press before an end stands in front of what is behind it.
    vision::CylinderSurface longer = camera.surface();
    longer.lowest_z_m -= kBeyondEnds_m;
    longer.highest_z_m += kBeyondEnds_m;
    const vision::CylinderCamera wide(camera.camera(), longer);
    for (int v = 0; v < m_place.rows; ++v) {
        for (int u = 0; u < m_place.cols; ++u) {
            cv::Vec2f& place = m_place(v, u);
            place = {kNone, kNone};
            const auto hit = wide.locate_m({u, v});
            if (hit)
                place = {static_cast<float>(std::atan2(hit->y(), hit->x())), static_cast<float>(hit->z())};
        }
    }
    drawAtRest();
}

void SkinRenderer::setLight(const cv::Mat1f& light) {
    m_light = light.clone();
    drawAtRest();
}

std::vector<cv::Rect> SkinRenderer::reach(const SkinDeformation& deformation) const {
    constexpr int kSteps = 24;
    std::vector<cv::Rect> all;
    for (const SkinDeformation::Press& press : deformation.presses()) {
        // The surface stands into the tube, where it hides what is further away.
        const double influence_m = press.imprint.influence_m();
        const double inner_m = m_skin.radius_m - deformation.deepest_m();
        Eigen::AlignedBox2d seen;
        for (int i = 0; i <= kSteps; ++i) {
            for (int k = 0; k <= kSteps; ++k) {
                const double angle_rad =
                    press.press.centre.angle_rad + influence_m / m_skin.radius_m * (2.0 * i / kSteps - 1.0);
                const double z_m = std::clamp(press.press.centre.z_m + influence_m * (2.0 * k / kSteps - 1.0),
                                              m_skin.begin_m, m_skin.begin_m + m_skin.length_m);
                for (const double rho_m : {m_skin.radius_m, inner_m}) {
                    const auto pixel = m_camera.camera().project(
                        {rho_m * std::cos(angle_rad), rho_m * std::sin(angle_rad), z_m});
                    if (pixel)
                        seen.extend(*pixel);
                }
            }
        }
        if (seen.isEmpty())
            continue;
        constexpr int kMargin = 3;
        const cv::Rect box(static_cast<int>(std::floor(seen.min().x())) - kMargin,
                           static_cast<int>(std::floor(seen.min().y())) - kMargin,
                           static_cast<int>(std::ceil(seen.sizes().x())) + 2 * kMargin + 1,
                           static_cast<int>(std::ceil(seen.sizes().y())) + 2 * kMargin + 1);
        if (const cv::Rect inside = box & cv::Rect(0, 0, m_place.cols, m_place.rows); !inside.empty())
            all.push_back(inside);
    }
    return all;
}

float SkinRenderer::brightness(const SkinPlace& place, const Eigen::Vector2d& right_m,
                               const Eigen::Vector2d& down_m) const {
    if (place.z_m < m_skin.begin_m || place.z_m > m_skin.begin_m + m_skin.length_m)
        return kHousing;
    // right, down: how the place (around, along) changes to the next pixel. No sample reaches further.
    const double right = right_m.norm();
    const double down = down_m.norm();
    const double reaches_m = 0.5 * (right + down);
    PrintedDots::Rim rim = m_dots.nearest(place);
    if (std::abs(rim.distance_m) >= reaches_m && reaches_m > 0.0)
        return rim.distance_m > 0.0 ? kPaint : kInk;
    const auto samples = [](double step_m) {
        return std::clamp(static_cast<int>(std::ceil(step_m / kSample_m)), 1, kMostSamples);
    };
    const int columns = samples(right);
    const int rows = samples(down);
    double covered = 0.0;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const Eigen::Vector2d offset_m =
                ((column + 0.5) / columns - 0.5) * right_m + ((row + 0.5) / rows - 0.5) * down_m;
            if (columns * rows > 1)
                rim = m_dots.nearest(
                    {place.angle_rad + offset_m.x() / m_skin.radius_m, place.z_m + offset_m.y()});
            const double width_m =
                std::abs(rim.aroundDirection * right_m.x() + rim.alongDirection * right_m.y()) / columns +
                std::abs(rim.aroundDirection * down_m.x() + rim.alongDirection * down_m.y()) / rows;
            covered += std::clamp(0.5 - rim.distance_m / std::max(width_m, 1e-9), 0.0, 1.0);
        }
    }
    return kPaint + (kInk - kPaint) * static_cast<float>(covered / (rows * columns));
}

float SkinRenderer::shade(const cv::Mat2f& seen, int v, int u) const {
    const auto at = [&](int dv, int du) -> const cv::Vec2f& {
        return seen(std::clamp(v + dv, 0, seen.rows - 1), std::clamp(u + du, 0, seen.cols - 1));
    };
    const cv::Vec2f& here = at(0, 0);
    if (std::isnan(here[0]))
        return kHousing;
    const auto step = [this](const cv::Vec2f& from, const cv::Vec2f& to) {
        const double around_m =
            m_skin.radius_m * wrapped_rad(static_cast<double>(to[0]) - static_cast<double>(from[0]));
        const double along_m = static_cast<double>(to[1]) - static_cast<double>(from[1]);
        return Eigen::Vector2d(std::clamp(around_m, -kLongestStep_m, kLongestStep_m),
                               std::clamp(along_m, -kLongestStep_m, kLongestStep_m));
    };
    const auto between = [&](const cv::Vec2f& low, const cv::Vec2f& high) {
        const bool hasLow = !std::isnan(low[0]);
        const bool hasHigh = !std::isnan(high[0]);
        if (hasLow && hasHigh)
            return Eigen::Vector2d(0.5 * step(low, high));
        if (hasLow)
            return step(low, here);
        return hasHigh ? step(here, high) : Eigen::Vector2d(Eigen::Vector2d::Zero());
    };
    return brightness({static_cast<double>(here[0]), static_cast<double>(here[1])},
                      between(at(0, -1), at(0, 1)), between(at(-1, 0), at(1, 0)));
}

void SkinRenderer::drawAtRest() {
    for (int v = 0; v < m_place.rows; ++v)
        for (int u = 0; u < m_place.cols; ++u)
            m_atRest(v, u) = shade(m_place, v, u) * m_light(v, u);
}

void SkinRenderer::draw(const SkinDeformation& deformation, const cv::Rect& part, cv::Mat1f& image) {
    if (part.empty())
        return;
    m_atRest(part).copyTo(image(part));
    // One pixel more on every side, for the differences to the neighbours.
    const cv::Rect wide = cv::Rect(part.x - 1, part.y - 1, part.width + 2, part.height + 2) &
                          cv::Rect(0, 0, m_place.cols, m_place.rows);
    m_seen.create(wide.size());
    m_moved.create(wide.size());
    SkinRays rays(deformation, m_lens_m);
    SkinPlace rest;
    for (int v = 0; v < wide.height; ++v) {
        const cv::Vec2f* places = m_place[wide.y + v] + wide.x;
        cv::Vec2f* seen = m_seen[v];
        std::uint8_t* moved = m_moved[v];
        for (int u = 0; u < wide.width; ++u) {
            seen[u] = places[u];
            moved[u] = kAtRest;
            if (std::isnan(places[u][0]) ||
                !rays.follow({static_cast<double>(places[u][0]), static_cast<double>(places[u][1])}, rest))
                continue;
            seen[u] = {static_cast<float>(rest.angle_rad), static_cast<float>(rest.z_m)};
            moved[u] = kMoved;
        }
    }
    for (int v = part.y; v < part.y + part.height; ++v) {
        const int row = v - wide.y;
        const std::uint8_t* here = m_moved[row];
        const std::uint8_t* above = m_moved[std::max(row - 1, 0)];
        const std::uint8_t* below = m_moved[std::min(row + 1, wide.height - 1)];
        for (int u = part.x; u < part.x + part.width; ++u) {
            const int column = u - wide.x;
            if ((here[column] | above[column] | below[column] | here[std::max(column - 1, 0)] |
                 here[std::min(column + 1, wide.width - 1)]) != kAtRest)
                image(v, u) = shade(m_seen, row, column) * m_light(v, u);
        }
    }
}

} // namespace teleta::simulation
