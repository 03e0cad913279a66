// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/vision/gel/gel_plane.h"
#include "backend/vision/gel/marker_gel_file.h"
#include "backend/vision/gel/marker_layout.h"
#include "backend/vision/gel/marker_tracker.h"

#include <opencv2/core.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace teleta::vision {

/// A marker of a gel: who it is.
struct GelMarker {
    GridPlace grid{}; ///< without a row in a free layout
    Eigen::Vector2d rest_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d rest_m = Eigen::Vector2d::Zero(); ///< on the gel's surface
};

/// A marker of a gel in one picture.
struct GelMotion {
    bool found = false;
    Eigen::Vector2d place_px = Eigen::Vector2d::Zero();       ///< undefined while it is lost
    Eigen::Vector2d displacement_m = Eigen::Vector2d::Zero(); ///< on the surface, from rest
};

/// What is wrong with a picture or the gel.
struct GelFaults {
    bool dead = false;        ///< a picture without any contrast, black or white
    bool lightJumped = false; ///< brighter or darker by a quarter than the last pictures
    bool torn = false;        ///< more than 30 % of the markers lost for 1 s
};

/// Follows the markers of a flat gel through the pictures of a camera. Places at rest are the median of the
/// first pictures that show no contact, 8 at most. Thread: one.
class MarkerGel {
public:
    static constexpr std::size_t kReferencePictures = 8;

    /// The part of a camera's picture that the file names: cropped, then flipped. frame: of one channel; the
    /// part may share its pixels. Error: refused when the crop reaches out of the picture.
    [[nodiscard]] static core::Expected<cv::Mat1b> part(const MarkerGelFile& file, const cv::Mat1b& frame);
    /// The same with dark markers.
    [[nodiscard]] static core::Expected<cv::Mat1b> picture(const MarkerGelFile& file, const cv::Mat1b& frame);

    /// first: the first pictures of the stream, from picture(); at least one, and of these up to 8 are used.
    /// Error: refused when they are black or of one colour, show no markers, or not those of the file.
    [[nodiscard]] static core::Expected<MarkerGel> make(const MarkerGelFile& file,
                                                        std::span<const cv::Mat1b> first);

    /// Follows the markers into the next picture; the first ones are given again. time_s: rises.
    /// Error: refused when the size of the picture has changed.
    [[nodiscard]] core::Expected<void> track(const cv::Mat1b& picture, double time_s);
    /// Expects all markers at rest, for use after a gap in the stream.
    void forget();

    [[nodiscard]] const std::vector<GelMarker>& markers() const { return m_markers; }
    [[nodiscard]] const std::vector<GelMotion>& motions() const { return m_motions; }
    [[nodiscard]] const std::vector<std::vector<std::size_t>>& neighbours() const {
        return m_tracker.neighbours();
    }
    [[nodiscard]] const GelFaults& faults() const { return m_faults; }
    [[nodiscard]] std::size_t found() const { return m_found; }
    [[nodiscard]] double diameter_px() const { return m_diameter_px; }
    [[nodiscard]] double pitch_px() const { return m_tracker.pitch_px(); }
    /// Pictures that the places at rest were made from.
    [[nodiscard]] std::size_t referencePictures() const { return m_references; }
    /// Standard deviation of a marker's place in a picture without contact, along one axis: the median of the
    /// markers. From a single picture it is not known: then it is taken as 0.1 px.
    [[nodiscard]] double noise_px() const { return m_noise_px; }
    /// Size on the surface of a pixel in the middle of the picture.
    [[nodiscard]] double scale_m() const { return m_scale_m; }
    /// Where the corners of the picture lie on the surface, from its first pixel along the first row and
    /// around; NaN where the lens shows no place.
    [[nodiscard]] std::array<Eigen::Vector2d, 4> corners_m() const;

private:
    MarkerGel(MarkerTracker tracker, GelPlane plane)
        : m_tracker(std::move(tracker))
        , m_plane(std::move(plane)) {}
    void findReference(std::span<const cv::Mat1b> first);
    void place();
    void judge(const cv::Mat1b& picture, double time_s);

    MarkerTracker m_tracker;
    GelPlane m_plane;
    std::vector<GelMarker> m_markers;
    std::vector<GelMotion> m_motions;
    GelFaults m_faults;
    cv::Size m_size;
    std::size_t m_found = 0;
    std::size_t m_references = 0;
    double m_diameter_px = 0.0;
    double m_noise_px = 0.0;
    double m_scale_m = 0.0;
    bool m_isBright = false; ///< the markers; then the pictures are inverted
    double m_usualLevel = std::numeric_limits<double>::quiet_NaN();
    double m_lostSince_s = std::numeric_limits<double>::quiet_NaN();
};

} // namespace teleta::vision
