// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"

namespace teleta::cli {

/// Tactile features of recorded frames, a row a frame.
[[nodiscard]] Command featuresCommand();
/// Contacts of recorded frames with their identities, a row a contact of a frame.
[[nodiscard]] Command contactsCommand();
/// What each taxel's load is multiplied with, from frames under an even load.
[[nodiscard]] Command gainsCommand();
/// Stiffness and material of the object that a joint's log has touched.
[[nodiscard]] Command stiffnessCommand();
/// Shape and spline of a series of contact points.
[[nodiscard]] Command contourCommand();
/// Points on the cylinder that pixels of a calibrated camera show, a row a pixel.
[[nodiscard]] Command locateCommand();

} // namespace teleta::cli
