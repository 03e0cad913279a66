// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/gel_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace teleta::vision {

namespace {

constexpr double kPatchNoises = 4.0;
constexpr double kHiddenNoise_px = 0.05;
constexpr double kLoadedShare = 0.25; ///< of the largest divergence
constexpr double kLoadChanges = 0.25;
constexpr double kRadial = 0.5; ///< sum of displacements over sum of their sizes, below which they spread
constexpr double kLoadNoises = 3.0;
constexpr std::size_t kLeastLoaded = 5;

double turnOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Andrew's monotone chain.
std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points) {
    std::ranges::sort(points, [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
    });
    std::vector<Eigen::Vector2d> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t first = hull.size();
        for (const Eigen::Vector2d& point : points) {
            while (hull.size() >= first + 2 && turnOf(hull[hull.size() - 2], hull.back(), point) <= 0.0)
                hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back();
        std::ranges::reverse(points);
    }
    return hull;
}

std::size_t shared(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
    return static_cast<std::size_t>(
        std::ranges::count_if(a, [&](std::size_t k) { return std::ranges::find(b, k) != b.end(); }));
}

} // namespace

const std::vector<GelContactState>& GelContacts::next(const MarkerGel& gel) {
    const std::vector<GelMarker>& markers = gel.markers();
    const std::vector<GelMotion>& motions = gel.motions();
    markerStrains(markers, motions, gel.neighbours(), m_strains);
    m_nodes.assign(markers.size(), {});
    for (std::size_t i = 0; i < markers.size(); ++i) {
        // The patches of a tube, of which this is a flat piece: 1 rad is 1 m.
        m_nodes[i].angle_rad = markers[i].rest_m.x();
        m_nodes[i].z_m = markers[i].rest_m.y() + (motions[i].found ? motions[i].displacement_m.y() : 0.0);
        m_nodes[i].around_m = motions[i].displacement_m.x();
        m_nodes[i].inward_m = motions[i].displacement_m.y();
        m_nodes[i].known = motions[i].found;
    }
    const double scale_m = gel.noise_m() / gel.noise_px();
    const double noise_m = scale_m * std::max(kHiddenNoise_px, gel.noise_px());
    SkinPatches patches({.radius_m = 1.0,
                         .threshold_m = kPatchNoises * noise_m,
                         .floorShare = 1.0,
                         .jump_m = std::numeric_limits<double>::infinity(),
                         .loneJump_m = std::numeric_limits<double>::infinity()});
    const std::vector<SkinPatch> found = patches.find(m_nodes, gel.neighbours());

    std::vector<bool> inPatch(markers.size(), false);
    for (const SkinPatch& patch : found)
        for (const std::size_t i : patch.nodes)
            inPatch[i] = true;
    Eigen::Vector2d outside_m = Eigen::Vector2d::Zero();
    double outside = 0.0;
    for (std::size_t i = 0; i < markers.size(); ++i) {
        if (inPatch[i] || !motions[i].found)
            continue;
        outside_m += motions[i].displacement_m;
        outside += 1.0;
    }
    if (outside > 0.0)
        outside_m /= outside;
    const double pitch_m = scale_m * gel.pitch_px();
    const double markerArea_m2 = pitch_m * pitch_m;

    std::vector<Followed> before = std::move(m_followed);
    m_followed.clear();
    m_contacts.clear();
    m_before_m.resize(markers.size(), Eigen::Vector2d::Zero());
    for (const SkinPatch& patch : found) {
        GelContactState contact;
        contact.markers = patch.nodes;
        contact.area_m2 = markerArea_m2 * static_cast<double>(patch.nodes.size());
        std::vector<Eigen::Vector2d> places;
        Eigen::Vector2d spread_m = Eigen::Vector2d::Zero();
        double spread = 0.0, curl = 0.0, known = 0.0, seen = 0.0, sizes = 0.0;
        for (const std::size_t i : patch.nodes) {
            if (!motions[i].found)
                continue;
            const Eigen::Vector2d place_m = markers[i].rest_m + motions[i].displacement_m;
            places.push_back(place_m);
            contact.shearProxy_m += motions[i].displacement_m;
            sizes += motions[i].displacement_m.norm();
            seen += 1.0;
            if (!m_strains[i].known)
                continue;
            curl += m_strains[i].curl;
            known += 1.0;
        }
        // A marker in the middle of a press does not move, so it is in no patch, but the skin spreads there.
        std::vector<std::size_t> spreading = patch.nodes;
        for (std::size_t i = 0; i < markers.size(); ++i) {
            const auto inThis = [&](std::size_t k) {
                return std::ranges::find(patch.nodes, k) != patch.nodes.end();
            };
            if (!inPatch[i] && 2 * std::ranges::count_if(gel.neighbours()[i], inThis) >=
                                   static_cast<std::ptrdiff_t>(gel.neighbours()[i].size()))
                spreading.push_back(i);
        }
        for (const std::size_t i : spreading) {
            if (!m_strains[i].known)
                continue;
            const double share = std::max(0.0, m_strains[i].divergence);
            spread += share;
            spread_m += share * (markers[i].rest_m + motions[i].displacement_m);
        }
        contact.normalProxy_m2 = spread * markerArea_m2;
        // Its upper half: tails reach far, and other contacts cut them off on one side.
        Eigen::Vector2d upper_m = Eigen::Vector2d::Zero();
        double upper = 0.0;
        for (const std::size_t i : patch.nodes) {
            const double weight =
                motions[i].found ? std::max(0.0, motions[i].displacement_m.norm() - 0.5 * patch.peak_m) : 0.0;
            upper_m += weight * (markers[i].rest_m + motions[i].displacement_m);
            upper += weight;
        }
        contact.centre_m =
            upper > 0.0 ? Eigen::Vector2d(upper_m / upper) : Eigen::Vector2d(patch.angle_rad, patch.z_m);
        // A press spreads the skin to all sides: the middle of that is sharper than that of the
        // displacements.
        if (spread > 0.0 && contact.shearProxy_m.norm() < kRadial * sizes)
            contact.centre_m = spread_m / spread;
        if (seen > 0.0)
            contact.shearProxy_m = (contact.shearProxy_m / seen - outside_m).eval();
        contact.torsion_rad = known > 0.0 ? 0.5 * curl / known : 0.0;
        contact.outline = places.size() >= 3 ? convexHull(places) : places;

        Followed followed;
        const auto mostShared = std::ranges::max_element(before, {}, [&](const Followed& other) {
            return other.id == 0 ? 0 : shared(other.markers, contact.markers);
        });
        if (mostShared != before.end() && mostShared->id != 0 &&
            shared(mostShared->markers, contact.markers) > 0) {
            followed = std::move(*mostShared);
            mostShared->id = 0;
        } else {
            followed.id = ++m_lastId;
        }
        followed.markers = contact.markers;
        contact.id = followed.id;
        judgeSlip(gel, contact, followed);
        m_followed.push_back(std::move(followed));
        m_contacts.push_back(std::move(contact));
    }
    for (std::size_t i = 0; i < markers.size(); ++i)
        m_before_m[i] = motions[i].displacement_m;
    return m_contacts;
}

