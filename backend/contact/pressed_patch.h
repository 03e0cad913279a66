// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

namespace teleta::contact {

/// The piece of a line of taxels on which an even pressure explains their loads best.
struct PressedPatch {
    double centre = 0.0; ///< in taxels from the middle of the first one
    double load_N = 0.0; ///< of a taxel that it covers wholly
    int first = 0;       ///< the taxels that it covers wholly, first to last
    int last = 0;
    double before = 0.0;   ///< share that it covers of the taxel before the first, 0..1
    double after = 0.0;    ///< and of the one behind the last
    double misfit_N = 0.0; ///< what the patch leaves unexplained, as the standard deviation of a load

    /// Standard error of the centre, in taxels, when the loads have the standard deviation noise_N >= 0.
    ///   se^2 = s^2 / (4 load^2) (2 + (after - before)^2 / n) + kShapeSe^2 + narrow^2
    /// s: the larger of noise_N and misfit_N; n: taxels that are covered wholly. narrow: a patch that covers
    /// one taxel and nothing of a neighbour may be narrower than a taxel; its centre is then somewhere
    /// between here and the far edge, and narrow is the root mean square of an even distribution there.
    [[nodiscard]] double centreSe(double noise_N) const;

    /// What the profile of the pressure, which is not known, adds to the standard error, in taxels: with it
    /// 1.96 standard errors hold the centre of flat, spherical, conical and Gaussian profiles of 1 to 5
    /// taxels in at least 92 %, with little noise.
    static constexpr double kShapeSe = 0.05;
};

/// Finds the patch by least squares:
///   load_i = load * (share of taxel i that the patch covers)
/// A taxel reads the pressure on its whole width, so the two shares at the ends, below one, place the edges
/// of the patch finer than the taxels. The patch covers at least one taxel wholly, one of the highest load.
/// Independent of the unit of load, and mirrored with the line. loads_N: >= 0 and finite, of a single
/// contact; what lies beyond the line has no load. Empty when there is no load. Cost: the square of the
/// number of taxels. Thread: any (pure); allocates nothing.
[[nodiscard]] std::optional<PressedPatch> pressedPatch(std::span<const float> loads_N);

} // namespace teleta::contact
