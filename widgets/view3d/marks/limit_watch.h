// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::view3d {

/// Whether a joint is near the end of its range: nearer than 10 degrees, or than a tenth of a range that is
/// shorter than 100 degrees. It counts as near until it is half as far again. Thread: one.
class LimitWatch {
public:
    static constexpr double kNear_deg = 10.0;
    static constexpr double kNearShare = 0.1;
    static constexpr double kLeave = 1.5; ///< times the distance at which it became near

    /// Way from the end of the range within which a joint is near it; rad.
    [[nodiscard]] static double nearness_rad(double lowest_rad, double highest_rad);

    /// Takes the newest angle. False where the limits or the angle are not finite or in the wrong order.
    bool update(double angle_rad, double lowest_rad, double highest_rad);

private:
    bool m_near = false;
};

} // namespace teleta::view3d