void GelContacts::judgeSlip(const MarkerGel& gel, GelContactState& contact, Followed& followed) {
    const std::vector<GelMotion>& motions = gel.motions();
    const double scale_m = gel.noise_m() / gel.noise_px();
    const double noise_m = scale_m * std::max(kHiddenNoise_px, gel.noise_px());
    const double pitch_m = scale_m * gel.pitch_px();
    const auto loadOn = [&](const std::vector<std::size_t>& places) {
        double sum = 0.0;
        for (const std::size_t i : places)
            sum += m_strains[i].known ? m_strains[i].divergence : 0.0;
        return sum * pitch_m * pitch_m;
    };
    const auto noiseOf = [&](std::size_t count) {
        return kLoadNoises * noise_m * pitch_m *
               std::sqrt(static_cast<double>(std::max<std::size_t>(1, count)));
    };
    const double load_m2 = loadOn(followed.loaded);
    const bool changed = followed.loaded.empty() || std::abs(load_m2 - followed.load_m2) >
                                                        std::max(kLoadChanges * std::abs(followed.load_m2),
                                                                 noiseOf(followed.loaded.size()));
    // A load that falls leaves the contact where it was, and its spread becomes too small to tell.
    if (changed && (followed.loaded.empty() || load_m2 > followed.most_m2)) {
        // Where the load is: a disc about the centre with the spread's mean square radius, since shear adds
        // to the divergence on one side and takes from it on the other.
        double most = 0.0;
        for (const std::size_t i : contact.markers)
            most = std::max(most, m_strains[i].known ? m_strains[i].divergence : 0.0);
        double squares = 0.0, shares = 0.0;
        const auto off_m = [&](std::size_t i) -> Eigen::Vector2d {
            return gel.markers()[i].rest_m + motions[i].displacement_m - contact.centre_m;
        };
        for (std::size_t i = 0; i < motions.size(); ++i) {
            if (!motions[i].found || !m_strains[i].known || m_strains[i].divergence < kLoadedShare * most ||
                off_m(i).squaredNorm() > contact.area_m2)
                continue;
            squares += m_strains[i].divergence * off_m(i).squaredNorm();
            shares += m_strains[i].divergence;
        }
        followed.loaded.clear();
        // The fit over the neighbours adds a pitch to the root of the mean square. A disc's border lies at 2
        // of its mean square where the skin spreads evenly, at 3 where the spread falls to the border as a
        // paraboloid.
        const double reach_m2 =
            shares > 0.0 ? std::max(1.5 * pitch_m * pitch_m, 2.5 * (squares / shares - pitch_m * pitch_m))
                         : 0.0;
        for (std::size_t i = 0; i < motions.size(); ++i) {
            if (motions[i].found && m_strains[i].known && off_m(i).squaredNorm() <= reach_m2)
                followed.loaded.push_back(i);
        }
        if (followed.loaded.size() < kLeastLoaded ||
            loadOn(followed.loaded) < noiseOf(followed.loaded.size()))
            followed.loaded = contact.markers;
        followed.most_m2 = loadOn(followed.loaded);
    }
    if (changed) {
        // The motion counts from here.
        followed.load_m2 = loadOn(followed.loaded);
        followed.start_m.clear();
        for (const std::size_t i : followed.loaded)
            followed.start_m.push_back(motions[i].found ? motions[i].displacement_m
                                                        : Eigen::Vector2d::Constant(std::nan("")));
    }
    // As long as the load changes little, the spread grows in proportion to it.
    Eigen::Vector2d mean_m = Eigen::Vector2d::Zero();
    double known = 0.0;
    for (const Eigen::Vector2d& start_m : followed.start_m) {
        if (start_m.allFinite()) {
            mean_m += start_m;
            known += 1.0;
        }
    }
    if (known > 0.0)
        mean_m /= known;
    const double growth = std::abs(followed.load_m2) > noiseOf(followed.loaded.size())
                              ? loadOn(followed.loaded) / followed.load_m2 - 1.0
                              : 0.0;
    std::vector<ContactPlace> places;
    for (std::size_t n = 0; n < followed.loaded.size(); ++n) {
        const std::size_t i = followed.loaded[n];
        if (!motions[i].found || !followed.start_m[n].allFinite())
            continue;
        places.push_back({.rest_m = gel.markers()[i].rest_m + followed.start_m[n],
                          .moved_m = motions[i].displacement_m - followed.start_m[n] -
                                     growth * (followed.start_m[n] - mean_m)});
    }
    if (const auto motion = sharedMotion(places, noise_m))
        contact.slipIndex = 1.0 - static_cast<double>(motion->sticking) / static_cast<double>(places.size());
    // The rim of a patch are the markers that have a neighbour outside of it.
    Eigen::Vector2d rimMoved_m = Eigen::Vector2d::Zero();
    double rim = 0.0;
    for (const std::size_t i : contact.markers) {
        const bool isRim = std::ranges::any_of(gel.neighbours()[i], [&](std::size_t k) {
            return std::ranges::find(contact.markers, k) == contact.markers.end();
        });
        if (!isRim || !motions[i].found)
            continue;
        rimMoved_m += motions[i].displacement_m - m_before_m[i];
        rim += 1.0;
    }
    if (rim > 0.0)
        rimMoved_m /= rim;
    contact.event = followed.monitor.next(contact.slipIndex, contact.shearProxy_m, rimMoved_m, noise_m);
}

} // namespace teleta::vision
