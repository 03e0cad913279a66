// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace teleta::scene_run {

/// What the simulated world knows of one contact of a frame. Frame {array}: x along the columns, y along the
/// rows, z out of the array.
struct ContactLabel {
    std::int32_t object = 0; ///< its place in the scene's list, from 0
    std::int32_t identity =
        0;            ///< number of the contact in its run, from 1; an object that comes back is a new one
    double x_m = 0.0; ///< centre of pressure
    double y_m = 0.0;
    double force_N = 0.0;                        ///< along the array's -z
    std::array<double, 3> normal{0.0, 0.0, 1.0}; ///< outward normal of what it presses, or of the array
};

/// A frame of a tactile array with its truth. Views are valid during the call only.
struct LabelledFrame {
    double time_s = 0.0;
    std::span<const float> values;
    std::span<const ContactLabel> contacts;
};

} // namespace teleta::scene_run
