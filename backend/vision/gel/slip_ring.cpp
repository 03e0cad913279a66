// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/slip_ring.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace teleta::vision {

namespace {

constexpr int kShares = 50; ///< steps of the share from 0 to 1
constexpr int kRadii = 11;  ///< that are tried
constexpr double kSmallestRadius = 0.8;
constexpr double kRadiusStep = 0.05;
constexpr double kRadiusSd = 0.1;
constexpr double kTableStep = 0.01; ///< of the distance from the centre, in radii
constexpr int kTableSize = static_cast<int>(kRingReach / kSmallestRadius / kTableStep) + 3;
/// The law is as good as this share of the way.
constexpr double kLawSd = 0.01;
/// Mean square of what the law leaves, over what it may.
constexpr double kMostLeft = 9.0;
/// Squares that a ring must explain beyond what no ring does, over the mean square that is left.
constexpr double kLeastExplained = 16.0;

/// Displacement on the surface under the traction of full slip, at a distance in radii of the load; 1 in the
/// middle.
double dragged(double x) {
    if (x <= 1.0)
        return 1.0 - 0.5 * x * x;
    return ((2.0 - x * x) * std::asin(1.0 / x) + std::sqrt(x * x - 1.0)) / std::numbers::pi;
}

/// The way of a place over that of the middle, by the share that slips and the distance in radii.
class RingLaw {
public:
    RingLaw() {
        for (int i = 0; i <= kShares; ++i)
            for (int k = 0; k < kTableSize; ++k)
                m_way[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] =
                    way(static_cast<double>(i) / kShares, kTableStep * k);
    }
    /// x: at most that of the table.
    [[nodiscard]] double at(int share, double x) const {
        const double place = x / kTableStep;
        const auto k = std::min(static_cast<std::size_t>(place), std::size_t{kTableSize - 2});
        const auto& row = m_way[static_cast<std::size_t>(share)];
        return std::lerp(row[k], row[k + 1], place - static_cast<double>(k));
    }

private:
    static double way(double share, double x) {
        // The middle goes by this share of the way at which all slips. Nothing slips: the limit.
        const double slips = std::max(share, 1e-6);
        const double stick = std::sqrt(1.0 - slips); // radius of what sticks
        const double held = stick > 0.0 ? (1.0 - slips) * dragged(x / stick) : 0.0;
        return (dragged(x) - held) / slips;
    }

    std::array<std::array<double, kTableSize>, kShares + 1> m_way{};
};

struct Fit {
    double share = 0.0;
    double cost = std::numeric_limits<double>::infinity(); ///< with what is known of the radius
    double left_m2 = 0.0;                                  ///< squares
};

/// How far each place went along the way of all, without the turn of all about the centre.
std::vector<double> along_m(std::span<const ContactPlace> places, const Eigen::Vector2d& centre_m) {
    Eigen::Vector2d way_m = Eigen::Vector2d::Zero();
    double cross_m2 = 0.0;
    double squares_m2 = 0.0;
    for (const ContactPlace& place : places) {
        const Eigen::Vector2d off_m = place.rest_m - centre_m;
        way_m += place.moved_m;
        cross_m2 += off_m.x() * place.moved_m.y() - off_m.y() * place.moved_m.x();
        squares_m2 += off_m.squaredNorm();
    }
    const double turn_rad = squares_m2 > 0.0 ? cross_m2 / squares_m2 : 0.0;
    const Eigen::Vector2d along = way_m.normalized();
    std::vector<double> went_m;
    went_m.reserve(places.size());
    for (const ContactPlace& place : places) {
        const Eigen::Vector2d off_m = place.rest_m - centre_m;
        went_m.push_back(along.dot(place.moved_m - turn_rad * Eigen::Vector2d(-off_m.y(), off_m.x())));
    }
    return went_m;
}

} // namespace

std::optional<double> slippingRing(std::span<const ContactPlace> places, const Eigen::Vector2d& centre_m,
                                   double radius_m, double noise_m) {
    static const RingLaw law;
    std::vector<ContactPlace> near;
    std::vector<double> off_m;
    for (const ContactPlace& place : places) {
        const double distance_m = (place.rest_m - centre_m).norm();
        if (distance_m > kRingReach * radius_m)
            continue;
        near.push_back(place);
        off_m.push_back(distance_m);
    }
    if (near.size() < 2)
        return std::nullopt;
    const std::vector<double> went_m = along_m(near, centre_m);
    double all_m2 = 0.0;
    double furthest_m = 0.0;
    for (const double way_m : went_m) {
        all_m2 += way_m * way_m;
        furthest_m = std::max(furthest_m, way_m);
    }
    const double may_m2 = noise_m * noise_m + kLawSd * kLawSd * furthest_m * furthest_m;
    Fit best;
    double unslippedCost = std::numeric_limits<double>::infinity();
    for (int r = 0; r < kRadii; ++r) {
        const double factor = kSmallestRadius + kRadiusStep * r;
        const double off = (factor - 1.0) / kRadiusSd;
        for (int share = 0; share <= kShares; ++share) {
            double law2 = 0.0;
            double both_m = 0.0;
            for (std::size_t i = 0; i < went_m.size(); ++i) {
                const double way = law.at(share, off_m[i] / (factor * radius_m));
                law2 += way * way;
                both_m += way * went_m[i];
            }
            const double left_m2 = all_m2 - both_m * both_m / law2;
            const double cost = left_m2 / may_m2 + off * off;
            if (share == 0)
                unslippedCost = std::min(unslippedCost, cost);
            if (cost < best.cost)
                best = {static_cast<double>(share) / kShares, cost, left_m2};
        }
    }
    const double left = best.left_m2 / (may_m2 * static_cast<double>(went_m.size()));
    if (left > kMostLeft)
        return std::nullopt;
    return unslippedCost - best.cost > kLeastExplained * std::max(1.0, left) ? best.share : 0.0;
}

} // namespace teleta::vision
