// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/camera_world.h"
#include "backend/simulation/camera/skin/printed_dots.h"
#include "backend/simulation/camera/skin/skin_deformation.h"
#include "backend/vision/camera/cylinder_projection.h"

#include <opencv2/core.hpp>

#include <vector>

namespace teleta::simulation {

/// What the camera inside the tube sees of the printed skin, in grey levels 0 .. 255 before the image sensor.
/// Each pixel's ray is followed to its first point of the deformed surface, so that a deep press hides what
/// is behind it; a dot's share of a pixel is its exact share of the pixel's footprint on the skin, at first
/// order. What no press reaches is drawn once (see SkinRays). Thread: one.
class SkinRenderer {
public:
    SkinRenderer(const vision::CylinderCamera& camera, const scene::CameraSkin& skin, PrintedDots dots);

    /// Multiplies the brightness of each pixel, before the first image. light: as large as the image.
    void setLight(const cv::Mat1f& light);

    /// Rectangles of the image that the presses can change, one for each that is seen; they may overlap.
    [[nodiscard]] std::vector<cv::Rect> reach(const SkinDeformation& deformation) const;

    /// Draws the skin into a part of the image; the rest of it stays.
    void draw(const SkinDeformation& deformation, const cv::Rect& part, cv::Mat1f& image);

    [[nodiscard]] const vision::CylinderCamera& camera() const { return m_camera; }
    /// The image without any press.
    [[nodiscard]] const cv::Mat1f& atRest() const { return m_atRest; }
    /// Angle and z of the skin behind each pixel at rest; NaN where there is none.
    [[nodiscard]] const cv::Mat2f& places() const { return m_place; }
    [[nodiscard]] const PrintedDots& dots() const { return m_dots; }

private:
    void drawAtRest();
    /// Grey level of a pixel. seen: places on the skin at rest that the pixels around it show.
    [[nodiscard]] float shade(const cv::Mat2f& seen, int v, int u) const;
    [[nodiscard]] float brightness(const SkinPlace& place, const Eigen::Vector2d& right_m,
                                   const Eigen::Vector2d& down_m) const;

    vision::CylinderCamera m_camera;
    scene::CameraSkin m_skin;
    PrintedDots m_dots;
    Eigen::Vector3d m_lens_m;
    cv::Mat2f m_place;
    cv::Mat1f m_light;
    cv::Mat1f m_atRest;
    cv::Mat2f m_seen;  ///< while drawing
    cv::Mat1b m_moved; ///< of m_seen: what a press changes
};

} // namespace teleta::simulation
