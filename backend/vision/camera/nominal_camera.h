// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/camera/cylinder_projection.h"

namespace teleta::vision {

/// The camera as the arm is designed, before any calibration: on the axis 20 mm before the sensor frame,
/// looking along it through a lens that is equidistant near its axis (Padé approximant of the arctangent) and
/// shows 146 degrees over the width of the image, y flipped. With it contacts can be found in the image while
/// their true places are still to be learnt.
/// width_px, height_px: > 0. Source: VTacArm, section III-A and III-B.
[[nodiscard]] CylinderCamera nominalCamera(int width_px, int height_px, const CylinderSurface& surface = {});

} // namespace teleta::vision
