// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace teleta::vision {

/// A point of the skin whose displacement is known.
struct SkinNode {
    double angle_rad = 0.0; ///< at rest, about the tube's axis
    double z_m = 0.0;
    double around_m = 0.0; ///< displacement
    double inward_m = 0.0;
    bool known = false;                                               ///< in this frame
    double inwardBefore_m = std::numeric_limits<double>::quiet_NaN(); ///< in the frame before; NaN: not known
};

/// Points that belong to one contact.
struct SkinPatch {
    double angle_rad = 0.0; ///< centre
    double z_m = 0.0;
    double depth_m = 0.0; ///< largest inward displacement of a point
    /// How much larger it is than in the frame before, of the points that are known in both; NaN without any.
    /// At least jump_m when several points were lost at once, since they moved further than they could be
    /// followed. A point that jumps while no other one does was taken for another and counts for neither; in
    /// the next frame it says nothing of how deep the contact was before.
    double deepened_m = std::numeric_limits<double>::quiet_NaN();
    double peak_m = 0.0;            ///< largest displacement
    std::vector<std::size_t> nodes; ///< falling displacement
};

/// Contacts among scattered points of a tube's skin: watershed over the graph of neighbours in order of
/// falling displacement, and the centre of each as the mean of its points:
///   weight = (displacement - floor)^(3/4)
/// Over evenly spread points that is the centre of a smooth summit itself, also between them. Thread: one.
class SkinPatches {
public:
    struct Settings {
        double radius_m = 0.025;
        double threshold_m = 0.00012; ///< of the summit of a contact
        double prominence = 0.4;
        double floorShare = 0.25; ///< of the threshold, down to which points still belong to a contact
        std::size_t leastNodes = 3;
        double jump_m = 0.0012;     ///< inward in one frame, that loses points
        std::size_t leastLost = 3;  ///< fewer vanish behind a dent that grows slowly
        double loneJump_m = 0.0004; ///< inward in one frame, beyond loneJumpShare of what the next point did
        double loneJumpShare = 3.0;
    };
    explicit SkinPatches(const Settings& settings)
        : m_settings(settings) {}

    /// neighbours: of each node. Largest peak first.
    [[nodiscard]] std::vector<SkinPatch> find(std::span<const SkinNode> nodes,
                                              std::span<const std::vector<std::size_t>> neighbours);
    /// The next nodes are others, or follow on no frame.
    void forget() { m_strays.clear(); }

    /// Displacement at a place, a mean of the known nodes among the candidates with weights that fall with
    /// the distance (Gaussian of the given width); 0 without any.
    [[nodiscard]] double smoothed_m(std::span<const SkinNode> nodes, std::span<const std::size_t> candidates,
                                    double angle_rad, double z_m, double width_m) const;

private:
    /// The point of a patch that jumps alone; kNone: none does.
    [[nodiscard]] std::size_t loneJump(std::span<const SkinNode> nodes, const SkinPatch& patch) const;
    /// Depth of a patch and how it has changed.
    void measureDepth(std::span<const SkinNode> nodes, SkinPatch& patch);
    /// Where the node was is known, and its own.
    [[nodiscard]] bool isKnownBefore(std::span<const SkinNode> nodes, std::size_t node) const;

    Settings m_settings;
    std::vector<double> m_moved_m;
    std::vector<std::size_t> m_order;
    std::vector<std::size_t> m_parent; ///< union-find; kNone: not active yet
    std::vector<double> m_peak_m;
    std::vector<std::size_t> m_strays;       ///< points that jumped alone in this frame
    std::vector<std::size_t> m_straysBefore; ///< and in the frame before
};

} // namespace teleta::vision
