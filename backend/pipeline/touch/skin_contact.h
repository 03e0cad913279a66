// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_record.h"
#include "backend/pipeline/touch/touch_snapshot.h"

namespace teleta::pipeline {

/// The strongest contact of a frame. Where the sheet lies around a cylinder, its edges in y meet: two parts
/// of a contact on both sides of the seam are then one. circumference_m: of the cylinder; 0: a flat sheet.
/// Thread: any (pure).
[[nodiscard]] SkinContact strongestContact(const TouchSnapshot& frame, double circumference_m);

} // namespace teleta::pipeline
