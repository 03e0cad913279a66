// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/gel_contacts.h"

#include "backend/vision/gel/slip_ring.h"

#include <Eigen/Cholesky>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace teleta::vision {

namespace {

constexpr double kPatchNoises = 4.0;
constexpr double kHiddenNoise_px = 0.05;
/// The middle of many places is judged, not the most distant of all markers.
constexpr double kHiddenSlipNoise_px = 0.035;
constexpr double kLoadedShare = 0.25; ///< of the largest divergence
constexpr double kLoadChanges = 0.25;
constexpr double kRadial = 0.5; ///< sum of displacements over sum of their sizes, below which they spread
constexpr double kLoadNoises = 3.0;
constexpr double kGrowthSd = 0.3; ///< the spread grows in proportion to itself but for this share

/// Of at least three points.
std::vector<Eigen::Vector2d> hullOf(const std::vector<Eigen::Vector2d>& points) {
    std::vector<cv::Point2f> rounded;
    for (const Eigen::Vector2d& point : points)
        rounded.emplace_back(static_cast<float>(point.x()), static_cast<float>(point.y()));
    std::vector<int> corners;
    cv::convexHull(rounded, corners);
    std::vector<Eigen::Vector2d> hull;
    for (const int corner : corners)
        hull.push_back(points[static_cast<std::size_t>(corner)]);
    return hull;
}

/// The share by which an area grows, det(1 + G) - 1. A turn has a divergence, but does not change it.
double stretchOf(const MarkerStrain& strain) {
    const double product = 0.25 * (strain.divergence * strain.divergence + strain.curl * strain.curl -
                                   strain.shear * strain.shear);
    return strain.divergence + product;
}

/// By which share of `spread` the places were spread across the way that they went on average, by least
/// squares with a shift and a turn: slip along that way does not change it. Nothing: they went no way
/// together, or are not spread.
std::optional<double> growthAcross(std::span<const ContactPlace> places,
                                   std::span<const Eigen::Vector2d> spread_m) {
    Eigen::Vector2d way_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();
    double sizes_m = 0.0;
    for (const ContactPlace& place : places) {
        way_m += place.moved_m;
        middle_m += place.rest_m;
        sizes_m += place.moved_m.norm();
    }
    if (!(way_m.norm() > kRadial * sizes_m))
        return std::nullopt;
    middle_m /= static_cast<double>(places.size());
    const Eigen::Vector2d along = way_m.normalized();
    const Eigen::Vector2d across(-along.y(), along.x());
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Eigen::Vector3d row(1.0, along.dot(places[i].rest_m - middle_m), across.dot(spread_m[i]));
        normal += row * row.transpose();
        right += row * across.dot(places[i].moved_m);
    }
    const Eigen::LDLT<Eigen::Matrix3d> solver(normal);
    if (solver.info() != Eigen::Success || !solver.isPositive() || !(solver.rcond() > 1e-12))
        return std::nullopt;
    return solver.solve(right).z();
}

/// Side of the square that is as large as the skin of one marker: the pitch, but p sqrt(sqrt(3) / 2) where
/// most markers that have all their neighbours have six, as on a grid of triangles, and not eight.
double sideOfMarker_m(const MarkerGel& gel) {
    const auto with = [&gel](std::size_t neighbours) {
        return std::ranges::count(gel.neighbours(), neighbours, &std::vector<std::size_t>::size);
    };
    constexpr double kOfTriangles = 0.930604859102; // sqrt(sqrt(3) / 2)
    return gel.scale_m() * gel.pitch_px() * (with(6) > with(8) ? kOfTriangles : 1.0);
}

} // namespace

const std::vector<GelContactState>& GelContacts::next(const MarkerGel& gel) {
    m_noise_m = gel.scale_m() * std::max(kHiddenNoise_px, gel.noise_px());
    m_pitch_m = sideOfMarker_m(gel);
    markerStrains(gel.markers(), gel.motions(), gel.neighbours(), m_strains);
    const std::vector<SkinPatch> patches = findPatches(gel);
    const Eigen::Vector2d outside_m = movedOutside_m(gel);
    std::vector<Followed> before = std::exchange(m_followed, {});
    m_contacts.clear();
    m_before_m.resize(gel.markers().size(), Eigen::Vector2d::Zero());
    for (std::size_t p = 0; p < patches.size(); ++p) {
        GelContactState contact = measured(gel, patches[p], p, outside_m);
        Followed followed = followedInto(p, before);
        followed.markers = contact.markers;
        contact.id = followed.id;
        judgeSlip(gel, contact, followed);
        m_followed.push_back(std::move(followed));
        m_contacts.push_back(std::move(contact));
    }
    for (std::size_t i = 0; i < m_before_m.size(); ++i)
        m_before_m[i] = gel.motions()[i].displacement_m;
    return m_contacts;
}

