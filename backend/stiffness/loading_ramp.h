// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/stiffness/compliance_line.h"
#include "backend/stiffness/joint_sample.h"

#include <cstddef>
#include <span>
#include <vector>

namespace teleta::stiffness {

/// How far outside the window samples are still used, as a share of its width: noise moves samples across its
/// borders.
inline constexpr double kWindowMargin = 0.5;

/// Selects the samples of the first loading of a touch, during which the torque rises through the window.
/// They are sorted by time, then torque, then angle, so that the order of the input does not matter; repeated
/// samples count once. Torques are relative to the reference and positive in the direction of the touch; the
/// sign of the angles is changed with theirs.
///   from  after the last sample below max(low - margin, low/2) that precedes the window's upper border
///   to    the highest sample before the torque falls below the middle or rises above high + margin
/// If the upper border is never reached, the highest torque of the log replaces it, also in the definition of
/// the middle. Empty when no sample reaches the lower border. samples: finite. Thread: any (pure).
[[nodiscard]] std::vector<JointSample> loadingRamp(std::span<const JointSample> samples,
                                                   const TorqueWindow& window,
                                                   double torqueReference_Nm = 0.0);

/// A touch in order of time, positive in its direction, with the range of its first loading.
struct OrderedTouch {
    std::vector<JointSample> log;
    std::size_t first = 0; ///< of the samples that loadingRamp() gives
    std::size_t end = 0;   ///< past the last of them; first: there are none
    bool turned = false;   ///< the signs of torque and angle were changed

    [[nodiscard]] std::span<const JointSample> ramp() const {
        return std::span(log).subspan(first, end - first);
    }
};

/// Sorts a log and takes repeated samples out. Thread: any (pure).
[[nodiscard]] std::vector<JointSample> inOrderOfTime(std::span<const JointSample> samples);

/// The whole log with the range of loadingRamp(). log: as inOrderOfTime() gives it, torques relative to the
/// reference. Thread: any (pure).
[[nodiscard]] OrderedTouch orderedTouch(std::vector<JointSample> log, const TorqueWindow& window);

/// Noise of both readings and the degrees of freedom of their variances, 0 when the noise is unknown.
struct EstimatedNoise {
    ReadingNoise noise;
    double degreesOfFreedom = 0.0;
};

/// Estimates the noise of both readings from the distance of each sample from the line, over time, between
/// its neighbours; during a steady motion this distance is pure noise. Degrees of freedom: 18/35 of the
/// number of such triples. Unknown when there are no three samples at different times. ramp: sorted by time.
/// Thread: any (pure). Source: Gasser, Sroka, Jennen-Steinmetz, Biometrika 73 (1986) 625.
[[nodiscard]] EstimatedNoise estimateNoise(std::span<const JointSample> ramp);

} // namespace teleta::stiffness
