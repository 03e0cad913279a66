// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/stiffness/compliance_line.h"
#include "backend/stiffness/joint_sample.h"

#include <span>
#include <vector>

namespace teleta::stiffness {

/// How far outside the window samples are still looked at, as a share of the window's width: noise carries
/// samples across its borders.
inline constexpr double kWindowMargin = 0.5;

/// The samples of the first loading of a touch, torque rising through the window. Order: time, then torque,
/// then angle, so that the order of the input does not matter; a sample that is there twice counts once.
/// Torques are relative to the reference and positive in the direction of the touch; angles turn with them.
///   from  after the last sample below max(low - margin, low/2) that precedes the window's upper border
///   to    the highest sample before the torque falls below the middle or rises above high + margin
/// Where the upper border is never reached the highest torque of the log stands for it, also for the middle.
/// Empty when no sample reaches the window's lower border. samples: finite. Thread: any (pure).
[[nodiscard]] std::vector<JointSample> loadingRamp(std::span<const JointSample> samples,
                                                   const TorqueWindow& window,
                                                   double torqueReference_Nm = 0.0);

/// Noise of both readings, and the degrees of freedom of their variances; 0 when the noise is unknown.
struct EstimatedNoise {
    ReadingNoise noise;
    double degreesOfFreedom = 0.0;
};

/// Noise of both readings from how far each sample lies off the line, over time, between its neighbours; a
/// steady motion leaves nothing but noise. Degrees of freedom: 18/35 of the number of such triples.
/// Unknown when there are no three samples at different times. ramp: in order of time. Thread: any (pure).
/// Source: Gasser, Sroka, Jennen-Steinmetz, Biometrika 73 (1986) 625.
[[nodiscard]] EstimatedNoise estimateNoise(std::span<const JointSample> ramp);

} // namespace teleta::stiffness
