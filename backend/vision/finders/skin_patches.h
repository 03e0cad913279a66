// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/taxels/graph_watershed.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace teleta::vision {

/// A point of the skin and its displacement.
struct SkinNode {
    double angle_rad = 0.0; ///< at rest, about the axis of the tube
    double z_m = 0.0;
    double around_m = 0.0; ///< displacement
    double inward_m = 0.0;
    bool known = false;                                               ///< in this frame
    double inwardBefore_m = std::numeric_limits<double>::quiet_NaN(); ///< in the previous frame; NaN: unknown
};

/// The points that belong to one contact.
struct SkinPatch {
    double angle_rad = 0.0; ///< centre
    double z_m = 0.0;
    double depth_m = 0.0; ///< largest inward displacement
    /// How much deeper the points known in both frames are than in the previous one; NaN if there are none.
    /// At least jump_m when several points were lost at once, because these moved further than they could be
    /// tracked. A point that jumps alone was confused with another one; it is not used in this frame, nor in
    /// the next one as previous depth.
    double deepened_m = std::numeric_limits<double>::quiet_NaN();
    double peak_m = 0.0;            ///< largest displacement
    std::vector<std::size_t> nodes; ///< in order of falling displacement
};

/// Segments scattered points of the skin of a tube into contacts by a watershed over the graph of neighbours
/// in order of falling displacement. The centre of a contact is the weighted mean of its points:
///   weight = (displacement - floor)^(3/4)
/// For evenly spaced points this is the centre of a smooth summit, even between the points. Thread: one.
class SkinPatches {
public:
    struct Settings {
        double radius_m = 0.025;
        double threshold_m = 0.00012; ///< least displacement at the summit of a contact
        double prominence = 0.4;
        double floorShare = 0.25; ///< share of the threshold down to which points belong to a contact
        std::size_t leastNodes = 3;
        double jump_m = 0.0012;     ///< inward displacement in one frame at which points are lost
        std::size_t leastLost = 3;  ///< fewer points than this may disappear behind a slowly growing dent
        double loneJump_m = 0.0004; ///< inward displacement in one frame, in excess of loneJumpShare times
                                    ///< that of the next point
        double loneJumpShare = 3.0;
    };
    explicit SkinPatches(const Settings& settings)
        : m_settings(settings) {}

    /// Finds the contacts, the largest peak first. neighbours: indices of the neighbours of each node.
    [[nodiscard]] std::vector<SkinPatch> find(std::span<const SkinNode> nodes,
                                              std::span<const std::vector<std::size_t>> neighbours);
    /// To be called when the next nodes are others, or the next frame does not follow the previous one.
    void forget() { m_strays.clear(); }

    /// Smoothed displacement at a place: mean of the known nodes among the candidates, weighted by a Gaussian
    /// of the given width of their distance; 0 if there are none.
    [[nodiscard]] double smoothed_m(std::span<const SkinNode> nodes, std::span<const std::size_t> candidates,
                                    double angle_rad, double z_m, double width_m) const;

private:
    /// The point of a patch that jumps alone, or kNone.
    [[nodiscard]] std::size_t loneJump(std::span<const SkinNode> nodes, const SkinPatch& patch) const;
    /// Sets the depth of a patch and its change.
    void measureDepth(std::span<const SkinNode> nodes, SkinPatch& patch);
    /// Whether the displacement of a node in the previous frame is known and not that of another point.
    [[nodiscard]] bool isKnownBefore(std::span<const SkinNode> nodes, std::size_t node) const;

    Settings m_settings;
    std::vector<double> m_moved_m;
    contact::GraphWatershed m_watershed;
    std::vector<std::size_t> m_strays;       ///< points that jumped alone in this frame
    std::vector<std::size_t> m_straysBefore; ///< the same in the previous frame
};

} // namespace teleta::vision
