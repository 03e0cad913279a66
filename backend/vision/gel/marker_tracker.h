// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/gel/marker_detector.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace teleta::vision {

/// One marker that is followed.
struct TrackedMarker {
    Eigen::Vector2d rest_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d now_px = Eigen::Vector2d::Zero(); ///< where it was found, or is expected while lost
    bool found = false;
};

/// Follows the markers of a gel from picture to picture. In each picture all dark spots are found; a marker
/// takes the spot next to where it is expected, within 0.45 pitches. It is expected where its velocity leads
/// or where it was, whichever makes neighbours move more alike; after a gap also at rest. A marker that moves
/// otherwise than its neighbours, or whose distances to them no longer fit, loses its spot, the worst first.
/// Lost ones are searched where their neighbours lead, from these inwards: by an affine map fitted to them.
/// One spot is never two markers. Unlike DotTracker it does not stay in a window about each dot, since
/// between two pictures a gel may move by nearly half the distance of its markers and turn by any angle over
/// time. Thread: one; allocates nothing once the largest number of spots was seen.
class MarkerTracker {
public:
    /// rest_px: places in a picture, found by the detector, with their contrast there. neighbours: of each.
    MarkerTracker(MarkerDetector detector, const std::vector<MarkerCentre>& rest,
                  std::vector<std::vector<std::size_t>> neighbours);

    /// Follows all markers into the next picture. Returns how many were found.
    std::size_t track(const cv::Mat1b& picture);
    /// Expects all markers at rest, for use after a gap in the stream.
    void forget();
    /// A better place at rest; the marker stays where it is.
    void setRest(std::size_t marker, const Eigen::Vector2d& rest_px) { m_markers[marker].rest_px = rest_px; }

    [[nodiscard]] const std::vector<TrackedMarker>& markers() const { return m_markers; }
    [[nodiscard]] const std::vector<std::vector<std::size_t>>& neighbours() const { return m_neighbours; }
    /// Of neighbours at rest, in the median.
    [[nodiscard]] double pitch_px() const { return m_pitch_px; }

private:
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    struct State {
        double pitch_px = 0.0; ///< distance to its neighbours at rest
        double contrast = 0.0; ///< at rest
        double diameter_px = 0.0;
        Eigen::Vector2d before_px = Eigen::Vector2d::Zero();
        Eigen::Vector2d velocity_px = Eigen::Vector2d::Zero(); ///< a picture
        bool wasFound = false;
    };
    struct Pair {
        double distance2_px = 0.0;
        std::size_t marker = 0;
        std::size_t spot = 0;
    };
    /// Where the markers are expected.
    enum class Guess { last, ahead, rest };

    void sortSpots(const cv::Mat1b& picture);
    /// The free spot next to a place; kNone: none within reach.
    [[nodiscard]] std::size_t nearest(const Eigen::Vector2d& place_px, double reach_px) const;
    [[nodiscard]] Eigen::Vector2d guessed_px(std::size_t marker, Guess guess) const;
    /// Gives each marker its spot. Returns how badly neighbours agree.
    double assign(Guess guess, std::vector<std::size_t>& spotOf);
    [[nodiscard]] double disagreement(Guess guess, const std::vector<std::size_t>& spotOf) const;
    void dropStrays();
    void searchLost();
    /// How far a marker is from what its neighbours allow, > 1; 0 when it agrees with them.
    [[nodiscard]] double strays(std::size_t marker) const;
    /// Where the found neighbours of a marker lead it. Returns false without enough of them.
    [[nodiscard]] bool led(std::size_t marker, Eigen::Vector2d& place_px) const;
    /// The median way of the found neighbours since the last picture. Returns false with fewer than two.
    [[nodiscard]] bool neighboursMoved(std::size_t marker, Eigen::Vector2d& moved_px) const;
    void take(std::size_t marker, std::size_t spot);
    void release(std::size_t marker);
    void refine(const cv::Mat1b& picture);

    MarkerDetector m_detector;
    std::vector<TrackedMarker> m_markers;
    std::vector<State> m_states;
    std::vector<std::vector<std::size_t>> m_neighbours;
    double m_pitch_px = 0.0;
    double m_leastContrast = 1.0;
    double m_shadeShare = 0.0; ///< grey level of a marker at rest over that around it
    std::vector<MarkerSpot> m_spots;
    std::vector<std::uint8_t> m_taken;
    std::vector<std::size_t> m_spotOf; ///< of each marker; kNone: lost
    std::vector<std::size_t> m_trial;
    std::vector<Pair> m_pairs;
    std::vector<double> m_strays; ///< of each marker, as strays() says
    bool m_afterGap = false;      ///< most markers were lost in the last picture
    /// Spots by squares of one pitch: of square k those from m_first[k] to m_first[k + 1] in m_inSquares.
    int m_squaresAcross = 0, m_squaresDown = 0;
    std::vector<std::size_t> m_first, m_inSquares;
};

} // namespace teleta::vision
