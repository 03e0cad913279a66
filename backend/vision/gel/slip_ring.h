// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/gel/slip_monitor.h"

#include <Eigen/Core>

#include <optional>
#include <span>

namespace teleta::vision {

/// Fewer places do not tell a ring.
inline constexpr std::size_t kLeastRingPlaces = 12;
/// In radii: places that lie further away are left out, since how they move depends on the skin's thickness.
inline constexpr double kRingReach = 1.2;

/// The share of a round contact that slips, from how far the places in it, and close around it, have gone:
/// the ring of slip after Cattaneo and Mindlin, whose width and the radius of the contact are those that
/// explain the motion best. Every place tells something of both, also where it lags by less than its noise,
/// so that few are enough. Source: K. L. Johnson, Contact Mechanics (1985), 7.2, with Poisson's number 0.
///
/// places: in and around the contact, since they began to move; the spread that the load makes taken off.
/// centre_m, radius_m: of the contact, as its press tells them, > 0; the radius to about 10 %.
/// noise_m: standard deviation of a place along an axis, > 0.
/// 0..1; nothing: no ring explains how they went.
/// Thread: any (pure).
[[nodiscard]] std::optional<double> slippingRing(std::span<const ContactPlace> places,
                                                 const Eigen::Vector2d& centre_m, double radius_m,
                                                 double noise_m);

} // namespace teleta::vision
