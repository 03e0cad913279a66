// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"

namespace teleta::cli {

/// Tactile features of recorded frames, one row per frame.
[[nodiscard]] Command featuresCommand();
/// Contacts of recorded frames with their identities, one row per contact and frame.
[[nodiscard]] Command contactsCommand();
/// The gain of each taxel, from frames under an even load.
[[nodiscard]] Command gainsCommand();
/// Loads in N from signals of a sensor, by a matrix from presses with a known load.
[[nodiscard]] Command loadsCommand();
/// Stiffness and material of a touched object from the log of a joint.
[[nodiscard]] Command stiffnessCommand();
/// Shape and spline of a series of contact points.
[[nodiscard]] Command contourCommand();
/// Points on the cylinder that pixels of a calibrated camera show, one row per pixel.
[[nodiscard]] Command locateCommand();

} // namespace teleta::cli
