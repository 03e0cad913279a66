// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace teleta::vision {

/// One dot as it is looked for.
struct TrackedDot {
    Eigen::Vector2d rest_px = Eigen::Vector2d::Zero(); ///< in the reference
    Eigen::Matrix2d metric =
        Eigen::Matrix2d::Identity(); ///< J of e^T J e = 1: rim of the window, e from its centre
    /// A of |A e| = 1: how far a dot's displacement e may differ from that of its neighbours.
    Eigen::Matrix2d tolerance = Eigen::Matrix2d::Identity();
    std::vector<std::size_t> neighbours{};
    Eigen::Vector2d now_px = Eigen::Vector2d::Zero(); ///< where it was found, or is expected while it is lost
    Eigen::Vector2d velocity_px = Eigen::Vector2d::Zero(); ///< a frame
    bool found = false;
};

/// Follows dark dots by the centroid of their darkness in a window, from where each should be after the frame
/// before. A dot that disagrees with its neighbours, or shares its place with another one, is looked for anew
/// where its neighbours say; what cannot be found is lost until the neighbours lead to it again.
///   c <- c + gain * sum(w d x) / sum(w d),   w = (1 - q)^2, q = e^T J e < 1,   d = darkness
/// The brightness of the whole image may change from frame to frame.
/// Thread: one. After the reference nothing is allocated.
class DotTracker {
public:
    /// dots: rest_px, about where dots are, metric, tolerance and neighbours of each. mask: as large as the
    /// frames, 0 beside the pattern. dotDiameterShare: of a dot in the radius of its window.
    DotTracker(std::vector<TrackedDot> dots, const cv::Mat1b& mask, double dotDiameterShare);

    /// Takes the frame in which the dots rest, and finds their exact places. Returns how many were found.
    std::size_t setReference(const cv::Mat1b& frame);
    /// Finds all dots in a frame. Returns how many were found.
    std::size_t track(const cv::Mat1b& frame);
    /// Expects all dots where they rest, as after a gap in the stream.
    void forget();

    [[nodiscard]] const std::vector<TrackedDot>& dots() const { return m_dots; }
    [[nodiscard]] Eigen::Vector2d displacement_px(std::size_t dot) const {
        return m_dots[dot].now_px - m_dots[dot].rest_px;
    }

private:
    struct Window {
        int stride = 1;
        int halfWidth = 0, halfHeight = 0;
        float ground = 0.0F;   ///< grey level around the dot in the reference
        double mass = 0.0;     ///< of its darkness in the reference
        float darkest = 0.0F;  ///< as Found::darkest, in the reference
        double reach_px = 0.0; ///< how far it may be from where its neighbours say
    };
    struct Found {
        Eigen::Vector2d place_px;
        double mass = 0.0;
        float darkest = 0.0F; ///< share of the ground that its darkest pixel lacks
    };
    [[nodiscard]] Found centroid(const cv::Mat1b& frame, std::size_t dot, const Eigen::Vector2d& start_px,
                                 float gain, int steps) const;
    [[nodiscard]] bool take(const cv::Mat1b& frame, std::size_t dot, const Eigen::Vector2d& start_px,
                            float gain);
    [[nodiscard]] float brightness(const cv::Mat1b& frame) const;
    /// Median displacement of the neighbours that were found; false when there are too few of them.
    [[nodiscard]] bool expected(std::size_t dot, Eigen::Vector2d& displacement_px) const;
    [[nodiscard]] bool strays(std::size_t dot) const;
    void dropDoubles();

    std::vector<TrackedDot> m_dots;
    cv::Mat1b m_mask;
    std::vector<Window> m_windows;
    std::vector<std::size_t> m_lost;
    std::vector<Eigen::Vector2d> m_before_px;
    double m_centroidGain;
    double m_referenceBrightness = 1.0;
};

} // namespace teleta::vision
