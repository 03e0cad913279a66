// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/gel/gel_renderer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::simulation {

GelRenderer::GelRenderer(const SimulatedGel& gel)
    : m_gel(gel)
    , m_noise(gel.seed, "gel noise")
    , m_drawn(gel.height_px, gel.width_px) {
    core::RandomStream print(gel.seed, "gel print");
    const double down_px = gel.hexagonal ? 0.5 * std::sqrt(3.0) * gel.pitch_px : gel.pitch_px;
    const Eigen::Vector2d first(0.5 * (gel.width_px - 1) -
                                    0.5 * (gel.columns - (gel.hexagonal ? 0.5 : 1.0)) * gel.pitch_px,
                                0.5 * (gel.height_px - 1) - 0.5 * (gel.rows - 1) * down_px);
    for (int row = 0; row < gel.rows; ++row) {
        for (int column = 0; column < gel.columns; ++column) {
            const double half = gel.hexagonal && row % 2 == 1 ? 0.5 : 0.0;
            const Eigen::Vector2d off(print.normal(), print.normal());
            m_rest_px.push_back(first + Eigen::Vector2d((column + half) * gel.pitch_px, row * down_px) +
                                gel.printError_px * off);
            m_diameters_px.push_back(gel.diameter_px *
                                     std::clamp(1.0 + gel.printScatter * print.normal(), 0.5, 1.5));
        }
    }
}

void GelRenderer::draw(std::span<const Eigen::Vector2d> places_px, cv::Mat1b& picture) {
    m_drawn = 0.0F;
    const double soft_px = std::max(0.3, m_gel.blur_px);
    for (std::size_t i = 0; i < places_px.size(); ++i) {
        const Eigen::Vector2d at = places_px[i];
        const double radius_px = 0.5 * m_diameters_px[i];
        const double reach_px = radius_px + 4.0 * soft_px;
        const int top = std::max(0, static_cast<int>(std::ceil(at.y() - reach_px)));
        const int bottom = std::min(m_gel.height_px - 1, static_cast<int>(std::floor(at.y() + reach_px)));
        const int left = std::max(0, static_cast<int>(std::ceil(at.x() - reach_px)));
        const int right = std::min(m_gel.width_px - 1, static_cast<int>(std::floor(at.x() + reach_px)));
        for (int v = top; v <= bottom; ++v) {
            for (int u = left; u <= right; ++u) {
                const double inwards_px = radius_px - std::hypot(u - at.x(), v - at.y());
                const double share = 0.5 * std::erfc(-inwards_px / (std::numbers::sqrt2 * soft_px));
                m_drawn(v, u) = std::max(m_drawn(v, u), static_cast<float>(share));
            }
        }
    }
    picture.create(m_gel.height_px, m_gel.width_px);
    for (int v = 0; v < m_gel.height_px; ++v) {
        for (int u = 0; u < m_gel.width_px; ++u) {
            const double across =
                static_cast<double>(u) / m_gel.width_px + static_cast<double>(v) / m_gel.height_px - 1.0;
            const double light = m_light * (1.0 + m_gel.unevenness * across);
            const double level =
                light * (m_gel.ground - m_gel.contrast * static_cast<double>(m_drawn(v, u))) +
                m_gel.noise * m_noise.normal();
            picture(v, u) = static_cast<std::uint8_t>(std::clamp(std::lround(level), 0L, 255L));
        }
    }
}

} // namespace teleta::simulation
