// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace teleta::vision {

/// A place in a picture where a marker may be.
struct MarkerSpot {
    Eigen::Vector2d place_px = Eigen::Vector2d::Zero();
    double contrast = 0.0; ///< grey levels of the marker below what surrounds it
};

/// The exact place of one marker.
struct MarkerCentre {
    Eigen::Vector2d place_px = Eigen::Vector2d::Zero();
    double contrast = 0.0;    ///< grey levels of its middle below the ground
    double ground = 0.0;      ///< grey level around it
    double diameter_px = 0.0; ///< of a disc of that contrast with the same darkness in all
    double longness = 1.0;    ///< long axis over short axis
};

/// Finds dark round markers of about one diameter in pictures.
///   spot:   local maximum of  mean over 2 diameters - mean over 0.7 diameters
///   centre: where  sum k(|x - c|) s(x)  is largest,  k' = -(1 - ((r - D/2) / h)^2)^2,
///           h = max(1.5 px, 0.3 D),  s = (ground(x) - I(x)) / (0.6 contrast), held to 0..1; ground: plane
///           through the ring around it
/// So a marker is a disc that is dark everywhere, and its rim tells where. Brightness and its slope across a
/// marker cancel, and what crosses one, such as a scratch, pulls only where it crosses the rim; a centroid of
/// the darkness would follow all of it. Thread: one.
class MarkerDetector {
public:
    /// diameter_px: >= 2. apart_px: distance of neighbouring markers; 0: not known yet.
    explicit MarkerDetector(double diameter_px, double apart_px = 0.0);

    /// All spots of at least this contrast, from top to bottom. shadeShare: grey level of a marker over that
    /// around it; what is darker is taken for no darker. 0: not known.
    void spots(const cv::Mat1b& picture, double leastContrast, std::vector<MarkerSpot>& found,
               double shadeShare = 0.0);

    /// The marker next to a place. mostContrast: of a marker here; what is darker is taken for no darker.
    /// Nothing when it has less than the given contrast, when it would be further than half a diameter (at
    /// least 1.5 px) from the place, or when its disc reaches out of the picture by more than a tenth of the
    /// diameter.
    [[nodiscard]] std::optional<MarkerCentre>
    centre(const cv::Mat1b& picture, const Eigen::Vector2d& place_px, double leastContrast,
           double mostContrast = std::numeric_limits<double>::infinity());

    /// The markers of a picture: centres of all spots that stand out from its texture.
    [[nodiscard]] std::vector<MarkerCentre> centres(const cv::Mat1b& picture);

    [[nodiscard]] double diameter_px() const { return m_diameter_px; }

private:
    [[nodiscard]] bool isInside(const cv::Mat1b& picture, const Eigen::Vector2d& place_px) const;
    [[nodiscard]] double within_px() const;
    /// Fills m_shade about a pixel. Returns false without a ground or enough contrast.
    [[nodiscard]] bool readShade(const cv::Mat1b& picture, const cv::Point& middle, double leastContrast,
                                 double mostContrast, MarkerCentre& result);

    double m_diameter_px;
    double m_window_px;               ///< radius
    double m_innerRing_px, m_ring_px; ///< radii of the ring that shows the ground
    std::vector<float> m_shade;       ///< of a square of 2 m_reach + 1 pixels, each row m_stride long
    int m_reach = 0, m_stride = 0;
    std::vector<std::uint8_t> m_levels;
    int m_apart_px;   ///< side of the square in which there is one spot
    cv::Mat m_square; ///< that square
    cv::Mat1b m_held, m_near, m_far, m_response, m_highest;
};

/// Diameter of the markers of a picture, found where spots of one size stand out most; 0 when none do.
/// Allowed: 3 px to an eighth of the shorter side. Thread: any (pure).
[[nodiscard]] double findMarkerDiameter(const cv::Mat1b& picture);

/// The contrast that parts markers from the texture of a picture, from the spots of it; 0 when they cannot be
/// parted. Thread: any (pure).
[[nodiscard]] double partingContrast(const std::vector<MarkerSpot>& spots);

} // namespace teleta::vision
