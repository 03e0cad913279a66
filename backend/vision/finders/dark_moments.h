// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <cstddef>
#include <vector>

namespace teleta::vision {

/// An elliptic window about a dot, and which of its pixels are read.
///   w = (1 - q)^2,  q = e^T J e < 1,  e: place of the pixel relative to the centre
class DotWindow {
public:
    DotWindow() = default;
    /// metric: J, positive definite. stride: every so many columns and rows are read; >= 1.
    DotWindow(const Eigen::Matrix2d& metric, int stride);

    /// J = (a, b/2; b/2, c).
    [[nodiscard]] float a() const { return m_a; }
    [[nodiscard]] float b() const { return m_b; }
    [[nodiscard]] float c() const { return m_c; }
    [[nodiscard]] int stride() const { return m_stride; }
    /// Of the pixels that may be in the window, relative to the one that is next to its centre.
    [[nodiscard]] int halfHeight_px() const { return static_cast<int>(m_rows.size() / 2); }
    [[nodiscard]] int halfWidth_px() const { return m_halfWidth_px; }
    struct Reach {
        int first_px = 0;
        int past_px = 0;
    };
    /// Columns in one of the rows -halfHeight_px() to halfHeight_px().
    [[nodiscard]] const Reach& reach(int row) const {
        return m_rows[static_cast<std::size_t>(row + halfHeight_px())];
    }

private:
    float m_a = 1.0F;
    float m_b = 0.0F;
    float m_c = 1.0F;
    int m_stride = 1;
    int m_halfWidth_px = 0;
    std::vector<Reach> m_rows;
};

/// Sums over the darkness in a window.
struct DarkMoments {
    float sum = 0.0F;                                 ///< sum of w d
    Eigen::Vector2f sum_px = Eigen::Vector2f::Zero(); ///< sum of w d e
    float darkest = 0.0F;                             ///< largest d
};

/// Adds up the darkness d = max(0, ground - I) of the pixels in a window with its weights w. The pixels lie
/// on the same lattice wherever the centre is. hidden: of the size of the frame, 255 where there is no
/// pattern, else 0; hidden pixels count as white, and white is never dark. Empty: no pixel of the window is
/// hidden. ground: grey level. Equal to the plain sums to rounding. Thread: any (pure).
[[nodiscard]] DarkMoments darkMoments(const cv::Mat1b& frame, const cv::Mat1b& hidden,
                                      const DotWindow& window, const Eigen::Vector2d& centre_px,
                                      float ground);

/// Asks the processor to read a window of a frame that darkMoments() needs soon: a frame that a camera has
/// just written is not in its cache.
void prefetch(const cv::Mat1b& frame, const DotWindow& window, const Eigen::Vector2d& centre_px);

} // namespace teleta::vision
