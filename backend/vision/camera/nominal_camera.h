// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/camera/cylinder_projection.h"

namespace teleta::vision {

/// The camera as designed, before any calibration: on the axis, 20 mm in front of the sensor frame and
/// looking along it, with a lens that is equidistant near its axis (Padé approximant of the arctangent) and
/// covers 146 degrees over the width of the image, y flipped. It is good enough to find contacts in the image
/// during calibration. width_px, height_px: > 0. Thread: any (pure). Source: VTacArm, sections III-A and
/// III-B.
[[nodiscard]] CylinderCamera nominalCamera(int width_px, int height_px, const CylinderSurface& surface = {});

} // namespace teleta::vision
