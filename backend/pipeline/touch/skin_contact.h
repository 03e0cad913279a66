// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/contact_segmenter.h"
#include "backend/pipeline/touch/touch_record.h"
#include "backend/pipeline/touch/touch_snapshot.h"

namespace teleta::pipeline {

/// Systematic error of a centroid over the pitch of the array, where no calibration run of the skin tells it:
/// measured in the scenes teleta-touch and teleoperation, seeds 1 to 10.
inline constexpr double kCentroidSe_pitches = 0.05;

/// Sets the standard errors of a contact's place from the patch:
///   se^2 = systematic^2 + noise^2 n (w^2 / 12) / force^2
/// with n taxels over w metres along each axis. systematic_m: of a calibration run of this skin; 0:
/// kCentroidSe_pitches of the pitch. noise_N: of one taxel; >= 0. Thread: any (pure). Source: propagation of
/// the noise through TeleTA, eq. (1).
void setPlaceErrors(SkinContact& contact, const contact::Contact& patch, double pitch_m, double noise_N,
                    double systematic_m);

/// Noise of a taxel, as far as the threshold for contacts tells: a third of it. Thread: any (pure).
[[nodiscard]] double taxelNoise_N(double threshold_N);

/// The strongest contact of a frame. Where the sheet lies around a cylinder, its edges in y meet: two parts
/// of a contact on both sides of the seam are then one. circumference_m: of the cylinder; 0: a flat sheet.
/// systematic_m: as in setPlaceErrors(). Thread: any (pure).
[[nodiscard]] SkinContact strongestContact(const TouchSnapshot& frame, double circumference_m,
                                           double systematic_m = 0.0);

} // namespace teleta::pipeline
