// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::contact {

/// What acts on taxels along the surface, in {s}, from frames of vectors.
struct ShearLoad {
    double x_N = 0.0; ///< force on the sensor
    double y_N = 0.0;
    /// About z, at the centre of pressure: sum (x - CoP_x) f_y - (y - CoP_y) f_x.
    double momentZ_Nm = 0.0;
    double friction =
        0.0; ///< |shear| / normal load; the friction coefficient is no less while nothing slides

    bool operator==(const ShearLoad&) const = default;
};

} // namespace teleta::contact
