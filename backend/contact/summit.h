// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/contact_segmenter.h"
#include "backend/core/data/array_layout.h"

#include <cstdint>
#include <optional>
#include <span>

namespace teleta::contact {

/// Where a body presses deepest, at a resolution finer than the taxels, in the sensor frame {s}.
struct Summit {
    double x_m = 0.0;
    double y_m = 0.0;
    double peak_N = 0.0; ///< load that a taxel at that place would have
    /// Standard errors; empty when the noise is not told, and across a strip, which does not tell its place.
    std::optional<double> xSe_m;
    std::optional<double> ySe_m;
};

/// Finds the summit of the only contact of a frame, or of one of its contacts.
///
/// An array of several rows and columns: the summit of the paraboloid through the loads of the active taxels,
///   load = a + b x + c y - d (x^2 + y^2),  least squares weighted by the loads,  summit (b, c) / 2d
/// On a bed of springs a ball has this profile, even where the border of the array cuts the contact off,
/// which would bias a centroid inwards. The standard errors follow from the noise, or from what the
/// paraboloid leaves unexplained where that is more. Empty for fewer than five active taxels, when they lie
/// on a line, when the loads do not fall off from a summit, or when the summit is more than half a taxel
/// outside the active ones.
///
/// A strip (one row or one column): the centre of the patch that pressedPatch() finds, from the active taxels
/// around the highest load and the two beyond, whose loads below the threshold place its edges. A single
/// active taxel is its own summit. Empty when the patch covers a taxel at the end of the strip wholly, since
/// then its other edge is not seen, or when a taxel beside the active ones is dead.
///
/// Independent of the unit of load. Thread: any (pure); allocates nothing.
///   load_N: layout.taxels() values, >= 0 and finite; threshold_N: > 0, a taxel is active from it on
///   (compared as float). dead: 1 for each taxel that is not used, or empty. noise_N: standard deviation of a
///   load; > 0.
[[nodiscard]] std::optional<Summit> summitOf(std::span<const float> load_N, const core::ArrayLayout& layout,
                                             double threshold_N, std::span<const std::uint8_t> dead = {},
                                             std::optional<double> noise_N = {});

/// The same of one contact: its active taxels are those of its region.
///   segmenter: as it is after the frame in which it found the contact.
[[nodiscard]] std::optional<Summit> summitOf(std::span<const float> load_N, const core::ArrayLayout& layout,
                                             const ContactSegmenter& segmenter, const Contact& contact,
                                             std::span<const std::uint8_t> dead = {},
                                             std::optional<double> noise_N = {});

} // namespace teleta::contact