void GelContacts::forget() {
    m_followed.clear();
    m_contacts.clear();
    m_before_m.clear();
}

std::vector<SkinPatch> GelContacts::findPatches(const MarkerGel& gel) {
    m_nodes.assign(gel.markers().size(), {});
    for (std::size_t i = 0; i < m_nodes.size(); ++i) {
        const GelMotion& motion = gel.motions()[i];
        // The patches of a tube, of which this is a flat piece: 1 rad is 1 m.
        m_nodes[i].angle_rad = gel.markers()[i].rest_m.x();
        m_nodes[i].z_m = gel.markers()[i].rest_m.y() + (motion.found ? motion.displacement_m.y() : 0.0);
        m_nodes[i].around_m = motion.displacement_m.x();
        m_nodes[i].inward_m = motion.displacement_m.y();
        m_nodes[i].known = motion.found;
    }
    SkinPatches finder({.radius_m = 1.0,
                        .threshold_m = kPatchNoises * m_noise_m,
                        .floorShare = 1.0,
                        .jump_m = std::numeric_limits<double>::infinity(),
                        .loneJump_m = std::numeric_limits<double>::infinity()});
    std::vector<SkinPatch> patches = finder.find(m_nodes, gel.neighbours());
    m_patchOf.assign(m_nodes.size(), kNone);
    for (std::size_t p = 0; p < patches.size(); ++p)
        for (const std::size_t i : patches[p].nodes)
            m_patchOf[i] = p;
    return patches;
}

Eigen::Vector2d GelContacts::movedOutside_m(const MarkerGel& gel) const {
    Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
    double count = 0.0;
    for (std::size_t i = 0; i < m_patchOf.size(); ++i) {
        if (m_patchOf[i] != kNone || !gel.motions()[i].found)
            continue;
        sum_m += gel.motions()[i].displacement_m;
        count += 1.0;
    }
    return sum_m / std::max(1.0, count);
}

GelContactState GelContacts::measured(const MarkerGel& gel, const SkinPatch& patch, std::size_t number,
                                      const Eigen::Vector2d& outside_m) const {
    const std::vector<GelMotion>& motions = gel.motions();
    const double markerArea_m2 = m_pitch_m * m_pitch_m;
    const auto now_m = [&](std::size_t i) -> Eigen::Vector2d {
        return gel.markers()[i].rest_m + motions[i].displacement_m;
    };
    GelContactState contact;
    contact.markers = patch.nodes;
    contact.area_m2 = markerArea_m2 * static_cast<double>(patch.nodes.size());
    std::vector<Eigen::Vector2d> places_m, places_px;
    // Of the displacements: their sum, that of their sizes, and places weighed by their upper half, since
    // tails reach far, and other contacts cut them off on one side.
    Eigen::Vector2d moved_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d upper_m = Eigen::Vector2d::Zero();
    double sizes_m = 0.0, upper = 0.0, curl = 0.0, known = 0.0;
    for (const std::size_t i : patch.nodes) {
        if (!motions[i].found)
            continue;
        places_m.push_back(now_m(i));
        places_px.push_back(motions[i].place_px);
        moved_m += motions[i].displacement_m;
        const double size_m = motions[i].displacement_m.norm();
        sizes_m += size_m;
        const double weight = std::max(0.0, size_m - 0.5 * patch.peak_m);
        upper_m += weight * now_m(i);
        upper += weight;
        if (m_strains[i].known) {
            curl += m_strains[i].curl;
            known += 1.0;
        }
    }
    // A marker in the middle of a press does not move, so it is in no patch, but the skin spreads there.
    const auto spreadsHere = [&](std::size_t i) {
        return m_patchOf[i] == number ||
               (m_patchOf[i] == kNone &&
                2 * std::ranges::count_if(gel.neighbours()[i],
                                          [&](std::size_t k) { return m_patchOf[k] == number; }) >=
                    static_cast<std::ptrdiff_t>(gel.neighbours()[i].size()));
    };
    Eigen::Vector2d spread_m = Eigen::Vector2d::Zero();
    double spread = 0.0;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        if (!m_strains[i].known || !spreadsHere(i))
            continue;
        const double share = std::max(0.0, m_strains[i].divergence);
        spread += share;
        spread_m += share * now_m(i);
    }
    contact.normalProxy_m2 = spread * markerArea_m2;
    // A press spreads the skin to all sides: the middle of that is sharper than that of the displacements.
    if (spread > 0.0 && moved_m.norm() < kRadial * sizes_m)
        contact.centre_m = spread_m / spread;
    else
        contact.centre_m =
            upper > 0.0 ? Eigen::Vector2d(upper_m / upper) : Eigen::Vector2d(patch.angle_rad, patch.z_m);
    if (!places_m.empty())
        contact.shearProxy_m = moved_m / static_cast<double>(places_m.size()) - outside_m;
    contact.torsion_rad = known > 0.0 ? 0.5 * curl / known : 0.0;
    contact.outline = places_m.size() >= 3 ? hullOf(places_m) : places_m;
    contact.outline_px = places_px.size() >= 3 ? hullOf(places_px) : places_px;
    return contact;
}

