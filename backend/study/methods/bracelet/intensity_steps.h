// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace teleta::study {

/// The smallest difference that is noticed at a level.
struct JndAt {
    double level = 0.0;
    double jnd = 0.0; ///< > 0
};

/// Levels x_{k+1} = x_k + JND(x_k) from `start` as far as `full`, start included: each is told apart from the
/// one before. JND is linear between the measured levels and stays as it is beyond them. Empty: a JND is not
/// above 0, nothing was measured, or full < start. jnds: of rising levels. Thread: any (pure).
[[nodiscard]] std::optional<std::vector<double>> intensitySteps(std::span<const JndAt> jnds, double start,
                                                                double full);

} // namespace teleta::study
