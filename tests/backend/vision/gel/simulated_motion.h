// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/simulation/camera/gel/gel_renderer.h"
#include "backend/vision/gel/marker_gel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace teleta::test {

using Places = std::vector<Eigen::Vector2d>;

[[nodiscard]] inline vision::MarkerGelFile fileOf(const simulation::SimulatedGel& gel) {
    vision::MarkerGelFile file;
    file.polarity = gel.contrast < 0.0 ? vision::MarkerPolarity::bright : vision::MarkerPolarity::dark;
    file.grid = gel.hexagonal ? vision::MarkerGrid::hexagonal : vision::MarkerGrid::rectangular;
    file.rows = gel.rows;
    file.columns = gel.columns;
    file.plane.mmPerPx = 0.1;
    return file;
}

/// Draws a gel and follows its markers, as a camera's pictures come.
class FollowedGel {
public:
    FollowedGel(const simulation::SimulatedGel& gel, const vision::MarkerGelFile& file)
        : m_file(file)
        , m_renderer(gel) {
        std::vector<cv::Mat1b> first;
        for (std::size_t i = 0; i < vision::MarkerGel::kReferencePictures; ++i)
            first.push_back(picture(m_renderer.rest_px()));
        auto made = vision::MarkerGel::make(file, first);
        EXPECT_TRUE(made) << (made ? "" : made.error().message);
        if (!made)
            return;
        m_gel.emplace(std::move(*made));
        for (const vision::GelMarker& marker : m_gel->markers()) {
            const auto near =
                std::ranges::min_element(m_renderer.rest_px(), {}, [&](const Eigen::Vector2d& p) {
                    return (p - marker.rest_px).squaredNorm();
                });
            m_true.push_back(static_cast<std::size_t>(near - m_renderer.rest_px().begin()));
        }
    }
    explicit FollowedGel(const simulation::SimulatedGel& gel)
        : FollowedGel(gel, fileOf(gel)) {}

    [[nodiscard]] cv::Mat1b picture(std::span<const Eigen::Vector2d> places_px) {
        cv::Mat1b drawn;
        m_renderer.draw(places_px, drawn);
        return vision::MarkerGel::picture(m_file, drawn).value().clone();
    }
    void follow(std::span<const Eigen::Vector2d> places_px) {
        const cv::Mat1b drawn = picture(places_px);
        ASSERT_TRUE(m_gel->track(drawn, m_time_s += 0.04));
    }
    /// Of the found markers to where they truly are, root of the mean square along one axis.
    [[nodiscard]] double error_px(std::span<const Eigen::Vector2d> places_px) const {
        double sum = 0.0;
        std::size_t count = 0;
        for (std::size_t i = 0; i < m_true.size(); ++i) {
            if (!m_gel->motions()[i].found)
                continue;
            sum += (m_gel->motions()[i].place_px - places_px[m_true[i]]).squaredNorm();
            count += 2;
        }
        return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, count)));
    }
    /// Markers that are taken for another one.
    [[nodiscard]] int confused(std::span<const Eigen::Vector2d> places_px) const {
        int count = 0;
        for (std::size_t i = 0; i < m_true.size(); ++i) {
            if (!m_gel->motions()[i].found)
                continue;
            const auto near = std::ranges::min_element(places_px, {}, [&](const Eigen::Vector2d& p) {
                return (p - m_gel->motions()[i].place_px).squaredNorm();
            });
            count += static_cast<std::size_t>(near - places_px.begin()) != m_true[i] ? 1 : 0;
        }
        return count;
    }
    [[nodiscard]] vision::MarkerGel& gel() { return *m_gel; }
    [[nodiscard]] bool isMade() const { return m_gel.has_value(); }
    [[nodiscard]] simulation::GelRenderer& renderer() { return m_renderer; }
    /// The number of a marker in the drawing.
    [[nodiscard]] std::size_t drawn(std::size_t marker) const { return m_true[marker]; }

private:
    vision::MarkerGelFile m_file;
    simulation::GelRenderer m_renderer;
    std::optional<vision::MarkerGel> m_gel;
    std::vector<std::size_t> m_true;
    double m_time_s = 0.0;
};

} // namespace teleta::test