GelContacts::Followed GelContacts::followedInto(std::size_t patch, std::vector<Followed>& before) {
    auto best = before.end();
    std::ptrdiff_t most = 0;
    for (auto other = before.begin(); other != before.end(); ++other) {
        const std::ptrdiff_t shared =
            std::ranges::count_if(other->markers, [&](std::size_t i) { return m_patchOf[i] == patch; });
        if (shared > most) {
            most = shared;
            best = other;
        }
    }
    if (best == before.end()) {
        Followed followed;
        followed.id = ++m_lastId;
        return followed;
    }
    Followed followed = std::move(*best);
    before.erase(best);
    return followed;
}

double GelContacts::loadOn_m2(const std::vector<std::size_t>& markers) const {
    double sum = 0.0;
    for (const std::size_t i : markers)
        sum += m_strains[i].known ? stretchOf(m_strains[i]) : 0.0;
    return sum * m_pitch_m * m_pitch_m;
}

double GelContacts::loadNoise_m2(std::size_t markers) const {
    return kLoadNoises * m_noise_m * m_pitch_m *
           std::sqrt(static_cast<double>(std::max<std::size_t>(1, markers)));
}

/// A disc about the centre with the spread's mean square radius, since shear adds to the divergence on one
/// side and takes from it on the other.
void GelContacts::findLoaded(const MarkerGel& gel, const GelContactState& contact, Followed& followed) const {
    const std::vector<GelMotion>& motions = gel.motions();
    double most = 0.0;
    for (const std::size_t i : contact.markers)
        most = std::max(most, m_strains[i].known ? m_strains[i].divergence : 0.0);
    const auto off_m2 = [&](std::size_t i) {
        return (gel.markers()[i].rest_m + motions[i].displacement_m - contact.centre_m).squaredNorm();
    };
    double squares = 0.0, shares = 0.0;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        if (!motions[i].found || !m_strains[i].known || m_strains[i].divergence < kLoadedShare * most ||
            off_m2(i) > contact.area_m2)
            continue;
        squares += m_strains[i].divergence * off_m2(i);
        shares += m_strains[i].divergence;
    }
    // The fit over the neighbours adds a pitch to the root of the mean square. A disc's border lies at 2 of
    // its mean square where the skin spreads evenly, at 3 where the spread falls to the border as a
    // paraboloid.
    const double pitch_m2 = m_pitch_m * m_pitch_m;
    const double reach_m2 =
        shares > 0.0 ? std::max(1.5 * pitch_m2, 2.5 * (squares / shares - pitch_m2)) : 0.0;
    std::vector<std::size_t> loaded;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        if (motions[i].found && m_strains[i].known && off_m2(i) <= reach_m2)
            loaded.push_back(i);
    }
    const bool spreads = !loaded.empty() && loadOn_m2(loaded) >= loadNoise_m2(loaded.size());
    followed.centre_m = contact.centre_m;
    followed.radius_m = spreads ? std::sqrt(reach_m2) : 0.0;
    followed.loaded = spreads ? std::move(loaded) : contact.markers;
}

Eigen::Vector2d GelContacts::rimMoved_m(const MarkerGel& gel, const GelContactState& contact) const {
    Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
    double count = 0.0;
    for (const std::size_t i : contact.markers) {
        const bool isRim = std::ranges::any_of(gel.neighbours()[i],
                                               [&](std::size_t k) { return m_patchOf[k] != m_patchOf[i]; });
        if (!isRim || !gel.motions()[i].found || !m_before_m[i].allFinite())
            continue;
        sum_m += gel.motions()[i].displacement_m - m_before_m[i];
        count += 1.0;
    }
    return sum_m / std::max(1.0, count);
}

