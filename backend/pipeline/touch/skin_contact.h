// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/contact_segmenter.h"
#include "backend/pipeline/touch/touch_record.h"
#include "backend/pipeline/touch/touch_snapshot.h"

namespace teleta::pipeline {

/// Sets the standard errors of a contact's place. Taxels whose load is below the threshold do not count, so
/// the centre is off by what those on one side of the patch carry, half the threshold each on average:
///   se_x = threshold / 2 sqrt(rows) (columns + 1) / 2 pitch / force
/// and likewise along y, for a patch of rows x columns taxels; 0 without a force. Where those on the other
/// side make up for a part it is up to twice too large; but presses at one place of the skin, as around one
/// object, are all off alike. Measured: skin_contact_test. The noise of single taxels, which the threshold is
/// above, is less. An uneven skin adds its own error, core::SkinPlacement::centreSe_m. Thread: any (pure).
void setPlaceErrors(SkinContact& contact, const contact::Contact& patch, const core::ArrayLayout& grid,
                    double threshold_N);

/// The strongest contact of a frame. Where the sheet lies around a cylinder, its edges in y meet: two parts
/// of a contact on both sides of the seam are then one. circumference_m: of the cylinder; 0: a flat sheet.
/// Thread: any (pure).
[[nodiscard]] SkinContact strongestContact(const TouchSnapshot& frame, double circumference_m);

/// Makes the parts of a contact on both sides of the seam one for those who show the frame: they get the
/// lower of their identities. The centres and the axis of such a frame are those of the flat sheet and are
/// left out, but for the centre of pressure of a single contact, which is that of its parts. Parts that are
/// not tracked yet, with identity 0, stay as they are. circumference_m: of the cylinder; 0: a flat sheet,
/// whose frame stays as it is. Thread: any (pure).
void joinAtSeam(TouchSnapshot& frame, double circumference_m);

} // namespace teleta::pipeline
