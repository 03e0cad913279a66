// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/finders/dark_moments.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace teleta::vision {

/// One tracked dot.
struct TrackedDot {
    Eigen::Vector2d rest_px = Eigen::Vector2d::Zero();    ///< in the reference
    Eigen::Matrix2d metric = Eigen::Matrix2d::Identity(); ///< J: e^T J e = 1 is the border of the window,
                                                          ///< with e relative to its centre
    /// A: the displacement of a dot may differ from that of its neighbours by e with |A e| <= 1.
    Eigen::Matrix2d tolerance = Eigen::Matrix2d::Identity();
    std::vector<std::size_t> neighbours{};
    Eigen::Vector2d now_px = Eigen::Vector2d::Zero();      ///< where it was found, or is expected while lost
    Eigen::Vector2d velocity_px = Eigen::Vector2d::Zero(); ///< a frame
    bool found = false;
};

/// Tracks dark dots by the centroid of their darkness in a window, started at the place predicted from the
/// previous frame. A dot that disagrees with its neighbours, or coincides with another one, is searched again
/// where its neighbours predict it; a dot that cannot be found is lost until its neighbours lead to it again.
///   c <- c + gain * sum(w d x) / sum(w d),   w = (1 - q)^2, q = e^T J e < 1,   d = darkness
/// The brightness of the whole image may change from frame to frame. Thread: one; allocates nothing after the
/// reference.
class DotTracker {
public:
    /// dots: with rest_px (approximate), metric, tolerance and neighbours. mask: of the size of the frames, 0
    /// outside the pattern. dotDiameterShare: diameter of a dot divided by the radius of its window. cores:
    /// >= 1; with more than one, OpenCV's pool of threads helps in track(), with the same results.
    DotTracker(std::vector<TrackedDot> dots, const cv::Mat1b& mask, double dotDiameterShare, int cores = 1);

    /// Sets the frame in which the dots are at rest and finds their exact places. Returns the number of dots
    /// found.
    std::size_t setReference(const cv::Mat1b& frame);
    /// Tracks all dots into the next frame. Returns the number of dots found.
    std::size_t track(const cv::Mat1b& frame);
    /// Expects all dots at rest, for use after a gap in the stream.
    void forget();

    [[nodiscard]] const std::vector<TrackedDot>& dots() const { return m_dots; }
    [[nodiscard]] Eigen::Vector2d displacement_px(std::size_t dot) const {
        return m_dots[dot].now_px - m_dots[dot].rest_px;
    }

private:
    struct Window {
        DotWindow shape{};
        Eigen::Vector2d middle_px = Eigen::Vector2d::Zero();
        /// While the centre is not further than this from the middle, in u or v, the mask is nowhere 0 in the
        /// window.
        double clear_px = -1.0;
        int halfWidth = 0, halfHeight = 0;
        float ground = 0.0F;   ///< grey level of the background around the dot in the reference
        double mass = 0.0;     ///< sum of the darkness in the reference
        float darkest = 0.0F;  ///< Found::darkest in the reference
        double reach_px = 0.0; ///< how far it may be from the place predicted by its neighbours
    };
    struct Found {
        Eigen::Vector2d place_px;
        double mass = 0.0;
        float darkest = 0.0F; ///< darkness of its darkest pixel, as a share of the background
    };
    [[nodiscard]] bool isClear(std::size_t dot, const Eigen::Vector2d& centre_px) const;
    [[nodiscard]] Found centroid(const cv::Mat1b& frame, std::size_t dot, const Eigen::Vector2d& start_px,
                                 float gain, int steps) const;
    [[nodiscard]] bool take(const cv::Mat1b& frame, std::size_t dot, const Eigen::Vector2d& start_px,
                            float gain);
    /// Follows each of these dots alone, from the previous frame.
    void follow(const cv::Mat1b& frame, float gain, const cv::Range& dots);
    [[nodiscard]] float brightness(const cv::Mat1b& frame) const;
    /// Median displacement of the neighbours that were found. Returns false when there are too few.
    [[nodiscard]] bool expected(std::size_t dot, Eigen::Vector2d& displacement_px) const;
    [[nodiscard]] bool strays(std::size_t dot) const;
    void dropDoubles();

    std::vector<TrackedDot> m_dots;
    cv::Mat1b m_hidden; ///< 255 outside the pattern, else 0
    std::vector<Window> m_windows;
    std::vector<std::size_t> m_lost;
    std::vector<Eigen::Vector2d> m_before_px;
    double m_centroidGain;
    int m_cores;
    double m_referenceBrightness = 1.0;
};

} // namespace teleta::vision
