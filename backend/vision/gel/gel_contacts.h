// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/finders/skin_patches.h"
#include "backend/vision/gel/marker_gel.h"
#include "backend/vision/gel/marker_strain.h"
#include "backend/vision/gel/slip_monitor.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace teleta::vision {

/// One contact on a flat gel in one picture. Without a calibration its measures are proxies, no forces.
struct GelContactState {
    int id = 0;                           ///< from 1; stays while its markers overlap from picture to picture
    std::vector<std::size_t> markers;     ///< in order of falling displacement
    std::vector<Eigen::Vector2d> outline; ///< convex, in m, counter-clockwise from x to y
    std::vector<Eigen::Vector2d> outline_px; ///< convex, in the picture
    double area_m2 = 0.0;                    ///< number of markers times the area of one
    Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
    double normalProxy_m2 = 0.0; ///< sum of max(divergence, 0) times the area of a marker
    Eigen::Vector2d shearProxy_m =
        Eigen::Vector2d::Zero();     ///< mean displacement less that outside of patches
    double torsion_rad = 0.0;        ///< half the mean curl
    std::optional<double> slipIndex; ///< share that slips, 0..1; nothing under five markers
    SlipEvent event = SlipEvent::none;
};

/// Makes contacts of the motion of markers: patches of displacements above 4 standard deviations of the noise
/// (of at least 0.05 px, since compressed videos hide noise), parted by a watershed over the graph of
/// neighbours. Slip is judged where the load spreads the skin, or on the whole patch where it does not, from
/// the motion since the load last changed by a quarter, less what its spread has grown in proportion to it:
/// the skin spreads without slipping. That proportion comes from the motion across the way of the contact,
/// which slip does not change, or from the load where it goes no way. Thread: one.
class GelContacts {
public:
    /// The contacts of the next picture, the largest displacement first.
    [[nodiscard]] const std::vector<GelContactState>& next(const MarkerGel& gel);
    /// Contacts of the next picture are new; its markers may be others. For use after a gap in the stream.
    void forget();

private:
    struct Followed {
        int id = 0;
        std::vector<std::size_t> markers;
        SlipMonitor monitor;
        double load_m2 =
            0.0; ///< sum of the divergence over the loaded markers when the motion was last counted anew
        double most_m2 = 0.0; ///< the largest of these sums, at which `loaded` was found
        std::vector<std::size_t> loaded;
        std::vector<Eigen::Vector2d> start_m;               ///< displacement of each marker of the gel then
        Eigen::Vector2d centre_m = Eigen::Vector2d::Zero(); ///< of the load, when `loaded` was found
        double radius_m = 0.0;                              ///< likewise; 0: it spreads the skin nowhere
    };
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

    /// Fills m_patchOf.
    [[nodiscard]] std::vector<SkinPatch> findPatches(const MarkerGel& gel);
    /// The mean displacement of the markers outside of patches.
    [[nodiscard]] Eigen::Vector2d movedOutside_m(const MarkerGel& gel) const;
    [[nodiscard]] GelContactState measured(const MarkerGel& gel, const SkinPatch& patch, std::size_t number,
                                           const Eigen::Vector2d& outside_m) const;
    /// The contact of the last picture that shares most markers with a patch, taken out of these; or a new
    /// one.
    [[nodiscard]] Followed followedInto(std::size_t patch, std::vector<Followed>& before);
    void judgeSlip(const MarkerGel& gel, GelContactState& contact, Followed& followed) const;
    /// Sets `loaded`, `centre_m` and `radius_m`.
    void findLoaded(const MarkerGel& gel, const GelContactState& contact, Followed& followed) const;
    /// What the markers did since the motion was last counted anew.
    struct Moved {
        std::vector<ContactPlace> places;      ///< the loaded markers first
        std::vector<Eigen::Vector2d> spread_m; ///< displacement of each when the count began
        std::size_t loaded = 0;
    };
    [[nodiscard]] static Moved movedSince(const MarkerGel& gel, const Followed& followed);
    /// By a quarter, and by more than noise, since then.
    [[nodiscard]] bool loadChanged(const MarkerGel& gel, const Followed& followed) const;
    /// The share that slips, by the ring of slip or else by the markers that lag.
    [[nodiscard]] std::optional<double> slipOf(const MarkerGel& gel, const Followed& followed) const;
    /// How far the markers of a contact that have a neighbour outside of it moved since the last picture.
    [[nodiscard]] Eigen::Vector2d rimMoved_m(const MarkerGel& gel, const GelContactState& contact) const;
    /// Sum of the divergence over markers, times the area of one.
    [[nodiscard]] double loadOn_m2(const std::vector<std::size_t>& markers) const;
    [[nodiscard]] double loadNoise_m2(std::size_t markers) const;

    double m_noise_m = 0.0; ///< of a marker
    double m_pitch_m = 0.0;
    std::vector<std::size_t> m_patchOf; ///< of each marker; kNone: none
    std::vector<MarkerStrain> m_strains;
    std::vector<SkinNode> m_nodes;
    std::vector<GelContactState> m_contacts;
    std::vector<Followed> m_followed;
    std::vector<Eigen::Vector2d> m_before_m; ///< displacements in the last picture
    int m_lastId = 0;
};

} // namespace teleta::vision
