// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/random_stream.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace teleta::simulation {

/// A flat gel with printed markers, as its camera sees it: a simulation.
struct SimulatedGel {
    int width_px = 320, height_px = 240;
    int rows = 8, columns = 10;
    bool hexagonal = false; ///< every second row is half a pitch further right, rows 0.87 pitches apart
    double pitch_px = 28.0;
    double diameter_px = 8.0; ///< of a marker
    double ground = 130.0;    ///< grey levels
    double contrast = 60.0;   ///< of a marker; < 0: brighter than the ground
    double unevenness = 0.0;  ///< the light falls to 1 - this share at a corner, and rises by it at the other
    double blur_px = 0.6;     ///< standard deviation
    double noise = 2.0;       ///< standard deviation, grey levels
    double printError_px = 0.0; ///< of places, standard deviation
    double printScatter = 0.0;  ///< of diameters, share, standard deviation
    std::uint64_t seed = 1;
};

/// Draws it. A marker is a disc with a rim as soft as the blur; its grey level is that of the middle of each
/// pixel, which for a rim of 0.5 px and more is the mean over the pixel to 0.01 of the contrast. Thread: one.
class GelRenderer {
public:
    explicit GelRenderer(const SimulatedGel& gel);

    /// Markers in order of rows, in pixels; where each was printed.
    [[nodiscard]] const std::vector<Eigen::Vector2d>& rest_px() const { return m_rest_px; }
    /// The picture with the markers at these places.
    void draw(std::span<const Eigen::Vector2d> places_px, cv::Mat1b& picture);
    /// Multiplies the light of the next pictures.
    void setLight(double share) { m_light = share; }

private:
    SimulatedGel m_gel;
    std::vector<Eigen::Vector2d> m_rest_px;
    std::vector<double> m_diameters_px;
    core::RandomStream m_noise;
    double m_light = 1.0;
    cv::Mat1f m_drawn;
};

} // namespace teleta::simulation