void GelContacts::judgeSlip(const MarkerGel& gel, GelContactState& contact, Followed& followed) const {
    const std::vector<GelMotion>& motions = gel.motions();
    const bool changed = followed.loaded.empty() || loadChanged(gel, followed);
    const double load_m2 = loadOn_m2(followed.loaded);
    // A load that falls leaves the contact where it was, and its spread becomes too small to tell.
    if (changed && (followed.loaded.empty() || load_m2 > followed.most_m2)) {
        findLoaded(gel, contact, followed);
        followed.most_m2 = loadOn_m2(followed.loaded);
    }
    if (changed) {
        // The motion counts from here.
        followed.load_m2 = loadOn_m2(followed.loaded);
        followed.start_m.clear();
        for (const GelMotion& motion : motions)
            followed.start_m.push_back(motion.found ? motion.displacement_m
                                                    : Eigen::Vector2d::Constant(std::nan("")));
    }
    contact.slipIndex = slipOf(gel, followed);
    contact.event =
        followed.monitor.next(contact.slipIndex, contact.shearProxy_m, rimMoved_m(gel, contact), m_noise_m);
}

GelContacts::Moved GelContacts::movedSince(const MarkerGel& gel, const Followed& followed) {
    Moved moved;
    const auto add = [&](std::size_t i) {
        const GelMotion& motion = gel.motions()[i];
        if (!motion.found || !followed.start_m[i].allFinite())
            return;
        moved.places.push_back({.rest_m = gel.markers()[i].rest_m + followed.start_m[i],
                                .moved_m = motion.displacement_m - followed.start_m[i]});
        moved.spread_m.push_back(followed.start_m[i]);
    };
    std::ranges::for_each(followed.loaded, add);
    moved.loaded = moved.places.size();
    // Those around it tell of the ring, too.
    for (std::size_t i = 0; followed.radius_m > 0.0 && i < gel.markers().size(); ++i)
        if (std::ranges::find(followed.loaded, i) == followed.loaded.end())
            add(i);
    return moved;
}

bool GelContacts::loadChanged(const MarkerGel& gel, const Followed& followed) const {
    const double load_m2 = loadOn_m2(followed.loaded);
    const double noise_m2 = loadNoise_m2(followed.loaded.size());
    const double least_m2 = std::max(kLoadChanges * std::abs(followed.load_m2), noise_m2);
    if (std::abs(load_m2 - followed.load_m2) <= least_m2)
        return false;
    if (std::abs(followed.load_m2) <= noise_m2)
        return true; // nothing that could have grown in proportion
    // A ring of slip stretches the skin on one side and presses it together on the other. Over few markers
    // that does not cancel; across the way there is nothing of it.
    const Moved moved = movedSince(gel, followed);
    const auto growth = growthAcross(std::span(moved.places).first(moved.loaded),
                                     std::span(moved.spread_m).first(moved.loaded));
    return !growth || std::abs(*growth * followed.load_m2) > least_m2;
}

std::optional<double> GelContacts::slipOf(const MarkerGel& gel, const Followed& followed) const {
    Moved moved = movedSince(gel, followed);
    std::vector<ContactPlace>& places = moved.places;
    const auto loaded = std::span(places).first(moved.loaded);
    const auto spread_m = std::span(moved.spread_m).first(moved.loaded);
    // As long as the load changes little, the spread grows in proportion to it.
    double growth = 0.0;
    if (std::abs(followed.load_m2) > loadNoise_m2(followed.loaded.size()))
        growth = growthAcross(loaded, spread_m).value_or(loadOn_m2(followed.loaded) / followed.load_m2 - 1.0);
    Eigen::Vector2d mean_m = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& spread : spread_m)
        mean_m += spread / static_cast<double>(spread_m.size());
    double taken_m2 = 0.0; // mean square of what is taken off
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Eigen::Vector2d grown_m = growth * (moved.spread_m[i] - mean_m);
        places[i].moved_m -= grown_m;
        if (i < moved.loaded)
            taken_m2 += grown_m.squaredNorm() / static_cast<double>(moved.loaded);
    }
    const double noise_m = gel.scale_m() * std::max(kHiddenSlipNoise_px, gel.noise_px());
    const auto motion = sharedMotion(loaded, noise_m);
    if (!motion)
        return std::nullopt;
    if (!motion->movesAsOne || followed.radius_m == 0.0)
        return motion->slipShare;
    // Fewer are too coarse for a ring: they would tell by 0.2 and more too little.
    if (loaded.size() < kLeastRingPlaces)
        return std::nullopt;
    const double unknown_m = std::hypot(noise_m, kGrowthSd * std::sqrt(taken_m2));
    return slippingRing(places, followed.centre_m, followed.radius_m, unknown_m).value_or(motion->slipShare);
}

} // namespace teleta::vision
